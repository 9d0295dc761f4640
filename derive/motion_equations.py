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

Here ``a = α u`` is the Euler dual vector and ``v = tan(α/2n) u`` the Rodrigues dual vector. Tests
prove each right-hand side equal to the printed one, which `derive.verify` decides. Near a = 0, (83) and (85) use
series.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .algebra import Coefficient, Dual, Isotropic, Quaternion, Structure, Tensor, Vector
from .algebra.arithmetic import PLAIN, Arithmetic
from .algebra.first_principles import tensor_by_sandwich
from .algebra.latex import Typeset
from .algebra.pose import Pose, Screw, natural_invariants, pose_from_tensor, quaternion_from_screw, tensor_from_pose
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

IDENTITY = Screw(Dual(0.0, 0.0), Vector.dual((1.0, 0.0, 0.0), (0.0, 0.0, 0.0)))
"""Screw of the identity; any axis would do."""


@dataclass(frozen=True)
class ArrayArithmetic(Arithmetic):
    """Operations on the arrays of a library, such as ``jax.numpy``."""

    library: Any

    def sqrt(self, a: Any, /) -> Any:
        return self.library.sqrt(a)

    def tan(self, a: Any, /) -> Any:
        return self.library.tan(a)

    def where(self, condition: Any, a: Any, b: Any, /) -> Any:
        return self.library.where(condition, a, b)


@dataclass(frozen=True)
class MotionEquation(Typeset):
    """Kinematic equation of CP23 as a system of real equations; `motion_equation` returns it.

    A state y has shape (states, ...): its components, then any batch. All real parts precede the dual parts. A tensor
    is given row by row, and a quaternion scalar first. A twist has shape (6, ...): the angular velocity in rad/s, then
    the velocity of the body point at the origin in length units per second. Arrays are of NumPy or JAX.

    Attributes
    ----------
    number : str
        Number of the equation in CP23.
    frame : str
        Frame of the twist, ``"space"`` or ``"body"``.
    chart : Chart or None
        Chart of a vector: ``derive.Cayley(n)`` or the exponential; None for tensors and quaternions.
    """

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

        Vectors have poles: (83) at Re α = 2kπ, k ≥ 1, and (90) at the angles ``chart.singular_angles``.

        Parameters
        ----------
        t : float
            Time in s.
        y : array, shape (states, ...)
            State.
        twist : callable
            Function of t that returns the twist in the equation's frame, shape (6, ...).

        Raises
        ------
        ValueError
            If y or the twist has a wrong number of components.
        """
        library, state = self._state(y)
        rate = self.rate(state, _dual(Vector, twist(t), "the twist"), ArrayArithmetic(library))
        return library.stack([*rate.re, *rate.du])

    def rate(self, state: Any, twist: Vector, m: Arithmetic = PLAIN) -> Any:
        """Return the rate of a dual tensor, quaternion or vector; exact coefficients give an exact rate."""
        body = self.frame == BODY
        if self.kind is Vector:
            square = state.dot(state)
            at = self.chart.scalars(square.re, m)
            fi, hi = _lifted(square, at.fi, at.fiy), _lifted(square, at.hi, at.hiy)
            inverse = Isotropic(fi, -1, hi, square)  # twice T⁻¹, as in `Chart`
            return (inverse.transpose if body else inverse).apply(state, twist) / 2
        if self.kind is Tensor:
            operator = Tensor.skew(twist)
            return state @ operator if body else operator @ state
        factor = Quaternion(0, twist)
        return (state * factor if body else factor * state) / 2

    def initial(self, pose: Any) -> Any:
        """Return the state of a pose, an array of floats of shape (states,).

        Parameters
        ----------
        pose : array_like, shape (4, 4)
            Homogeneous matrix that takes body to space; orthogonality is not checked.

        Raises
        ------
        ValueError
            If the matrix has another shape, or the chart does not reach its angle, as for a half turn at n = 1.
        """
        matrix = np.asarray(pose, dtype=float)
        if matrix.shape != (4, 4):
            raise ValueError(f"expected a pose of shape (4, 4), got {matrix.shape}")
        R = tensor_from_pose(Pose(Tensor.from_entries(matrix[:3, :3].ravel()), Vector(*matrix[:3, 3])))
        state = R if self.kind is Tensor else self._of_tensor(R)
        return np.array([*state.re, *state.du])

    def pose(self, y: Any) -> Any:
        """Return the homogeneous matrix of a state, shape (4, 4, ...); errors of norm or orthogonality stay visible."""
        library, state = self._state(y)
        R = state if self.kind is Tensor else tensor_by_sandwich(self._quaternion(state, ArrayArithmetic(library)))
        found = pose_from_tensor(R)
        zero = 0 * found.displacement.c1
        rows = [(*row, c) for row, c in zip(found.rotation.rows, found.displacement, strict=True)]
        return library.stack([library.stack(row) for row in (*rows, (zero, zero, zero, 1 + zero))])

    def _state(self, y: Any) -> tuple[Any, Any]:
        """Return the library of an array, and its components as a dual quantity."""
        given = y if hasattr(y, "__array_namespace__") else np.asarray(y, dtype=float)
        return given.__array_namespace__(), _dual(self.kind, given, f"a state of ({self.number})")

    def _quaternion(self, state: Any, m: Arithmetic) -> Quaternion:
        if self.kind is Quaternion:
            return state  # type: ignore[no-any-return]
        square = state.dot(state)
        at = self.chart.scalars(square.re, m)
        return Quaternion(_lifted(square, at.s, at.sy), state * _lifted(square, at.w, at.wy))

    def _of_tensor(self, R: Tensor) -> Any:
        screw = IDENTITY if all(a == b for a, b in zip(R, Tensor.identity(), strict=True)) else natural_invariants(R)
        if self.kind is Quaternion:
            return quaternion_from_screw(screw)
        if screw.angle.re >= float(self.chart.edge):
            raise ValueError(f"({self.number}) does not reach the angle {screw.angle.re}: {self.chart} has no vector")
        size, slope = self.chart.coefficient(screw.angle.re, PLAIN)
        return screw.axis * Dual(size, slope * screw.angle.du)


def motion_equation(number: str, order: int | None = None) -> MotionEquation:
    """Return a kinematic equation of CP23 as a right-hand side for integrators.

    Parameters
    ----------
    number : str
        Number in CP23. Twist in space: ``"70"`` (tensor), ``"75"`` (quaternion), ``"83"`` (Euler dual vector) or
        ``"90"`` (Rodrigues dual vector). Twist in the body: ``"74"``, ``"76"``, ``"85"`` or ``"91"``.
    order : int, optional
        Order n of (90) and (91); required there, and not accepted elsewhere.

    Returns
    -------
    MotionEquation
        Equation with ``rhs(t, y, twist)``, ``initial(pose)``, ``pose(y)`` and the number of its ``states``.

    Raises
    ------
    ValueError
        If CP23 has no such kinematic equation, or the order is missing or not accepted.

    Examples
    --------
    >>> import derive, numpy as np
    >>> from scipy.integrate import solve_ivp
    >>> equation = derive.motion_equation("90", order=2)
    >>> def twist(t):  # a quarter turn about the third axis, and a climb by 2
    ...     return np.array([0, 0, np.pi / 2, 0, 0, 2])
    >>> y = solve_ivp(equation.rhs, (0, 1), equation.initial(np.eye(4)), args=(twist,), rtol=1e-10, atol=1e-12).y
    >>> print(equation.pose(y[:, -1]).round(6) + 0.0)
    [[ 0. -1.  0.  0.]
     [ 1.  0.  0.  0.]
     [ 0.  0.  1.  2.]
     [ 0.  0.  0.  1.]]
    """
    if number not in KINDS:
        raise ValueError(f"expected the number of a kinematic equation, {', '.join(KINDS)}, got {number!r}")
    frame, kind, chart = KINDS[number]
    if chart is Cayley:
        if order is None:
            raise ValueError(f"({number}) needs an order")
        return MotionEquation(number, frame, kind, Cayley(order))
    if order is not None:
        raise ValueError(f"({number}) has no order, got {order!r}")
    return MotionEquation(number, frame, kind, chart and chart())


def _dual(kind: type[Structure], components: Iterable[Coefficient], what: str) -> Any:
    """Return the dual quantity of the given components, real parts first."""
    numbers, expected = list(components), STATES[kind]
    if len(numbers) != expected:
        raise ValueError(f"expected {expected} components of {what}, got {len(numbers)}")
    return kind.dual(numbers[: expected // 2], numbers[expected // 2 :])


def _lifted(square: Dual, value: Coefficient, slope: Coefficient) -> Dual:
    """Return a scalar of the chart as a dual number, from its slope at ``v · v = x + 2 ε y``."""
    return Dual(value, slope * (square.du / 2))

