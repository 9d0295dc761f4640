"""Steps, shadows and motions in charts: choices of branches, and laws of motions."""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np
import pytest

import dualcay
from dualcay import cayley1, cayley2, cayley3, exponential, lambert
from tests.support import families
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


def test_half_turn_between_poses_is_decided_by_the_closed_form():
    """Expect an end at v2 or −v2, as given, although both are the same pose; the motions turn in opposite senses."""
    v1 = np.zeros(6)
    v2 = np.array([0, 0, 1.0, 0, 0, 0.5])  # half a turn about z
    assert cayley2.quaternion(v2)[0] == 0
    for end in (v2, -v2):
        way = cayley2.interpolate(v1, end, np.array([0.5, 1.0]))
        np.testing.assert_allclose(way[1], end, rtol=0, atol=1e-15)
        np.testing.assert_allclose(cayley2.compose(way[0], way[0]), end, rtol=0, atol=1e-15)


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
