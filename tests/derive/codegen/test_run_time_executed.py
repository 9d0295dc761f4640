"""Run-time parts: each alteration of their formulas is refused; properties that results do not show."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.codegen import ValidationFailed
from derive.codegen.package import shared_texts
from derive.codegen.targets import TARGETS
from derive.codegen.validation import runtime
from derive.codegen.validation.loading import loaded
from derive.maps import Cayley
from derive.output import files
from tests.support.packages import printed

CHART = Cayley(3)

ALTERED = {
    "scalars of a step": ("numpy", "_derived.py", "w = 2 * r", "w = 3 * r", "propagate, lie, space: poses"),
    "order of a product": (
        "numpy", "_stepping.py", 'centre) if frame == "space"', 'centre) if frame == "body"', "propagate, lie, space",
    ),
    "start beyond the limit": (
        "numpy", "_propagate.py", "module.principal(v) if switched else v", "v", "propagate, chart, space: switches",
    ),
    "frame of the noise": (
        "numpy", "_trajectory.py", 'if self.problem.frame == "space" else tensors', "if False else tensors",
        "propagate, lie, space: covariances",
    ),
    "order of a derivative": (
        "numpy", "_motion.py", "path.derivative(times.ravel(), order)", "path.derivative(times.ravel(), order - 1)",
        "propagate, lie, space: first derivatives",
    ),
    "angle of a switch": ("numpy", "_switching.py", "(pi + first) / 2", "(pi + first) / 3", "propagate, lie, space"),
    "branch of a sequence": (
        "numpy", "_sequences.py", "angle + 2 * pi * branches", "angle - 2 * pi * branches", "unwrap of 6 components",
    ),
    "ways through a sequence": (
        "numpy", "_sequences.py", "better = total < costs", "better = total > costs", "unwrap of 6 components",
    ),
    "Cayley map of 4x4": ("numpy", "_other_vectors.py", "scale**2 + (real", "scale**2 - (real", "to_cayley_4x4"),
    "position for ROS": (
        "numpy", "interop.py", "np.cross(position, vector)", "np.cross(vector, position)", "from_ros, component 3",
    ),
    "fraction of a multiple": (
        "numpy", "_multiple.py", 'f" * {divisor.denominator}"', 'f" * {divisor.numerator}"',
        "switch_event of a multiple",
    ),
    "rate at a switch": (
        "numpy", "_branches.py", "kernels.rate(moved, kernels.twist(array", "kernels.rate(array, kernels.twist(array",
        "switch of 6 components: rate",
    ),
    "chart of a Jacobian": (
        "numpy", "_tools.py", "target.rate(w[beside]", "source.rate(w[beside]", "convert_jacobian of 6 components",
    ),
    "law of a pose": (
        "numpy", "_checks.py", "[T[12], T[13], T[14], T[15] - 1]", "[T[12], T[13], T[14]]",
        "from_pose with check: refused components, component 15",
    ),
    "bound of random angles": (
        "numpy", "_interface.py", "max_angle * generator", "2 * max_angle * generator", "random: bounds",
    ),
    "rule of a kernel": (
        "array-api", "_rules.py", "at.moved(-v1, at.twist", "at.moved(v1, at.twist", "rule of between of 6",
    ),
    "scalars beside the rules": ("array-api", "_slopes.py", "(1 - f) / xx", "(2 - f) / xx", "pose_scalars"),
    "slope of a gain": ("array-api", "_slopes.py", "share * (fe * hi - 1)", "share * (fe * hi + 1)", "slopes of gain"),
    "third slope": ("array-api", "_slopes.py", "(fyyy + 6 * hyy)", "(fyyy + 5 * hyy)", "slopes of exp"),
    "selection of a switch": (
        "array-api", "_branches.py", "kernels.twist(v, covariance", "kernels.twist(moved, covariance",
        "switch of 6 components: covariance",
    ),
}  # fmt: skip
"""Target, file, text, its replacement, and the case that refuses it; the first alters a printed formula."""


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], tuple[Path, Mapping[str, str]]]:
    """Return a function that gives the folder and the texts of a package for a target."""
    made: dict[str, tuple[Path, Mapping[str, str]]] = {}

    def package(target: str) -> tuple[Path, Mapping[str, str]]:
        if target not in made:
            made[target] = tmp_path_factory.mktemp(target), printed([CHART.order], target)
            files.write(*made[target])
        return made[target]

    return package


@pytest.mark.parametrize("target", ["numpy", "array-api"])
def test_right_parts_pass_without_scipy_and_jax(packages: Callable[..., tuple[Path, object]], target: str) -> None:
    before = {name: sys.modules.get(name) for name in ("scipy", "scipy.integrate", "jax", "jax.numpy")}
    count = runtime.check(packages(target)[0], CHART, TARGETS[target].checks)
    assert count > 100
    assert {name: sys.modules.get(name) for name in before} == before


@pytest.mark.parametrize("what", ALTERED)
def test_altered_run_time_part_is_refused(packages: Callable[..., tuple[Path, Mapping[str, str]]], what: str) -> None:
    target, file, old, new, case = ALTERED[what]
    folder, texts = packages(target)
    assert old in texts[file]
    path = folder / file
    try:
        path.write_text(texts[file].replace(old, new), encoding="utf-8")
        with pytest.raises(ValidationFailed, match=f"^run-time parts, {case}"):
            runtime.check(folder, CHART, TARGETS[target].checks)
    finally:
        path.write_text(texts[file], encoding="utf-8")


LINE = 64  # size of a cache line and of the widest vector register, in bytes


@pytest.fixture(scope="module")
def part(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[[str], Any]]:
    """Yield a function that imports a run-time module of the NumPy target by name."""
    folder: Path = tmp_path_factory.mktemp("kernels")
    files.write(folder, shared_texts(TARGETS["numpy"]))
    with loaded(folder) as package:
        yield lambda name: importlib.import_module(f"{package}.{name}")


def test_rows_of_scratch_begin_on_a_cache_line(part: Callable[[str], Any]) -> None:
    kernel = part("_kernel")
    for size in (1, 63, 64, 1000, 100_000):
        scratch = kernel.Scratch()
        memory = scratch.take(size)
        assert memory.ctypes.data % LINE == 0
        assert memory.size >= size
        scratch.give_back(memory)
        assert scratch.take(size) is memory
    for dtype in map(np.dtype, (np.float32, np.float64, np.longdouble)):
        for cells in (1, 7, 8, 100, 16384):
            padded = kernel._padded(cells, dtype)
            assert padded >= cells
            assert padded * dtype.itemsize % LINE == 0


@pytest.mark.parametrize("shape", [(6,), (2, 3)])
def test_single_poses_are_read_with_components_first_or_last(part: Callable[[str], Any], shape: Any) -> None:
    last = np.arange(30.0).reshape(5, *shape)
    first = np.moveaxis(last, 0, -1)
    for array, axis in ((last, -1), (first, 0)):
        assert part("_runtime")._poses(array, shape, (5,), axis, array.dtype) == last.reshape(5, 6).tolist()


def test_dense_or_broadcast_rows_are_read_without_copying(part: Callable[[str], Any]) -> None:
    is_read, dtype = part("_kernel")._unit_stride, np.dtype(np.float64)
    dense, one = np.ones((6, 10)), np.broadcast_to(np.ones((6, 1)), (6, 10))
    spread, same = np.ones((6, 20))[:, ::2], np.broadcast_to(np.ones(20)[::2], (6, 10))
    for rows, wanted in ((dense, True), (one, True), (spread, False), (same, False), (dense.astype(np.float32), False)):
        assert is_read(rows, dtype, broadcast=True) is wanted
    assert [is_read(rows, dtype) for rows in (dense, one)] == [True, False]
