"""Motions under a given twist: poses, branches, derivatives, covariances and errors."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import dualcay
from dualcay import MotionError, cayley2, exponential, propagate
from tests.support import motions, thorough

NAMES = ("cayley1", "cayley2", "cayley3", "cayley5", "exponential")
FRAMES, METHODS = ("space", "body"), ("lie", "chart")
OMEGA = np.array([0.3, 0.8, -0.5, 0.4, -0.2, 0.6]) / np.sqrt(0.98)  # constant twist of one radian per second

START = np.array([0.4, -1.0, 0.7, 0.3, 2.0, -1.0])  # exponential coordinates of a pose


def steady(t: float) -> tuple[float, ...]:
    return tuple(OMEGA)


def matrix(omega: np.ndarray) -> np.ndarray:
    """Return the 4x4 matrix of a twist."""
    found = np.zeros((4, 4))
    found[:3, :3] = np.cross(np.eye(3), omega[:3])
    found[:3, 3] = omega[3:]
    return found


def turned(pose: np.ndarray, t: np.ndarray, frame: str) -> np.ndarray:
    """Return the poses after a constant twist by the matrix exponential."""
    steps = np.array([expm(matrix(OMEGA) * one) for one in t])
    return steps @ pose if frame == "space" else pose @ steps


@pytest.mark.parametrize(("name", "method"), thorough.in_turn(NAMES, METHODS))
def test_three_turns_agree_with_the_matrix_exponential(name: str, method: str) -> None:
    """Allow 1e-8: steps at rtol = 1e-10 number below 100. Vectors lose digits with their distance to the pole."""
    module, t = getattr(dualcay, name), np.linspace(0, 6 * np.pi, 12)
    for frame, v0 in zip(FRAMES, (np.zeros(6), module.from_exponential(START)), strict=True):
        found = propagate(module, v0, steady, t, frame=frame, method=method)
        np.testing.assert_allclose(found.pose, turned(module.pose(v0), t, frame), rtol=0, atol=1e-8)
        near = abs(module.angle(found.v)[:, 0]) < 2.9 if name == "cayley1" else np.full(12, True)
        np.testing.assert_allclose(module.pose(found.v[near]), found.pose[near], rtol=0, atol=1e-12)
        assert len(found.switches) == 3
        assert (np.diff(found.switches) > np.pi).all()
        np.testing.assert_allclose(found.v[0], v0, rtol=0, atol=1e-14)


@pytest.mark.parametrize("frame", FRAMES)
@pytest.mark.parametrize("method", METHODS)
def test_a_tumbling_body_is_where_its_closed_form_is(method: str, frame: str) -> None:
    t = np.linspace(0, 6, 40)
    v0 = cayley2.from_pose(motions.pose(0))
    found = propagate(cayley2, v0, motions.TWISTS[frame], t, frame=frame, method=method, rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(found.pose, [motions.pose(one) for one in t], rtol=0, atol=1e-8)
    coarse = propagate(cayley2, v0, motions.TWISTS[frame], t, frame=frame, method=method, rtol=1e-4, atol=1e-5)
    assert abs(coarse.pose - found.pose).max() > 1e-7  # control: the tolerance matters


@pytest.mark.parametrize("integrator", ["RK45", "RK23"])
def test_other_methods_of_runge_and_kutta_converge(integrator: str) -> None:
    t = np.linspace(0, 2, 5)
    errors = []
    for rtol in (1e-4, 1e-7):
        found = propagate(cayley2, np.zeros(6), motions.space_twist, t, rtol=rtol, atol=rtol, integrator=integrator)
        errors.append(abs(found.pose - [motions.pose(one) for one in t]).max())
    assert errors[0] < 1e-2
    assert errors[1] < 1e-5


@pytest.mark.parametrize(("name", "method"), thorough.in_turn(NAMES[1:], METHODS))
def test_vectors_are_continuous_between_switches_with_their_derivatives(name: str, method: str) -> None:
    """Compare derivatives with central differences of step 1e-4: error 1e-8 by order, 1e-10/1e-4 by tolerance."""
    module = getattr(dualcay, name)
    for frame, twist in motions.TWISTS.items():
        spun: Callable[[float], Any] = lambda t, twist=twist: twist(t) + 3 * OMEGA  # noqa: E731
        found = propagate(module, module.from_exponential(START), spun, [0, 4, 9], frame=frame, method=method)
        edges = np.array([0, *found.switches, 9])
        assert len(found.switches) > 0
        assert abs(found(found.switches - 1e-9) - found(found.switches)).max() > 0.1  # v jumps at a switch
        for begin, end in pairwise(edges):
            t = np.linspace(begin + 2e-3, end - 2e-3, 50)
            for order in (1, 2):
                wanted = (found(t + 1e-4, order - 1) - found(t - 1e-4, order - 1)) / 2e-4
                derivative = found(t, order)
                bound = 1e-4 * max(1, abs(derivative).max())
                np.testing.assert_allclose(derivative, wanted, rtol=0, atol=bound)
        np.testing.assert_array_equal(found(found.t), found.v)
        np.testing.assert_array_equal(np.unique(found.branch % 2), [0, 1][: len(np.unique(found.branch))])


def test_a_vector_beyond_the_switch_angle_starts_at_its_principal_one() -> None:
    far = exponential.from_exponential(5.5 * OMEGA)
    for method in METHODS:
        found = propagate(exponential, far, steady, [0, 1, 5], method=method, covariance=np.eye(6))
        np.testing.assert_allclose(found.v[0], exponential.principal(far), rtol=0, atol=1e-12)
        assert found.switches[0] == 0
        np.testing.assert_allclose(found.pose, turned(exponential.pose(far), found.t, "space"), rtol=0, atol=1e-8)
        wanted = exponential.switch(far, covariance=np.eye(6))[1]
        np.testing.assert_allclose(found.covariance[0], wanted, rtol=0, atol=1e-10 * abs(wanted).max())
        other = exponential.from_exponential(4.5 * OMEGA)
        kept = propagate(exponential, other, steady, [0, 0.1, 3], method=method)
        np.testing.assert_allclose(kept.v[:2], np.outer([4.5, 4.6], OMEGA), rtol=0, atol=1e-9)
        np.testing.assert_array_equal(kept.branch, [-1, -1, 0])


@pytest.mark.parametrize("frame", FRAMES)
def test_covariance_without_noise_is_moved_by_the_transition(frame: str) -> None:
    """Compare with the derivative of v(t) by v(0), by differences; J has entries up to 10 at errors near 1e-6."""
    root = np.random.default_rng(4).normal(size=(6, 6))
    P, v0, t, h = root @ root.T, cayley2.from_exponential(START), [0, 1.5, 8], 1e-5
    ends = [propagate(cayley2, v0 + s * h * e, motions.TWISTS[frame], t, frame=frame).v
            for e in np.eye(6) for s in (1, -1)]  # fmt: skip
    J = np.moveaxis((np.array(ends[::2]) - ends[1::2]) / (2 * h), 0, -1)
    wanted = J @ P @ J.swapaxes(-1, -2)
    for method in METHODS:
        found = propagate(cayley2, v0, motions.TWISTS[frame], t, frame=frame, method=method, covariance=P)
        np.testing.assert_allclose(found.covariance, wanted, rtol=0, atol=1e-4 * abs(wanted).max())


@pytest.mark.parametrize("frame", FRAMES)
def test_covariance_with_noise_solves_its_differential_equation(frame: str) -> None:
    """Integrate ``Ṗ = A P + P Aᵀ + T⁻¹ n T⁻ᵀ`` beside v, with the derivative A of the rate; 1e-7 is above its error."""
    names = (("" if frame == "space" else "body_") + name for name in ("rate", "rate_jacobian", "tangent_inv"))
    rate, slope, inverse = (getattr(cayley2, name) for name in names)
    P, noise, v0 = np.diag([1.0, 2, 3, 4, 5, 6]), np.diag([3.0, 1, 2, 6, 4, 5]), cayley2.from_exponential(START)

    def change(t: float, y: np.ndarray) -> np.ndarray:
        v, P = y[:6], y[6:].reshape(6, 6)
        A, B = slope(v, OMEGA), dualcay.matrix6(inverse(v))
        return np.concatenate([rate(v, OMEGA), (A @ P + P @ A.T + B @ noise @ B.T).ravel()])

    solved = solve_ivp(change, (0, 1), [*v0, *P.ravel()], rtol=1e-10, atol=1e-12).y[6:, -1].reshape(6, 6)
    found = propagate(cayley2, v0, steady, [0, 1], frame=frame, covariance=P, noise=noise).covariance
    np.testing.assert_allclose(found[-1], solved, rtol=0, atol=1e-7 * abs(solved).max())


def test_noise_adds_up_over_times_and_ends_as_over_one_span() -> None:
    noise = np.diag([1.0, 2, 3, 4, 5, 6])
    many = propagate(cayley2, np.zeros(6), motions.space_twist, np.linspace(0, 3, 50), noise=noise).covariance
    one = propagate(cayley2, np.zeros(6), motions.space_twist, [0, 3], noise=noise).covariance
    np.testing.assert_array_equal(many[0], np.zeros((6, 6)))
    np.testing.assert_allclose(many[-1], one[-1], rtol=1e-5, atol=1e-5 * abs(one).max())


BAD: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"module": np}, TypeError, "module must be a kernel module of poses"),
    ({"module": dualcay.rotation.cayley2}, TypeError, "module must be a kernel module of poses"),
    ({"v0": np.zeros(3)}, ValueError, r"v0 must have shape \(6,\), got \(3,\)"),
    ({"v0": np.zeros(6, complex)}, TypeError, "v0 must hold real numbers, got dtype complex128"),
    ({"v0": 2 * np.pi * np.eye(6)[0]}, ValueError, "v0 must not be on the singular set .* angle 6.28318531"),
    ({"t": [0, 2, 1]}, ValueError, "t must increase, got 1 after 2"),
    ({"t": [0, 1, 1]}, ValueError, "t must increase, got 1 after 1"),
    ({"t": [0, np.inf]}, ValueError, "t must be finite, got inf"),
    ({"t": 3.0}, ValueError, r"t must have shape \(T,\) with at least two times, got \(\)"),
    ({"twist": np.full((2, 6), np.inf)}, ValueError, "twist must be finite, got inf"),
    ({"twist": lambda t: np.full(6, np.nan)}, ValueError, "twist at the first time must be finite"),
    ({"frame": "world"}, ValueError, "frame must be one of 'space', 'body', got 'world'"),
    ({"method": "rk4"}, ValueError, "method must be one of 'lie', 'chart', got 'rk4'"),
    ({"integrator": "LSODA"}, ValueError, "integrator must be one of 'RK23', 'RK45', 'DOP853', got 'LSODA'"),
    ({"rtol": 0}, ValueError, "rtol must be positive, got 0"),
    ({"max_step": np.nan}, ValueError, "max_step must be positive, got nan"),
    ({"covariance": np.eye(3)}, ValueError, r"covariance must have shape \(6, 6\), got \(3, 3\)"),
    ({"covariance": np.tri(6)}, ValueError, "covariance must be symmetric, got entries that differ by 1"),
]  # fmt: skip


@pytest.mark.parametrize(("given", "kind", "message"), BAD, ids=lambda one: one if isinstance(one, str) else "")
def test_wrong_arguments_are_named(given: dict[str, Any], kind: type[Exception], message: str) -> None:
    arguments: dict[str, Any] = {"module": exponential, "v0": np.zeros(6), "twist": steady, "t": [0, 1], **given}
    with pytest.raises(kind, match=message):
        propagate(**arguments)


@pytest.mark.parametrize("method", METHODS)
def test_a_twist_that_ends_says_where_and_leaves_the_motion_before(method: str) -> None:
    t = np.linspace(0, 4, 41)
    with pytest.raises(MotionError, match=r"twist must be finite, got .*nan.* at t = 2\.") as caught:
        propagate(cayley2, np.zeros(6), lambda t: OMEGA if t < 2 else OMEGA * np.nan, t, method=method, max_step=0.05)
    before = caught.value.motion
    assert 2 <= caught.value.time < 2.05
    assert 1.8 < before.t[-1] <= 2
    np.testing.assert_allclose(before.pose, turned(np.eye(4), before.t, "space"), rtol=0, atol=1e-8)
    with pytest.raises(ValueError, match=r"t must be in \[0, "):
        before(3.0)


def test_a_twist_that_grows_without_bound_or_ends_at_once_is_an_error() -> None:
    sliding = np.array([0, 0, 0, 1.0, 2, 3])
    with pytest.raises(MotionError, match="no step is small enough at t = 1") as caught:
        propagate(
            cayley2, np.zeros(6), lambda t: sliding / (1 - t) ** 2 if t < 1 else 1e200 * sliding, [0, 2], rtol=1e-3
        )
    assert caught.value.time == pytest.approx(1, abs=1e-3)
    with pytest.raises(MotionError, match="twist must be finite") as caught:
        propagate(cayley2, np.zeros(6), lambda t: OMEGA * (1 if t == 0 else np.nan), [0, 2], covariance=np.eye(6))
    np.testing.assert_array_equal(caught.value.motion.t, [0])
    assert np.isnan(caught.value.motion([0], 2)).all()


def test_a_call_takes_any_shape_and_checks_time_and_order() -> None:
    motion = propagate(cayley2, np.zeros(6), steady, [1, 2])
    assert motion(1.5).shape == (6,)
    assert motion(np.full((2, 3), 1.5), 2).shape == (2, 3, 6)
    assert motion([]).shape == (0, 6)
    for wrong in (0.9, 2.1, np.nan):
        with pytest.raises(ValueError, match=r"t must be in \[1, 2\], got "):
            motion(wrong)
    with pytest.raises(ValueError, match="order must be 0, 1 or 2, got 3"):
        motion(1.5, 3)


def test_progress_rises_to_one(capsys: pytest.CaptureFixture[str]) -> None:
    parts: list[float] = []
    propagate(cayley2, np.zeros(6), steady, [100, 109], progress=parts.append)
    assert parts == sorted(parts)
    assert 0 < parts[0] < 0.9
    assert parts[-1] == 1
    propagate(cayley2, np.zeros(6), steady, [0, 9], progress=True)
    assert capsys.readouterr().err.endswith("100%\n")


def test_scipy_is_imported_by_motions_alone_and_missed_by_name() -> None:
    code = (
        "import sys, dualcay, dualcay.cayley2 as c\nassert 'scipy' not in sys.modules\nsys.modules['scipy'] = None\n"
        "still = [[0.0] * 6] * 4\ndualcay.PoseSpline(c, [0, 1], still, kind='bspline').acceleration(0.5)\n"
        "for call in (lambda: dualcay.propagate(c, still[0], lambda t: still[0], [0, 1]),\n"
        "             lambda: dualcay.PoseSpline(c, range(4), still)):\n"
        "    try: call()\n    except ImportError as error: print(error)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    said = 'dualcay.{} needs SciPy: pip install "scipy>=1.16"'.format
    assert done.stdout.splitlines() == [said("propagate"), said("PoseSpline")]
