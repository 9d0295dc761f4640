"""Cayley(n): domains, LaTeX text, records and refused orders; `make check-theorems` decides its formulas."""

from __future__ import annotations

import dataclasses

import pytest
import sympy

from derive.maps import Cayley

V = sympy.symbols("v1:4 d1:4")
MAPS = ("tensor", "tangent", "tangent_inv")


def test_equation_numbers() -> None:
    assert [getattr(Cayley(3), name).equations for name in ("quaternion", *MAPS)] == [
        (50, 55, 109),
        (57, 110),
        (88, 111),
        (89, 112),
    ]
    assert Cayley(5).tangent_inv.equations == (89, 125)
    assert Cayley(7).tangent.equations == (88,)


def test_domains_and_singular_sets() -> None:
    assert Cayley(2).tangent_inv.domain == "every dual vector v"
    assert Cayley(5).tangent_inv.domain == "every dual vector v with Re q_5 != 0"
    assert Cayley(5).tangent.singular == "loses rank at Re alpha = 2*pi, 4*pi; v is infinite at Re alpha = 5*pi"
    assert Cayley(1).tangent_inv.singular == "pole at no finite v; v is infinite at Re alpha = pi"


def test_latex() -> None:
    assert Cayley(3).tangent_inv.latex() == (
        r"\mathrm{dcay}_{3}^{-1} = \frac{p_{3}}{2 q_{3}} I - \frac{1}{2} \tilde{v} + "
        r"\frac{(1 + x) q_{3} - 3 p_{3}}{6 x q_{3}} v \otimes v = "
        r"\frac{1 - 3 x}{6 - 2 x} I - \frac{1}{2} \tilde{v} + \frac{11 - x}{18 - 6 x} v \otimes v"
    )
    assert (
        Cayley(2)
        .tangent_inv.latex()
        .endswith(r"= \left(\frac{1}{4} - \frac{x}{4}\right) I - \frac{1}{2} \tilde{v} + \frac{1}{2} v \otimes v")
    )
    assert Cayley(1).tangent.latex().endswith(r"= \frac{2}{1 + x} I + \frac{2}{1 + x} \tilde{v}")
    text = Cayley(3).latex()
    for part in (r"p_{3} &= 1 - 3 x", r"q_{3} &= 3 - x", r"\hat{q} &=", r"(1 + x)^{3/2}", r"\mathrm{dcay}_{3}^{-1}"):
        assert part in text
    for item in (Cayley(3), Cayley(3).tensor):
        shown = item._repr_latex_()
        assert shown.startswith("$")
        assert shown.endswith("$")
        assert item.latex() in shown


def test_values_are_frozen_and_equal_by_content() -> None:
    assert Cayley(3) == Cayley(3)
    assert hash(Cayley(3)) == hash(Cayley(3))
    assert Cayley(3).n == Cayley(3).order == 3
    assert Cayley(3).tensor == Cayley(3).tensor != Cayley(3).tangent
    with pytest.raises(dataclasses.FrozenInstanceError):
        Cayley(3).order = 4  # type: ignore[misc]
    with pytest.raises(dataclasses.FrozenInstanceError):
        Cayley(3).tensor.order = 4  # type: ignore[misc]


def test_bad_input() -> None:
    with pytest.raises(ValueError, match="n must be an integer >= 1, got 0"):
        Cayley(0)
    with pytest.raises(TypeError, match=r"n must be an integer >= 1, got 2.5 of type float"):
        Cayley(2.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"expected 6 components, .* or 3 for a rotation, got 4"):
        Cayley(2).tensor.matrix(V[:4])
    with pytest.raises(ValueError, match="t"):
        Cayley(2).tensor.matrix(["t", 0, 0])  # type: ignore[list-item]
