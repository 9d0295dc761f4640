"""``python -m proofs.rounding``: bound the rounding errors of emitted C programs with Gappa.

The exit code is 1 if a bound is refused or a control passes, and 3 if Gappa is missing. Bounds hold if every
operation is rounded to nearest, without fused multiply-adds.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from functools import lru_cache
from itertools import product
from pathlib import Path

import mpmath
import numpy as np

from derive.output import files, pages
from derive.workers import scratch

from .checker import PROCESSES
from .coq_definitions import GEOMETRY, V
from .emitted import CHeader, printed
from .gappa import EPS, claim, outputs, reach, require, rounded_up, run, script
from .statements import MachineError
from .transcript import Transcript

FUNCTIONS, ORDERS = ("tangent", "pose", "quaternion"), (3, 2)  # functions and orders, the slowest first
SAMPLES, SAMPLED_DIGITS = 10_000, 40
"""Arguments of a measurement, and digits of the exact values, of which 16 are lost in the difference."""


@dataclass(frozen=True)
class Bound:
    """Certified bound and largest measured error of an output in eps; without a bound there is a reason."""

    function: str
    order: int
    output: int
    bound: float | None
    measured: float
    reason: str = ""

    @property
    def name(self) -> str:
        """Output as the C header names it, such as ``pose[3]``."""
        return f"{GEOMETRY[self.function].result}[{self.output}]"

    def __str__(self) -> str:
        start = f"{self.function:12} {self.order:5}  {self.name:12}"
        return f"{start} {self.reason}" if self.bound is None else f"{start} {self.bound:9.2f} {self.measured:9.2f}"


def read(folder: Path, function: str, order: int) -> Transcript:
    """Return the transcript of a function of a C header with the scalar program that it calls."""
    texts = tuple(path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*.h")))
    return _header(folder / f"cayley{order}.h", texts).geometry(function)


@lru_cache(maxsize=8)
def _header(path: Path, texts: tuple[str, ...]) -> CHeader:
    """Return a header, which takes a second to read; ``texts`` of its folder are a key of the cache."""
    return CHeader(path)


def measured(program: Transcript, order: int, count: int = SAMPLES) -> dict[int, float]:
    """Return the largest errors in eps at random arguments with |v| ≤ 1 and the largest dual parts, by output."""
    random = np.random.default_rng(order)
    directions = random.normal(size=(2, 3, count))
    real, dual = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    length = random.random(count) * (1 - 1e-12)  # rounding of v stays below |v| = 1
    dual *= reach(order, length * length) * (1 - 1e-12)
    inputs = dict(zip(V, (*(real * length), *dual), strict=True))
    context = mpmath.MPContext()  # one for each thread
    context.dps = SAMPLED_DIGITS
    number = np.vectorize(context.mpf, otypes=[object])
    rounded, exact = program.values(inputs), program.values({name: number(each) for name, each in inputs.items()})
    names = ((i, program.results[i]) for i in outputs(program))
    return {i: float(np.max(abs(exact[name] - number(rounded[name]))) / EPS) for i, name in names}


def found(folder: Path, function: str, order: int) -> list[Bound]:
    """Return the bounds that Gappa finds for a function, rounded up, and the largest measured errors."""
    program = read(folder, function, order)
    bounds, reason = run(script(program, order, dict.fromkeys(outputs(program), "in ?")))
    return [
        Bound(function, order, i, rounded_up(bounds[step]), error)
        if step in bounds
        else Bound(function, order, i, None, error, f"not covered: {reason}")
        for i, error in measured(program, order).items()
        for step in [str(program.results[i])]
    ]


def certify(folder: Path, bounds: Sequence[Bound]) -> None:
    """Prove the bounds of one function again as claims; one that is refused raises `MachineError`."""
    function, order = bounds[0].function, bounds[0].order
    program, where = read(folder, function, order), f"{function} of order {order}"
    if outputs(program) != tuple(each.output for each in bounds):
        raise MachineError(f"{program.place}: {where} has other outputs than those with bounds")
    for each in bounds:
        if each.bound is not None and each.measured > each.bound:
            raise MachineError(f"{each.name} of {where}: measured {each.measured} eps, above the bound {each.bound}")
    claims = {each.output: claim(each.bound) for each in bounds if each.bound is not None}
    _, unproved = run(script(program, order, claims))
    if unproved:
        names = [each.name for each in bounds if f"{program.results[each.output]}_exact" in unproved]
        raise MachineError(f"{program.place}: Gappa refuses bounds of {where}: {', '.join(names) or unproved}")


def control(folder: Path, bound: Bound) -> None:
    """Require that Gappa refuses a bound of half the measured error, which is false."""
    program, small = read(folder, bound.function, bound.order), bound.measured / 2
    _, unproved = run(script(program, bound.order, {bound.output: claim(small)}))
    if not unproved:
        raise MachineError(f"{bound.name} of order {bound.order}: Gappa accepts {small} eps, half the measured error")


def every(folder: Path, known: Sequence[Bound] = ()) -> list[Bound]:
    """Find the bounds of all functions, or take known ones; certify them, and print them with seconds."""
    begun, table = time.monotonic(), list[Bound]()

    def one(job: tuple[str, int]) -> tuple[list[Bound], float]:
        start = time.monotonic()
        bounds = [each for each in known if (each.function, each.order) == job] or found(folder, *job)
        certify(folder, bounds)
        return bounds, time.monotonic() - start

    print(f"{'function':12} order  {'output':12} {'bound':>9} {'measured':>9}  in eps = 2^-52")
    with ThreadPoolExecutor(PROCESSES) as pool:
        for bounds, seconds in pool.map(one, product(FUNCTIONS, ORDERS)):
            print("\n".join(map(str, bounds)), f"{seconds:.1f} s", sep="\n", flush=True)
            table += bounds
    control(folder, table[-1])
    print(f"control refused; {time.monotonic() - begun:.0f} s in all")
    return table


def load(path: Path) -> list[Bound]:
    try:
        return [Bound(**each) for each in json.loads(path.read_text(encoding="utf-8"))]
    except (OSError, ValueError, TypeError) as error:
        raise MachineError(f"{path}: no file of bounds: {error}") from None


def main(arguments: Sequence[str] | None = None) -> int:
    """Find and certify bounds of the C headers of a folder, or of those that the generator prints now."""
    parser = argparse.ArgumentParser(prog="python -m proofs.rounding", description="Bound rounding errors.")
    parser.add_argument("--c", type=Path, help="folder of C headers; by default they are printed to a temporary folder")
    parser.add_argument("-o", "--output", type=Path, help="file of bounds to write")
    parser.add_argument("--check", type=Path, metavar="FILE", help="certify the bounds of a file instead")
    options = parser.parse_args(arguments)
    if not pages.writable(options.output):
        return 3
    with scratch() as folder:
        try:
            known = load(options.check) if options.check else ()
            require()
            bounds = every(options.c or printed(folder, ORDERS), known)
        except MachineError as error:
            print(f"error: {error}", file=sys.stderr)
            return error.code
    if options.output:
        lines = ",\n".join(json.dumps(asdict(each)) for each in bounds)
        files.put(options.output, f"[\n{lines}\n]\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
