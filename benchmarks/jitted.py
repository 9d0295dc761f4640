"""Expressions compiled by JAX on a CPU, beside the same expressions in NumPy and by jaxlie, values and gradients.

``python -m benchmarks.jitted -o docs/benchmarks.md``; all forms take turns in one process.
"""

from __future__ import annotations

import argparse
import importlib
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from benchmarks.page import write_section
from benchmarks.peers import SWAP, Poses, load
from benchmarks.timing import fix_allocator, markdown, medians
from tests.support import packages

SIZES = (1, 10_000)
CHARTS = ("exponential", "cayley2")
NUMPY_GATE, PEER_GATE = 1.5, 1.0
"""Largest time of a compiled expression, over that of NumPy and over that of jaxlie."""

EXPRESSIONS: Mapping[str, Callable[[Any, Any, Any], Any]] = {
    "compose(compose(a, b), a)": lambda m, a, b: m.compose(m.compose(a, b), a),
    "body_local(between(a, b), a)": lambda m, a, b: m.body_local(m.between(a, b), a),
    "compose(a, b)": lambda m, a, b: m.compose(a, b),
    "retract(a, b)": lambda m, a, b: m.retract(a, b),
}


class Peer:
    """Functions of jaxlie on exponential coordinates, its translation first."""

    def __init__(self) -> None:
        self.group = load("jaxlie").SE3

    def compose(self, a: Any, b: Any) -> Any:
        return (self.group.exp(a) @ self.group.exp(b)).log()

    def between(self, a: Any, b: Any) -> Any:
        return (self.group.exp(b).inverse() @ self.group.exp(a)).log()

    retract, body_local = compose, between


def rows(package: str, size: int, dtype: Any) -> Iterator[tuple[str, ...]]:
    """Yield lines of times by expression: values and gradients, with ratios to NumPy and jaxlie."""
    import jax

    peer = Peer() if load("jaxlie") else None
    for chart in CHARTS:
        kernel = importlib.import_module(f"dualcay.{chart}")
        module, poses = importlib.import_module(f"{package}.{chart}"), Poses.draw(kernel, size)
        a, b = (np.atleast_2d(v).astype(dtype) for v in (poses.v, poses.w))
        x, y = (np.atleast_2d(v)[:, SWAP].astype(dtype) for v in (poses.exponential, poses.other))
        for text, expression in EXPRESSIONS.items():
            calls, seconds = [partial(expression, kernel, a, b)], list[float]()
            for of, given in ((module, (a, b)), *([(peer, (x, y))] if peer else [])):
                for form in (partial(expression, of), jax.grad(partial(_total, expression, of))):
                    arrays, start = [jax.numpy.asarray(v) for v in given], perf_counter()
                    compiled = jax.jit(jax.vmap(form)).lower(*arrays).compile()
                    seconds.append(perf_counter() - start)
                    calls.append(partial(_waited, compiled, arrays))
            times = [time / size * 1e9 for time in medians(calls, kept=False)]
            numpy, ours, gradient, *others = times
            ratios = [f"{one / other:.2f}" for one, other in zip((ours, ours, gradient), (numpy, *others))]
            met = ours <= NUMPY_GATE * numpy and (not others or ours <= PEER_GATE * others[0])
            shown = [f"{time:.0f}" for time in (ours, numpy, *others[:1], gradient, *others[1:])]
            gates = "met" if met else "SHORT"
            yield chart, text, f"{size:,}", dtype.__name__, *shown, *ratios, gates, f"{seconds[0]:.1f}"


def _total(expression: Callable[..., Any], of: Any, a: Any, b: Any) -> Any:
    return expression(of, a, b).sum()


def _waited(function: Callable[..., Any], arrays: Sequence[Any]) -> object:
    return function(*arrays).block_until_ready()


def section() -> str:
    """Return the times of all expressions as Markdown."""
    import jax

    jax.config.update("jax_enable_x64", True)
    with tempfile.TemporaryDirectory(prefix="dualcay-jitted-") as name:
        packages.write((2,), "array-api", Path(name) / "dualcay_jitted", ("exponential",))
        sys.path.insert(0, name)
        try:
            cases = [(size, dtype) for dtype in (np.float64, np.float32) for size in SIZES]
            found = [row for size, dtype in cases for row in rows("dualcay_jitted", size, dtype)]
        finally:
            sys.path.remove(name)
    head = ("chart", "expression", "N", "type", "jit", "NumPy", "jaxlie", "gradient", "jaxlie's", "jit/NumPy")
    head = (*head, "jit/jaxlie", "gradient/jaxlie's", "gates", "compile, s")
    how = (
        f"Written by `python -m benchmarks.jitted`, JAX {jax.__version__} with its default flags: processor time in ns "
        f"per pose, all threads added. XLA takes 6 ns for a tangent of float64, NumPy 1 ns. "
        f"Gates: at most {NUMPY_GATE} x NumPy and {PEER_GATE} x jaxlie, for values."
    )
    return f"{how}\n\n{markdown('Expressions compiled by JAX on a CPU', head, found)}"


def main(given: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, help="page whose section is replaced")
    options = parser.parse_args(given)
    text = section()
    print(text)
    if options.output:
        write_section(options.output, "jitted", text)


if __name__ == "__main__":
    fix_allocator()
    main()
