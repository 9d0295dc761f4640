"""Covariances of products, motions, inverses and moved points, to first order."""

from __future__ import annotations

from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from ._arguments import require_one_of, vector_size
from ._branches import require_symmetric
from ._kernel import Array
from ._runtime import as_array
from ._tools import ChartModule

FrameOfCovariance: TypeAlias = Literal["body", "space", "chart"]
FRAMES = get_args(FrameOfCovariance)


def compose_covariance(
    module: ChartModule, v2: ArrayLike, v1: ArrayLike, covariance2: ArrayLike, covariance1: ArrayLike,
    cross: ArrayLike | None = None, *, frame: FrameOfCovariance = "body",
) -> Array:  # fmt: skip
    """Return the covariance of ``compose(v2, v1)`` to first order.

    Covariances are of small steps δ: in ``R(v) exp(δ)`` for the frame ``"body"``, as `mean` has them, and in
    ``exp(δ) R(v)`` for ``"space"``. They are the same in every chart. For ``"chart"`` they are of the components of v,
    as `switch` and `propagate` have them. All have the order [rotation, translation].

    Parameters
    ----------
    module : module
        Kernel module, of poses or of rotations alone.
    v2, v1 : array, shape (..., 6), or (..., 3) for rotations
        Vectors of the chart.
    covariance2, covariance1 : array, shape (..., 6, 6), or (..., 3, 3) for rotations
        Covariances of v2 and of v1 in the frame, symmetric; 0 for a known pose.
    cross : array, shape (..., 6, 6), or (..., 3, 3) for rotations, optional
        Covariance of the rows, for v2, with the columns, for v1; 0 by default, for independent poses.
    frame : {"body", "space", "chart"}
        Frame of the arguments and of the result.

    Returns
    -------
    array, shape (..., 6, 6), or (..., 3, 3) for rotations
        Symmetric. Terms of fourth order in the deviations are left out.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import cayley2, compose_covariance
    >>> turn, move = [0, 0, 0.5, 0, 0, 0], [0, 0, 0, 0.5, 0, 0]  # by 106°, then 2 along the turned x axis
    >>> P = compose_covariance(cayley2, turn, move, np.diag([0, 0, 1e-4, 0, 0, 0]), np.zeros((6, 6)))
    >>> np.sqrt(np.diag(P)).round(3)  # 0.01 rad moves the end sideways by 0.02
    array([0.  , 0.  , 0.01, 0.  , 0.02, 0.  ])
    """
    if _frame(module, frame) == "chart":
        jacobians = module.compose_jacobians(v2, v1)
    elif frame == "space":
        jacobians = _identity(module, v1), module.adjoint(v2)
    else:
        jacobians = module.adjoint(module.inverse(v1)), _identity(module, v2)
    return _combined(jacobians, {"covariance2": covariance2, "covariance1": covariance1}, cross)


def between_covariance(
    module: ChartModule, v2: ArrayLike, v1: ArrayLike, covariance2: ArrayLike, covariance1: ArrayLike,
    cross: ArrayLike | None = None, *, frame: FrameOfCovariance = "body",
) -> Array:  # fmt: skip
    """Return the covariance of ``between(v2, v1)`` to first order.

    Parameters and result are as in `compose_covariance`. Neighbours of one trajectory share errors: give ``cross``.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import between_covariance, cayley2
    >>> v, P = cayley2.random(rng=0), np.eye(6) / 100
    >>> np.allclose(between_covariance(cayley2, v, v, P, P, P), 0)  # equal errors cancel
    True
    """
    if _frame(module, frame) == "chart":
        jacobians = module.between_jacobians(v2, v1)
    elif frame == "space":
        back = module.adjoint(module.inverse(v1)) @ _identity(module, v2)
        jacobians = back, -back
    else:
        jacobians = _identity(module, v2), -module.adjoint(module.between(v1, v2))
    return _combined(jacobians, {"covariance2": covariance2, "covariance1": covariance1}, cross)


def inverse_covariance(
    module: ChartModule, v: ArrayLike, covariance: ArrayLike, *, frame: FrameOfCovariance = "body"
) -> Array:
    """Return the covariance of ``inverse(v)``; parameters and result are as in `compose_covariance`.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import cayley2, inverse_covariance
    >>> v, P = cayley2.random(rng=0), np.diag([1.0, 2, 3, 4, 5, 6]) / 1e4
    >>> there = inverse_covariance(cayley2, v, P)
    >>> np.allclose(inverse_covariance(cayley2, cayley2.inverse(v), there), P)
    True
    """
    if _frame(module, frame) == "chart":  # the vector is −v
        return _combined((_identity(module, v),), {"covariance": covariance})
    return _combined((module.adjoint(v if frame == "body" else module.inverse(v)),), {"covariance": covariance})


def transform_point_covariance(
    module: ChartModule, v: ArrayLike, r: ArrayLike, covariance: ArrayLike, point_covariance: ArrayLike | None = None,
    cross: ArrayLike | None = None, *, frame: FrameOfCovariance = "body",
) -> Array:  # fmt: skip
    """Return the covariance (..., 3, 3) of ``transform_point(v, r)`` to first order.

    Parameters are as in `compose_covariance`, with the point r (..., 3) and its ``point_covariance`` (..., 3, 3), 0 by
    default. ``cross``, of shape (..., 6, 3), has rows for the pose and columns for r.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import cayley2, transform_point_covariance
    >>> P = transform_point_covariance(cayley2, np.zeros(6), [2, 0, 0], np.diag([0, 0, 1e-4, 0, 0, 0]))
    >>> np.sqrt(np.diag(P))  # 0.01 rad at the distance 2
    array([0.  , 0.02, 0.  ])
    """
    by_chart = _frame(module, frame) == "chart"
    by_v, by_r = module.transform_point_jacobians(v, r)
    if not by_chart:
        eye, about = np.eye(3, dtype=by_r.dtype), module.transform_point(v, r) if frame == "space" else np.asarray(r)
        turned = -np.cross(eye, about[..., None, :])
        by_v = np.concatenate([turned, np.broadcast_to(eye, turned.shape)], axis=-1)[..., : by_v.shape[-1]]
        by_v = by_v if frame == "space" else by_r @ by_v
    point = np.zeros((3, 3), by_r.dtype) if point_covariance is None else point_covariance
    return _combined((by_v, by_r), {"covariance": covariance, "point_covariance": point}, cross)


def _frame(module: ChartModule, frame: FrameOfCovariance) -> str:
    vector_size(module)
    return require_one_of("frame", frame, FRAMES)


def _identity(module: ChartModule, v: ArrayLike) -> Array:
    """Return an identity matrix for each vector."""
    n = len(module.identity())
    array = as_array("v", v, (n,), -1, real=True)
    return np.broadcast_to(np.eye(n, dtype=array.dtype), (*array.shape, n))


def _combined(jacobians: tuple[Array, ...], covariances: dict[str, ArrayLike], cross: ArrayLike | None = None) -> Array:
    """Return the covariance of a function of one or two arguments from its derivatives."""
    total: Any = 0
    for J, (name, value) in zip(jacobians, covariances.items(), strict=True):
        P = as_array(name, value, (J.shape[-1], J.shape[-1]), -1, real=True)
        require_symmetric(name, P)
        total = total + J @ P @ J.mT
    if cross is not None:
        first, second = jacobians
        between = as_array("cross", cross, (first.shape[-1], second.shape[-1]), -1, real=True)
        total = total + 2 * (first @ between @ second.mT)
    return np.asarray((total + total.mT) / 2)
