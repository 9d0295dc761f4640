"""Steps, shadows and motions in charts: choices of branches, and laws of motions."""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np
import pytest

import dualcay
from dualcay import cayley1, cayley2, cayley3, exponential, lambert
from tests.support import errors, families, sampling
from tests.support.oracle import Oracle

NAMES = ("cayley1", "cayley2", "cayley3", "cayley8", "exponential", "lambert")


@pytest.fixture(params=NAMES)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def oracle(name: str) -> Oracle:
    return families.oracle_of(name)


def vectors(oracle: Oracle, *angles: float) -> np.ndarray:
    """Draw dual vectors with given angles about random axes."""
    return np.concatenate([families.vectors(oracle, angle, angle, 1) for angle in angles])


def angles_of(name: str) -> tuple[float, ...]:
    """Return small and medium angles, and those angles beyond half a turn that the chart reaches."""
    return (1e-7, 0.02, 1.0, 2.5, *(angle for angle in (4.0, 7.0) if angle < 0.9 * families_edge(name)))


def families_edge(name: str) -> float:
    return np.pi * int(name.removeprefix("cayley")) if name.startswith("cayley") else families.edge_of(name)


@pytest.mark.parametrize("chart", ["cayley1", "cayley2", "orthographic", "lambert", "breusing", "wiener_milenkovic"])
def test_steps_lead_to_the_branch_of_the_shorter_way(chart: str):
    """Expect quaternions s + w v at most half a turn apart, angles that differ by at most the step, and the pose.

    The translation loses digits at the edge, as 1/d² at an angle d from it: 600 eps/d² at most in 10^6 steps.
    """
    module = importlib.import_module(f"dualcay.{chart}")
    rng = np.random.default_rng(7)
    edge = module.singular_angles()[-1]
    logarithms = sampling.unit_vectors(rng, (4000,)) * rng.uniform(0, 0.999 * edge, (4000, 1))
    v = module.from_exponential(np.concatenate([logarithms, rng.normal(size=(4000, 3))], axis=1))
    turn = rng.choice([0.3, 1.0, np.pi, 2 * np.pi], (4000, 1)) * rng.uniform(0, 1, (4000, 1))
    delta = np.concatenate([sampling.unit_vectors(rng, (4000,)) * turn, rng.normal(size=(4000, 3))], axis=1)
    shorter = np.minimum(turn, 2 * np.pi - turn)[:, 0]
    for step in (module.retract, module.body_retract):
        w = step(v, delta)
        if module.CHART.branches == 2:
            before, after = (module.angle(u)[:, 0] for u in (v, w))
            cosine = np.sum(module.quaternion(v)[:, :4] * module.quaternion(w)[:, :4], axis=1)
            np.testing.assert_allclose(cosine, np.cos(shorter / 2), rtol=0, atol=1e-12)
            assert (np.abs(after - before) <= shorter + 1e-6).all()
        exact = exponential.pose(delta)
        wanted = exact @ module.pose(v) if step is module.retract else module.pose(v) @ exact
        left = edge - module.angle(w)[:, 0]
        lost = np.abs(module.pose(w) - wanted).max(axis=(1, 2))
        assert (lost <= 1000 * np.finfo(float).eps * (1 + 1 / left**2)).all()


def test_shadows_of_no_rotation_have_no_derivative(name: str, kernels: ModuleType):
    """Expect derivatives on branch 0 only, and NaN only in its own element."""
    v = np.array([[0, 0, 0, 1.0, 2.0, 3.0], [0.1, 0.2, 0, 1, 0, 0], [np.nan, 0, 0, 0, 0, 0]])
    one, other = kernels.shadow_jacobian(v, 0), kernels.shadow_jacobian(v, 1)
    np.testing.assert_array_equal(one[:2], np.broadcast_to(np.eye(6), (2, 6, 6)))
    assert np.isnan(one[2, :3, :3]).all()
    assert np.isfinite(other[1]).all()
    assert np.isnan(other[2, :3, :3]).all()
    if kernels.CHART.branches != 1:
        assert not np.isfinite(other[0]).all()


# --- the screw-linear motion ----------------------------------------------------------------------------------------


def pairs(name: str, oracle: Oracle) -> tuple[np.ndarray, np.ndarray]:
    """Return pairs of vectors with different angles, a translation and the identity included."""
    v = np.concatenate([vectors(oracle, *angles_of(name)), [[0, 0, 0, 1.0, -2.0, 0.5]], np.zeros((1, 6))])
    return v, np.roll(v, 2, axis=0)


def test_motions_are_screws_of_constant_pitch_and_the_shorter_way(name: str, kernels: ModuleType, oracle: Oracle):
    """Compare with shares of one step from v1 to the pose of v2; the step turns by at most π."""
    v1, v2 = pairs(name, oracle)
    t = np.linspace(0, 1, 6)
    way = kernels.interpolate(v1[:, None], v2[:, None], t)
    assert way.shape == (len(v1), 6, 6)
    whole = kernels.local(v2, v1)
    assert (np.linalg.norm(whole[:, :3], axis=-1) <= np.pi * (1 + 1e-12)).all()
    size = 1 + np.abs(kernels.pose(v2)[:, :3, 3]).max(-1) + np.abs(kernels.pose(v1)[:, :3, 3]).max(-1)
    moved = kernels.pose(way)
    for i in range(len(v1)):
        by_steps = kernels.pose(kernels.retract(v1[i], t[:, None] * whole[i]))
        np.testing.assert_allclose(moved[i], by_steps, rtol=0, atol=1e-10 * size[i])
    np.testing.assert_allclose(moved[:, -1], kernels.pose(v2), rtol=0, atol=1e-10 * size.max())
    np.testing.assert_allclose(way[:, 0], v1, rtol=1e-11, atol=1e-11)


@pytest.mark.parametrize("angle", [0.4, 2.0, 4.0, 7.5])
def test_motion_about_a_fixed_axis_passes_whole_turns(angle: float):
    """Expect linear exponential coordinates, forwards and backwards through whole turns."""
    xi = np.array([2.0, -3.0, 6.0, 0.5, 1.5, -1.0]) / 7
    t = np.arange(-20.0, 21.0)
    way = exponential.interpolate(angle * xi, (angle + 0.9) * xi, t)
    expected = (angle + 0.9 * t)[:, None] * xi
    np.testing.assert_allclose(way, expected, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize(("dtype", "size"), [(np.float32, 1e-22), (np.float64, 1e-161)])
def test_start_with_subnormal_square_keeps_its_axis(dtype: type, size: float):
    """Compare with a motion from a start 1e10 times larger, to 16 eps."""
    u, end = np.array([1, 2, 2, 0, 0, 0], dtype) / 3, dtype(0.4)
    tiny, small = (cayley2.interpolate(dtype(s) * u, end * u, dtype(5)) for s in (size, 1e10 * size))
    np.testing.assert_allclose(tiny, small, rtol=16 * np.finfo(dtype).eps)


def test_interpolation_follows_its_branch_over_half_turns(name: str, kernels: ModuleType, oracle: Oracle):
    """Expect small changes of α u in fine steps, and an end at v2 or at one of its shadows."""
    edge = families_edge(name)
    for low, high in ((2.0, 3.0), *([(2.4 * np.pi, 2.7 * np.pi)] if edge > 3 * np.pi else [])):
        v1, v2 = (families.vectors(oracle, low, high, 3) for _ in range(2))
        v2[:, :3] = -np.roll(v1[:, :3], 1, axis=-1)
        t = np.linspace(0, 1, 2001)
        way = kernels.interpolate(v1[:, None], v2[:, None], t)
        alpha = kernels.angle(way)[..., :1] * way[..., :3] / np.linalg.norm(way[..., :3], axis=-1, keepdims=True)
        if np.linalg.norm(alpha, axis=-1).max() < 0.95 * edge:
            assert np.linalg.norm(np.diff(alpha, axis=1), axis=-1).max() < 0.1
        same = np.linalg.norm(way[:, -1] - v2, axis=-1) < 1e-9 * (1 + np.linalg.norm(v2, axis=-1))
        shadows = ~np.isclose(kernels.angle(way[:, -1])[:, 0], kernels.angle(v2)[:, 0], rtol=0, atol=1e-6)
        assert (same | shadows | (np.einsum("ij,ij->i", way[:, -1, :3], v2[:, :3]) < 0)).all()


@pytest.mark.parametrize(("dtype", "angle"), [(np.float32, 1e-7), (np.float32, 1e-12), (np.float64, 1e-15)])
def test_small_motions_are_linear(kernels: ModuleType, dtype: type, angle: float):
    """Compare motions through tiny angles with straight lines; the difference is of the order of the angle squared."""
    a, b = sampling.dual_vectors("smallest", count=20).astype(dtype).reshape(2, 10, 6)
    a[:, :3], b[:, :3] = angle * a[:, :3], angle * b[:, :3]
    t = dtype(0.375)
    found, straight = kernels.interpolate(a, b, t)[:, :3], (a + t * (b - a))[:, :3]
    error = np.linalg.norm(found - straight, axis=-1) / np.linalg.norm((abs(a) + abs(b))[:, :3], axis=-1)
    assert error.max() <= errors.GENERAL * np.finfo(dtype).eps


def test_half_turn_between_poses_is_decided_by_the_closed_form():
    """Expect an end at v2 or −v2, as given, although both are the same pose; the motions turn in opposite senses."""
    v1 = np.zeros(6)
    v2 = np.array([0, 0, 1.0, 0, 0, 0.5])  # half a turn about z
    assert cayley2.quaternion(v2)[0] == 0
    for end in (v2, -v2):
        way = cayley2.interpolate(v1, end, np.array([0.5, 1.0]))
        np.testing.assert_allclose(way[1], end, rtol=0, atol=1e-15)
        np.testing.assert_allclose(cayley2.compose(way[0], way[0]), end, rtol=0, atol=1e-15)


def test_times_broadcast_keep_types_and_nan_in_their_element(kernels: ModuleType, name: str, oracle: Oracle):
    v1, v2 = pairs(name, oracle)
    few = v1[:2].astype(np.float32), v2[:2].astype(np.float32)
    assert kernels.interpolate(*few, 0.5).dtype == np.float32
    assert kernels.interpolate(*few, np.linspace(0, 1, 5, dtype=np.float32)[:, None]).shape == (5, 2, 6)
    t = np.array([0.5, np.nan])
    found = kernels.interpolate(v1[2], v2[2], t)
    assert np.isfinite(found[0]).all()
    assert np.isnan(found[1]).all()
    np.testing.assert_array_equal(kernels.interpolate(v1[2][:, None], v2[2][:, None], t, axis=0).T, found)
    with pytest.raises(TypeError, match="t must be real"):
        kernels.interpolate(v1, v2, 0.5j)
    with pytest.raises(ValueError, match="broadcast"):
        kernels.interpolate(v1, v2, np.zeros(3))


# --- from chart to chart --------------------------------------------------------------------------------------------


def test_conversion_keeps_the_branch_or_the_nearest_one(name: str, kernels: ModuleType, oracle: Oracle):
    """Expect the same branch within the target's edge, and otherwise the nearest branch, whole turns away."""
    v = vectors(oracle, *angles_of(name))
    for other in NAMES:
        target = importlib.import_module(f"dualcay.{other}")
        there = dualcay.convert(v, kernels, target)
        own, found = kernels.angle(v)[:, 0], target.angle(there)[:, 0]
        pose = kernels.pose(v)
        np.testing.assert_allclose(target.pose(there), pose, rtol=0, atol=1e-10 * np.abs(pose).max())
        reached = own < families_edge(other) * (1 - 1e-9)
        np.testing.assert_allclose(found[reached], own[reached], rtol=1e-11)
        turns = (own - found) / (2 * np.pi), (own + found) / (2 * np.pi)  # about v's axis or its opposite
        assert (np.minimum(*(np.abs(t - np.round(t)) for t in turns)) < 1e-9).all()
        back = dualcay.convert(there[reached], target, kernels)
        np.testing.assert_allclose(back, v[reached], rtol=0, atol=1e-10 * (1 + np.abs(v).max()))


def test_conversion_takes_the_nearest_branch():
    """Expect for 4.5π: 2.5π with the edge at 3π, π/2 with edges at 2π and π; for 1.5π: −π/2 with the edge at π."""
    axis = np.array([0.6, 0, 0.8, 0, 5.0, 0])
    w = exponential.from_screw(np.array([4.5 * np.pi, 0.4]), axis)
    for target, angle in ((cayley3, 2.5), (cayley2, 0.5), (lambert, 0.5), (cayley1, 0.5)):
        expected = target.from_screw(np.array([angle * np.pi, 0.4]), axis)
        np.testing.assert_allclose(dualcay.convert(w, exponential, target), expected, rtol=0, atol=1e-13)
    half = exponential.from_screw(np.array([1.5 * np.pi, 0.4]), axis)
    expected = cayley1.from_screw(np.array([-0.5 * np.pi, 0.4]), axis)
    np.testing.assert_allclose(dualcay.convert(half, exponential, cayley1), expected, rtol=0, atol=1e-13)


def test_conversion_keeps_layouts_and_types_and_names_errors():
    v = np.array([[0.1, 0.2, 0.3, 1, 2, 3], [np.nan, 0, 0, 0, 0, 0]], np.float32)
    out = np.empty((6, 2), np.float32)
    found = dualcay.convert(v.T, cayley3, cayley2, axis=0, out=out)
    assert found is out
    assert np.isfinite(found[:, 0]).all()
    assert np.isnan(found[:3, 1]).all()
    np.testing.assert_array_equal(dualcay.convert(v, cayley3, cayley2).T, found)
    with pytest.raises(TypeError, match=r"target must be a kernel module, as cayley3 is, got 'cayley3'"):
        dualcay.convert(v, cayley2, "cayley3")
    with pytest.raises(TypeError, match="v must be real"):
        dualcay.convert(v * 1j, cayley2, cayley3)


def test_conversion_keeps_the_identity(kernels: ModuleType):
    for other in NAMES:
        target = importlib.import_module(f"dualcay.{other}")
        np.testing.assert_array_equal(dualcay.convert(np.zeros(6), kernels, target), np.zeros(6))
