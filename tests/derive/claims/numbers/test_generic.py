"""Generic values: frame along the vectors, exact angles and magnitudes, dual parts and derivatives."""

from __future__ import annotations

from fractions import Fraction

import pytest

from derive.algebra import Dual
from derive.algebra.element import NotExactError
from derive.claims.language.printed import Symbol
from derive.claims.numbers.generic import EveryOrder, Generic
from derive.claims.numbers.kinds import QUANTITIES

t, v, w = (Symbol(name, "dual vector") for name in "tvw")
u1, u2, u3 = (Symbol(f"u{i}", "unit vector") for i in (1, 2, 3))
a, alpha, n, k = Symbol("a", "dual number"), Symbol("α", "angle"), Symbol("n", "order"), Symbol("k", "branch")
q, r, T = Symbol("q", "unit quaternion"), Symbol("r", "real"), Symbol("T", "tensor")


def zeros(vector) -> list[bool]:
    return [c == 0 for c in vector]


def test_frame_is_chosen_along_the_vectors() -> None:
    found = Generic([t, v, w], dual=False, moving=False).values
    assert [zeros(found[x]) for x in (t, v, w)] == [[False, True, True], [False, False, True], [False, False, False]]
    found = Generic([t, v], dual=False, moving=False, framed=False).values
    assert zeros(found[t]) == zeros(found[v]) == [False, False, False]
    found = Generic([T, v], dual=False, moving=False).values
    assert zeros(found[v]) == [False, False, False]


def test_unit_vectors_have_a_frame_too() -> None:
    found = Generic([u1, u2, u3], dual=False, moving=False).values
    assert list(found[u1]) == [1, 0, 0]
    assert zeros(found[u2]) == [False, True, False]
    assert zeros(found[u3]) == [False, False, False]
    assert all(found[u].dot(found[u]) == 1 for u in (u1, u2, u3))
    found = Generic([v, u1, u2], dual=False, moving=False).values
    assert [zeros(found[x]) for x in (v, u1, u2)] == [[False, True, True], [False, True, False], [False, False, False]]
    found = Generic([u1, u2], dual=False, moving=False, framed=False).values
    assert zeros(found[u1]) == zeros(found[u2]) == [False, False, False]
    assert found[u1].dot(found[u1]) == 1 == found[u2].dot(found[u2])


def test_frame_along_real_parts_leaves_dual_parts_free() -> None:
    found = Generic([t, v, u1], dual=True, moving=False).values
    assert zeros(found[t].re) == [False, True, True]
    assert zeros(found[v].re) == [False, False, True]
    assert not any(zeros(found[t].du) + zeros(found[v].du))
    square = found[u1].dot(found[u1])
    assert (square.re, square.du) == (1, 0)
    found = Generic([u1, u2, u3], dual=True, moving=False).values
    assert [zeros(found[u].re) for u in (u1, u2)] == [[False, True, True], [False, True, False]]
    assert all(found[u].dot(found[u]) == Dual(1, 0) for u in (u1, u2, u3))
    assert not any(zeros(found[u2].du) + zeros(found[u3].du))


def test_magnitudes_of_the_first_vector_are_tangents() -> None:
    point = Generic([v], dual=False, moving=False)
    X = point.field.magnitude(point.values[v])
    root = point.field.sqrt(1 + X * X)
    assert point.field.same(root * root, 1 + X * X)
    with pytest.raises(NotExactError):
        point.field.sqrt(1 + 2 * X * X)


@pytest.mark.parametrize(("dual", "moving"), [(False, False), (True, False), (False, True), (True, True)])
def test_parts_follow_the_layout(dual: bool, moving: bool) -> None:
    value = Generic([a], dual, moving).values[a]
    layers = 0
    while isinstance(value, Dual):
        assert value.du != 0
        value, layers = value.re, layers + 1
    assert layers == dual + moving


def test_symbols_are_independent() -> None:
    b = Symbol("b", "dual number")
    found = Generic([a, b, v], dual=True, moving=False).values
    parts = [found[a].re, found[a].du, found[b].re, found[b].du, found[v].c1.re, found[v].c1.du]
    assert all(one != other for i, one in enumerate(parts) for other in parts[:i])


def test_real_symbols_have_the_dual_part_0() -> None:
    assert not isinstance(Generic([r], dual=True, moving=False).values[r], Dual)
    assert not isinstance(Generic([r], dual=False, moving=False).values[r], Dual)
    moving = Generic([r], dual=True, moving=True).values[r]
    assert (moving.re.du == 0, moving.du) == (False, 0)
    with pytest.raises(NotExactError, match="a moving displacement"):
        Generic([q], dual=True, moving=True)


@pytest.mark.parametrize("steps", [2, 4, 6])
def test_parts_of_angles_have_sine_and_cosine(steps: int) -> None:
    point = Generic([alpha], dual=False, moving=False, steps=steps)
    for multiple in (1, 3, -2):
        part = point.values[alpha] * Fraction(multiple, steps)
        assert point.field.sin(part) ** 2 + point.field.cos(part) ** 2 == 1
        whole = 2 * point.field.sin(part) * point.field.cos(part)
        assert point.field.sin(2 * part) == whole
    with pytest.raises(NotExactError):
        point.field.sin(point.values[alpha] * Fraction(1, 2 * steps + 1))


@pytest.mark.parametrize("branch", [0, 1, 2])
def test_branch_subtracts_whole_turns(branch: int) -> None:
    point = Generic([alpha, a], dual=False, moving=False)
    before = dict(point.values)
    point.fix_branch(k, branch)
    assert point.values[k] == branch
    assert point.values[alpha] == before[alpha] - 2 * branch * point.field.pi
    assert point.values[a] == before[a]
    assert set(point.values) == {alpha, a, k}


def test_displacements_are_unit_quaternions() -> None:
    for symbols in ([q], [v, q], [q, u1]):
        point = Generic(symbols, dual=False, moving=False)
        value = point.values[q]
        assert value.norm2() == 1
        assert value.scalar == point.field.cos(point.field.symbol("q"))


def test_symbolic_order_makes_a_displacement_a_square() -> None:
    for symbols in ([q], [v, q]):
        point = Generic(symbols, dual=False, moving=False, order=n)
        assert point.values[q].norm2() == 1
        assert not any(zeros(point.values[q].vector))
        assert point.values[q].scalar not in (0, 1)


def test_symbolic_order_allows_one_vector_and_one_angle() -> None:
    s = Symbol("s", "scale")
    point = Generic([v, alpha, s], dual=False, moving=False, order=n)
    field = point.field
    assert isinstance(field, EveryOrder)
    assert point.values[n] == field.n
    assert field.magnitude(point.values[v]) == field.X
    assert point.values[alpha] == 2 * field.n * field.theta
    assert point.values[s] == field.scale
    assert Generic([s], dual=False, moving=False).values.keys() == {s}


def test_quantities_without_generic_values_are_refused() -> None:
    for name, quantity in QUANTITIES.items():
        if quantity.exact is None:
            with pytest.raises(NotExactError, match=f"no generic {name}"):
                Generic([Symbol("x", name)], dual=False, moving=False)
