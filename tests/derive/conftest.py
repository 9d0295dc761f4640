"""Fixtures for tests of the toolkit."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator

import mpmath
import pytest
from hypothesis import HealthCheck, settings

from derive.algebra import Dual, Structure, Vector, dual_part, real_part
from derive.codegen.targets import TARGETS
from tests.support.altered_maps import stated  # noqa: F401 (a fixture)
from tests.support.packages import unvalidated

settings.register_profile("untimed", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("untimed")


@pytest.fixture
def without_validation(monkeypatch: pytest.MonkeyPatch) -> None:
    """Write kernels without validation, which takes seconds per module."""
    found = {name: unvalidated(target) for name, target in TARGETS.items()}
    monkeypatch.setattr("derive.codegen.build.TARGETS", found)


# --- seeded dual vectors: numbers of 50 digits, or exact fractions ----------------------------------------------------


@pytest.fixture
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


@pytest.fixture
def draw() -> Callable[..., Vector]:
    """Draw a 50-digit dual vector with Re|v| up to √3 `size`."""
    rng = random.Random(20231)

    def vector(size: float = 1.0) -> Vector:
        def part(scale: float) -> list[mpmath.mpf]:
            return [mpmath.mpf(rng.uniform(-scale, scale)) for _ in range(3)]

        return Vector.dual(part(size), part(4))

    return vector


@pytest.fixture
def gap() -> Callable[[object, object], mpmath.mpf]:
    """Return the largest difference, real or dual, between two numbers or structures."""

    def largest(a: object, b: object) -> mpmath.mpf:
        difference = a - b  # type: ignore[operator]
        entries = list(difference) if isinstance(difference, Structure) else [difference]
        return max(abs(mpmath.mpmathify(part)) for e in entries for part in (real_part(e), dual_part(e)))

    assert largest(Dual(1, 5), Dual(1, 2)) == 3
    return largest
