"""Page of speeds: ``python -m benchmarks -o docs/benchmarks.md``, with its data and its plot beside it."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path

from benchmarks import clouds, kernels, maps, motion, native, page, plot, propagate, splines, tables, times
from benchmarks.timing import allocator_is_fixed, fix_allocator
from derive.output.files import put


def measure() -> Iterator[times.Timed]:
    """Yield all times: maps and clouds beside libraries, rows, derivatives, compiled functions beside a C loop."""
    with maps.forms() as packages:
        yield from maps.measure(packages)
        yield from clouds.measure(packages)
        if maps.COMPILED in packages:
            yield from native.measure(packages[maps.COMPILED])
    yield from kernels.on_rows()
    yield from kernels.of_jacobians()
    yield from kernels.of_derivatives()


def main() -> None:
    parser = argparse.ArgumentParser(description="Measure the kernels against peers, in about eight minutes.")
    parser.add_argument("-o", "--output", type=Path, required=True, help="page; data and plot are written beside it")
    only = "print the page anew from its data, without measuring"
    parser.add_argument("--print", action="store_true", dest="printed", help=only)
    options = parser.parse_args()
    output, kept = options.output, {}
    file = output.with_suffix(".json")
    data = times.read(file)
    if output.exists():
        kept = page.sections(output.read_text(encoding="utf-8"))
    if not options.printed:
        if not allocator_is_fixed():
            raise RuntimeError("malloc's thresholds are not fixed in this process")
        data = times.Data(times.commit(), times.versions(), list(measure())).with_missing(data)
        data.write(file)
        kept |= {"motion": motion.section(), "propagate": propagate.section(), "splines": splines.section()}
    kept.pop("", None)
    plot.draw(data, output.with_suffix(".svg"))
    put(output, page.joined(page.head(data), kept | tables.sections(data)))
    if output.resolve() == times.FILE.with_suffix(".md"):
        text = page.README.sub(rf"\1{page.figures(data)}\2", times.README.read_text(encoding="utf-8"))
        put(times.README, text)
    print(f"{output}, {file.name} and {page.FILE_OF_PLOT} are written", file=sys.stderr)


if __name__ == "__main__":
    fix_allocator()
    main()
