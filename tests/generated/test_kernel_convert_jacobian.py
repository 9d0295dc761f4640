"""Derivatives of v by the vector of another chart."""

from __future__ import annotations

import importlib

import numpy as np
import pytest

import dualcay
from dualcay import cayley2, cayley3, exponential
from tests.support import sampling

CHARTS = ("cayley2", "cayley3", "scaled2", "exponential")
START = np.array([0.2, -0.1, 0.3, 0.5, -1.0, 0.7])
"""Exponential coordinates of a pose."""

EPS = float(np.finfo(float).eps)
DIFFERENCE = 1e-11  # longdouble: h^4/30 of fifth derivatives below 1e4 for h = 1e-4, and rounding 1e-19/h


def chart(name: str):
    return importlib.import_module(f"dualcay.{name}")


ANGLES = np.pi * np.array([0.02, 0.6, 1.3, 2.6, 4.5])
"""Rotation angles in the exponential chart; the last ones lie beyond the edges of other charts."""


@pytest.mark.parametrize("name", [*CHARTS, "cayley1", "lambert", "breusing"])
def test_convert_jacobian_is_the_derivative_of_convert(name: str) -> None:
    target, axis = chart(name), np.array([0.48, 0.6, 0.64, 1, 0.4, -1.125], np.longdouble)
    w = exponential.from_screw(np.stack([ANGLES, 0.3 + 0 * ANGLES], -1).astype(np.longdouble), axis)
    h = np.longdouble(1e-4)

    def central(step: np.longdouble) -> np.ndarray:
        moved = [dualcay.convert(w + sign * step * np.eye(6)[:, None], exponential, target) for sign in (1, -1)]
        return np.moveaxis((moved[0] - moved[1]) / (2 * step), 0, -1)

    expected = (4 * central(h) - central(2 * h)) / 3
    found = dualcay.convert_jacobian(w, exponential, target)
    assert found.dtype == np.longdouble
    sizes = abs(expected).max(axis=(1, 2), keepdims=True)
    assert (abs(found - expected) < DIFFERENCE * sizes).all()
    real = dualcay.convert_jacobian(w[:, :3], chart("rotation.exponential"), chart(f"rotation.{name}"))
    assert (abs(real - expected[:, :3, :3]) < DIFFERENCE * sizes).all()


def test_convert_jacobian_of_the_same_chart_and_of_the_identity() -> None:
    v = cayley3.from_exponential(START)
    np.testing.assert_allclose(dualcay.convert_jacobian(v, cayley3, cayley3), np.eye(6), rtol=0, atol=1e-14)
    found = dualcay.convert_jacobian(np.zeros(6), cayley3, exponential)
    np.testing.assert_array_equal(found, 6 * np.eye(6))


@pytest.mark.parametrize("distance", [1e-2, 1e-5])
def test_convert_jacobian_loses_digits_by_the_distance_from_a_whole_turn(distance: float) -> None:
    """Allow 16 roundings of T⁻¹ T: T⁻¹ is of order 1/distance, its dual part of order 1/distance²."""
    v = cayley3.from_exponential(np.array([2 * np.pi - distance, 0, 0, 0.1, 0.2, 0.3]))
    expected = dualcay.convert_jacobian(v.astype(np.longdouble), cayley3, exponential)
    errors = abs(dualcay.convert_jacobian(v, cayley3, exponential) - expected) / abs(expected).max()
    real, every = 16 * EPS / distance, 16 * EPS / distance**2
    assert errors[:3, :3].max() < real
    assert EPS / distance < errors.max() < every


def test_convert_jacobian_of_nan_is_nan_in_that_element_alone() -> None:
    found = dualcay.convert_jacobian(np.array([START / 9, np.full(6, np.nan)]), cayley3, exponential)
    assert np.isfinite(found[0]).all()
    assert np.isnan(found[1]).all()


def test_convert_jacobian_keeps_layouts_and_types_and_names_errors() -> None:
    v = sampling.dual_vectors("layouts", count=6).reshape(2, 3, 6).astype(np.float32) / 8
    expected = dualcay.convert_jacobian(v, cayley3, cayley2)
    out = np.empty((6, 6, 2, 3), np.float32)
    assert dualcay.convert_jacobian(np.moveaxis(v, -1, 0), cayley3, cayley2, axis=0, out=out) is out
    np.testing.assert_allclose(np.moveaxis(out, (0, 1), (-2, -1)), expected, rtol=1e-5, atol=1e-6)
    assert expected.dtype == np.float32
    assert dualcay.convert_jacobian(np.zeros((0, 6)), cayley3, cayley2).shape == (0, 6, 6)
    with pytest.raises(TypeError, match="v must be real"):
        dualcay.convert_jacobian(v * 1j, cayley3, cayley2)
    with pytest.raises(TypeError, match="target must be a kernel module"):
        dualcay.convert_jacobian(v, cayley3, "cayley2")
    with pytest.raises(ValueError, match=r"out must have shape \(2, 3, 6, 6\), got \(6, 6\)"):
        dualcay.convert_jacobian(v, cayley3, cayley2, out=np.empty((6, 6)))
