r"""Kinematic equations of CP23 as right-hand sides for integrators: the rate of a pose under a prescribed twist.

======  =====  ====================================================  ======
number  frame  equation                                              states
======  =====  ====================================================  ======
70      space  :math:`\dot R = \tilde\omega R`                       18
74      body   :math:`\dot R = R\,\tilde\omega_B`                    18
75      space  :math:`\dot q = \tfrac12 \omega q`                    8
76      body   :math:`\dot q = \tfrac12 q\,\omega_B`                 8
83      space  :math:`\dot a = \mathrm{dexp}_a^{-1}\,\omega`         6
85      body   :math:`\dot a = \mathrm{dexp}_a^{-T}\,\omega_B`       6
90      space  :math:`\dot v = \mathrm{dcay}_n^{-1}(v)\,\omega`      6
91      body   :math:`\dot v = \mathrm{dcay}_n^{-T}(v)\,\omega_B`    6
======  =====  ====================================================  ======

Here ``a = α u`` is the Euler dual vector and ``v = tan(α/2n) u`` the Rodrigues dual vector. Near a = 0, (83) and (85)
use series.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .algebra import Coefficient, Dual, Isotropic, Quaternion, Structure, Tensor, Vector
from .algebra.arithmetic import PLAIN, Arithmetic
from .algebra.latex import Typeset
from .maps.cayley import Cayley
from .maps.chart import Chart
from .maps.exponential import Exponential

STATES: dict[type[Structure], int] = {Tensor: 18, Quaternion: 8, Vector: 6}
"""Number of real components of each kind of dual quantity."""

SPACE, BODY = "space", "body"

KINDS: dict[str, tuple[str, type[Structure], type[Chart] | None]] = {
    "70": (SPACE, Tensor, None), "74": (BODY, Tensor, None),
    "75": (SPACE, Quaternion, None), "76": (BODY, Quaternion, None),
    "83": (SPACE, Vector, Exponential), "85": (BODY, Vector, Exponential),
    "90": (SPACE, Vector, Cayley), "91": (BODY, Vector, Cayley),
}  # fmt: skip
"""Frame, kind of state and kind of chart of each equation, by its number."""


class ArrayArithmetic(Arithmetic):
    """Operations on the arrays of a library, such as ``jax.numpy``."""

    def __init__(self, library: Any) -> None:
        vars(self).update(sqrt=library.sqrt, tan=library.tan, where=library.where)


@dataclass(frozen=True)
class MotionEquation(Typeset):
    """Kinematic equation of CP23; `motion_equation` returns it. Its chart is that of a vector, otherwise None."""

    number: str
    frame: str
    kind: type[Structure] = field(repr=False)
    chart: Any = None

    def _typeset(self) -> str:
        body = self.frame == BODY
        twist = r"\omega_B" if body else r"\omega"
        if self.kind is Vector:
            inverse = self.chart.tangent_inv
            operator = rf"\left({inverse.symbol}\right)^T" if body else inverse.symbol
            return rf"\dot{{v}} = {operator} {twist} \qquad {inverse.latex()}"
        if self.kind is Tensor:
            return rf"\dot{{R}} = R\,\tilde{{{twist}}}" if body else rf"\dot{{R}} = \tilde{{{twist}}}\,R"
        product = rf"\hat{{q}}\,{twist}" if body else rf"{twist}\,\hat{{q}}"
        return rf"\dot{{\hat{{q}}}} = \tfrac12 {product}"

    @property
    def states(self) -> int:
        """Number of real equations: 18 for a tensor, 8 for a quaternion, 6 for a vector."""
        return STATES[self.kind]

    def rhs(self, t: Any, y: Any, twist: Callable[[Any], Any]) -> Any:
        """Return ẏ at a time, for ``scipy.integrate.solve_ivp(equation.rhs, ..., args=(twist,))`` or under ``jax.jit``.

        All real parts precede the dual parts; a tensor is given row by row, a quaternion scalar first. Vectors have
        poles: (83) at Re α = 2kπ, k ≥ 1, and (90) at the angles ``chart.singular_angles``.

        Parameters
        ----------
        t : float
            Time in s.
        y : array, shape (states, ...)
            State, as the kernels ``tensor`` and ``quaternion`` or ``from_pose`` return it, with any batch last.
        twist : callable
            Function of t that returns the twist in the equation's frame, shape (6, ...).

        Raises
        ------
        ValueError
            If y or the twist has a wrong number of components.
        """
        given = y if hasattr(y, "__array_namespace__") else np.asarray(y, dtype=float)
        library, state = given.__array_namespace__(), _dual(self.kind, given, f"a state of ({self.number})")
        rate = self.rate(state, _dual(Vector, twist(t), "the twist"), ArrayArithmetic(library))
        return library.stack([*rate.re, *rate.du])

    def rate(self, state: Any, twist: Vector, m: Arithmetic = PLAIN) -> Any:
        """Return the rate of a dual tensor, quaternion or vector; exact coefficients give an exact rate."""
        body = self.frame == BODY
        if self.kind is Vector:
            square = state.dot(state)
            at = self.chart.scalars(square.re, m)
            fi, hi = (Dual(f, slope * (square.du / 2)) for f, slope in ((at.fi, at.fiy), (at.hi, at.hiy)))
            inverse = Isotropic(fi, -1, hi, square)  # twice T⁻¹, as in `Chart`
            return (inverse.transpose if body else inverse).apply(state, twist) / 2
        if self.kind is Tensor:
            operator = Tensor.skew(twist)
            return state @ operator if body else operator @ state
        factor = Quaternion(0, twist)
        return (state * factor if body else factor * state) / 2


def motion_equation(number: str, order: int | None = None) -> MotionEquation:
    """Return a kinematic equation of CP23 as a right-hand side ``rhs(t, y, twist)`` for integrators.

    Parameters
    ----------
    number : str
        Number in CP23. Twist in space: ``"70"`` (tensor), ``"75"`` (quaternion), ``"83"`` (Euler dual vector) or
        ``"90"`` (Rodrigues dual vector). Twist in the body: ``"74"``, ``"76"``, ``"85"`` or ``"91"``.
    order : int, optional
        Order n of (90) and (91); required there, and not accepted elsewhere.

    Raises
    ------
    ValueError
        If CP23 has no such kinematic equation, or the order is missing or not accepted.

    Examples
    --------
    >>> import derive, numpy as np
    >>> from dualcay import cayley2
    >>> from scipy.integrate import solve_ivp
    >>> equation = derive.motion_equation("90", order=2)
    >>> def twist(t):  # a quarter turn about the third axis, and a climb by 2
    ...     return np.array([0, 0, np.pi / 2, 0, 0, 2])
    >>> v = solve_ivp(equation.rhs, (0, 1), np.zeros(6), args=(twist,), rtol=1e-10, atol=1e-12).y[:, -1]
    >>> print(cayley2.pose(v).round(6) + 0.0)
    [[ 0. -1.  0.  0.]
     [ 1.  0.  0.  0.]
     [ 0.  0.  1.  2.]
     [ 0.  0.  0.  1.]]
    """
    if number not in KINDS:
        raise ValueError(f"expected the number of a kinematic equation, {', '.join(KINDS)}, got {number!r}")
    frame, kind, chart = KINDS[number]
    if (order is None) == (chart is Cayley):
        raise ValueError(f"({number}) needs an order" if order is None else f"({number}) has no order, got {order!r}")
    return MotionEquation(number, frame, kind, chart and (chart() if order is None else Cayley(order)))


def _dual(kind: type[Structure], components: Iterable[Coefficient], what: str) -> Any:
    """Return the dual quantity of the given components, real parts first."""
    numbers, expected = list(components), STATES[kind]
    if len(numbers) != expected:
        raise ValueError(f"expected {expected} components of {what}, got {len(numbers)}")
    return kind.dual(numbers[: expected // 2], numbers[expected // 2 :])
