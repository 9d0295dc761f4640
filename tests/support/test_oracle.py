"""Checks of the oracle against independent first principles, SciPy, and itself at other precisions."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import RigidTransform

from tests.support import sampling
from tests.support.exponential import exponential
from tests.support.first_principles import pack
from tests.support.kernels import ORDERS
from tests.support.nilpotent import Nil, hamilton, power
from tests.support.oracle import Oracle

DIGITS = 1e-40  # of 50 digits; conditioning costs the others
ORDER = pytest.mark.parametrize("order", ORDERS)


def largest(a) -> float:
    return max(float(abs(c)) for c in np.asarray(a, dtype=object).flat)


def samples(order: int, count: int = 2) -> list[np.ndarray]:
    regimes = [r for r in sampling.REGIMES if sampling.has_regime(order, r)]
    return [v for regime in regimes for v in sampling.poses(order, regime, count=count)]


@pytest.mark.smoke
@ORDER
def test_tensor_is_the_exponential_of_the_dual_angle_about_the_dual_axis(order: int) -> None:
    oracle = Oracle(order)
    for v in samples(order, 1):
        alpha, axis = oracle.reduced(oracle.unpack(v))
        if axis is not None:
            series = pack(exponential(tuple(alpha * c for c in axis))[0])
            assert largest(series - oracle.tensor(v)) < DIGITS * (1 + largest(v)) * (1 + largest(pack(axis)))


def test_power_is_repeated_multiplication() -> None:
    q = tuple(Nil(a, b) for a, b in zip((1, 2, -3, 5), (7, -1, 4, 2), strict=True))
    product = q
    for n in range(2, 12):
        product = hamilton(product, q)
        assert pack(power(q, n)).tolist() == pack(product).tolist()


@ORDER
def test_tangent_is_the_difference_quotient_of_the_tensor_and_dual_linear(order: int) -> None:
    oracle = Oracle(order)
    step = oracle.field.number(10.0**-12)
    for v, rate in zip(samples(order, 1), sampling.dual_vectors("rates", count=20), strict=False):
        exact = np.array([oracle.field.number(c) for c in v], dtype=object)
        rates = np.array([oracle.field.number(c) for c in rate], dtype=object)
        change = (oracle.tensor(exact + step * rates) - oracle.tensor(exact - step * rates)) / (2 * step)
        r = oracle.tensor(exact)
        spin = (change[0] @ r[0].T, change[1] @ r[0].T + change[0] @ r[1].T)
        quotient = [(s[i, j] - s[j, i]) / 2 for s in spin for i, j in ((2, 1), (0, 2), (1, 0))]
        twist = oracle.twist(v, rate)
        assert largest(twist - quotient) < 1e-18 * order**4 * (1 + largest(v)) * (1 + largest(twist))
        a, b = oracle.tangent(v)
        assert largest(twist - np.concatenate([a @ rates[:3], a @ rates[3:] + b @ rates[:3]])) < DIGITS * 1e6
        assert largest(oracle.tangent(v) - pack(oracle.operator_by_spin(oracle.unpack(v)))) < DIGITS * (1 + largest(v))


@ORDER
def test_scipy_agrees(order: int) -> None:
    oracle = Oracle(order)
    for v in samples(order, 1):
        pose = oracle.pose(v).astype(float)
        size = 1 + abs(pose).max()
        third = RigidTransform.from_dual_quat(oracle.quaternion(v).astype(float), scalar_first=True)
        assert abs(third.as_matrix() - pose).max() < 1e-14 * size
        alpha, axis = (part.astype(float) for part in oracle.to_screw(v))
        if np.isfinite(axis).all():
            screw = np.concatenate([alpha[0] * axis[:3], alpha[1] * axis[:3] + alpha[0] * axis[3:]])
            assert abs(RigidTransform.from_exp_coords(screw).as_matrix() - pose).max() < 1e-13 * size * order**2
        w = sampling.poses(order, "uniform", count=1)[0]
        both = RigidTransform.from_matrix(pose) * RigidTransform.from_matrix(oracle.pose(w).astype(float))
        assert abs(both.as_matrix() - oracle.pose(oracle.compose(v, w)).astype(float)).max() < 1e-13 * size


def test_precision_is_a_parameter() -> None:
    v = sampling.poses(5, "shadow", count=1)[0]
    for name in ("quaternion", "tensor", "tangent", "principal"):
        many = getattr(Oracle(5, 80), name)(v)
        for digits in (30, 50):
            few = [Oracle(5, 80).field.number(c) for c in getattr(Oracle(5, digits), name)(v).flat]
            assert 10.0 ** (-digits - 3) < largest(np.array(few) - many.ravel()) < 10.0 ** (5 - digits)
