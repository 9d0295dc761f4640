"""Run-time parts written by hand: each alteration of their formulas is refused before a package is written."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from derive.codegen import ValidationFailed
from derive.codegen.targets import TARGETS
from derive.codegen.validation import runtime
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
        "numpy", "_propagate.py", "(math.pi < angle and not switched)", "(math.pi < angle)",
        "propagate, chart, space: switches",
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
        "numpy", "_sequences.py", "(along - angle) / (2 * pi)", "(along + angle) / (2 * pi)", "unwrap of 6 components",
    ),
    "ways through a sequence": (
        "numpy", "_sequences.py", "better = total < costs", "better = total > costs", "unwrap of 6 components",
    ),
    "Cayley map of 4x4": ("numpy", "_other_vectors.py", "scale**2 + (real", "scale**2 - (real", "to_cayley_4x4"),
    "position for ROS": (
        "numpy", "interop.py", "np.cross(position, vector)", "np.cross(vector, position)", "from_ros, component 3",
    ),
    "fraction of a multiple": (
        "numpy", "_multiple.py", "value * divisor.denominator / divisor.numerator",
        "value * divisor.numerator / divisor.denominator", "switch_event of a multiple",
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
    "rule for JAX": ("array-api", "_jax.py", "at.moved(-v1, at.twist", "at.moved(v1, at.twist", "rule of between of 6"),
    "scalars beside the rules": ("array-api", "_jax.py", "(1 - f) / xx", "(2 - f) / xx", "pose_scalars"),
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
