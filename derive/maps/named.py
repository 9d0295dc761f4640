"""The parameterizations that have names, and those that a φ of a known form is."""

from __future__ import annotations

import keyword
import re
import shlex
from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import TypeAlias

import sympy

from .any_phi.edges import edge_of
from .any_phi.expressions import parity, parsed
from .any_phi.general import General
from .any_phi.grammar import PhiError
from .breusing import Breusing
from .exponential_chart import Exponential
from .families import alpha
from .multiple import Scaled
from .polynomials import require_order
from .sine import Sine

Named: TypeAlias = Sine | Scaled | Breusing | Exponential

LONGEST = 9
"""Digits of the order in a name."""


def sine(n: int) -> Sine:
    """``sin(α/2n) u``."""
    return Sine(f"sine{n}", require_order(n), title=f"Sine chart of order {n}")


def scaled(n: int) -> Scaled:
    """``2n tan(α/2n) u``, the normal higher-order Rodrigues vector."""
    return Scaled(f"scaled{n}", require_order(n), Fraction(2 * n), title=f"Normal Rodrigues vector of order {n}")


SINGLE: Mapping[str, Callable[[], Named]] = {
    "exponential": Exponential,
    "orthographic": lambda: replace(sine(1), title="Orthographic projection"),
    "lambert": lambda: replace(sine(2), title="Lambert's equal-area projection"),
    "breusing": Breusing,
    "wiener_milenkovic": lambda: replace(scaled(2), title="Wiener-Milenkovic vector"),
    "reduced_euler_rodrigues": lambda: Sine("", 1, Fraction(2), title="Reduced Euler-Rodrigues vector"),
}
"""By name."""

SYMBOLIC = ("isochoric",)
"""Names of `families` without a kernel: their scalars are no functions of x that have names."""

NUMBERED: Mapping[str, Callable[[int], Named]] = {"sine": sine, "scaled": scaled}
"""By what stands before the order in the name."""


def family(name: str) -> Named:
    """Return a parameterization by its name, such as ``lambert`` or ``sine7``.

    Raises
    ------
    ValueError
        If there is none of that name.
    """
    numbered = re.fullmatch(rf"([a-z]+?)([1-9]\d{{0,{LONGEST - 1}}})", name)
    if name in SINGLE:
        found = SINGLE[name]()
    elif numbered and numbered[1] in NUMBERED:
        found = NUMBERED[numbered[1]](int(numbered[2]))
    elif name in SYMBOLIC:
        raise ValueError(f"{name} is symbolic only, without kernels: derive.maps.families.{name}() has its phi and T")
    else:
        names = ", ".join([*SINGLE, *(f"{stem}N" for stem in NUMBERED)])
        raise ValueError(f"a family is one of {names}, N an order; got {name!r}")
    return replace(found, name=name, selection=("--family", name))


def recognized(phi: sympy.Expr, name: str, selection: tuple[str, str]) -> Named | None:
    """The chart that a rational multiple of tan(α/2n) or sin(α/2n) is."""
    factor, function = phi.as_coeff_Mul()
    kinds: Mapping[type[sympy.Function], type[Sine] | type[Scaled]] = {sympy.sin: Sine, sympy.tan: Scaled}
    if function.func not in kinds or not factor.is_Rational:
        return None
    order = 1 / (2 * function.args[0].coeff(alpha))
    if function.args[0] != alpha / (2 * order) or not (order.is_Integer and order > 0 and factor > 0):
        return None
    scale = Fraction(int(factor.p), int(factor.q))
    return kinds[function.func](name, int(order), scale, selection, f"The chart of phi = {phi}")


def parameterization(phi: str | sympy.Expr, name: str, order: int | None = None) -> Named | General:
    """Return the chart of a φ.

    Parameters
    ----------
    phi : str or Expr
        Odd, in `families.alpha`; of a text what `expressions.parsed` takes.
    name : str
        Of its module, an identifier.
    order : int, optional
        The value of n in a text.

    Raises
    ------
    PhiError
        If φ is refused, with the reason.
    """
    expression = parsed(phi, order) if isinstance(phi, str) else phi
    if not (name.isidentifier() and name.isascii() and not keyword.iskeyword(name)):
        raise PhiError(f"the name of a module is an identifier, got {name!r}")
    if expression != 0 and parity(expression) != -1:  # of 0 the slope is at fault
        raise PhiError(f"phi = {expression} is not odd by its structure: a sum of odd terms, products odd times even")
    with_n = f" -n {order}" if order is not None else ""
    selection = ("--phi", f"{shlex.quote(phi if isinstance(phi, str) else str(phi))} --name {name}{with_n}")
    found = recognized(expression, name, selection)
    if found is not None:
        return found
    edge_of(expression)
    return General(name, expression, selection, f"The chart of phi = {expression}")
