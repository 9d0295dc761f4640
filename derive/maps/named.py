"""Charts by name, and the chart of a user's φ: a named chart, a multiple of a named chart, or a general chart."""

from __future__ import annotations

import keyword
import re
import shlex
from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any, TypeAlias

import sympy

from ..algebra.arithmetic import require_order
from .any_phi.edges import edge_of, require_values
from .any_phi.expressions import expression_of, left_out, multiple_of_known, parity
from .any_phi.general import General
from .any_phi.regular import regular
from .cayley import Cayley
from .chart import Chart
from .elementary import elementary
from .exponential import Exponential
from .grammar import PhiError, spelled
from .multiple import Multiple
from .real_constants import is_small
from .sine import Breusing, Sine

Base: TypeAlias = Cayley | Sine | Breusing | Exponential
Named: TypeAlias = Base | Multiple

ORDER_DIGITS_MAX = 9


def sine(n: int) -> Sine:
    """Return the sine chart ``sin(α/2n) u``."""
    return Sine(f"sine{n}", require_order(n), title=f"Sine chart of order {n}")


def scaled(n: int) -> Multiple:
    """Return the chart ``2n tan(α/2n) u``, the normal higher-order Rodrigues vector."""
    return Multiple(f"scaled{n}", Cayley(n), Fraction(2 * n), title=f"Normal Rodrigues vector of order {n}")


SINGLE: Mapping[str, Callable[[], Named]] = {
    "exponential": Exponential,
    "orthographic": lambda: replace(sine(1), title="Orthographic projection"),
    "lambert": lambda: replace(sine(2), title="Lambert's equal-area projection"),
    "breusing": Breusing,
    "wiener_milenkovic": lambda: replace(scaled(2), title="Wiener-Milenkovic vector"),
    "reduced_euler_rodrigues": lambda: Multiple("", sine(1), Fraction(2), title="Reduced Euler-Rodrigues vector"),
}
"""Charts by name."""

CONSTANT_VOLUME = {"homochoric": "cbrt(3*(alpha - sin(alpha))/4)", "isochoric": "cbrt(6*(alpha - sin(alpha)))"}
"""Texts of φ by name. Their volume elements are constant: det T = 8 and det T = 1."""

NUMBERED: Mapping[str, Callable[[int], Named]] = {"sine": sine, "scaled": scaled}
"""Functions that return the chart of an order, by the stem of the name."""


def family(name: str) -> Chart:
    """Return a parameterization by its name, such as ``lambert`` or ``sine7``; ValueError for another name."""
    numbered = re.fullmatch(rf"([a-z]+?)([1-9]\d{{0,{ORDER_DIGITS_MAX - 1}}})", name)
    found: Any
    if name in SINGLE:
        found = SINGLE[name]()
    elif numbered and numbered[1] in NUMBERED:
        found = NUMBERED[numbered[1]](int(numbered[2]))
    elif name in CONSTANT_VOLUME:
        found = parameterization(CONSTANT_VOLUME[name], name)
    else:
        names = ", ".join([*SINGLE, *CONSTANT_VOLUME, *(f"{stem}N" for stem in NUMBERED)])
        raise ValueError(f"a family is one of {names}, N an order; got {name!r}")
    title = f"{name.capitalize()} vector" if name in CONSTANT_VOLUME else found.title
    named: Chart = replace(found, name=name, title=title, selection=("--family", name))
    return named


def described(chart: Chart) -> str:
    """Return the name of a known chart, such as ``cayley1`` or ``2 sine1``; an empty text for another φ."""
    match chart:
        case Multiple():
            return f"{chart.factor} {described(chart.base)}"
        case Breusing() | Exponential():
            return type(chart).__name__.lower()
        case Cayley() | Sine():
            return f"{type(chart).__name__.lower()}{chart.order}"
    return ""


def recognized(phi: sympy.Expr) -> Named | None:
    """Return the known chart of φ, or the multiple of a known chart, by exact comparison; None for another φ."""
    if phi == Breusing().phi:
        return Breusing()
    form = multiple_of_known(phi)
    if form is None or not is_small(form[0]):
        return None
    factor, function, order = form
    base: Base = Exponential()
    if function is not None:
        base = Cayley(order) if function == sympy.tan else sine(order)
    if factor == 1:
        return base
    return Multiple("", base, factor, title=f"{factor} times the vector of {base.name}")


def parameterization(phi: str | sympy.Expr, name: str, order: int | None = None) -> Named | General:
    """Return the chart of φ, an odd function of α: a known chart where φ describes one, else a general chart.

    `order` is the value of n in a text. A refused φ raises `PhiError` with the reason.
    """
    phi = spelled(phi) if isinstance(phi, str) else phi
    expression = regular(expression_of(phi, order))
    if not (name.isidentifier() and name.isascii() and not keyword.iskeyword(name)):
        raise PhiError(f"the name of a module is an identifier, got {name!r}")
    if expression != 0 and parity(expression) != -1:  # edge_of refuses φ = 0 for its slope
        raise PhiError(f"phi = {expression} is not odd by its structure: write it as a sum of odd terms")
    with_n = f" -n {order}" if order is not None else ""
    selection = ("--phi", f"{shlex.quote(phi if isinstance(phi, str) else str(phi))} --name {name}{with_n}")
    known = recognized(expression)
    edge = known.edge if known else edge_of(expression).angle
    for part in left_out(phi, order) if isinstance(phi, str) else ():
        require_values(part, edge)
    if known:
        return replace(known, name=name, selection=selection)
    return General(name, expression, selection, f"The chart of phi = {elementary(expression)}")
