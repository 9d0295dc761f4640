"""Smooth curve through poses, or near them: a spline with its twist, acceleration and Jacobians at any time."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from math import pi
from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arguments import FRAMES, Frame, finite, increasing, require_one_of
from ._curve import Group, of_controls
from ._kernel import Array
from ._motion import OfModule
from ._tools import ChartModule

Kind: TypeAlias = Literal["interpolating", "bspline"]
Boundary: TypeAlias = Literal["natural", "clamped", "periodic"]

NEAR = 0.95 * pi
"""Rotation angle between neighbouring poses above which noise of some degrees may change the way round."""

ROUNDING = 1e-9
"""Angle (rad) beyond which half a turn counts as passed."""


@dataclass(frozen=True, eq=False)
class SplineJacobians:
    """Derivatives at each time by small body steps of four control poses: ``X`` becomes ``X exp(δ)``.

    Parameters
    ----------
    index : array of int, shape (..., 4)
        Control poses that the curve depends on at this time, as rows of ``controls``.
    pose : array, shape (..., 4, 6, 6)
        Derivative of the body step of the pose, one block for each control pose; 3 x 3 for rotations.
    twist, acceleration : array, shape (..., 4, 6, 6)
        Derivatives of ``twist(t, frame="body")`` and ``acceleration(t, frame="body")``.
    """

    index: NDArray[np.int_]
    pose: NDArray[np.float64]
    twist: NDArray[np.float64]
    acceleration: NDArray[np.float64]


class PoseSpline(OfModule):
    """Curve of poses whose pose, twist and acceleration are continuous; rotations by a module of rotations.

    Between knots the pose is ``X₀ Cay(λ₁ d₁) Cay(λ₂ d₂) Cay(λ₃ d₃)``: a control pose and three steps d, of which the
    parts λ(t) follow from cubic B-splines. A rigid change of frame moves the whole curve and changes nothing else.

    Parameters
    ----------
    module : module
        Kernel module, of poses or of rotations, whose chart measures the steps.
    t : array, shape (T,)
        Increasing times (s) of the poses. For ``"bspline"`` they are the knots, N - 2 for N control poses; the curve
        begins and ends at control poses. Of N times the second and the last but one are no knots. Of N + 4 knots the
        first three lie before the curve and the last three after it.
    poses_or_v : array, shape (T, 4, 4) or (T, 6)
        Homogeneous matrices, or vectors of the chart on any branch; for rotations (T, 3, 3) or (T, 3). Neighbours are
        joined by the shorter way round.
    kind : {"interpolating", "bspline"}
        Curve through all poses, or curve with these control poses, which it approaches.
    boundary : {"natural", "clamped", "periodic"}
        Acceleration 0 at both ends; or ``twists`` there; or a closed curve, whose last pose is the first again. A
        closed ``"bspline"`` has N + 1 knots. A clamped one does not exist.
    axis : int
        Axis of time in ``poses_or_v``.
    twists : array, shape (2, 6), optional
        Space twists at both ends of a clamped curve; 0 if none are given.

    Raises
    ------
    ValueError, TypeError
        If an argument is wrong; the message names it, and its row. Rows of vectors whose own branch goes on by more
        than half a turn are refused. Rows nearly half a turn apart raise a RuntimeWarning: the way round is doubtful.
    ArithmeticError
        If no curve is found, because control poses would be too far apart.
    ImportError
        If SciPy is missing, which all but ``"bspline"`` need.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import PoseSpline, cayley2
    >>> t = np.arange(5.0)
    >>> poses = cayley2.pose(np.outer(np.sin(t), [0.3, 0.1, 0, 1, 0, 2]))
    >>> spline = PoseSpline(cayley2, t, poses)
    >>> np.allclose(spline.pose(t), poses), spline.twist(2.5, frame="body").shape
    (True, (6,))
    """

    module: Any

    def __init__(
        self, module: ChartModule, t: ArrayLike, poses_or_v: ArrayLike, *, kind: Kind = "interpolating",
        boundary: Boundary = "natural", axis: int = 0, twists: ArrayLike | None = None,
    ) -> None:  # fmt: skip
        group = Group(module)
        require_one_of("kind", kind, get_args(Kind))
        require_one_of("boundary", boundary, get_args(Boundary))
        if twists is not None and boundary != "clamped":
            raise ValueError(f"twists belong to the boundary 'clamped', got the boundary {boundary!r}")
        if kind == "bspline" and boundary == "clamped":
            raise ValueError("the kind 'bspline' has no boundary 'clamped': its control poses fix the ends")
        times = increasing("t", t)
        poses = neighbours(group, poses_or_v, axis, None if kind == "bspline" else len(times))
        self.module, self.period = module, times[-1] - times[0] if boundary == "periodic" else None
        if kind == "bspline":
            self._curve = of_controls(group, times, poses, self.period)
        else:
            ends = None if twists is None else finite("twists", twists, (2, group.size), rows=True)
            self._curve = _solver().interpolating(group, times, poses, boundary, ends)

    @classmethod
    def fit(
        cls, module: ChartModule, t: ArrayLike, poses: ArrayLike, knots: ArrayLike, weights: ArrayLike | None = None
    ) -> PoseSpline:
        """Return the spline nearest to noisy poses: least squares by Gauss–Newton on the control poses.

        The sum of ``weights`` times the squares of the body steps from the poses to the curve is smallest.

        Parameters
        ----------
        module : module
            Kernel module, of poses or of rotations.
        t : array, shape (T,)
            Increasing times (s) of the poses, from the first to the last knot.
        poses : array, shape (T, 4, 4) or (T, 6)
            Poses or vectors of the chart; for rotations (T, 3, 3) or (T, 3).
        knots : array, shape (K,)
            Increasing times, at least two, between which the curve is smooth; it has K + 2 control poses.
        weights : array, shape (T,) or (T, 6), optional
            Weights of the squares, such as 1/σ²: of each pose, or of each component [rotation (rad), translation].

        Returns
        -------
        PoseSpline
            Spline of the kind ``"bspline"``.

        Raises
        ------
        ValueError, TypeError, ArithmeticError, ImportError
            As `PoseSpline`; also if too few poses lie between knots.

        Examples
        --------
        >>> import numpy as np
        >>> from dualcay import PoseSpline, cayley2
        >>> t = np.linspace(0, 4, 40)
        >>> poses = cayley2.pose(np.outer(np.sin(t), [0.3, 0.1, 0, 1, 0, 2]))
        >>> spline = PoseSpline.fit(cayley2, t, poses, knots=np.linspace(0, 4, 9))
        >>> bool(abs(spline.pose(t) - poses).max() < 5e-3)
        True
        """
        group, times = Group(module), increasing("t", t)
        given = neighbours(group, poses, 0, len(times))
        weighed = np.ones(len(times)) if weights is None else np.asarray(weights)
        shape = (len(times), *[group.size] * (weighed.ndim == 2))
        weighed = finite("weights", weighed, shape, rows=True)
        if (wrong := np.argwhere(weighed < 0)).size:
            raise ValueError(f"weights must not be negative, got {weighed[tuple(wrong[0])]:g} in row {wrong[0, 0]}")
        found = cls.__new__(cls)
        found.module, found.period = module, None
        found._curve = _solver().fitted(group, increasing("knots", knots), times, given, weighed)
        return found

    @property
    def knots(self) -> Array:
        """Times, from the first to the last, between which the curve is smooth."""
        return self._curve.breaks

    @property
    def controls(self) -> NDArray[np.float64]:
        """Control poses, shape (N, 4, 4); (N, 3, 3) for rotations."""
        return self._curve.controls if self.period is None else self._curve.controls[1:-2]

    def __call__(self, t: ArrayLike, order: Literal[0, 1, 2] = 0) -> NDArray[np.float64]:
        """Return the principal v, or v̇ or v̈, at times of any shape.

        v jumps at half a turn, as `principal` does; `unwrap` makes a sequence continuous.

        Parameters
        ----------
        t : array, shape (...)
            Times (s) within the knots; any times if the curve is closed.
        order : {0, 1, 2}
            0 for v, 1 for v̇ (1/s), 2 for v̈ (1/s²).

        Returns
        -------
        array, shape (..., 6)
            Real part, then dual part; (..., 3) for rotations.
        """
        if order not in (0, 1, 2):
            raise ValueError(f"order must be 0, 1 or 2, got {order!r}")
        return self._values(("v", "v_dot", "v_ddot")[order], t)

    def pose(self, t: ArrayLike) -> NDArray[np.float64]:
        """Return the poses, shape (..., 4, 4), at times of shape (...); rotations (..., 3, 3)."""
        return self._values("pose", t)

    def twist(self, t: ArrayLike, frame: Frame = "space") -> NDArray[np.float64]:
        """Return the twists [ω, v], shape (..., 6), at times of shape (...), in the frame "space" or "body"."""
        return self._values("twist", t, frame)

    def acceleration(self, t: ArrayLike, frame: Frame = "space") -> NDArray[np.float64]:
        """Return the time derivatives of the twists in a frame, shape (..., 6), at times of shape (...).

        The one in space is the one of the body, carried by the pose.
        """
        return self._values("acceleration", t, frame)

    def parts(self, t: ArrayLike) -> tuple[Array, Array]:
        """Return the rows (..., 4) of four control poses at each time, and λ, λ̇, λ̈ of three factors, (3, ..., 3).

        From these a curve is computed again by other means, such as kernels that JAX differentiates.
        """
        times, shape = self._times(t)
        index, parts = self._curve.parts(times)
        return self._rows(index).reshape(*shape, 4), parts.reshape(3, *shape, 3)

    def jacobians(self, t: ArrayLike) -> SplineJacobians:
        """Return the derivatives of pose, body twist and body acceleration by four control poses at each time."""
        times, shape = self._times(t)
        index, *parts = self._curve.jacobians(times)
        return SplineJacobians(*(part.reshape(*shape, *part.shape[1:]) for part in (self._rows(index), *parts)))

    def _rows(self, index: Array) -> Array:
        """Return rows of ``controls``, which a closed curve repeats at both ends."""
        return index if self.period is None else (index - 1) % len(self.controls)

    def _values(self, name: str, t: ArrayLike, frame: Frame = "space") -> NDArray[np.float64]:
        """Return a quantity at times of any shape."""
        require_one_of("frame", frame, FRAMES)
        times, shape = self._times(t)
        found = self._curve.values(f"body_{name}" if frame == "body" else name, times)
        return found.reshape(*shape, *found.shape[1:])

    def _times(self, t: ArrayLike) -> tuple[Array, tuple[int, ...]]:
        """Return the times in one row, within the knots, and their shape."""
        times, (begin, end) = np.asarray(t, float), self.knots[[0, -1]]
        if self.period is not None:
            times = np.where((times >= begin) & (times <= end), times, begin + (times - begin) % self.period)
        outside = times[~((times >= begin) & (times <= end))]
        if outside.size:
            raise ValueError(f"t must be in [{begin:g}, {end:g}], got {outside.flat[0]:g}")
        return times.ravel(), times.shape


def _solver() -> Any:
    try:
        from . import _solving
    except ModuleNotFoundError as error:
        raise ImportError('dualcay.PoseSpline needs SciPy: pip install "scipy>=1.16"') from error
    return _solving


def neighbours(group: Group, given: ArrayLike, axis: int, count: int | None) -> Array:
    """Return poses, as many as asked for, as matrices after a check that each way round to the next is known."""
    values, n = np.asarray(given), group.size
    values, side = np.moveaxis(values, axis, 0), 4 if n == 6 else 3
    if values.shape[1:] not in ((n,), (side, side)):
        raise ValueError(f"poses must have shape (T, {side}, {side}), or (T, {n}) as vectors, got {values.shape}")
    if count not in (None, len(values)):
        raise ValueError(f"t must have one time for each pose, got {count} times and {len(values)} poses")
    values = finite("poses", values, values.shape, rows=True)
    poses = values if values.ndim == 3 else group.matrix(values)
    with np.errstate(invalid="ignore"):  # rows beyond the edge
        steps = group.vector(group.between(poses[:-1], poses[1:]))
    angles = np.linalg.norm(group.module.to_exponential(steps)[:, :3], axis=-1)
    passed = _passed(group, values) if values.ndim == 2 else np.zeros(len(steps), bool)
    finite_step = np.isfinite(steps).all(axis=-1)
    for wrong, text in (
        (~np.isfinite(poses).all(axis=(1, 2)), "poses must lie within the edge of the chart, beyond which is"),
        (np.append(False, passed), "poses must be at most half a turn apart: vectors turn further up to"),
        (np.append(False, ~finite_step), "poses half a turn apart have no vector in this chart: half a turn up to"),
    ):
        if wrong.any():
            raise ValueError(f"{text} row {np.argmax(wrong)}")
    if (near := np.flatnonzero(angles > NEAR) + 1).size:
        text = f"row {near[0]} is {angles[near[0] - 1]:.4g} rad from the row before: near half a turn the way round is"
        warnings.warn(f"{text} not determined", RuntimeWarning, stacklevel=3)
    return poses


def _passed(group: Group, v: Array) -> Array:
    """Tell for each step of vectors whether its branch goes on by more than half a turn, not back to another branch."""
    q, w = group.module.quaternion(v)[:, :4], group.module.to_exponential(v)[:, :3]
    onward = np.sum(w[1:] * w[:-1], axis=-1) >= 0
    far = abs(np.diff(np.linalg.norm(w, axis=-1))) > pi + ROUNDING
    return np.asarray(onward & (far | (np.sum(q[1:] * q[:-1], axis=-1) < -ROUNDING)))
