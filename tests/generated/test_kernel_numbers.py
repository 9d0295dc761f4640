"""Number types: float types are kept, integers become doubles, real maps refuse complex numbers, fractions stay
exact."""

from __future__ import annotations

import itertools
from fractions import Fraction
from types import ModuleType

import numpy as np
import pytest

import dualcay
from tests.support import thorough
from tests.support.kernels import ALIKE, load, orders
from tests.support.nilpotent import exact_field
from tests.support.oracle import Oracle
from tests.support.signatures import (
    KINDS,
    SHAPES,
    SIGNATURES,
    assert_nearly_equal,
    components_last,
    inputs,
    rows_of,
)

FUNCTION = pytest.mark.parametrize("name", thorough.sampled(SIGNATURES, KINDS.values()))
order = orders(ALIKE)
REAL = [f for f, s in SIGNATURES.items() if not s.complex]
FORWARD = [f for f, s in SIGNATURES.items() if s.complex]


@pytest.mark.parametrize(
    ("name", "dtype"),
    thorough.in_turn(SIGNATURES, [np.complex128, np.float32, np.complex64, np.longdouble, np.float64]),
)
def test_types_are_kept_but_complex_refused_where_the_map_is_real(
    kernel: ModuleType, order: int, name: str, dtype: type
) -> None:
    function, refused = getattr(kernel, name), np.dtype(dtype).kind == "c" and name in REAL
    for shape in ((), (3,), (0,)):
        arguments = inputs(kernel, name, order, shape, dtype)
        for given, axis in ((arguments, -1), (rows_of(name, arguments), 0), ([a.tolist() for a in arguments], -1)):
            if refused and (shape != (0,) or isinstance(given[0], np.ndarray)):
                with pytest.raises(TypeError, match=r"(?i)complex"):
                    function(*given, axis=axis)
            elif not refused and isinstance(given[0], np.ndarray):
                result = function(*given, axis=axis)
                assert result.dtype == dtype
                out = np.empty_like(result)
                assert function(*given, axis=axis, out=out) is out
        if not refused:
            real = function(*inputs(kernel, name, order, shape, np.float32))
            np.testing.assert_allclose(function(*arguments), real, rtol=1e-4, atol=1e-4)


def test_complex_screws_are_refused(kernel: ModuleType) -> None:
    with pytest.raises(TypeError, match=r"(?i)complex"):
        kernel.from_screw(np.array([0.1 + 0j, 1]), np.array([1.0, 0, 0, 0, 0, 0]))


@FUNCTION
@pytest.mark.parametrize("dtype", [np.int8, np.uint16])
def test_integers_become_doubles(kernel: ModuleType, order: int, name: str, dtype: type) -> None:
    whole = {
        "v": np.array([1, 0, 2, 0, 1, 3]),
        "w": np.array([3, 1, 0, 2, 5, 1]),
        "r": np.array([1, 2, 3]),
        "t": np.array(2),
        "q": np.array([1, 0, 0, 0, 0, 1, 2, 3]),
        "T": np.array([[0, 0, 1, 4], [1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 0, 1]]),
        "R": np.array([np.eye(3), np.zeros((3, 3))]),
    }
    arguments = [whole[k].astype(dtype) for k in SIGNATURES[name].arguments]
    expected = getattr(kernel, name)(*(a.astype(float) for a in arguments))
    assert expected.dtype == np.float64
    for form in (arguments, [a.tolist() for a in arguments], [np.stack([a, a]) for a in arguments]):
        result = getattr(kernel, name)(*form)
        assert_nearly_equal(np.atleast_1d(result), np.broadcast_to(expected, result.shape))


MIXED = ((np.float32, np.float64), (np.float64, np.longdouble), (np.int64, np.float64))
"""Pairs of types, and the second as the type of the result."""


@pytest.mark.parametrize("name", ["twist", "compose", "transform_point"])
def test_mixed_types_meet_in_the_wider(kernel: ModuleType, order: int, name: str) -> None:
    for shape, (first, second) in itertools.product(((), (3,)), MIXED):
        a, b = inputs(kernel, name, order, shape)
        assert getattr(kernel, name)(a.astype(first), b.astype(second)).dtype == second
        assert getattr(kernel, name)(a.astype(second), b.astype(first)).dtype == second


@FUNCTION
def test_other_byte_orders_are_read_and_text_is_refused(kernel: ModuleType, order: int, name: str) -> None:
    arguments = inputs(kernel, name, order, (3,))
    swapped = [a.astype(a.dtype.newbyteorder()) for a in arguments]
    assert_nearly_equal(getattr(kernel, name)(*swapped).astype(float), getattr(kernel, name)(*arguments))
    with pytest.raises((TypeError, ValueError)):
        getattr(kernel, name)(*(np.full(SHAPES[k], "one") for k in SIGNATURES[name].arguments))


V = (Fraction(3, 7), Fraction(-2, 5), Fraction(1, 3), Fraction(11, 2), Fraction(-5, 9), Fraction(4))
W = (Fraction(1, 2), Fraction(5, 3), Fraction(-7, 4), Fraction(2, 9), Fraction(1), Fraction(-8, 3))
U = (Fraction(-1, 5), Fraction(2), Fraction(3, 8), Fraction(-7, 6), Fraction(1, 9), Fraction(5, 4))
# the oracle computes the inverse by a logarithm, so not rationally
RATIONAL = [f for f in FORWARD if f not in ("quaternion", "inverse", "dcay", "dcay_inv")]


@pytest.mark.parametrize("name", thorough.sampled(RATIONAL, KINDS.values()))
def test_fractions_give_exact_fractions(kernel: ModuleType, order: int, name: str) -> None:
    """Compare with the definition, evaluated over the rational numbers."""
    rows = [np.array(row, dtype=object) for row in (V, W, U)]
    size = {"v": 6, "w": 6, "r": 3}
    arguments = [row[: size[k]] for row, k in zip(rows, SIGNATURES[name].arguments, strict=False)]
    exact = np.array(getattr(Oracle(order, field=exact_field()), name)(*arguments), dtype=object)
    result = getattr(kernel, name)(*arguments)
    assert result.dtype == object
    assert result.shape == exact.shape
    assert (result == exact).all()
    assert all(isinstance(c, Fraction | int) for c in result.flat)
    batch = [np.stack([a, a]) for a in arguments]
    assert (getattr(kernel, name)(*batch) == np.stack([exact, exact])).all()
    first = getattr(kernel, name)(*rows_of(name, batch), axis=0)
    assert (components_last(first, len(SIGNATURES[name].result)) == np.stack([exact, exact])).all()
    out = np.empty(exact.shape, dtype=object)
    assert getattr(kernel, name)(*arguments, out=out) is out
    assert (out == exact).all()


def test_matrix6_keeps_every_type(kernel: ModuleType) -> None:
    for dtype in (np.float32, np.float64, np.longdouble, np.complex64, np.complex128):
        assert dualcay.matrix6(kernel.tangent(np.zeros(6, dtype))).dtype == dtype
    exact = dualcay.matrix6(kernel.tangent(np.array(V, dtype=object)))
    assert exact.dtype == object
    assert exact.shape == (6, 6)


def test_multiples_of_a_chart_keep_fractions() -> None:
    """Compare with the base chart, in which some scalars are integers: half of 1 is a fraction too."""
    v, base = np.array(V, dtype=object), load(1)
    exact = 2 * base.tangent_inv(v / 2)
    for result in (dualcay.scaled1.tangent_inv(v), dualcay.scaled1.tangent_inv(np.stack([v, v]))[1]):
        assert (result == exact).all()
        assert all(isinstance(c, Fraction | int) for c in result.flat)


@pytest.mark.parametrize("shape", [(6,), (1, 6), (3, 6)])
def test_errors_of_objects_are_their_own(shape: tuple[int, ...]) -> None:
    """Expect the error of fractions at a pole, |v| = 1 for n = 4, and no run on arrays, which would round thirds."""
    whole_turn = np.broadcast_to(np.array([Fraction(i == 1) for i in range(6)]), shape)
    with pytest.raises(ZeroDivisionError):
        load(4).tangent_inv(whole_turn)
    assert not any(dtype.hasobject for _, dtype, *_ in load(4).CHART._recorded)
