"""Mutation test of the whole toolkit: ``python -m tests.mutants`` (``make mutants``).

A mutant has one small change, which tests should refuse. The command draws a sample of mutants from each room, tries
each one in a separate process, lists the survivors and prints the score. The tree stays unchanged.

========== ==========================================================================================================
programs   straight-line programs of the NumPy target with one operation changed: validation must fail
maps, proof, lowering, templates
           sources with one token changed: `generate`, or the tests of the room, must fail
========== ==========================================================================================================
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Sequence

from . import lines, programs
from .mutant import KILLED, Mutant, Room, Verdict, sampled, tried

ROOMS: dict[str, Room] = {"programs": programs.mutants} | lines.ROOMS
SAMPLE, SEED, JOBS = 40, 88, 2


def main(arguments: Sequence[str] | None = None) -> int:
    """Return 0 if every room reaches the floor, 1 if one does not, 3 if the unchanged tree is refused."""
    options = _options(arguments)
    scores: dict[str, float] = {}
    for room in options.room:
        unchanged, *mutants = ROOMS[room]()
        (verdict,) = tried([unchanged], 1)
        if verdict.kind == KILLED:
            print(f"{room}: the unchanged tree is refused: {verdict.by}", file=sys.stderr)
            return 3
        sample = sampled(mutants, options.sample, options.seed)
        scores[room] = _report(room, len(mutants), sample, list(tried(sample, options.jobs)))
    short = [room for room, score in scores.items() if score < options.floor]
    if short:
        print(f"below the floor: {', '.join(short)}", file=sys.stderr)
    return 1 if short else 0


def _report(room: str, population: int, sample: Sequence[Mutant], verdicts: Sequence[Verdict]) -> float:
    """Print survivors and score of a room; return its percentage of killed mutants."""
    for mutant, verdict in zip(sample, verdicts, strict=True):
        if verdict.kind != KILLED:
            print(f"{room}: survives: {mutant}")
    counts = Counter(verdict.kind for verdict in verdicts)
    by = Counter(verdict.by.partition(" ")[0] for verdict in verdicts if verdict.kind == KILLED)
    score = 100 * counts[KILLED] / len(sample) if sample else 100.0
    stages = ", ".join(f"{count} by {stage}" for stage, count in by.most_common())
    killed = f"{counts[KILLED]} of {len(sample)} killed"
    print(f"{room}: {killed} ({score:.1f} %; {stages}); drawn from {population}", flush=True)
    return score


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tests.mutants", description="Count which changes are refused.")
    parser.add_argument("--room", type=_rooms, default=tuple(ROOMS), help=f"of {', '.join(ROOMS)} (default: all)")
    parser.add_argument("--sample", type=int, default=SAMPLE, help="mutants of each room (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=SEED, help="seed of the sample (default: %(default)s)")
    parser.add_argument("--jobs", type=int, default=JOBS, help="processes at once (default: %(default)s)")
    parser.add_argument("--floor", type=float, default=0.0, help="least percentage of each room")
    return parser.parse_args(arguments)


def _rooms(text: str) -> tuple[str, ...]:
    names = tuple(text.split(","))
    if unknown := [name for name in names if name not in ROOMS]:
        raise argparse.ArgumentTypeError(f"no room {', '.join(unknown)}: expected {', '.join(ROOMS)}")
    return names


if __name__ == "__main__":
    sys.exit(main())
