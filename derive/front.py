"""The front door: the maps of `derive.maps` with their proofs."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import sympy

from . import maps
from .output.listing import Listing
from .proof import Proof, proofs


class Provable:
    """A chart that can be asked for its proofs."""

    def prove(self: Any) -> Listing[Proof]:
        """Decide everything claimed of this chart; return each `Proof`.

        Examples
        --------
        >>> import derive
        >>> {proof.status for proof in derive.family("lambert").prove()}
        {'proved'}
        """
        return Listing(proofs(self))


def family(name: str) -> Any:
    """Return a parameterization v = φ(α) u by its name, such as ``"lambert"``, ``"sine7"``, ``"scaled3"``.

    Parameters
    ----------
    name : str
        One of those that `dualcay list` names, with the order n where there is one in it.

    Returns
    -------
    Chart
        With the formulas ``quaternion``, ``tensor``, ``tangent``, ``tangent_inv``, with φ as ``phi`` and its end as
        ``edge``, with ``singular_angles``, and with ``prove()``.

    Raises
    ------
    ValueError
        If there is none of that name.

    Examples
    --------
    >>> import derive
    >>> lambert = derive.family("lambert")
    >>> lambert.phi, lambert.edge
    (sin(alpha/4), 2*pi)
    >>> lambert.tangent.coefficients[1]
    -8*(x - 1)
    """
    return provable(maps.family(name))


def Parameterization(phi: str | sympy.Expr, name: str = "phi", order: int | None = None) -> Any:
    """Return the parameterization v = φ(α) u of a φ, such as ``"alpha/(1 + alpha**2/40)"``.

    Parameters
    ----------
    phi : str or Expr
        Odd by its structure, φ′(0) > 0; of one that ends before half a turn, as sin α does, there are formulas but no
        kernels. What is beyond 4π is left out. Of a text numbers, ``alpha``, ``n``, ``pi``, ``+ - * / **`` and
        elementary functions are understood, and nothing of it is run. An expression is one in `derive.alpha`.
    name : str
        An identifier.
    order : int, optional
        The value of n in a text.

    Returns
    -------
    Chart
        As of `family`; also ``scale`` (a(v) of CP23 (60)), ``range`` of |v|, ``limits`` of T and T⁻¹ at 0, ``inverse``.

    Raises
    ------
    PhiError
        A `ValueError` that says why φ is refused.

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
    """The same chart, with ``prove()``."""
    kind = type(chart)
    with_proofs = type(kind.__name__, (Provable, kind), {"__doc__": kind.__doc__, "__module__": kind.__module__})
    return with_proofs(**{field.name: getattr(chart, field.name) for field in fields(chart)})


@dataclass(frozen=True)
class Cayley(maps.Cayley):
    __doc__ = maps.Cayley.__doc__

    def prove(self) -> Listing[Proof]:
        """Decide everything claimed of this map, for all n and by components at this n; return each `Proof`.

        Whether all hold is ``all(proof.proved for proof in m.prove())``.

        Examples
        --------
        >>> import derive
        >>> proofs = derive.Cayley(3).prove()
        >>> {proof.status for proof in proofs}, {proof.scope for proof in proofs} == {"all n", "n = 3"}
        ({'proved'}, True)
        """
        return Listing(proofs(self))
