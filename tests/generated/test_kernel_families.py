"""Comparison of non-Cayley families with first principles, on floats, at angles from 0 to the edge."""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np
import pytest

from derive.about import FAMILIES
from derive.codegen.signatures import POSES
from dualcay import cayley3, exponential, orthographic
from dualcay._interface import PoseKernels
from dualcay._multiple import multiple
from tests.support import families, sampling

LEFT = (0.2, 0.1, 3e-2, 3e-3, 1e-4)  # distances from the edge, as shares of the edge angle
EDGES = [(name, LEFT[i % 5]) for i, name in enumerate(FAMILIES) if name != "exponential"]


@pytest.mark.parametrize(("name", "left"), EDGES)
def test_steps_next_to_an_edge_stay_within_gates(name: str, left: float):
    """Test steps at a distance from the edge of each chart.

    Next to an edge with φ′ = 0, x hardly determines the angle, and T is nearly singular. Next to a pole, the rounded
    angle hardly determines v: steps from this angle have errors of 0.2 eps over the share.
    """
    oracle, kernels = families.oracle_of(name), importlib.import_module(f"dualcay.{name}")
    angle, steps = families.edge_of(name) * (1 - left), sampling.dual_vectors(f"{name} {left}", count=2)
    v, delta = families.vectors(oracle, angle, angle, 2), steps * np.array([left] * 3 + [1] * 3)
    for function in families.STEPS:
        families.require(kernels, oracle, function, [v, delta])


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
def test_rotation_stays_orthogonal_at_any_angle(dtype: type):
    """Expect R Rᵀ = I to 16 eps of the type, even for an α with a rounding error of many turns."""
    sizes = 10.0 ** np.arange(0, 0.9 * np.log10(np.finfo(dtype).max) / 2)
    v = np.zeros((len(sizes), 6), dtype)
    v[:, :3] = sizes.astype(dtype)[:, None] * np.array([2, -3, 6], dtype) / 7
    R = exponential.tensor(v)[:, 0]
    off = abs(R @ R.swapaxes(1, 2) - np.eye(3, dtype=dtype)).max(axis=(1, 2))
    assert (off <= 16 * np.finfo(dtype).eps).all()


@pytest.mark.parametrize("base", [cayley3, orthographic], ids=lambda base: base.CHART.module)
def test_functions_of_a_multiple_are_those_of_its_base(base: ModuleType):
    """Take K = 3/2: arguments and results named v or v_… are K times those of the base; the edge is, too."""
    kernels, K = PoseKernels(multiple(base.CHART, "made", 3, 2, constant=(), programs="")), 1.5
    v, w, rates = np.array([0.1, -0.3, 0.2, 0.3, 2.0, -1.0]), np.array([0.02, 0.05, -0.01, 0.3, -0.2, 0.1]), np.eye(6)
    angle, line = base.to_screw(w)
    values = {
        **dict.fromkeys(("v", "v2"), v), **dict.fromkeys(("v1", "v0"), w), "v_dot": rates[1], "v_ddot": rates[2],
        "omega": rates[4], "omega_dot": rates[0], "w": w, "delta": w, "t": np.array(0.3), "angle": angle, "line": line,
        "q": base.quaternion(v), "R": base.tensor(v), "T": base.pose(v),
    }  # fmt: skip
    rows = [row for row in POSES.public.values() if values.keys() >= {array.name for array in row.arguments}]
    plain = ("v", "q", "w", "tensor", "pose", "moved", "omega", "angle", "line", "delta")
    rows = [row for row in rows if all(array.name.startswith(plain) for array in row.results)]
    assert len(rows) > 25
    for row in rows:
        given = [values[array.name] for array in row.arguments]
        scaled = [K * a if array.name.startswith("v") else a for a, array in zip(given, row.arguments, strict=True)]
        found, there = (getattr(one, row.name)(*at) for one, at in ((kernels, scaled), (base, given)))
        for array, one, other in zip(row.results, *(r if isinstance(r, tuple) else (r,) for r in (found, there))):
            scale = K if array.name.startswith("v") else 1
            np.testing.assert_allclose(one, scale * other, rtol=0, atol=1e-12, err_msg=row.name)
    beyond = np.array([0, 0, 1.01 * K, 0, 0, 0])
    assert np.isfinite(kernels.principal(beyond)).all() == (base is cayley3)
