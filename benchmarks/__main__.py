"""Page of speeds: ``python -m benchmarks -o docs/benchmarks.md``, with its data and its plot beside it."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Collection, Iterator
from contextlib import nullcontext
from functools import partial
from pathlib import Path

from benchmarks import clouds, kernels, maps, motion, native, page, plot, propagate, splines, tables, times
from benchmarks.timing import allocator_is_fixed, fix_allocator
from derive.output.files import put

PARTS = (maps.PART, maps.SMALL, clouds.PART, kernels.ON_ROWS, kernels.JACOBIANS, kernels.DERIVATIVES)


def measure(parts: Collection[str] = ()) -> Iterator[times.Timed]:
    """Yield the times of some parts, or of all: beside libraries, on rows, of derivatives, beside a C loop.

    Compiled functions are built and measured with all parts alone.
    """
    with nullcontext({maps.NUMPY: "dualcay"}) if parts else maps.forms() as packages:
        by_part: dict[str, Callable[[], Iterator[times.Timed]]] = {
            maps.PART: partial(maps.measure, packages), maps.SMALL: partial(maps.on_small_batches, packages),
            clouds.PART: partial(clouds.measure, packages), kernels.ON_ROWS: kernels.on_rows,
            kernels.JACOBIANS: kernels.of_jacobians, kernels.DERIVATIVES: kernels.of_derivatives,
        }  # fmt: skip
        if maps.COMPILED in packages:
            by_part[native.PART] = partial(native.measure, packages[maps.COMPILED])
        for part in parts or by_part:
            yield from by_part[part]()


def main() -> None:
    parser = argparse.ArgumentParser(description="Measure the kernels against peers, in about eight minutes.")
    parser.add_argument("-o", "--output", type=Path, required=True, help="page; data and plot are written beside it")
    only = "print the page anew from its data, without measuring"
    parser.add_argument("--print", action="store_true", dest="printed", help=only)
    some = "measure only these parts, without compiled functions, and keep the times of the others"
    parser.add_argument("--parts", nargs="+", default=(), choices=PARTS, help=some)
    options = parser.parse_args()
    output, kept = options.output, {}
    file = output.with_suffix(".json")
    data = times.read(file)
    if output.exists():
        kept = page.sections(output.read_text(encoding="utf-8"))
    if not options.printed:
        if not allocator_is_fixed():
            raise RuntimeError("malloc's thresholds are not fixed in this process")
        found = times.Data(times.commit(), times.versions(), list(measure(options.parts)))
        data = data.with_parts(found) if options.parts else found.with_missing(data)
        data.write(file)
        if not options.parts:
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
