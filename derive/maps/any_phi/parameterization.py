"""Chart of a user's φ: a named chart, a multiple of a named chart, or a general chart."""

from __future__ import annotations

import keyword
import shlex
from dataclasses import replace

import sympy

from ..breusing import Breusing
from ..cayley import Cayley
from ..exponential import Exponential
from ..multiple import Multiple
from ..named import Base, Named, sine
from ..phi_error import PhiError
from ..quotient import elementary
from ..real_constants import is_small
from .edges import edge_of, require_values
from .expressions import expression_of, left_out, multiple_of_known, parity
from .general import General
from .grammar import spelled
from .regular import regular


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
