"""Jacobians of shadows where v·v underflows: finite, and the limit of Jacobians at longer vectors."""

from __future__ import annotations

import importlib

import numpy as np
import pytest

TINY, SMALL = 1e-300, 1e-6


@pytest.mark.parametrize("chart", ["cayley3", "cayley5", "lambert", "sine3", "exponential", "scaled4"])
def test_jacobian_of_a_shadow_is_finite_where_x_underflows(chart: str) -> None:
    kernels = importlib.import_module(f"dualcay.{chart}")
    direction = np.array([1.0, 2.0, -2.0]) / 3
    tiny, small = (kernels.shadow_jacobian([*(size * direction), 0, 0, 0], 1) for size in (TINY, SMALL))
    along, across = direction, np.array([2.0, 1.0, 2.0]) / 3
    assert np.isfinite(tiny).all()
    for block in (slice(0, 3), slice(3, 6)):
        # across the axis, the Jacobian is r_k/r and grows like 1/r
        expected = across @ small[block, block] @ across * SMALL
        assert across @ tiny[block, block] @ across * TINY == pytest.approx(expected, rel=1e-5)
    slope = kernels.shadow_jacobian([TINY, 0, 0, 0.1, 0, 0], 1)
    assert np.isfinite(slope).all(axis=1)[0]
    assert slope[0, 0] == pytest.approx(along @ small[:3, :3] @ along, rel=1e-4, abs=1e-4)
    assert not np.isnan(slope).any()
