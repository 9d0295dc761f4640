"""Mutation of the whole road: ``python -m tests.mutants`` (``make mutants``) says how much the checks would notice.

========== ====================================================================================================
mutant     a mutant, its fate, and how a sample is drawn
python     operators on Python source
templates  operators on templates
programs   operators on straight-line programs; their validation; equality in a prime field
statements mutants of the papers' statements
rooms      where mutants are made and which checks should kill them, in stages
road       the checks that are no tests: proofs, validation, comparison of what is emitted
texts      what emitted texts say but for comments, layout and names of variables
knowledge  what is known of the unchanged tree
suite      tests, chosen and in order, inside this process
reach      which checks reach which lines
tree       copies of the working tree
child      forked processes with limits
run        sample and trials
past       what is known from before, and stands
record     what became of a sample, kept with the sources
report     table and page
========== ====================================================================================================

A mutant of a file is written into a copy of the tree; a forked process imports the toolkit from there, runs the checks
that reach the changed lines, and says which one failed. Results are kept in ``.mutants``, so that a run that was
stopped goes on, and recorded in ``fates``, with the sources: a fate stands as long as what decided it is the same,
rooms can be measured one by one, and where something else has changed, what killed a mutant is asked first.
"""

from __future__ import annotations

import argparse
import importlib
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from . import record, report
from .knowledge import NotControlled
from .rooms import ROOMS
from .run import Run

ROOT = Path(__file__).parent.parent.parent
PAGE = "docs/assurance.md"
SEED = 88
SAMPLE = 200
WARM = (
    "sympy", "numpy", "mpmath", "jinja2", "click", "rich", "flint", "hypothesis", "latex2mathml", "pytest",
    "scipy.spatial.transform",
)  # fmt: skip
"""Libraries that every trial needs; imported once, before processes are forked."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; 0 if every room meets the floor, 1 if one does not, 3 if the unchanged tree fails."""
    options = _options(arguments)
    started = time.monotonic()

    def say(line: str) -> None:
        print(f"[{time.monotonic() - started:5.0f} s] {line}", file=sys.stderr, flush=True)

    for library in WARM:
        importlib.import_module(library)
    run = Run(ROOT, ROOT / ".mutants", _state(), options.seed, options.sample, options.jobs, say)
    scores = []
    try:
        for found in run.rooms([ROOMS[name] for name in options.room]):
            found.write(ROOT)
            scores.append(report.score(found))
            for trial in found.survivors:
                print(f"{found.room}: {trial.where}: {trial.operator}: {trial.change}")
    except NotControlled as error:
        print(error, file=sys.stderr)
        return 3
    print("\n" + report.plain(report.rows(scores)))
    known = [kept for name in ROOMS if (kept := record.read(ROOT, name))]
    (ROOT / options.output).write_text(report.page(known), encoding="utf-8")
    short = [s.name for s in scores if s.share < options.floor.get(s.name, options.floor.get("", 0.0))]
    if short:
        print(f"below the floor: {', '.join(short)}", file=sys.stderr)
    return 1 if short else 0


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tests.mutants", description="How much the checks would notice.")
    parser.add_argument("--room", type=_rooms, default=tuple(ROOMS), help=f"of {', '.join(ROOMS)}; all by default")
    parser.add_argument("--sample", type=int, default=SAMPLE, help="mutants of each room (%(default)s)")
    parser.add_argument("--seed", type=int, default=SEED, help="of the sample (%(default)s)")
    parser.add_argument("--jobs", type=int, default=2, help="processes at once (%(default)s)")
    parser.add_argument("--floor", type=_floor, default={}, help="least per cent: 95, or proof=80,maps=90")
    parser.add_argument("-o", "--output", default=PAGE, help="page of all rooms that were ever measured (%(default)s)")
    return parser.parse_args(arguments)


def _rooms(text: str) -> tuple[str, ...]:
    names = tuple(text.split(","))
    if unknown := [name for name in names if name not in ROOMS]:
        raise argparse.ArgumentTypeError(f"no room {', '.join(unknown)}: expected {', '.join(ROOMS)}")
    return names


def _floor(text: str) -> dict[str, float]:
    floors = {}
    for part in text.split(","):
        name, _, value = part.rpartition("=")
        if name and name not in ROOMS:
            raise argparse.ArgumentTypeError(f"no room {name}: expected {', '.join(ROOMS)}")
        floors[name] = float(value)
    return floors


def _state() -> str:
    """The commit, and whether the tree differs from it."""
    command = ["git", "describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"]
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()


if __name__ == "__main__":
    sys.exit(main())
