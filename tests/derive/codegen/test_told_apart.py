"""What validation has to tell apart where the two are near: comparisons of C, what is drawn, means of poses."""

from __future__ import annotations

import random
from contextlib import nullcontext
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import mpmath
import numpy as np
import pytest
from derive.codegen.cases.maps_at import flat
from derive.codegen.cases.vectors import Vectors
from derive.codegen.validation.helpers import COUNT, SEED, SIGMAS, _translations, _uniform

from derive.algebra import Vector
from derive.codegen.validation import ValidationFailed
from derive.codegen.validation.c_interpreter import load
from derive.codegen.validation.c_text import _drawn
from derive.maps import Cayley
from derive.maps.pose import tensor_from_screw
from dualcay import cayley3

HOLDS = {"<": (True, False, False), "<=": (True, True, False), "==": (False, True, False)}
"""Of a comparison: for a smaller number, an equal one, a greater one."""


def test_comparisons_of_c_tell_smaller_from_equal_from_greater() -> None:
    opposite = {">": HOLDS["<="], ">=": HOLDS["<"], "!=": HOLDS["=="]}
    expected = HOLDS | {name: tuple(not holds for holds in row) for name, row in opposite.items()}
    for name, holds in expected.items():
        program = load(f"double f(double a) {{ return a {name} 2 ? 1 : 0; }}")
        assert tuple(bool(program.call("f", Fraction(a))) for a in (1, 2, 3)) == holds, name


def test_where_no_branch_is_named_it_is_the_principal_one() -> None:
    chart = Vectors(Cayley(2))
    v = Vector(mpmath.mpf(1) / 5, mpmath.mpf(0), mpmath.mpf(0))
    q = chart.quaternion(Vector.dual(v, 0 * v))
    R = tensor_from_screw(chart.screw(Vector.dual(v, 0 * v))[0])
    for found in (chart.of_quaternion(q), chart.of_tensor(R)):
        assert flat(found) == pytest.approx((*v, 0, 0, 0), abs=1e-12)


def test_arguments_of_rational_functions_are_drawn_on_both_sides_of_0() -> None:
    drawn = [float(c.value) for c in _drawn(random.Random(1), 200)]
    assert -0.5 <= min(drawn) < -0.45
    assert 0.45 < max(drawn) <= 0.5


def test_the_principal_vector_may_differ_by_rounding_relative_to_its_size() -> None:
    """At v = 0 by 1e-9 itself, which is its limit; far out by nearly 1e-9 of v."""
    v = np.where(np.arange(COUNT) % 2, 2.0**20, 0.0)[:, np.newaxis] * np.ones(6)
    q = cayley3.quaternion(cayley3.random(COUNT, rng=SEED))

    def module(error: float, share: float) -> Any:
        off = np.where(v == 0, error, share * v)
        return SimpleNamespace(random=lambda *_, **__: v, principal=lambda v: v + off, quaternion=lambda v: q)

    _uniform(module(1e-9, 0.9e-9), moves=False)
    for error, share in ((1.1e-9, 0.9e-9), (1e-9, 1.1e-9)):
        with pytest.raises(ValidationFailed, match="random is not principal"):
            _uniform(module(error, share), moves=False)


@pytest.mark.parametrize("share", [0.2, 1.8])
def test_long_translations_and_short_ones_may_follow_the_axis_as_little(share: float) -> None:
    """As many along the axis as make the mean so many times what chance makes it."""
    draw = np.random.default_rng(SEED)
    axes, directions = (u / np.linalg.norm(u, axis=-1, keepdims=True) for u in draw.normal(size=(2, COUNT, 3)))
    directions[COUNT // 2 :] = -directions[: COUNT // 2]
    along = np.arange(COUNT) < share * SIGMAS / np.sqrt(3) * COUNT
    lengths = draw.permuted((np.arange(COUNT) + 0.5) / COUNT)
    pose = np.zeros((COUNT, 4, 4))
    pose[:, :3, 3] = lengths[:, np.newaxis] * np.where(draw.permuted(along)[:, np.newaxis], axes, directions)
    module: Any = SimpleNamespace(pose=lambda v: pose)
    found = pytest.raises(ValidationFailed, match="translations of random follow the axis")
    with found if share > 1 else nullcontext():
        _translations(module, pose, 1.0, axes)
