"""Switch of branches with rate and covariance, and its event."""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import dualcay
from dualcay import _switching, switch_event

NAMES = ("cayley2", "cayley3", "cayley5", "exponential", "sine4", "scaled3", "wiener_milenkovic")
EPS = np.finfo(float).eps


def charts(table: str = "") -> list[ModuleType]:
    return [importlib.import_module(".".join(filter(None, ("dualcay", table, name)))) for name in NAMES]


def on_shadows(module: ModuleType, count: int = 6) -> np.ndarray:
    """Return vectors with angles from 0.5 to 5.5 on their own branch."""
    w = dualcay.exponential.random(count, max_angle=1.0, rng=3)
    w *= (np.linspace(0.5, 5.5, count) / np.linalg.norm(w[:, :3], axis=-1))[:, None]
    return module.from_exponential(w if len(module.identity()) == 6 else w[:, :3])


@pytest.mark.parametrize("table", ["", "rotation"])
def test_a_switch_keeps_pose_and_twist_and_carries_the_covariance(table: str) -> None:
    """Compare with the shadow's Jacobian, row by row; both lose digits by the condition of T, below 1e4 here."""
    for module in charts(table):
        v, rng = on_shadows(module), np.random.default_rng(0)
        n = v.shape[-1]
        v_dot, root = rng.normal(size=v.shape), rng.normal(size=(len(v), n, n))
        P = root @ root.swapaxes(-1, -2)
        moved, rate, spread = module.switch(v, v_dot, P)
        np.testing.assert_array_equal(moved, module.principal(v))
        for i, (x, y) in enumerate(zip(v, moved, strict=True)):
            if np.array_equal(x, y):
                assert np.array_equal(rate[i], v_dot[i])
                assert np.array_equal(spread[i], P[i])
                continue
            branch = 1 if np.allclose(module.shadow(x, 1), y) else -1
            J = module.shadow_jacobian(x, branch)
            np.testing.assert_allclose(rate[i], J @ v_dot[i], rtol=0, atol=1e5 * EPS * abs(J).max())
            wanted = J @ P[i] @ J.T
            np.testing.assert_allclose(spread[i], wanted, rtol=0, atol=1e4 * EPS * abs(wanted).max())
        first = module.switch(v.T, v_dot.T, np.moveaxis(P, 0, -1), axis=0)
        np.testing.assert_allclose(np.moveaxis(first[2], -1, 0), spread, rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(first[1].T, rate, rtol=1e-12, atol=1e-12)


def test_arguments_that_need_no_switch_are_returned() -> None:
    for module in (*charts(), dualcay.cayley1):
        v, P = module.random(4, max_angle=3.0, rng=1), np.broadcast_to(np.eye(6), (4, 6, 6))
        found = module.switch(v, v, P)
        assert [a is b for a, b in zip(found, (v, v, P), strict=True)] == [True] * 3
        assert module.switch(v) is v
        v[0] = np.nan
        for got, given in zip(module.switch(v, np.ones_like(v)), (v, np.where(np.isnan(v), v, 1)), strict=True):
            np.testing.assert_array_equal(got, given)
    assert np.isnan(dualcay.cayley1.switch(np.full(6, np.inf), np.ones(6))[1]).all()  # a chart with one branch too
    with pytest.raises(ValueError, match=r"covariance must have shape \(..., 6, 6\), got \(6,\)"):
        dualcay.cayley2.switch(np.zeros(6), covariance=np.zeros(6))


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
@pytest.mark.parametrize("table", ["", "rotation"])
def test_covariances_that_are_not_symmetric_are_refused(table: str, dtype: type) -> None:
    """Rounding errors pass, also those of a switch; errors of a single pair, in one of many matrices, do not."""
    for module in charts(table):
        v, n = on_shadows(module).astype(dtype), len(module.identity())
        root = np.random.default_rng(2).normal(size=(len(v), n, n)).astype(dtype)
        P = root @ root.swapaxes(-1, -2)
        rounded = P * (1 + np.triu(np.full((n, n), 8 * np.finfo(dtype).eps, dtype)))
        moved, spread = module.switch(v, covariance=rounded)
        assert module.switch(moved, covariance=spread)[0] is moved
        gap = P.copy()
        gap[1, 0, 1] = np.nan
        assert module.switch(v, covariance=gap)[1].shape == P.shape
        for size in (1.0, 1e5 * np.finfo(dtype).eps * abs(P).sum()):
            P = rounded.copy()
            P[3, n - 1, 1] += dtype(size)
            for given, axis in ((P, -1), (np.moveaxis(P, 0, -1), 0)):
                with pytest.raises(ValueError, match=r"^covariance must be symmetric, got entries that differ by "):
                    module.switch(v if axis else v.T, covariance=given, axis=axis)
    with pytest.raises(ValueError, match=r"got entries that differ by 1$"):
        module.switch(v[0], covariance=np.tri(n))


def test_the_covariance_at_an_mrp_switch_is_the_closed_form() -> None:
    """Compare with 2 σσᵀ/|σ|⁴ − I/|σ|², away from |σ| = 1 where a shorter formula holds by chance."""
    s, P = np.array([0.9, -0.8, 0.4]), np.diag([1.0, 2.0, 3.0])
    x = s @ s
    J = 2 * np.outer(s, s) / x**2 - np.eye(3) / x
    found = dualcay.rotation.cayley2.switch(s, covariance=P)[1]
    np.testing.assert_allclose(found, J @ P @ J.T, rtol=50 * EPS)
    wrong = 2 * np.outer(s, s) - np.eye(3)  # control: the formula for |σ| = 1
    assert not np.allclose(found, wrong @ P @ wrong.T, rtol=0.1)


@pytest.mark.parametrize("name", NAMES)
def test_the_event_stops_three_turns_before_every_singular_angle(name: str) -> None:
    module = getattr(dualcay, name)
    omega, t0, y0, times = np.array([0.2, 1.0, -0.1, 0.1, 0, 0.3]), 0.0, np.zeros(7), []
    event, end = switch_event(module, slice(1, 7)), 6 * np.pi
    while True:
        piece = solve_ivp(
            lambda t, y: np.concatenate([[1], module.rate(y[1:], omega)]), (t0, end), y0,
            events=event, max_step=1.0, rtol=1e-10, atol=1e-12, method="DOP853",
        )  # fmt: skip
        if piece.status != 1:
            break
        t0, y0 = piece.t[-1], piece.y[:, -1]
        y0[1:] = module.switch(y0[1:])
        times.append(t0)
    size = np.linalg.norm(omega[:3])
    np.testing.assert_allclose(np.array(times) * size, np.pi * np.array([1.5, 3.5, 5.5]), rtol=1e-8)
    wanted = dualcay.exponential.tensor(omega * end)
    np.testing.assert_allclose(module.tensor(piece.y[1:, -1]), wanted, rtol=0, atol=1e-8)


def test_the_event_of_a_controller_stops_at_half_a_turn_and_refuses_a_start_beyond() -> None:
    mrp, omega, t, times = dualcay.rotation.cayley2, np.array([0.2, 1.0, -0.1]), 0.0, []
    event, y = switch_event(mrp, angle=np.pi), np.zeros(3)
    for _ in range(3):
        piece = solve_ivp(lambda t, y: mrp.rate(y, omega), (t, 20.0), y, events=event, max_step=1.0, rtol=1e-10)
        assert np.linalg.norm(piece.y, axis=0).max() < 1 + 1e-6
        t, y = piece.t[-1], mrp.switch(piece.y[:, -1])
        times.append(t * np.linalg.norm(omega) / np.pi)
    np.testing.assert_allclose(times, [1, 3, 5], rtol=1e-5)
    start = mrp.from_angle_axis(5.0, [1.0, 0, 0])
    with pytest.raises(ValueError, match=r"v starts beyond the angle 4.71239 of the event, at t = 0: switch it first"):
        solve_ivp(lambda t, y: mrp.rate(y, omega), (0, 9.0), start, events=switch_event(mrp))
    assert switch_event(mrp)(0.0, mrp.from_exponential([_switching.switch_angle(mrp), 0, 0])) == 0  # not beyond
    for angle in (3.0, 2 * np.pi, 6.3):
        with pytest.raises(ValueError, match=r"angle must be from π to below 6\.28319"):
            switch_event(mrp, angle=angle)


def test_charts_singular_at_half_a_turn_have_no_event() -> None:
    for module in (dualcay.cayley1, dualcay.orthographic):
        with pytest.raises(ValueError, match=r"is singular at the angle 3.14159, where no other branch helps"):
            switch_event(module)
