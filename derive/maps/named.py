"""Charts by name."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any, TypeAlias

from ..algebra.cayley_pairs import require_order
from .breusing import Breusing
from .cayley import Cayley
from .chart import Chart
from .exponential import Exponential
from .multiple import Multiple
from .sine import Sine

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
        from .any_phi.parameterization import parameterization  # it imports the charts of this module

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
