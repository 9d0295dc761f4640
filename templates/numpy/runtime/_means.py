"""Mean of poses, the same in every chart, and the covariance of the steps from it."""

from __future__ import annotations

from math import cos, pi
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from ._arguments import require_one_of, vector_size
from ._covariances import FRAMES, FrameOfCovariance
from ._kernel import Array
from ._runtime import as_array
from ._tools import ChartModule

STEPS = 20
"""Largest number of Newton's steps. Four end at rounding from the start that `_start` gives."""

SEARCH = 1000
"""Largest number of steps towards the middle of rotations."""


@overload
def mean(
    module: ChartModule, v: ArrayLike, weights: ArrayLike | None = None, *, covariance: Literal[False] = False,
    frame: FrameOfCovariance = "body",
) -> Array: ...
@overload
def mean(
    module: ChartModule, v: ArrayLike, weights: ArrayLike | None = None, *, covariance: Literal[True],
    frame: FrameOfCovariance = "body",
) -> tuple[Array, Array]: ...
def mean(
    module: ChartModule, v: ArrayLike, weights: ArrayLike | None = None, *, covariance: bool = False,
    frame: FrameOfCovariance = "body",
) -> Array | tuple[Array, Array]:  # fmt: skip
    """Return the mean m of poses: the steps from it cancel, ``Σ w log(R(m)⁻¹ R(v)) = 0``.

    The pose is the same in every chart, and moves along if one pose multiplies all poses, on either side. The mean of
    inverses is the inverse. For rotations alone, the angles α from the mean have the least ``Σ w α²``.

    The rotations must lie within a quarter turn of some rotation c; farther apart they may have several means. Then
    one mean is within a quarter turn of c, and Newton's steps find it to rounding. Translations are free.

    Parameters
    ----------
    module : module
        Kernel module, of poses or of rotations alone.
    v : array, shape (..., N, 6)
        Vectors of N poses, on any branches; (..., N, 3) for rotations.
    weights : array, shape (..., N), optional
        Weights, at least 0 and not all 0; equal by default. Only their ratios count. Weight 0 leaves a pose out.
    covariance : bool
        True returns the covariance too.
    frame : {"body", "space", "chart"}
        Frame of the covariance: of steps, or of components of v, as in `compose_covariance`.

    Returns
    -------
    m : array, shape (..., 6)
        Principal vector of the mean.
    covariance : array, shape (..., 6, 6)
        ``Σ w δ δᵀ / Σ w`` of the steps δ from m, ``body_local(v, m)`` or ``local(v, m)``; only if asked for. For an
        estimate without bias from N independent poses of equal weights, multiply it by N/(N − 1).

    Raises
    ------
    ValueError
        If a shape or a weight is wrong, a pose is not finite, or rotations lie too far apart; the message says where.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import cayley2, mean
    >>> v = cayley2.body_retract(np.arange(6) / 10, np.array([[0.3, 0, 0, 0, 1, 0], [-0.3, 0, 0, 0, -1, 0]]))
    >>> m, P = mean(cayley2, v, covariance=True)
    >>> np.allclose(m, np.arange(6) / 10), np.diag(P).round(2)
    (True, array([0.09, 0.  , 0.  , 0.  , 1.  , 0.  ]))
    """
    require_one_of("frame", frame, FRAMES)
    n, shape = vector_size(module), np.shape(v)
    if len(shape) < 2 or shape[-1] != n or not shape[-2]:
        raise ValueError(f"v must have shape (..., N, {n}) with at least one pose, got {shape}")
    w = _weights(weights, shape[-2])
    rows, w = np.broadcast_arrays(as_array("v", v, (n,), -1, real=True), w[..., None])
    heaviest = np.take_along_axis(rows, np.argmax(w, axis=-2)[..., None, :], axis=-2)
    rows, w = np.where(w > 0, rows, heaviest), w[..., 0].astype(rows.dtype)
    with np.errstate(all="ignore"):
        m = _start(module, rows, w)
        scale = module.body_tangent_inv(module.identity()).flat[0]  # a small step over the change of v there
        for _ in range(STEPS):
            steps = module.body_local(rows, m[..., None, :])
            by_pose = module.body_local_jacobians(module.between(rows, m[..., None, :]), module.identity())[1]
            slope = -scale * np.einsum("...k,...kij->...ij", w, by_pose)
            rest = np.einsum("...k,...ki->...i", w, steps)
            move = np.linalg.solve(slope.astype(float), rest[..., None].astype(float))[..., 0].astype(rows.dtype)
            m = module.body_retract(m, move)
            if abs(rest[..., :3]).max(initial=0) < np.sqrt(np.finfo(rows.dtype).eps):  # this was one step more
                break
    m = np.asarray(module.principal(m))
    if not covariance:
        return m
    steps = (module.local if frame == "space" else module.body_local)(rows, m[..., None, :])
    if frame == "chart":
        steps = module.body_rate(m[..., None, :], steps)
    P = (w[..., None] * steps).mT @ steps
    return m, (P + P.mT) / 2


def _weights(weights: ArrayLike | None, count: int) -> Array:
    """Return weights of sum 1."""
    if weights is None:
        return np.full(count, 1 / count)
    w = as_array("weights", weights, (count,), -1, real=True)
    largest = w.max(axis=-1, keepdims=True)
    if not ((w >= 0) & (w < np.inf) & (largest > 0)).all():
        raise ValueError(f"weights must be finite, at least 0 and not all 0, got {w}")
    w = w / largest  # the sum of large weights does not overflow
    return np.asarray(w / w.sum(axis=-1, keepdims=True))


def _start(module: Any, rows: Array, w: Array) -> Array:
    """Return the vectors of the sums of quaternions, after a check that the rotations are near enough.

    Quaternions within a quarter turn of c have products with c above cos(π/4), on one of their sides. If any c exists,
    the point nearest to 0 in their convex hull is one. The search moves from the sum towards the farthest quaternion.
    """
    q = module.quaternion(rows)
    _require(np.isfinite(q).all(axis=-1), "must be finite and within the edge of the chart")
    q = q * np.copysign(1, np.sum(q[..., :4] * q[..., :1, :4], axis=-1, keepdims=True))
    start = np.einsum("...k,...ki->...i", w, q)
    sides, middle = q[..., :4], start[..., :4].copy()
    limit = cos(pi / 4) + 8 * np.finfo(rows.dtype).eps
    farthest, open_ = np.zeros(rows.shape[:-2], int), np.zeros(rows.shape[:-2], bool)
    for _ in range(SEARCH):
        products = np.sum(sides * middle[..., None, :], axis=-1)
        length = np.linalg.norm(middle, axis=-1)
        farthest, open_ = products.argmin(axis=-1), products.min(axis=-1) <= limit * length
        if not (open_ & (length > limit)).any():
            break
        toward = np.take_along_axis(sides, farthest[..., None, None], axis=-2)[..., 0, :] - middle
        part = np.clip(-np.sum(middle * toward, axis=-1) / np.sum(toward * toward, axis=-1), 0, 1)
        middle = middle + np.where(open_, part, 0)[..., None] * toward
    near = (np.arange(rows.shape[-2]) != farthest[..., None]) | ~open_[..., None]
    _require(near, "is too far from the others: one mean needs rotations within a quarter turn of some rotation")
    return np.asarray(module.from_quaternion(start))


def _require(right: Array, text: str) -> None:
    """Raise ValueError with the index of the first pose that is not right."""
    wrong = np.argwhere(~right)
    if len(wrong):
        raise ValueError(f"v[{', '.join(map(str, wrong[0]))}] {text}")
