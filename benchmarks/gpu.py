"""Times of array-api kernels on a GPU, by CuPy, PyTorch and JAX, relative to the memory speed of the card.

    python benchmarks/gpu.py [--device gpu|cpu] [--poses 1e6,1e7,1e8] [-n 3] [--dtype float32|float64]

The table has a row per library and number of poses. Columns are nanoseconds per pose of the map, of a copy of as many
bytes (the floor), and their ratio. Missing libraries and libraries without such a device are named.
"""

from __future__ import annotations

import argparse
import importlib
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

from derive.codegen import generate

REPEATS = 7
BYTES = {"float32": 4, "float64": 8}
MAPS = {"quaternion": (6, 8), "pose": (6, 16), "rate": (12, 6), "from_pose": (16, 6)}
"""Numbers read and written per pose, by map."""


class Missing(Exception):
    """Exception for a library that is not installed or finds no device of this kind."""


@dataclass(frozen=True)
class Library:
    """Functions of a library: make an array on the device, compile a function, wait for results."""

    name: str
    array: Callable[[np.ndarray], Any]
    compiled: Callable[[Callable[..., Any]], Callable[..., Any]]
    wait: Callable[[Any], Any]


def cupy(device: str) -> Library:
    if device != "gpu":
        raise Missing("runs on GPUs only")
    xp = _module("cupy")
    if not xp.cuda.is_available():
        raise Missing("sees no GPU")
    return Library("CuPy", xp.asarray, lambda f: f, lambda _: xp.cuda.Stream.null.synchronize())


def torch(device: str) -> Library:
    xp = _module("torch")
    if device == "gpu" and not xp.cuda.is_available():
        raise Missing("sees no GPU")
    place = "cuda" if device == "gpu" else "cpu"
    wait = xp.cuda.synchronize if device == "gpu" else (lambda: None)
    return Library("PyTorch", lambda a: xp.asarray(a, device=place), lambda f: f, lambda _: wait())


def torch_compiled(device: str) -> Library:
    plain, xp = torch(device), _module("torch")
    if device != "gpu":
        raise Missing("is measured on GPUs only: it needs a C++ compiler elsewhere")
    return Library("PyTorch, compiled", plain.array, xp.compile, plain.wait)


def jax(device: str) -> Library:
    xp = _module("jax")
    xp.config.update("jax_enable_x64", True)
    try:
        place = xp.devices(device)[0]
    except RuntimeError:
        raise Missing("sees no GPU") from None
    return Library("JAX", lambda a: xp.device_put(a, place), xp.jit, xp.block_until_ready)


LIBRARIES = (cupy, torch, torch_compiled, jax)


def _module(name: str) -> ModuleType:
    try:
        return importlib.import_module(name)
    except ImportError:
        raise Missing("is not installed") from None


def kernels(order: int) -> ModuleType:
    """Generate the array-api module of an order and return it."""
    folder = Path(tempfile.mkdtemp(prefix="dualcay-"))
    generate([order], "array-api", folder / "portable")
    sys.path.insert(0, str(folder))
    return importlib.import_module(f"portable.cayley{order}")


def arguments(module: ModuleType, library: Library, name: str, count: int, dtype: str) -> list[Any]:
    """Return arguments on the device, with components first: this layout causes the least memory traffic."""
    rng = np.random.default_rng(0)
    v, w = (library.array(rng.random((6, count), np.dtype(dtype)) - np.dtype(dtype).type(0.5)) for _ in range(2))
    if name == "from_pose":
        return [library.compiled(lambda a: module.pose(a, axis=0))(v)]
    return [v, w] if name == "rate" else [v]


def seconds(run: Callable[[], Any], wait: Callable[[Any], Any]) -> float:
    """Return the median time over repeats, after two calls that compile and warm up."""
    times = []
    for repeat in range(REPEATS + 2):
        begin = time.perf_counter()
        wait(run())
        if repeat >= 2:
            times.append(time.perf_counter() - begin)
    return statistics.median(times)


def rows(module: ModuleType, library: Library, counts: list[int], dtype: str) -> Iterator[tuple[str, ...]]:
    for name, (read, written) in MAPS.items():
        for count in counts:
            values = arguments(module, library, name, count, dtype)
            function = library.compiled(lambda *a, name=name: getattr(module, name)(*a, axis=0))
            # the copy moves as many bytes: half of them are read, half written
            copied = library.array(np.ones(count * (read + written) // 2, dtype))
            copy = library.compiled(lambda a: a + 1)
            spent = seconds(lambda f=function, v=values: f(*v), library.wait) / count * 1e9
            floor = seconds(lambda f=copy, a=copied: f(a), library.wait) / count * 1e9
            speed = (read + written) * BYTES[dtype] / floor
            times = f"{spent:.3f}", f"{floor:.3f}", f"{spent / floor:.2f}", f"{speed:.0f}"
            yield library.name, name, f"{count:.0e}", *times


def measure(device: str, counts: list[int], order: int, dtype: str, console: Console) -> int:
    """Print the table; return its number of rows."""
    table = Table(title=f"n = {order}, {dtype}, {device}: ns per pose", title_justify="left")
    for heading in ("library", "map", "poses", "map, ns", "copy, ns", "ratio", "copy, GB/s"):
        table.add_column(heading, justify="left" if heading in ("library", "map") else "right")
    found = []
    for find in LIBRARIES:
        try:
            found.append(find(device))
        except Missing as reason:
            console.print(f"{find.__name__}: {reason}")
    module = kernels(order) if found else None
    for row in (row for library in found for row in rows(module, library, counts, dtype)):
        table.add_row(*row)
    console.print(table)
    return table.row_count


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="Array-api kernels on a GPU against its memory speed.")
    parser.add_argument("--device", choices=("gpu", "cpu"), default="gpu")
    parser.add_argument("--poses", default="1e6,1e7,1e8", help="numbers of poses, separated by commas")
    parser.add_argument("-n", dest="order", type=int, default=3)
    parser.add_argument("--dtype", choices=tuple(BYTES), default="float32")
    options = parser.parse_args(given)
    counts = [int(float(part)) for part in options.poses.split(",")]
    return 0 if measure(options.device, counts, options.order, options.dtype, Console(soft_wrap=True)) else 3


if __name__ == "__main__":
    sys.exit(main())
