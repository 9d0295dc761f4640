"""Splines of poses beside other truths: 50 digits, the theorem on their parts, and classical splines."""

from __future__ import annotations

import functools
import importlib
from typing import Any

import numpy as np
import pytest
import sympy
from mpmath import mp
from scipy.interpolate import BSpline, CubicSpline

from derive.proof import spline_theorems
from dualcay import PoseSpline, cayley1, cayley2, exponential
from dualcay._curve import Curve, Group
from tests.support import families
from tests.support.errors import close

EPS = np.finfo(float).eps
NAMES = ("cayley1", "cayley2", "cayley5", "exponential", "lambert", "scaled2")
ROWS = [("interpolating", "natural"), ("interpolating", "clamped"), ("interpolating", "periodic"),
        ("bspline", "natural"), ("bspline", "periodic")]  # fmt: skip
T = np.array([0, 0.7, 1.5, 2.9, 3.4, 4.6, 5.5])  # s


@pytest.mark.parametrize("angle", [0, 1e-9, 1e-4, 0.9])
@pytest.mark.parametrize("name", NAMES)
def test_motion_and_jacobians_agree_with_50_digits(name: str, angle: float) -> None:
    """Compare one span with the oracle; its differences by steps of 1e-10 have errors near 1e-20."""
    oracle, module, h = families.oracle_of(name, 60), importlib.import_module(f"dualcay.{name}"), mp.mpf(2) ** -33
    knots, t = [-3.0, -1.5, -1, 0, 1.5, 2, 3, 3.5], 0.7
    rng = np.random.default_rng(8)
    v, steps = module.random(4, max_angle=angle, rng=rng), rng.normal(size=(4, 6))

    def part(k: int, time: Any) -> Any:
        """Return λ by cubes of distances from knots, as the theorem on parts has them."""
        near = [mp.mpf(knot) for knot in knots[k : k + 4]]
        return sum(max(time - a, 0) ** 3 / mp.fprod(b - a for b in near if b != a) for a in near)

    def motion(s: Any) -> list[np.ndarray]:
        """Return the vector, body twist and body acceleration after steps s of the control poses."""
        moved = [oracle.body_retract(one, s * step) for one, step in zip(v, steps)]
        d = [oracle.between(*pair) for pair in zip(moved[1:], moved)]

        def at(time: Any) -> np.ndarray:
            factors = (part(k, time) * one for k, one in enumerate(d, 1))
            return functools.reduce(oracle.compose, factors, moved[0])

        here = at(mp.mpf(t))
        ahead, back = (oracle.body_local(at(t + side * h), here) for side in (1, -1))
        return [here, (ahead - back) / (2 * h), (ahead + back) / h**2]

    with mp.workdps(60):
        there, ahead, back = motion(0), motion(h), motion(-h)
        differences = oracle.body_local(ahead[0], back[0]), *(a - b for a, b in zip(ahead[1:], back[1:], strict=True))
        slopes = [difference / (2 * h) for difference in differences]
    spline = PoseSpline(module, knots, v, kind="bspline")
    J = spline.jacobians(t)
    found_blocks = J.pose, J.twist, J.acceleration
    for found, wanted in (
        (spline.twist(t, "body"), there[1]), (spline.acceleration(t, "body"), there[2]),
        *((np.einsum("kij,kj->i", blocks, steps), slope) for blocks, slope in zip(found_blocks, slopes)),
    ):  # fmt: skip
        close(found, wanted.astype(float), 1e3 * EPS)


def test_parts_are_those_of_the_theorem() -> None:
    """Build the data of a span with symbols as knots; the theorem states that its parts are C²."""
    knots, t = sympy.symbols("k:8"), sympy.Symbol("t")
    empty = np.zeros((4, 6), object)
    ((*row,),) = Curve(Group(cayley2), np.array(knots), np.eye(4)[None].repeat(4, 0).astype(object), empty[1:]).spans.T
    for k, piece in zip((2, 1, 0), spline_theorems.pieces()):
        there = piece.subs(zip(spline_theorems.KNOTS, knots[k + 1 : k + 5]), simultaneous=True)
        polynomial = sum(c * (row[0] * (t - knots[3])) ** power for power, c in enumerate(row[1 + 4 * k : 5 + 4 * k]))
        assert sympy.cancel(polynomial - there) == 0


@pytest.mark.parametrize("row", ROWS)
def test_where_poses_commute_the_spline_is_the_classical_one(row: tuple[str, str]) -> None:
    """Compare translations in any chart, and turns about one axis in exponential coordinates, with SciPy."""
    x = np.array([0, 1.3, 0.4, 2, 1.1, -0.5, 0])
    ends = {"natural": "natural", "periodic": "periodic", "clamped": ((1, 0.6), (1, -0.4))}[row[1]]
    whole = np.pad(T, 3, mode="edge")
    t = np.linspace(T[0], T[-1], 50)
    for module, part in ((cayley1, 3), (cayley2, 5), (exponential, 0)):
        v = np.outer(x, np.eye(6)[part])
        scale = module.from_exponential(np.eye(6)[part])[part]
        twists = np.outer([0.6, -0.4], np.eye(6)[part]) if row[1] == "clamped" else None
        truth: Any
        if row[0] == "interpolating":
            found = PoseSpline(module, T, scale * v, boundary=row[1], twists=twists)
            truth = CubicSpline(T, x, bc_type=ends)
        elif row[1] == "periodic":
            found = PoseSpline(module, T, scale * v[:-1], kind="bspline", boundary="periodic")
            around = np.concatenate([T[-4:-1] - T[-1], T, T[1:4] + T[-1]])
            truth = BSpline(around, x[[5, 0, 1, 2, 3, 4, 5, 0, 1]], 3)
        else:
            found = PoseSpline(module, T, scale * np.vstack([v, v[:2]]), kind="bspline")
            truth = BSpline(whole, [*x, *x[:2]], 3)
        for order, values in enumerate((found(t) / scale, found.twist(t), found.acceleration(t))):
            close(values[:, part], truth(t, order), 1e-12)
    knots = np.array([-3.0, -2, -1, 0, 0.5, 1.5, 2, 3, 4, 4.5, 6])
    found = PoseSpline(cayley2, knots, 0.3 * v, kind="bspline")
    np.testing.assert_allclose(found.knots, knots[3:-3])
