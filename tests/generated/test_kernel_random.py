"""Functions without pose arguments: ``identity`` and ``random``."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest

COUNT = 4000


def angles(kernel: ModuleType, v: np.ndarray) -> np.ndarray:
    return kernel.to_screw(v)[0][..., 0]


def test_the_identity(kernel: ModuleType) -> None:
    np.testing.assert_array_equal(kernel.pose(kernel.identity()), np.eye(4))
    first, second = kernel.identity(), kernel.identity()
    assert first is not second


def test_random_vectors_are_seeded_and_of_the_shape_asked_for(kernel: ModuleType) -> None:
    v = kernel.random((5, 4), rng=1)
    assert v.shape == (5, 4, 6)
    assert v.dtype == np.float64
    np.testing.assert_array_equal(v, kernel.random((5, 4), rng=np.random.default_rng(1)))
    assert (v != kernel.random((5, 4), rng=2)).all()
    assert kernel.random().shape == (6,)
    assert kernel.random(3).shape == (3, 6)
    assert kernel.random((0, 2)).shape == (0, 2, 6)
    assert (kernel.random() != kernel.random()).any()


def test_without_a_limit_rotations_are_uniform(kernel: ModuleType) -> None:
    """Compare moments of the uniform distribution: E[Q] = 0, E[(tr Q)²] = 1, E[α] = π/2 + 2/π. The tolerance is five
    standard deviations, each at most 1.2/√N (variances are 1/3 of entries of Q, 1.4 of (tr Q)², 0.42 of α)."""
    v = kernel.random(COUNT, rng=7)
    np.testing.assert_array_equal(kernel.principal(v), v)
    Q, allowed = kernel.pose(v)[:, :3, :3], 5 * 1.2 / np.sqrt(COUNT)
    assert abs(Q.mean(axis=0)).max() < allowed
    assert abs((np.trace(Q, axis1=1, axis2=2) ** 2).mean() - 1) < allowed
    assert abs(angles(kernel, v).mean() - (np.pi / 2 + 2 / np.pi)) < allowed
    few = angles(kernel, kernel.random(COUNT, max_angle=np.pi, rng=7))
    assert abs(few.mean() - (np.pi / 2 + 2 / np.pi)) > allowed


def test_angles_and_translations_stay_within_their_limits(kernel: ModuleType) -> None:
    v = kernel.random(COUNT, max_angle=2.5, max_translation=3.0, rng=3)
    assert 2.4 < angles(kernel, v).max() <= 2.5 + 1e-12
    shifts = np.linalg.norm(kernel.pose(v)[:, :3, 3], axis=-1)
    assert 2.9 < shifts.max() <= 3.0 + 1e-12
    # half the numbers lie below the middle, up to five standard deviations
    assert abs((shifts < 1.5).mean() - 0.5) < 2.5 / np.sqrt(COUNT)
    assert abs((angles(kernel, v) < 1.25).mean() - 0.5) < 2.5 / np.sqrt(COUNT)


def test_angles_beyond_half_a_turn_lie_on_other_branches(kernel: ModuleType, order: int) -> None:
    v = kernel.random(COUNT, max_angle=order * np.pi, max_translation=0.5, rng=5)
    theta = 2 * order * np.arctan(np.linalg.norm(v[:, :3], axis=-1))
    assert theta.max() > 0.99 * order * np.pi
    # near a multiple of 2π, a translation makes the vector long and its pose less accurate
    far = abs(np.sin(theta / 2)) > 0.01
    shifts = np.linalg.norm(kernel.pose(v[far])[:, :3, 3], axis=-1)
    assert shifts.max() <= 0.5 + 1e-9


def test_no_angle_and_no_translation(kernel: ModuleType) -> None:
    still = kernel.random(9, max_angle=0, rng=1)
    np.testing.assert_array_equal(still[:, :3], 0)
    assert (np.linalg.norm(kernel.pose(still)[:, :3, 3], axis=-1) > 0).all()
    turned = kernel.random(9, max_translation=0, rng=1)
    np.testing.assert_array_equal(turned[:, 3:], 0)


def test_limits_outside_the_chart_are_refused(kernel: ModuleType, order: int) -> None:
    kernel.random(max_angle=kernel.singular_angles()[-1])
    for wrong in (-0.1, order * np.pi + 0.1, np.nan):
        with pytest.raises(ValueError, match=r"max_angle must be in \[0, "):
            kernel.random(max_angle=wrong)
    for wrong in (-0.1, np.nan):
        with pytest.raises(ValueError, match="max_translation must be >= 0"):
            kernel.random(max_translation=wrong)
