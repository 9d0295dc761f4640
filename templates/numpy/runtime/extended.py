"""Poses with velocity, SE_2(3), and with any number k of such vectors, SE_k(3), by the kernels of poses.

``extended.cayley2`` has the functions of `ExtendedKernels` in the chart ``cayley2``; every chart has them.
"""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from ._checks import LAWS, Components, Law, require
from ._interface import PoseKernels
from ._kernel import Array, Shape
from ._runtime import as_array, filled
from ._tools import matrix6

__all__ = ["ExtendedKernels"]

F = TypeVar("F", bound=Callable[..., Any])

COLUMN, PART = 1, 3
"""Lengths of a dual part: a column of X, and three components of a vector."""
VECTOR = "array, shape (..., 3 + 3k)\n    "
MATRIX = "array, shape (..., 3 + 3k, 3 + 3k)\n    Rows: components of the result. Columns: of the argument."
ENTRIES = {
    **dict.fromkeys(("v", "v2", "v1"), VECTOR + "Vector: real part (dimensionless), position part, velocity part."),
    "v_dot": VECTOR + "Time derivative of v.",
    "omega": VECTOR + "Twist in the space frame: ω (rad/s), ṗ − ω × p, ṡ − ω × s.",
    "body_omega": VECTOR + "Twist in the body frame: ω_B (rad/s), Qᵀ ṗ, Qᵀ ṡ.",
    "delta": VECTOR + "Step, a twist times its time: rotation vector (rad), position part, velocity part.",
    "w": VECTOR + "Exponential coordinates, a step from the identity.",
    "T": "array, shape (..., 3 + k, 3 + k)\n    Matrix X = [[Q, p, s], [0, I]].",
}
"""Text of arguments and results by name."""

EVERY = "Defined for every v."
POLES = "inf or NaN at the poles of ``tangent_inv``: rotation angles 2π, 4π, …"
PRINCIPAL = "Infinite at half a turn if the chart has a pole there."
NEAREST = "On the branch nearest to v."
SHORT = "The way is the shorter one, by at most half a turn."
ENDS = "inf or NaN where the result has a rotation angle of 2π, 4π, …"
SLOPE = ">>> def slope(f):\n...     return (f(v + 1e-6 * u) - f(v - 1e-6 * u)) / 2e-6\n"


def _sections(returns: str, domain: str, example: str) -> Callable[[F], F]:
    """Add to a docstring the sections on the arguments, on the result and its domain, and a law as an example."""

    def complete(function: F) -> F:
        name, code = function.__name__, function.__code__
        body = "body_" * name.startswith("body_")
        names = code.co_varnames[1 : code.co_argcount]
        by = ", ".join(f"by_{one}" for one in names) + " : " if name.endswith("_jacobians") else ""
        sections = {
            "Parameters": "\n".join(f"{one} : {ENTRIES.get(body + one, ENTRIES[one])}" for one in names),
            "Returns": f"{by}{ENTRIES.get(body + returns, ENTRIES.get(returns, returns))}\n    {domain}",
            "Examples": ">>> import numpy as np\n>>> from dualcay.extended import cayley2\n"
            ">>> v, w, u = np.arange(9) / 10, np.full(9, 0.2), np.ones(9)\n"
            f"{SLOPE * ('slope' in example)}>>> bool(np.allclose({example}))\nTrue",
        }
        text = "".join(f"\n\n{title}\n{'-' * len(title)}\n{lines}" for title, lines in sections.items() if lines)
        function.__doc__ = inspect.cleandoc(function.__doc__ or "") + text
        return function

    return complete


@cache
def _place(part: int, width: int, axes: int, axis: int) -> tuple[Any, ...]:
    """Return the index of the pose with one dual part: in a vector (one axis), or in a matrix (two)."""
    grid = np.ix_(*[np.r_[:3, 3 + width * part : 3 + width * (part + 1)]] * axes)
    return (*grid, ...) if axis == 0 else (..., *grid)


def _glued(poses: list[Array], width: int, axes: int, axis: int, out: Array | None = None) -> Array:
    """Return the array that holds results for poses, whose real parts are equal; ``out`` filled with it if given."""
    first, size = poses[0], (3 + width * len(poses),) * axes
    full = size + first.shape[axes:] if axis == 0 else first.shape[: first.ndim - axes] + size
    found: Array = np.zeros(full, first.dtype)
    for part, pose in reversed([*enumerate(poses)]):
        found[_place(part, width, axes, axis)] = pose
    return np.asarray(filled(found, out))


def _length(name: str, value: ArrayLike, axes: int, axis: int, fixed: str, width: int) -> int:
    """Return the number of components along each component axis; raise ValueError unless it belongs to a k >= 1."""
    array = as_array(name, value, (), axis)
    found: Shape = array.shape[:axes] if axis == 0 else array.shape[max(array.ndim - axes, 0) :]
    if len(found) < axes or len({*found}) > 1 or found[0] < 3 + width or (found[0] - 3) % width:
        inner = ", ".join([fixed] * axes)
        expected = f"({inner}, ...)" if axis == 0 else f"(..., {inner})"
        raise ValueError(f"{name} must have shape {expected} with k >= 1, got {array.shape}")
    return found[0]


def _law(k: int) -> Law:
    """Return the condition of a matrix of SE_k(3)."""
    n = 3 + k

    def violations(T: Components) -> Iterator[tuple[str, list[Any]]]:
        yield "its last rows are not [0, I]", [T[n * i + j] - int(i == j) for i in range(3, n) for j in range(n)]
        yield from LAWS["from_pose"].violations([T[n * i + j] for i in range(4) for j in range(4)])

    return Law("T", (n, n), f"matrix of SE_{k}(3)", violations)


class ExtendedKernels:
    """Maps of one chart between vectors and elements X of SE_k(3), with their twists and steps.

    ``X = [[Q, p, s], [0, I]]`` holds rotation Q, position p and velocity s in space, p in column 3. The group of these
    matrices is SO(3) over the ring R[ε₁ … ε_k]/(ε_i ε_j), as that of poses is SO(3) over dual numbers. The theorems
    hold over every commutative ring, and no two ε_i meet: each function calls that of `PoseKernels` k times, with the
    real part and one of the dual parts.

    A vector has 3 + 3k components: the real part, which is the vector of the rotation, then a dual part for each
    column; k = 2 has position and velocity. Twists are those of ``Ẋ X⁻¹`` in the space frame, and of ``X⁻¹ Ẋ`` in
    functions whose names begin with ``body``. Lengths of arguments must be equal; leading axes broadcast. Types of
    numbers, NaN, errors, ``axis`` and ``out`` are those of poses. With k = 1 results are theirs to the last bit.

    Parameters
    ----------
    poses : module
        Kernel module of poses, such as ``cayley2``. Others are a TypeError.

    References
    ----------
    A. Barrau, S. Bonnabel, The invariant extended Kalman filter as a stable observer, IEEE Trans. Automatic Control 62
    (2017), for SE_2(3); CP23 for the formulas.

    Examples
    --------
    >>> from dualcay.extended import cayley2
    >>> cayley2.pose([0, 0, 0.5, 1, 0, 0.25, 0, 0, 1]).round(2)
    array([[-0.28, -0.96,  0.  ,  1.92,  0.  ],
           [ 0.96, -0.28,  0.  ,  2.56,  0.  ],
           [ 0.  ,  0.  ,  1.  ,  0.8 ,  3.2 ],
           [ 0.  ,  0.  ,  0.  ,  1.  ,  0.  ],
           [ 0.  ,  0.  ,  0.  ,  0.  ,  1.  ]])
    """

    def __init__(self, poses: Any) -> None:
        if not isinstance(getattr(poses, "KERNELS", None), PoseKernels):
            raise TypeError(f"poses must be a kernel module of poses, as cayley3 is, got {poses!r}")
        self.poses = poses

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {self.poses.__name__}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _kernels_of, (self.poses.__name__,)

    def _each(self, name: str, axis: int, arguments: dict[str, ArrayLike]) -> list[Any]:
        """Return the results of a function of poses for each dual part."""
        n = _length(*next(iter(arguments.items())), 1, axis, "3 + 3k", PART)
        arrays = [as_array(argument, value, (n,), axis) for argument, value in arguments.items()]
        parts = [_place(part, PART, 1, axis) for part in range(n // 3 - 1)]
        return [getattr(self.poses, name)(*(array[at] for array in arrays), axis=axis) for at in parts]

    def _run(self, name: str, axes: int, axis: int, out: Array | None, **arguments: ArrayLike) -> Array:
        return _glued(self._each(name, axis, arguments), PART, axes, axis, out)

    def _pair(self, name: str, axis: int, **arguments: ArrayLike) -> tuple[Array, ...]:
        return tuple(_glued([*one], PART, 2, axis) for one in zip(*self._each(name, axis, arguments)))

    def _operator(self, name: str, axis: int, out: Array | None, v: ArrayLike) -> Array:
        first, last = ((0, 1, 2), (-3, -2, -1)) if axis == 0 else ((), ())
        matrices = [matrix6(np.moveaxis(D, first, last)) for D in self._each(name, axis, {"v": v})]
        return _glued([np.moveaxis(M, last[1:], first[:2]) for M in matrices], PART, 2, axis, out)

    @_sections("T", EVERY, "cayley2.pose(cayley2.inverse(v)) @ cayley2.pose(v), np.eye(5)")
    def pose(self, v: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the matrix X of v, CP23 (16) of (57): position ``Re(T) v°`` for each dual part v°."""
        return _glued(self._each("pose", axis, {"v": v}), COLUMN, 2, axis, out)

    @_sections("v", PRINCIPAL, "cayley2.from_pose(cayley2.pose(v)), v")
    def from_pose(
        self, T: ArrayLike, *, axis: int = -1, out: Array | None = None, check: bool | float = False
    ) -> Array:
        """Return the principal vector of a matrix X; ``check`` is as for poses, and reads all of the last rows."""
        n = _length("T", T, 2, axis, "3 + k", COLUMN)
        array = as_array("T", T, (n, n), axis, real=True)
        require(_law(n - 3), array, axis, check)
        poses = (array[_place(part, COLUMN, 2, axis)] for part in range(n - 3))
        return _glued([self.poses.from_pose(pose, axis=axis) for pose in poses], PART, 1, axis, out)

    @_sections("array, shape (3 + 3k,)", "Zeros.", "cayley2.pose(cayley2.identity()), np.eye(5)")
    def identity(self, *, k: int = 2) -> Array:
        """Return the vector of the identity, with k dual parts."""
        return np.zeros(3 + 3 * k)

    @_sections("v", EVERY, "cayley2.inverse(v), -v")
    def inverse(self, v: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the vector −v of ``X(v)⁻¹``."""
        return self._run("inverse", 1, axis, out, v=v)

    @_sections("v", PRINCIPAL, "cayley2.pose(cayley2.compose(w, v)), cayley2.pose(w) @ cayley2.pose(v)")
    def compose(self, v2: ArrayLike, v1: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the principal vector of ``X(v2) X(v1)``, CP23 (58); with v1 = 0, that of X(v2)."""
        return self._run("compose", 1, axis, out, v2=v2, v1=v1)

    @_sections("v", PRINCIPAL, "cayley2.compose(v, cayley2.between(w, v)), w")
    def between(self, v2: ArrayLike, v1: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the principal vector of ``X(v1)⁻¹ X(v2)``."""
        return self._run("between", 1, axis, out, v2=v2, v1=v1)

    @_sections("w", "Angle from 0 to the edge of the chart.", "cayley2.from_exponential(cayley2.to_exponential(v)), v")
    def to_exponential(self, v: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the exponential coordinates ``log X(v)`` on the branch of v."""
        return self._run("to_exponential", 1, axis, out, v=v)

    @_sections("v", "NaN if no branch reaches the angle.", "cayley2.to_exponential(cayley2.from_exponential(v)), v")
    def from_exponential(self, w: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the vector of ``exp(w)``, on the branch of its angle if the chart has it."""
        return self._run("from_exponential", 1, axis, out, w=w)

    @_sections(MATRIX, SHORT, "cayley2.compose_jacobians(w, v)[1] @ u, slope(lambda v: cayley2.compose(w, v))")
    def compose_jacobians(self, v2: ArrayLike, v1: ArrayLike, *, axis: int = -1) -> tuple[Array, ...]:
        """Return the derivatives of ``compose(v2, v1)`` by v2 and by v1."""
        return self._pair("compose_jacobians", axis, v2=v2, v1=v1)

    @_sections(MATRIX, SHORT, "cayley2.between_jacobians(w, v)[1] @ u, slope(lambda v: cayley2.between(w, v))")
    def between_jacobians(self, v2: ArrayLike, v1: ArrayLike, *, axis: int = -1) -> tuple[Array, ...]:
        """Return the derivatives of ``between(v2, v1)`` by v2 and by v1."""
        return self._pair("between_jacobians", axis, v2=v2, v1=v1)

    @_sections(MATRIX, EVERY, "cayley2.adjoint(v) @ cayley2.body_twist(v, u), cayley2.twist(v, u)")
    def adjoint(self, v: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the matrix A from twists in the body frame to twists in space: ``hat(A ω_B) = X hat(ω_B) X⁻¹``."""
        return self._run("adjoint", 2, axis, out, v=v)

    @_sections(MATRIX, EVERY, "cayley2.tangent(v) @ u, cayley2.twist(v, u)")
    def tangent(self, v: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the matrix from rates of v to twists in the space frame, CP23 (88): ``ω = T v̇``."""
        return self._operator("tangent", axis, out, v)

    @_sections(MATRIX, POLES, "cayley2.tangent_inv(v) @ u, cayley2.rate(v, u)")
    def tangent_inv(self, v: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the matrix from twists in the space frame to rates of v, CP23 (89): ``v̇ = T⁻¹ ω``."""
        return self._operator("tangent_inv", axis, out, v)

    @_sections("omega", EVERY, "cayley2.twist(v, cayley2.rate(v, u)), u")
    def twist(self, v: ArrayLike, v_dot: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the twist in the space frame from the rate of v, CP23 (86): ``ω = T v̇``."""
        return self._run("twist", 1, axis, out, v=v, v_dot=v_dot)

    @_sections("v_dot", POLES, "cayley2.rate(v, cayley2.twist(v, u)), u")
    def rate(self, v: ArrayLike, omega: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the rate of v from the twist in the space frame, CP23 (87), (90), (91): ``v̇ = T⁻¹ ω``."""
        return self._run("rate", 1, axis, out, v=v, omega=omega)

    @_sections(MATRIX, EVERY, "cayley2.twist_jacobian(v, w) @ u, slope(lambda v: cayley2.twist(v, w))")
    def twist_jacobian(self, v: ArrayLike, v_dot: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the derivative of ``twist(v, v_dot)`` by v."""
        return self._run("twist_jacobian", 2, axis, out, v=v, v_dot=v_dot)

    @_sections(MATRIX, POLES, "cayley2.rate_jacobian(v, w) @ u, slope(lambda v: cayley2.rate(v, w))")
    def rate_jacobian(self, v: ArrayLike, omega: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the derivative of ``rate(v, omega)`` by v."""
        return self._run("rate_jacobian", 2, axis, out, v=v, omega=omega)

    @_sections("v", NEAREST, "cayley2.retract(v, w), cayley2.compose(cayley2.from_exponential(w), v)")
    def retract(self, v: ArrayLike, delta: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the vector of ``exp(δ) X(v)``."""
        return self._run("retract", 1, axis, out, v=v, delta=delta)

    @_sections("delta", SHORT, "cayley2.local(cayley2.retract(v, w), v), w")
    def local(self, v2: ArrayLike, v1: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the step δ from v1 to v2: ``X(v2) = exp(δ) X(v1)``."""
        return self._run("local", 1, axis, out, v2=v2, v1=v1)

    @_sections(MATRIX, ENDS, "cayley2.retract_jacobians(v, w)[0] @ u, slope(lambda v: cayley2.retract(v, w))")
    def retract_jacobians(self, v: ArrayLike, delta: ArrayLike, *, axis: int = -1) -> tuple[Array, ...]:
        """Return the derivatives of ``retract(v, delta)`` by v and by δ."""
        return self._pair("retract_jacobians", axis, v=v, delta=delta)

    @_sections(MATRIX, SHORT, "cayley2.local_jacobians(w, v)[1] @ u, slope(lambda v: cayley2.local(w, v))")
    def local_jacobians(self, v2: ArrayLike, v1: ArrayLike, *, axis: int = -1) -> tuple[Array, ...]:
        """Return the derivatives of ``local(v2, v1)`` by v2 and by v1."""
        return self._pair("local_jacobians", axis, v2=v2, v1=v1)

    @_sections(MATRIX, EVERY, "cayley2.body_tangent(v) @ u, cayley2.body_twist(v, u)")
    def body_tangent(self, v: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the matrix from rates of v to twists in the body frame, CP23 (86): ``ω_B = Tᵀ v̇``."""
        return self._operator("body_tangent", axis, out, v)

    @_sections(MATRIX, POLES, "cayley2.body_tangent_inv(v) @ u, cayley2.body_rate(v, u)")
    def body_tangent_inv(self, v: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the matrix from twists in the body frame to rates of v, CP23 (91): ``v̇ = T⁻ᵀ ω_B``."""
        return self._operator("body_tangent_inv", axis, out, v)

    @_sections("omega", EVERY, "cayley2.body_twist(v, cayley2.body_rate(v, u)), u")
    def body_twist(self, v: ArrayLike, v_dot: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the twist in the body frame from the rate of v, CP23 (86): ``ω_B = Tᵀ v̇``."""
        return self._run("body_twist", 1, axis, out, v=v, v_dot=v_dot)

    @_sections("v_dot", POLES, "cayley2.body_rate(v, cayley2.body_twist(v, u)), u")
    def body_rate(self, v: ArrayLike, omega: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the rate of v from the twist in the body frame, CP23 (87), (90), (91): ``v̇ = T⁻ᵀ ω_B``."""
        return self._run("body_rate", 1, axis, out, v=v, omega=omega)

    @_sections(MATRIX, EVERY, "cayley2.body_twist_jacobian(v, w) @ u, slope(lambda v: cayley2.body_twist(v, w))")
    def body_twist_jacobian(self, v: ArrayLike, v_dot: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the derivative of ``body_twist(v, v_dot)`` by v."""
        return self._run("body_twist_jacobian", 2, axis, out, v=v, v_dot=v_dot)

    @_sections(MATRIX, POLES, "cayley2.body_rate_jacobian(v, w) @ u, slope(lambda v: cayley2.body_rate(v, w))")
    def body_rate_jacobian(self, v: ArrayLike, omega: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the derivative of ``body_rate(v, omega)`` by v."""
        return self._run("body_rate_jacobian", 2, axis, out, v=v, omega=omega)

    @_sections("v", NEAREST, "cayley2.body_retract(v, w), cayley2.compose(v, cayley2.from_exponential(w))")
    def body_retract(self, v: ArrayLike, delta: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the vector of ``X(v) exp(δ)``."""
        return self._run("body_retract", 1, axis, out, v=v, delta=delta)

    @_sections("delta", SHORT, "cayley2.body_local(cayley2.body_retract(v, w), v), w")
    def body_local(self, v2: ArrayLike, v1: ArrayLike, *, axis: int = -1, out: Array | None = None) -> Array:
        """Return the step δ from v1 to v2: ``X(v2) = X(v1) exp(δ)``."""
        return self._run("body_local", 1, axis, out, v2=v2, v1=v1)

    @_sections(MATRIX, ENDS, "cayley2.body_retract_jacobians(v, w)[0] @ u, slope(lambda v: cayley2.body_retract(v, w))")
    def body_retract_jacobians(self, v: ArrayLike, delta: ArrayLike, *, axis: int = -1) -> tuple[Array, ...]:
        """Return the derivatives of ``body_retract(v, delta)`` by v and by δ."""
        return self._pair("body_retract_jacobians", axis, v=v, delta=delta)

    @_sections(MATRIX, SHORT, "cayley2.body_local_jacobians(w, v)[1] @ u, slope(lambda v: cayley2.body_local(w, v))")
    def body_local_jacobians(self, v2: ArrayLike, v1: ArrayLike, *, axis: int = -1) -> tuple[Array, ...]:
        """Return the derivatives of ``body_local(v2, v1)`` by v2 and by v1."""
        return self._pair("body_local_jacobians", axis, v2=v2, v1=v1)


@cache
def _kernels_of(module: str) -> ExtendedKernels:
    """Return the functions for the kernel module of a full name."""
    return ExtendedKernels(importlib.import_module(module))


def __getattr__(name: str) -> ExtendedKernels:
    if name.startswith("_") or not hasattr(found := getattr(importlib.import_module(__package__), name), "KERNELS"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return _kernels_of(found.__name__)


def __dir__() -> list[str]:
    return sorted({*__all__, *importlib.import_module(__package__)._modules()})
