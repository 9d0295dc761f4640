"""Coordinates do what the objects do that they are those of, and tell readings apart as the objects do."""

from __future__ import annotations

import random
from itertools import product

import pytest

from derive.algebra import Dual, Quaternion, Tensor, Vector
from derive.algebra.mixed import MeaninglessError
from derive.papers import PAPERS
from derive.papers.language import values
from derive.papers.numbers.residues import PRIME, Residue
from derive.papers.readings import combine, coordinates, enumeration, items
from derive.papers.readings.coordinates import NUMBERS, SIZES, inner, inverse, made, plus, scale, times
from derive.papers.readings.enumeration import UnreadableError, read

KINDS = [(kind, layers) for kind in (Vector, Quaternion, Tensor) for layers in (1, 2)] + [(Residue, 1), (Dual, 2)]
SMALL = [
    (PAPERS[0], ("2", "cosine", "skew-module", "22-displacement", "39", "44-screw", "principal-vector",
                 "orthographic-tensor", "velocity-tensor-sum", "86", "92", "115")),
    (PAPERS[1], ("b-orthogonal", "rodrigues-matrix", "2", "6")),
]  # fmt: skip
"""Entries of all kinds of values, dual ones too, with few readings."""


def drawn(kind: type, layers: int, seed: int) -> tuple[int, ...]:
    draw = random.Random(f"{kind.__name__} {layers} {seed}")
    return tuple(draw.randrange(1, PRIME) for _ in range(SIZES[kind] * layers))


def by_objects(operation, *arguments):
    """What the objects make: the kind and the coordinates."""
    try:
        value = operation(*arguments)
    except MeaninglessError:
        return None
    return type(value), coordinates.coordinates(value)


@pytest.mark.parametrize(("first", "second"), [*product(KINDS, KINDS)])
def test_operations_are_those_of_the_objects(first, second) -> None:
    (kind_a, _), (kind_b, _) = first, second
    a, b = drawn(*first, 1), drawn(*second, 2)
    object_a, object_b = made(kind_a, a), made(kind_b, b)
    assert plus(kind_a, a, kind_b, b) == by_objects(values.add, object_a, object_b)
    assert plus(kind_a, a, kind_b, b, -1) == by_objects(values.add, object_a, values.negative(object_b))
    if kind_a in NUMBERS:
        assert scale(a, kind_b, b) == by_objects(values.multiply, object_a, object_b)
    elif kind_b not in NUMBERS:
        assert times(values.multiply, kind_a, a, kind_b, b) == by_objects(values.multiply, object_a, object_b)
    if kind_a is kind_b is Vector:
        assert times(Tensor.dyad, kind_a, a, kind_b, b) == by_objects(Tensor.dyad, object_a, object_b)
        assert times(inner, kind_a, a, kind_b, b) == by_objects(Vector.dot, object_a, object_b)
    if kind_b in (*NUMBERS, Quaternion):
        assert (kind_b, inverse(kind_b, b)) == by_objects(values.divide, Residue(1), object_b)


@pytest.mark.parametrize(("kind", "layers"), KINDS)
def test_an_item_has_the_key_of_its_value(kind: type, layers: int) -> None:
    for zeros in ((), (0,), range(SIZES[kind], 2 * SIZES[kind])):
        c = tuple(0 if k in zeros else x for k, x in enumerate(drawn(kind, layers, 3)))
        value = made(kind, c)
        assert items.Item(value, items.Shape.ATOM, 0, None, ()).key == items.key(value)
        assert items.Item(None, items.Shape.ATOM, 0, None, (), kind, c).value == value
    one, other = drawn(kind, layers, 4), drawn(kind, layers, 5)
    for k in range(len(one)):
        assert items.key(made(kind, one)) != items.key(made(kind, (*one[:k], other[k], *one[k + 1 :])))


def test_numbers_and_vectors_have_keys_of_quaternions() -> None:
    assert items.key(Residue(3)) == items.key(3) == items.key(Dual(3, 0)) == (3, 0, 0, 0)
    assert items.key(Vector(1, 2, Dual(3, 4))) == (0, 1, 2, (3, 4))
    assert items.key(Quaternion(5, Vector(1, 2, 3))) == (5, 1, 2, 3)
    assert items.key(Tensor.identity()) == (1, 0, 0, 0, 1, 0, 0, 0, 1)
    with pytest.raises(TypeError, match="no number"):
        items.key("a")


def test_what_has_no_inverse_has_none() -> None:
    assert inverse(Dual, (0, 3)) is inverse(Residue, (0,)) is inverse(Quaternion, (0, 0, 0, 0)) is None


def small_entries():
    return [(paper, entry) for paper, numbers in SMALL for entry in paper.entries() if entry.number in numbers]


def counts() -> list[int]:
    return [count(entry, paper.lost) for paper, entry in small_entries()]


def count(entry, lost: str) -> int:
    """None where the search itself misses the listed reading."""
    try:
        return read(entry, lost, search=False).count
    except UnreadableError:
        return 0


def test_as_many_readings_differ_as_of_the_objects(monkeypatch) -> None:
    found = counts()
    assert len(found) == sum(len(numbers) for _, numbers in SMALL)
    assert all(found)
    monkeypatch.setattr(items, "coordinates", lambda value: None)
    assert counts() == found


@pytest.mark.parametrize("name", ["plus", "scale", "times"])
def test_operations_that_lose_a_coordinate_are_noticed(monkeypatch, name: str) -> None:
    found, right = counts(), getattr(combine, name)

    def wrong(*arguments):
        result = right(*arguments)
        return result and (result[0], (*result[1][:-1], 0))

    monkeypatch.setattr(combine, name, wrong)
    assert counts() != found


def test_readings_that_are_taken_for_one_are_missed(monkeypatch) -> None:
    found, of_item, of_value = counts(), items.Item.key.fget, enumeration.key
    monkeypatch.setattr(items.Item, "key", property(lambda item: of_item(item)[0]))
    monkeypatch.setattr(enumeration, "key", lambda value: of_value(value)[0])
    assert any(0 < a < b for a, b in zip(counts(), found, strict=True))
