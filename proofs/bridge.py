"""Coq run on the emitted programs: all goals in two processes, a table of seconds, and a sentence for each failure."""

from __future__ import annotations

import argparse
import re
import sys
import time
from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from derive.codegen.signatures import PUBLIC
from derive.workers import scratch

from .checker import CLOSED, PROCESSES, Coq, compiled, find
from .coq_definitions import GEOMETRY
from .emitted import printed
from .goals import ORDERS, Goal, goals
from .statements import MachineError

ROOT = Path(__file__).parents[1]


@dataclass(frozen=True)
class ProofTime:
    """Goal with the seconds that Coq took; ``reason`` is empty if the goal is proved."""

    goal: Goal
    seconds: float
    reason: str = ""


def prove(goal: Goal, coq: Coq) -> ProofTime:
    """Prove a goal where the proofs are compiled; a program that differs raises `MachineError`."""
    path, begun = coq.build / f"{goal.name}.v", time.monotonic()
    path.write_text(goal.text, encoding="utf-8")
    try:
        done = coq.run("coqc", "-q", path.name)
    except MachineError as error:
        return ProofTime(goal, time.monotonic() - begun, f"not covered: {error}")
    if done.returncode:
        raise MachineError(_difference(goal, done.stderr))
    if done.stdout.count(CLOSED) != goal.text.count("Print Assumptions"):
        raise MachineError(f"{goal.name}: the proof rests on an axiom: {' '.join(done.stdout.split())}")
    return ProofTime(goal, time.monotonic() - begun)


def _difference(goal: Goal, stderr: str) -> str:
    """Return the sentence that names the entry at whose line Coq stopped."""
    line = int(found[1]) if (found := re.search(r"line (\d+)", stderr)) else 1
    comment = re.search(r"\(\* (.*) \*\)", goal.text.splitlines()[line - 1])
    which = f"{goal.function} of order {goal.order}" if goal.order else goal.function
    part = comment[1] if comment else "its text"
    return f"{goal.place}: {which} ({goal.target}) differs from its definition: {part}. Coq: {' '.join(stderr.split())}"


def prove_all(numpy: Path, c: Path, coq: Coq, orders: Sequence[int] = ORDERS) -> list[ProofTime]:
    """Prove the programs of two folders of kernels, where the proofs are compiled; progress goes to stderr."""
    every, outcomes = list(goals(numpy, c, orders)), list[ProofTime]()
    with ThreadPoolExecutor(PROCESSES) as pool:
        for stage in ([g for g in every if not g.order], [g for g in every if g.order]):
            for outcome in pool.map(prove, stage, [coq] * len(stage)):
                outcomes.append(outcome)
                print(f"{len(outcomes)}/{len(every)}: {outcome.goal.name} {outcome.seconds:.1f} s", file=sys.stderr)
    return outcomes


def table(outcomes: Iterable[ProofTime]) -> str:
    """Return function, order, target and seconds of each goal as lines of text, and what is not covered."""
    lines = [f"{'function':20} {'order':>5}  {'target':6} {'seconds':>7}"]
    for each in outcomes:
        start = f"{each.goal.function:20} {each.goal.order or 'any':>5}  {each.goal.target:6}"
        lines.append(f"{start} {each.seconds:7.1f}  {each.reason}".rstrip())
    return "\n".join([*lines, f"not covered: {', '.join(sorted(PUBLIC.keys() - GEOMETRY.keys()))}"])


def main(arguments: Sequence[str] | None = None) -> int:
    """Prove the committed NumPy kernels and the C headers of a folder, or those that the generator prints now."""
    parser = argparse.ArgumentParser(prog="python -m proofs.bridge", description=__doc__)
    parser.add_argument("--numpy", type=Path, default=ROOT / "generated" / "dualcay", help="folder of NumPy kernels")
    parser.add_argument("--c", type=Path, help="folder of C headers; by default they are printed to a temporary folder")
    chosen = parser.parse_args(arguments)
    with scratch() as folder:
        try:
            coq = find(folder / "proofs")
            headers = chosen.c or printed(folder / "c", ORDERS)
            list(compiled(coq))
            outcomes = prove_all(chosen.numpy, headers, coq)
        except MachineError as error:
            print(f"error: {error}", file=sys.stderr)
            return error.code
    print(table(outcomes))
    return 0


if __name__ == "__main__":
    sys.exit(main())
