"""Processor time of JAX to compile derivatives of compose: with our rules of differentiation, and without them.

``python -m benchmarks.compiling -o docs/benchmarks.md``; without rules, six calls of one chart take a minute.
"""

from __future__ import annotations

import argparse
import importlib
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

from benchmarks.page import write_section
from benchmarks.timing import fix_allocator, markdown
from tests.support import packages

ORDERS = (1, 2, 3, 4, 5, 8)
FAMILIES = ("exponential", "orthographic", "lambert", "sine3", "sine4", "breusing", "scaled2", "wiener_milenkovic")
CHARTS = (*(f"cayley{n}" for n in ORDERS), *FAMILIES)
WITHOUT = ("cayley2", "exponential")
"""Charts also measured without rules."""

CALLS = (1, 2, 6)
MODES = ("jacfwd", "jacrev", "grad")


def seconds(module: Any, calls: int, mode: str) -> float:
    """Return the seconds to trace and compile a derivative of a chain of compose calls."""
    import jax

    def chain(v: Any) -> Any:
        w = v
        for _ in range(calls):
            w = module.compose(w, v)
        return w.sum() if mode == "grad" else w

    function = jax.jit(getattr(jax, mode)(chain))
    start = process_time()
    function.lower(jax.numpy.asarray(np.array([0.1, 0.2, 0.05, 0.3, 0.2, 0.1]))).compile()
    return process_time() - start


def rows(package: str, charts: Sequence[str], without: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Yield lines of seconds by chart; for some charts a second line without rules."""
    rules = importlib.import_module(f"{package}._rules")
    kept: Mapping[str, Callable[..., Any]] = rules.RULES
    for chart in charts:
        module = importlib.import_module(f"{package}.{chart}")
        for form in ("rules", "text") if chart in without else ("rules",):
            rules.RULES = kept if form == "rules" else {}
            times = [seconds(module, calls, mode) for mode in MODES for calls in CALLS]
            yield chart, form, *(f"{time:.1f}" for time in times)
    rules.RULES = kept


def section(charts: Sequence[str] = CHARTS, without: Sequence[str] = WITHOUT) -> str:
    """Return the seconds of all charts as Markdown."""
    import jax

    jax.config.update("jax_enable_x64", True)
    with tempfile.TemporaryDirectory(prefix="dualcay-rules-") as name:
        packages.write(ORDERS, "array-api", Path(name) / "dualcay_rules", FAMILIES)
        sys.path.insert(0, name)
        try:
            found = list(rows("dualcay_rules", charts, without))
        finally:
            sys.path.remove(name)
    head = ("chart", "derivatives by", *(f"{mode}, {calls}" for mode in MODES for calls in CALLS))
    how = (
        f"Written by `python -m benchmarks.compiling`, JAX {jax.__version__}: processor seconds to trace and compile a "
        "derivative of one, two and six calls of `compose` in a row. Processor time grows when other processes use the "
        "same cores. `text` is the differentiated text of `compose`, as JAX derives it without rules."
    )
    return f"{how}\n\n{markdown('Derivatives of compose by JAX, seconds to compile', head, found)}"


def main(given: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--charts", type=lambda text: text.split(","), default=CHARTS, help="only these modules")
    parser.add_argument("-o", "--output", type=Path, help="page whose section is replaced")
    options = parser.parse_args(given)
    text = section(options.charts)
    print(text)
    if options.output:
        write_section(options.output, "compiling", text)


if __name__ == "__main__":
    fix_allocator()
    main()
