"""Motions at the ends of charts and numbers, from twists of every form, and copied into other processes."""

from __future__ import annotations

import copy
import pickle
import sys
import time
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import dualcay
from dualcay import MotionError, _stepping, cayley2, exponential, lambert, propagate
from tests.support import motions, sampling, thorough

EDGED = {"orthographic": 1.0, "lambert": 1.0, "sine3": 1.0, "sine4": 1.0}
"""Largest |v| by chart."""

OMEGA = np.array([0.3, 0.8, -0.5, 0.4, -0.2, 0.6])
TIMES = np.linspace(0.0, 4.0, 6)
FORMS = [(frame, method) for frame in ("space", "body") for method in ("lie", "chart")]


@pytest.mark.parametrize(("name", "frame", "method"), thorough.in_turn(EDGED, ("space", "body"), ("lie", "chart")))
def test_a_start_beyond_the_edge_or_that_overflows_is_named_at_once(name: str, frame: str, method: str) -> None:
    module, edge, begin = getattr(dualcay, name), EDGED[name], time.process_time()
    for real, dual in ((1.1, 0.0), (1 + 1e-12, 0.1), (1e78, 0.0), (1e200, 1.0)):
        v0 = [real * edge * 0.6, -real * edge * 0.8, 0, dual, dual, dual]
        with pytest.raises(ValueError, match=r"v0 must .*within the edge .* got the real length"):
            propagate(module, v0, OMEGA, [0, 1], frame=frame, method=method)
    assert time.process_time() - begin < 5
    inside = propagate(module, [0.5 * edge, 0, 0, 1, 2, 3], OMEGA, [0, 1], frame=frame, method=method)
    assert np.isfinite(inside.v).all()


@pytest.mark.parametrize(("frame", "method"), FORMS)
def test_a_motion_that_overflows_or_does_not_end_says_when(frame: str, method: str) -> None:
    def grows(t: float) -> list[float]:
        return [0.1, 0, 0, 1e300 if t > 0.5 else 1.0, 0, 0]

    for twist in ([1e308, 1e308, 0, 0, 0, 0], [1e160] * 6, [0, 0, 0, 1.7e308, 1.7e308, 1.7e308], grows):  # all finite
        given = twist if callable(twist) else lambda t, twist=twist: twist
        with pytest.raises(MotionError, match=r"not finite at t = |no step is small enough at t = "):
            propagate(lambert, [0.1, 0, 0, 1, 2, 3], given, [0, 1], frame=frame, method=method)
    said = r"the pose is not finite at t = 0\.8" if method == "lie" else "no step is small enough at t = 0"
    with pytest.raises(MotionError, match=said):
        propagate(lambert, [0.3, -0.4, 0, *[8.5e307] * 3], OMEGA, [0, 20], frame=frame, method=method)
    with pytest.raises(MotionError, match=r"the rate of v is not finite at t = 0$"):
        propagate(cayley2, [0.3, -0.4, 0, 1, 2, 3], lambda t: [1.7e308] * 6, [0, 1], method="chart")


SIDED = ("cayley2", "cayley3", "cayley8", "exponential", "lambert", "breusing", "sine3", "wiener_milenkovic")


@pytest.mark.parametrize(("name", "frame", "method"), thorough.in_turn(SIDED, ("space", "body"), ("lie", "chart")))
def test_a_motion_from_half_a_turn_keeps_its_side_and_has_the_branches_of_shadow(
    name: str, frame: str, method: str
) -> None:
    """Start with v and with poses whose scalar part is 0 within rounding; the turn grows, shrinks, or changes axis."""
    module, matrix = getattr(dualcay, name), np.eye(4)
    for place, u in enumerate(sampling.unit_vectors(sampling.generator("sides", name), (8,))):
        matrix[:3] = np.c_[2 * np.outer(u, u) - np.eye(3), [1.0, -2, 3]]
        v0 = module.from_pose(matrix) if place % 2 else module.from_quaternion([0, *u, 0, *np.cross(u, [1.0, 2, 3])])
        v0[:3] *= 1 + (place - 4) * 2.0**-52
        motion = propagate(module, v0, [*(0.3 * u - 0.1), *u], [0, 1e-9, 2, 4], frame=frame, method=method)
        np.testing.assert_allclose(motion.v[0], v0, rtol=0, atol=1e-13 * (1 + v0 @ v0))
        back = [module.shadow(module.principal(v), int(k)) for v, k in zip(motion.v, motion.branch, strict=True)]
        np.testing.assert_allclose(back, motion.v, rtol=0, atol=1e-10 * (1 + abs(motion.v).max() ** 2))
        np.testing.assert_allclose(module.pose(motion.v), motion.pose, rtol=0, atol=1e-9)


def test_components_are_finite_one_by_one() -> None:
    for index in range(6):
        wrong = np.where(np.arange(6) == index, np.nan, 0.1)
        with pytest.raises(ValueError, match="v0 must be finite, got nan"):
            propagate(cayley2, wrong, OMEGA, [0, 1])
        with pytest.raises(MotionError, match=r"twist must be finite, got nan in it at t = "):
            propagate(cayley2, np.zeros(6), lambda t, wrong=wrong: wrong if t else OMEGA, [0, 1])


def test_one_twist_is_constant_as_its_function_and_its_samples_are() -> None:
    given: tuple[Any, ...] = (OMEGA, [*OMEGA], lambda t: OMEGA, np.tile(OMEGA, (6, 1)))
    for frame, method in FORMS:
        found = [propagate(cayley2, np.zeros(6), twist, TIMES, frame=frame, method=method) for twist in given]
        for one in found:
            np.testing.assert_allclose(one.pose, exponential.pose(np.outer(TIMES, OMEGA)), rtol=0, atol=1e-8)
            np.testing.assert_allclose(one(0.7, 2), found[2](0.7, 2), rtol=0, atol=1e-8)
    for wrong in (np.zeros(5), np.zeros((5, 6)), 1.0):
        with pytest.raises(ValueError, match=r"twist must have shape \(6, 6\), got .* a constant one has \(6,\)"):
            propagate(cayley2, np.zeros(6), wrong, TIMES)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (np.zeros(3), r"shape \(6,\), got \(3,\)"),
        (np.zeros((1, 6)), r"shape \(6,\), got \(1, 6\)"),
        (1.0, r"shape \(6,\), got \(\)"),
        ([1.0, [2.0]], r"shape \(6,\), got rows of several shapes"),
        (OMEGA * 1j, "real numbers, got dtype complex128"),
        (["1"] * 6, "real numbers, got dtype <U1"),
        (None, "real numbers, got dtype object"),
    ],
    ids=str,
)
def test_a_wrong_twist_on_the_way_is_named_with_its_time(value: Any, message: str) -> None:
    with pytest.raises(MotionError, match=rf"twist must (have|hold) {message} at t = [12]") as caught:
        propagate(cayley2, np.zeros(6), lambda t: OMEGA if t < 1 else value, [0, 0.5, 2])
    assert caught.value.time >= 1
    assert caught.value.motion.t[1] == 0.5
    with pytest.raises((ValueError, TypeError), match=f"twist at the first time must (have|hold) {message}"):
        propagate(cayley2, np.zeros(6), lambda t: value, [0, 2])


def test_starts_near_a_whole_turn_and_indefinite_covariances_are_refused() -> None:
    for off in (-1e-10, 1e-12, 1e-10):
        with pytest.raises(ValueError, match="v0 must not be on the singular set"):
            propagate(exponential, [2 * np.pi + off, 0, 0, 0, 0, 0], OMEGA, [0, 1])
    propagate(exponential, [2 * np.pi - 1e-8, 0, 0, 0, 0, 0], OMEGA, [0, 1])
    rounded = {"covariance": np.outer(np.arange(6) / 3, np.arange(6) / 3), "noise": np.diag([1, 2, 3, 4, 5, -1e-15])}
    propagate(cayley2, np.zeros(6), OMEGA, [0, 1], **rounded)
    for least in (-0.5, -1e-6):
        for name in ("covariance", "noise"):
            with pytest.raises(ValueError, match=f"{name} must be positive semidefinite, got the eigenvalue {least:g}"):
                propagate(cayley2, np.zeros(6), OMEGA, [0, 1], **{name: np.diag([1.0, 2, 3, 4, 5, least])})


def test_a_twist_is_called_within_the_span() -> None:
    begin, end, called = 0.1, 0.7, list[float]()

    def twist(t: float) -> np.ndarray:
        called.append(t)
        return np.cos(t) * OMEGA

    for method in ("lie", "chart"):
        motion = propagate(cayley2, np.zeros(6), twist, [begin, end], method=method)
        for order in (1, 2):
            motion(np.linspace(begin, end, 101), order)
    assert (min(called), max(called)) == (begin, end)


def test_tolerances_follow_the_translation() -> None:
    """Count the calls of a twist far from the origin: with the tolerance of the start, steps are far smaller there."""

    def calls(jump: float) -> int:
        times: list[float] = []

        def twist(t: float) -> np.ndarray:
            times.append(t)
            return np.array([0.5, 0.3, -0.4, jump * (t < 1), 0, 0])

        propagate(cayley2, np.zeros(6), twist, [0, 30], frame="body", max_step=1.0)
        return sum(t > 2 for t in times)

    assert calls(1e9) < 1.3 * calls(0.0)


def test_steps_keep_both_parts_of_the_unit_quaternion() -> None:
    q, centre = cayley2.quaternion([[0.2, -0.3, 0.1, 1, 2, 3], [0.4, 0.1, -0.2, 3, -1, 2]])
    off = [*(1.1 * q[:4]), *(1.1 * q[4:] + 0.2 * q[:4])]  # by 1.1 + 0.2 ε
    for frame in ("space", "body"):
        found, wanted = (_stepping.displaced(np, frame, local, centre) for local in (off, q))
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-14)


COPIES: list[Callable[[Any], Any]] = [copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))]


@pytest.mark.parametrize("twist", [motions.space_twist, OMEGA], ids=["function", "constant"])
@pytest.mark.parametrize(("frame", "method"), FORMS)
def test_copied_motions_are_the_same(twist: Any, frame: str, method: str) -> None:
    motion = propagate(cayley2, np.zeros(6), twist, TIMES, frame=frame, method=method, covariance=np.eye(6))
    for other in (copied(motion) for copied in COPIES):
        for name in ("t", "v", "pose", "branch", "switches", "covariance"):
            np.testing.assert_array_equal(getattr(other, name), getattr(motion, name))
        for order in range(3):
            np.testing.assert_array_equal(other(TIMES / 2, order), motion(TIMES / 2, order))


def test_a_lambda_is_kept_by_copies_and_left_out_by_pickle() -> None:
    motion = propagate(cayley2, np.zeros(6), lambda t: OMEGA, TIMES)
    np.testing.assert_array_equal(copy.deepcopy(motion)(1.0, 2), motion(1.0, 2))
    loaded = pickle.loads(pickle.dumps(motion))
    for one in (loaded, pickle.loads(pickle.dumps(loaded))):
        np.testing.assert_array_equal(one(1.0), motion(1.0))
        for order in (1, 2):
            with pytest.raises(MotionError, match=r"the twist <function .*<lambda> .* was not saved .* only order=0"):
                one(1.0, order)


def test_errors_keep_their_motion_when_copied() -> None:
    with pytest.raises(MotionError) as caught:
        propagate(cayley2, np.zeros(6), lambda t: OMEGA if t < 1 else OMEGA * np.nan, TIMES)
    for one in (copied(caught.value) for copied in COPIES):
        assert (str(one), one.time) == (str(caught.value), caught.value.time)
        np.testing.assert_array_equal(one.motion(0.5), caught.value.motion(0.5))


def test_motions_are_loaded_where_their_twist_is_not_known(monkeypatch: pytest.MonkeyPatch) -> None:
    """Save a twist of a module, which another process may not have."""
    monkeypatch.setattr(twist, "__module__", "elsewhere")
    monkeypatch.setitem(sys.modules, "elsewhere", SimpleNamespace(twist=twist))
    saved = pickle.dumps(propagate(cayley2, np.zeros(6), twist, [0, 1]))
    monkeypatch.delitem(sys.modules, "elsewhere")
    loaded = pickle.loads(saved)
    np.testing.assert_array_equal(loaded(1.0), loaded.v[-1])
    with pytest.raises(MotionError, match=r"^the twist <function twist at 0x"):
        loaded(0.5, 1)


def twist(t: float) -> np.ndarray:
    return np.arange(6.0)
