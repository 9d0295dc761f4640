"""Wrong matrices and wrongly distributed poses are found when a package is validated."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from derive.codegen.validation.helpers import helpers

import dualcay
from derive.codegen.validation.errors import ValidationFailed
from dualcay import cayley3

NAMES = ("identity", "random", "singular_angles", "to_screw", "principal", "quaternion", "pose", "from_screw", "rate")
RIGHT = {name: getattr(cayley3, name) for name in NAMES}


def redrawn(change: Callable[..., Any]) -> Callable[..., Any]:
    """`random` with its poses changed, as ``change(v)`` says."""

    def wrong(*arguments: Any, **options: Any) -> Any:
        return change(cayley3.random(*arguments, **options))

    return wrong


def with_angle(change: Callable[[Any], Any]) -> Callable[..., Any]:
    """`random` with rotations by another angle."""

    def wrong(v: Any) -> Any:
        if not v.any():
            return v
        angle, line = cayley3.to_screw(v)
        return cayley3.from_screw(np.stack([change(angle[..., 0]), angle[..., 1]], axis=-1), line)

    return redrawn(wrong)


def unseeded(*arguments: Any, rng: Any = None, **options: Any) -> Any:
    return cayley3.random(*arguments, **options)


def tolerant(*arguments: Any, max_angle: Any = None, max_translation: Any = 1.0, rng: Any = None) -> Any:
    length = max_translation if max_translation >= 0 else 0
    return cayley3.random(*arguments, max_angle=max_angle, max_translation=length, rng=rng)


def halves(v: Any) -> Any:
    return np.concatenate([v[..., :3], v[..., 3:] / 2], axis=-1)


def upwards(v: Any) -> Any:
    return np.where(v[..., 2:3] < 0, -v, v)


WRONG = {
    "another seed each time": (unseeded, "not that of its seed"),
    "any length": (tolerant, "taken for right: max_translation"),
    "angles squared": (with_angle(lambda angle: angle**2 / 3), "angles of random have another mean"),
    "angles about the mean": (with_angle(lambda angle: 0.7 + angle / 2), "angles of random have another"),
    "half the translation": (redrawn(halves), "translations of random have another mean"),
    "axes upwards": (redrawn(upwards), "prefer a side"),
    "one component missing": (redrawn(lambda v: v[..., :5]), "another shape"),
}


def test_right_ones_pass() -> None:
    assert helpers(dualcay, cayley3) == 5
    assert helpers(dualcay, SimpleNamespace()) == 1  # type: ignore[arg-type]


@pytest.mark.parametrize("what", WRONG)
def test_wrong_random_poses_are_found(what: str) -> None:
    wrong, message = WRONG[what]
    with pytest.raises(ValidationFailed, match=message):
        helpers(dualcay, SimpleNamespace(**RIGHT | {"random": wrong}))  # type: ignore[arg-type]


def steep(v: Any) -> Any:
    order = np.argsort(abs(v[..., :3]), axis=-1)
    return np.concatenate([np.take_along_axis(part, order, -1) for part in (v[..., :3], v[..., 3:])], axis=-1)


def test_steep_axes_are_found() -> None:
    """Of both signs alike, so that only their squares tell."""
    with pytest.raises(ValidationFailed, match="prefer an axis"):
        helpers(dualcay, SimpleNamespace(**RIGHT | {"random": redrawn(steep)}))  # type: ignore[arg-type]


def test_a_wrong_rest_is_found() -> None:
    with pytest.raises(ValidationFailed, match="identity moves"):
        helpers(dualcay, SimpleNamespace(**RIGHT | {"identity": lambda: np.ones(6)}))  # type: ignore[arg-type]


@pytest.mark.parametrize("place", range(36))
def test_a_wrong_entry_of_a_matrix_is_found(place: int) -> None:
    def wrong(D: Any) -> Any:
        matrix = dualcay.matrix6(D)
        matrix[..., place // 6, place % 6] += 1
        return matrix

    with pytest.raises(ValidationFailed, match="matrix6 has wrong entries"):
        helpers(SimpleNamespace(matrix6=wrong), cayley3)  # type: ignore[arg-type]
