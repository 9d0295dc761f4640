"""Conditions that the keyword ``check`` requires, by NumPy's linear algebra, and arguments that violate them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from dualcay import cayley3, rotation

KERNELS: dict[str, ModuleType] = {"poses": cayley3, "rotations": rotation.cayley3}

REFUSALS = {
    ("poses", "from_pose"): "T is no homogeneous matrix of a rotation and a translation",
    ("poses", "from_quaternion"): "q is no unit dual quaternion",
    ("poses", "from_tensor"): "R is no orthogonal dual tensor of determinant 1",
    ("poses", "from_screw"): "line is no unit dual vector",
    ("rotations", "from_quaternion"): "q is no unit quaternion",
    ("rotations", "from_tensor"): "R is no orthogonal matrix of determinant 1",
    ("rotations", "from_angle_axis"): "u is no unit vector",
}
"""Beginning of a refusal, by kernels and function."""

WITH_ANGLE = {"from_screw": [0.3, 0.0], "from_angle_axis": 0.3}
"""Angles for functions that take one beside the argument that they check."""


def right(kernels: str, name: str, v: np.ndarray) -> np.ndarray:
    """Return the arguments that an inverse map checks, for vectors of cayley3."""
    way = getattr(KERNELS[kernels], name.replace("from_", "to_" if name in WITH_ANGLE else ""))
    found = way(v if kernels == "poses" else v[..., :3])
    return np.asarray(found[1] if name in WITH_ANGLE else found)


def way_back(module: ModuleType, name: str) -> Callable[..., Any]:
    """Return an inverse map as a function of the argument that it checks; those with an angle get 0.3."""
    function: Callable[..., Any] = getattr(module, name)
    if name not in WITH_ANGLE:
        return function

    def from_line(line: Any, **given: Any) -> Any:
        angle = np.array(WITH_ANGLE[name], np.result_type(np.asarray(line), np.float32))
        return function(angle, line, **given)

    return from_line


def residues(x: np.ndarray) -> dict[str, Any]:
    """Return the violations of the condition of an argument, by their words."""
    if x.shape in ((3,), (4,)):
        return {"its square is not 1": x @ x - 1}
    if x.ndim == 1:
        real, dual = ("real part", "dual part") if len(x) == 8 else ("direction", "moment")
        a, b = np.split(x, 2)
        across = a @ b / (1 + abs(b).sum())
        return {
            f"the square of its {real} is not 1": a @ a - 1,
            f"its {dual} is not perpendicular to its {real}": across,
        }
    Q = x[0] if x.ndim == 3 else x[:3, :3]
    found: dict[str, Any] = {"Q Qᵀ is not I": Q @ Q.T - np.eye(3), "det Q is not 1": np.linalg.det(Q) - 1}
    if x.ndim == 3:
        moved = x[1] @ Q.T
        found["its dual part times Qᵀ is not skew"] = (moved + moved.T) / (1 + abs(x[1]).sum())
    if x.shape == (4, 4):
        found["its last row is not [0, 0, 0, 1]"] = x[3] - [0, 0, 0, 1]
    return found


def altered(x: np.ndarray) -> Iterator[np.ndarray]:
    """Yield zeros, a multiple, reflections, and arguments with one entry off, or one NaN in a multiple."""
    yield from (0 * x, 2 * x)
    for row in range(3) if x.ndim > 1 else ():
        reflected = x.copy()
        reflected[..., row, :3] *= -1
        yield reflected
    for place in np.ndindex(x.shape):
        off, unknown = x.copy(), 2 * x
        off[place], unknown[place] = off[place] + 0.3, np.nan
        yield from (off, unknown)


@np.errstate(all="ignore")  # of determinants and of singular values
def assert_refused(
    module: ModuleType, kernels: str, name: str, x: np.ndarray, axis: int, taken: Callable[[Any], Any] = np.asarray
) -> None:
    """Require that ``check`` names the first wrong element of a batch, its largest violation and the words for it.

    This violation is allowed if ``check`` is it, but for rounding.
    """
    function, (argument, noun) = way_back(module, name), REFUSALS[kernels, name].split(" ", 1)
    for wrong in altered(x):
        found = {words: abs(residue).max() for words, residue in residues(wrong).items()}
        words = max(found, key=lambda one: np.nan_to_num(found[one], nan=np.inf))
        if found[words] < 1e-8:
            continue  # no condition limits the position of a pose
        batch = np.array([[x, x, x], [x, wrong, 9 * x]])
        batch = np.moveaxis(batch, (0, 1), (-2, -1)) if axis == 0 else batch
        said = f" {noun}: {words}, off by {found[words]:.2g} (allowed "
        for given, place in ((batch, "[..., 1, 1]" if axis == 0 else "[1, 1]"), (wrong, "")):
            with pytest.raises(ValueError, match="^" + re.escape(f"{argument}{place}{said}")):
                function(taken(given), axis=axis, check=True)
        if np.isfinite(found[words]):
            function(taken(wrong), axis=axis, check=(1 + 1e-9) * found[words])
            with pytest.raises(ValueError, match=re.escape(said)):
                function(taken(wrong), axis=axis, check=(1 - 1e-9) * found[words])
