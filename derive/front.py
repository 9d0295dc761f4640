"""Charts for users: the charts of `derive.maps`, with a method that proves them."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cache
from typing import Any

import sympy

from . import maps
from .maps.any_order import AnyOrder
from .output.shown import Listing, bar
from .proof import Proof, proofs, theorems


class Provable:
    """Chart with a method that proves it."""

    def prove(self: Any) -> Listing[Proof]:
        """Decide every statement about this chart and return the proofs.

        A Cayley map has statements for all n, and statements in components at its order.

        Examples
        --------
        >>> import derive
        >>> proofs = derive.Cayley(3).prove()
        >>> all(proof.proved for proof in proofs), {proof.scope for proof in proofs} == {"all n", "n = 3"}
        (True, True)
        """
        with bar() as step:
            step(f"proofs of {self.name}")
            return Listing(proofs(self))


@dataclass(frozen=True)
class Cayley(Provable, maps.Cayley):
    __doc__ = maps.Cayley.__doc__

    def __new__(cls, order: Any = None, *others: Any, **named: Any) -> Any:
        """Return a map of symbolic order for an expression with symbols."""
        symbolic = isinstance(order, sympy.Expr) and bool(order.free_symbols)
        return object.__new__(CayleyOfAnyOrder if symbolic else cls)


@dataclass(frozen=True)
class CayleyOfAnyOrder(AnyOrder, Cayley):
    __doc__ = AnyOrder.__doc__

    def subs(self, *changes: Any) -> Any:
        """Return the map with symbols of its order replaced, as by ``n.subs``; ``subs(n, 7)`` is ``Cayley(7)``."""
        return Cayley(self.order.subs(*changes))

    def prove(self) -> Listing[Proof]:
        """Decide the theorems for every n and return their proofs."""
        return Listing(theorems())


def family(name: str) -> Any:
    """Return a parameterization v = φ(α) u by its name, such as ``"lambert"``, ``"sine7"``, ``"scaled3"``.

    The command ``dualcay list`` shows all names; a numbered family has the order n at the end of its name. The chart
    has the formulas ``quaternion``, ``tensor``, ``tangent`` and ``tangent_inv``, φ as ``phi``, its largest angle as
    ``edge``, ``singular_angles`` and ``prove()``. Raise ValueError for an unknown name.

    Examples
    --------
    >>> import derive
    >>> lambert = derive.family("lambert")
    >>> lambert.phi, lambert.edge
    (sin(alpha/4), 2*pi)
    >>> lambert.tangent.coefficients[1]
    8 - 8*x
    """
    return provable(maps.family(name))


def Parameterization(phi: str | sympy.Expr, name: str = "phi", order: int | None = None) -> Any:
    """Return the parameterization v = φ(α) u of a φ, such as ``"alpha/(1 + alpha**2/40)"``.

    Besides the attributes listed in `family`, the chart has ``scale`` (a(v) of CP23 (60)), ``range`` of ``|v|``,
    ``limits`` of T and T⁻¹ at 0, ``angle`` (φ⁻¹ of ``|v|`` as a function of x), and ``inverse`` at numbers.
    Raise `PhiError`, a ValueError with the reason, for a φ that is refused.

    Parameters
    ----------
    phi : str or Expr
        Function that is odd by its structure, with φ′(0) > 0, such as an odd root of an odd expression; 0/0 at α = 0 is
        its limit. Angles beyond 4π are ignored. A φ that ends before half a turn, such as sin α, has formulas but no
        kernels. A text may contain numbers, ``alpha``, ``n``, ``pi``, ``+ - * / **`` and elementary functions; it is
        parsed, never evaluated. An expression uses `derive.alpha`.
    name : str
        Name of the chart, an identifier.
    order : int, optional
        Value of n in a text.

    Examples
    --------
    >>> import derive
    >>> derive.Parameterization("sin(alpha/6)").edge
    3*pi
    >>> derive.Parameterization("alpha + alpha**3/100").limits  # T and T⁻¹ at 0
    ((1, 1/2, 11/75), (1, -1/2, 31/300))
    """
    return provable(maps.parameterization(phi, name, order))


def provable(chart: Any) -> Any:
    """Return a chart with the method ``prove``."""
    kind: Any = type(chart)
    return _with_proofs(kind)(**{field.name: getattr(chart, field.name) for field in fields(chart)})


@cache
def _with_proofs(kind: Any) -> Any:
    """Return a class of charts with the method ``prove``. Pickle saves its charts as those of the given class."""

    def reduced(chart: Any) -> tuple[Any, ...]:
        return provable, (kind(**{field.name: getattr(chart, field.name) for field in fields(chart)}),)

    names = {"__doc__": kind.__doc__, "__module__": kind.__module__, "__reduce__": reduced}
    return type(kind.__name__, (Provable, kind), names)
