"""Steps, shadows and motions of charts: Jacobians against first principles, and laws of what is followed."""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np
import pytest

import dualcay
from tests.support import errors, families, sampling
from tests.support.nilpotent import Nil
from tests.support.oracle import Oracle, oracle_of

NAMES = ("cayley1", "cayley2", "cayley3", "cayley8", "exponential", "lambert")
CLOSE = 1e-12
"""Of the size of what a result is a product of: its operators are good to 8 eps of theirs each, 2e-15."""


@pytest.fixture(params=NAMES)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def kernels(name: str) -> ModuleType:
    return importlib.import_module(f"dualcay.{name}")


@pytest.fixture
def oracle(name: str) -> Oracle:
    return families.oracle_of(name) if name in families.ORACLES else oracle_of(int(name.removeprefix("cayley")))


def vectors(oracle: Oracle, *angles: float) -> np.ndarray:
    """Dual vectors of these angles about drawn axes."""
    return np.concatenate([families.vectors(oracle, angle, angle, 1) for angle in angles])


def size_of(operator: np.ndarray) -> Nil:
    """Norms of the parts of a dual tensor, or of the real matrix of one."""
    if operator.shape == (6, 6):
        operator = np.stack([operator[:3, :3], operator[3:, :3]])
    return Nil(np.linalg.norm(operator[0]), np.linalg.norm(operator[1]))


def assert_near(got: np.ndarray, exact: np.ndarray, size: Nil) -> None:
    """Two real matrices of dual tensors, to 1e-12 of a size."""
    difference = size_of(got - exact.astype(float))
    assert difference.re <= CLOSE * size.re, (got, exact)
    assert difference.du <= CLOSE * (size.re + size.du), (got, exact)


def angles_of(name: str) -> tuple[float, ...]:
    """Small ones, ordinary ones, and where the chart has any, those beyond half a turn."""
    return (1e-7, 0.02, 1.0, 2.5, *(angle for angle in (4.0, 7.0) if angle < 0.9 * families_edge(name)))


def families_edge(name: str) -> float:
    return np.pi * int(name.removeprefix("cayley")) if name.startswith("cayley") else families.edge_of(name)


@pytest.mark.parametrize("body", ["", "body_"])
def test_jacobians_of_steps(name: str, kernels: ModuleType, oracle: Oracle, body: str):
    """Long ones and short ones, and none, where they are I and T⁻¹ of the frame."""
    retract_jacobians = getattr(kernels, f"{body}retract_jacobians")
    v = np.concatenate([vectors(oracle, *angles_of(name)), [[0, 0, 0, 1.0, -2.0, 0.5]], np.zeros((1, 6))])
    for v_i, delta in zip(v, np.resize((0.3, 0.01), (len(v), 1)) * sampling.dual_vectors("steps", count=len(v))):
        exact = getattr(oracle, f"{body}retract_jacobians")(v_i, delta)
        back = kernels.tangent_inv(getattr(kernels, f"{body}retract")(v_i, delta))
        for got, wanted in zip(retract_jacobians(v_i, delta), exact, strict=True):
            size = size_of(back) * size_of(kernels.tensor(v_i)) * (size_of(kernels.tangent(v_i)) + Nil(1.0, 1.0))
            assert_near(got, wanted, size)
        by_v, by_delta = retract_jacobians(v_i, np.zeros(6))
        inverse = getattr(kernels, f"{body}tangent_inv")(v_i)
        assert_near(by_v, np.eye(6), size_of(inverse) * size_of(kernels.tangent(v_i)))
        assert_near(by_delta, dualcay.matrix6(inverse), size_of(inverse))


def test_jacobians_of_shadows(name: str, kernels: ModuleType, oracle: Oracle):
    """Against T(v_k)⁻¹ T(v), to 1e-12 of these two; one after the other is that of both steps."""
    v = vectors(oracle, *angles_of(name)[1:])
    count = kernels.CHART.branches or 100
    for branch in (1, -1) if count > 1 else (0, 1):
        J, there = kernels.shadow_jacobian(v, branch), kernels.shadow(v, branch)
        for v_i, v_k, got in zip(v, there, J, strict=True):
            size = size_of(got) + size_of(kernels.tangent_inv(v_k)) * size_of(kernels.tangent(v_i))
            if name != "exponential":  # whose oracle counts no turns
                assert_near(got, oracle.shadow_jacobian(v_i, branch), size)
            assert_near(kernels.shadow_jacobian(v_k, -branch) @ got, np.eye(6), size * size)
            omega = np.array([0.3, -0.2, 0.5, 1.0, 0.4, -0.6])
            rates = kernels.shadow_jacobian(v_i, branch) @ kernels.rate(v_i, omega), kernels.rate(v_k, omega)
            np.testing.assert_allclose(*rates, rtol=0, atol=CLOSE * (size * errors.size(rates[0]) + Nil(1, 1)).du * 10)
    np.testing.assert_array_equal(kernels.shadow_jacobian(v, 0), np.broadcast_to(np.eye(6), (len(v), 6, 6)))


@pytest.mark.parametrize("name", ["cayley3", "cayley8"])
def test_jacobians_of_shadows_lose_nothing_at_whole_turns(kernels: ModuleType, oracle: Oracle):
    """To 1e-12 of themselves, where T(v) has all but lost its rank; at the turn itself they are finite."""
    for angle in (2 * np.pi * (1 + 1e-7), 2 * np.pi):
        v = kernels.from_screw(np.array([angle, 0.4]), np.array([0.6, 0, 0.8, 1.6, 5.0, -1.2]))
        J = kernels.shadow_jacobian(v, 1)
        assert np.linalg.cond(kernels.tangent(v)[0]) > 1e6
        assert np.isfinite(J).all()
        if angle > 2 * np.pi:
            assert_near(J, oracle.shadow_jacobian(v, 1), size_of(J))


def test_shadows_of_no_rotation_have_no_derivative(name: str, kernels: ModuleType):
    """But that of branch 0; NaN goes through element by element."""
    v = np.array([[0, 0, 0, 1.0, 2.0, 3.0], [0.1, 0.2, 0, 1, 0, 0], [np.nan, 0, 0, 0, 0, 0]])
    one, other = kernels.shadow_jacobian(v, 0), kernels.shadow_jacobian(v, 1)
    np.testing.assert_array_equal(one[:2], np.broadcast_to(np.eye(6), (2, 6, 6)))
    assert np.isnan(one[2, :3, :3]).all()
    assert np.isfinite(other[1]).all()
    assert np.isnan(other[2, :3, :3]).all()
    if kernels.CHART.branches != 1:
        assert not np.isfinite(other[0]).all()
