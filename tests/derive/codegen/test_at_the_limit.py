"""What validation asks for, next to its limits: what is just right passes, and what is just wrong does not."""

from __future__ import annotations

import dataclasses
import math
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from derive.codegen.cases import samples
from derive.codegen.validation.helpers import COUNT, SIGMAS, _directed, helpers
from derive.codegen.validation.known import Analysis, Known, require_sharp
from derive.codegen.validation.rounding import FUNCTION_UNITS

import dualcay
from derive.codegen.lowered import lower_chart
from derive.codegen.validation import NUMPY, ValidationFailed
from derive.codegen.validation.c_interpreter import load
from derive.maps import Cayley
from dualcay import cayley3

CHART = Cayley(3)


def test_functions_keep_within_4_units_in_the_last_place() -> None:
    """A unit in the last place is up to two units of roundoff."""
    roundoff = np.finfo(float).eps / 2
    assert FUNCTION_UNITS * roundoff == 4 * np.spacing(1.0)


@pytest.fixture(scope="module")
def known() -> Known:
    found = next(s for s in samples(CHART) if s.function == "from_pose")
    return Analysis(CHART, lower_chart(CHART), NUMPY.dtypes).known(found)


def with_bounds(known: Known, factor: float) -> Known:
    """Results that are 1, and bounds of so many times what may be lost of them."""
    kept = [1 / 2 if dtype.itemsize >= 8 else 1 / 4 for dtype in known.dtypes]
    lost = np.array([np.finfo(d).eps ** share for d, share in zip(known.dtypes, kept, strict=True)], np.longdouble)
    bounds = np.broadcast_to(lost[:, np.newaxis, np.newaxis] * np.longdouble(factor), known.bounds.shape)
    return dataclasses.replace(known, results=np.ones_like(known.results), bounds=bounds)


def test_half_of_the_digits_are_enough(known: Known) -> None:
    require_sharp(with_bounds(known, 1))
    with pytest.raises(ValueError, match="from_pose: rounding may change too many digits"):
        require_sharp(with_bounds(known, 1 + 2.0**-20))


def leaning(size: int, mean: float) -> np.ndarray:
    """As many unit vectors as are drawn, along all axes alike, of which those of the first one lean to one side."""
    units = np.tile(np.concatenate([np.eye(size), -np.eye(size)]), (COUNT // size // 2, 1))
    against = np.flatnonzero(units[:, 0] < 0)[: round(mean * len(units) / 2)]
    units[against] *= -1
    return units


@pytest.mark.parametrize(("size", "deviation"), [(3, 1 / 3), (4, 1 / 4)])
def test_directions_may_lean_by_as_much_as_chance_makes_them(size: int, deviation: float) -> None:
    most = SIGMAS * deviation**0.5
    _directed(leaning(size, 0.95 * most), "axes")
    with pytest.raises(ValidationFailed, match="axes prefer a side"):
        _directed(leaning(size, 1.05 * most), "axes")


def test_rotations_without_a_bound_are_uniform_among_rotations_and_not_by_angle() -> None:
    def by_angle(*arguments: Any, **options: Any) -> Any:
        return cayley3.random(*arguments, **{"max_angle": math.pi} | options)

    right = {name: getattr(cayley3, name) for name in dir(cayley3)}
    with pytest.raises(ValidationFailed, match="quaternions of random prefer"):
        helpers(dualcay, SimpleNamespace(**right | {"random": by_angle}))  # type: ignore[arg-type]


@pytest.mark.parametrize(("step", "value"), [("k++", 34), ("++k", 44), ("k--", 32), ("--k", 22)])
def test_a_step_stands_for_the_value_before_it_or_after(step: str, value: int) -> None:
    text = f"double f(double a) {{ int k = 3; const int found = {step}; return a * found + k; }}"
    assert load(text).call("f", Fraction(10)) == value
