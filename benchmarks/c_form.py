"""Kernels in C as a shared library, for comparison with the NumPy and numba kernels.

``load(3)`` generates, compiles and loads the kernels of order 3; ``python benchmarks/c_form.py`` prints their times.
"""

from __future__ import annotations

import argparse
import ctypes
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).parent.parent))

from derive.codegen.rows import Table, inside
from derive.codegen.signatures import POSES, PUBLIC, Function
from derive.codegen.validation.c_text import prefix
from derive.codegen.validation.compiled import compiler
from derive.maps import Cayley
from derive.maps.chart import Chart
from tests.support import packages

FLAGS = ("-std=c99", "-O3", "-march=native", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math",
         "-DDUALCAY_SIMD_MATH")  # fmt: skip
TYPES = {"double": np.float64, "float": np.float32}

Array = NDArray[Any]


class CForm:
    """Compiled kernels of one chart; ``call("pose", v, out=pose)`` runs one of them on C-contiguous arrays.

    Arrays have shape (components, N), or with ``layout="aos"`` shape (N, components).
    """

    def __init__(self, library: Path, real: str, table: Table = POSES) -> None:
        self._library = ctypes.CDLL(str(library))
        self._dtype = np.dtype(TYPES[real])
        self._functions = table.public

    def call(
        self, name: str, *arguments: Array, out: Array | tuple[Array, ...], branch: int = 0, layout: str = "rows"
    ) -> None:
        """Run a kernel; ``out`` is a tuple for functions with two results."""
        arrays = (*arguments, *(out if isinstance(out, tuple) else (out,)))
        axis = 0 if layout == "rows" else -1
        row = self._functions[name]
        sizes = [array.size for array in (*row.arguments, *row.results)]
        if [array.shape[axis] for array in arrays] != sizes:
            raise ValueError(f"{name} takes {sizes} components on axis {axis}, got {[a.shape for a in arrays]}")
        if not all(array.dtype == self._dtype and array.flags.c_contiguous for array in arrays):
            raise ValueError(f"expected C-contiguous arrays of {self._dtype}")
        count = arrays[0].size // sizes[0]
        pointers = (ctypes.c_void_p(array.ctypes.data) for array in arrays)
        getattr(self._library, f"{name}_{layout}")(ctypes.c_size_t(count), ctypes.c_int(branch), *pointers)


def load(order: int, real: str = "double") -> CForm | None:
    """Print and compile the kernels of an order; return None if no C compiler is found."""
    command = compiler()
    if command is None:
        return None
    with tempfile.TemporaryDirectory(prefix="dualcay-c-form-") as build:
        folder = Path(build)
        packages.write([order], "c", folder)
        return CForm(compiled(command, folder, Cayley(order), real, folder), real)  # usable without its file


def compiled(
    command: list[str],
    headers: Path,
    chart: Chart,
    real: str,
    folder: Path,
    table: Table = POSES,
    flags: Sequence[str] = FLAGS,
) -> Path:
    """Compile the header of a chart in one folder into a shared library in another folder."""
    source, library = folder / "library.c", folder / "library.so"
    source.write_text("\n".join(_source(chart, table)) + "\n", encoding="utf-8")
    options = [*flags, f"-DDUALCAY_REAL={real}", f"-I{headers}", "-shared", "-fPIC"]
    subprocess.run([*command, *options, str(source), "-o", str(library), "-lm"], check=True)
    return library


def _source(chart: Chart, table: Table) -> Iterator[str]:
    yield f'#include "{inside(table, f"{chart.name}.h")}"'
    for name, signature in table.public.items():
        yield from _exports(f"{prefix(chart, table)}_{name}", name, signature)


def _exports(function: str, name: str, signature: Function) -> Iterator[str]:
    """Yield C wrappers of a function in both layouts, with one pointer per array and always a branch argument."""
    given, made = signature.arguments, signature.results
    pointers = [f"const dualcay_real *{a.name}" for a in given] + [f"dualcay_real *{a.name}" for a in made]
    parameters = ", ".join(["size_t n", "int branch", *pointers])
    chosen, ignored = (["branch"], "") if signature.branch else ([], "(void)branch; ")
    rows = ", ".join([*(f"{a.name}, n" for a in given), *chosen, *(f"{a.name}, n" for a in made)])
    first = [f"{a.name}[j]" if a.size == 1 else f"{a.name} + {a.size} * j" for a in given]
    values = ", ".join([*first, *chosen, *(f"{a.name} + {a.size} * j" for a in made)])
    yield f"void {name}_rows({parameters}) {{ {ignored}{function}_rows(n, {rows}); }}"
    yield f"void {name}_aos({parameters}) {{ {ignored}for (size_t j = 0; j < n; ++j) {function}({values}); }}"


def _best(form: CForm, name: str, count: int, layout: str, repeats: int = 15) -> float:
    """Return the least time of some runs, in nanoseconds per value."""
    signature, random = PUBLIC[name], np.random.default_rng(1)

    def shape(size: int) -> tuple[int, int]:
        return (size, count) if layout == "rows" else (count, size)

    arguments = [random.uniform(-0.3, 0.3, shape(array.size)) for array in signature.arguments]
    out = tuple(np.empty(shape(array.size)) for array in signature.results)
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        form.call(name, *arguments, out=out, branch=1, layout=layout)
        times.append(time.perf_counter() - start)
    return min(times) / count * 1e9


def main() -> int:
    """Print the times of the kernels of one order."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-n", "--order", type=int, default=3)
    order = parser.parse_args().order
    form = load(order)
    if form is None:
        print("no C compiler found (set CC)", file=sys.stderr)
        return 3
    print(f"ns per value, order {order}        rows 10^4  rows 10^6   aos 10^4   aos 10^6")
    for name in PUBLIC:
        times = [_best(form, name, count, layout) for layout in ("rows", "aos") for count in (10**4, 10**6)]
        print(f"{name:24s}" + "".join(f"{value:11.2f}" for value in times))
    return 0


if __name__ == "__main__":
    sys.exit(main())
