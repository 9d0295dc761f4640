"""Vectors and matrices as other libraries have them: the order of a twist, and the Cayley vector of 4x4 matrices.

They take arrays of JAX too, also under ``jit``.
"""

from __future__ import annotations

from typing import cast

import numpy as np
from numpy.typing import ArrayLike

from ._kernel import Array

SWAPPED = np.array([3, 4, 5, 0, 1, 2])
"""Places of [v, ω] in [ω, v], and the other way round."""


def to_linear_angular(twist: ArrayLike) -> Array:
    """Return twists [v, ω] from twists [ω, v]: the order of pinocchio, jaxlie and manif.

    The halves are swapped; frame and reference point stay. GTSAM has the order [ω, v], as here. Vectors of a chart,
    such as exponential coordinates, are swapped alike. Wrenches [f, m] have the order of pinocchio already.

    Parameters
    ----------
    twist : array, shape (..., 6)
        Twist [ω, v], or another vector with its rotational half first.

    Returns
    -------
    array, shape (..., 6)
        The same with its translational half first.

    Examples
    --------
    >>> from dualcay.interop import to_linear_angular
    >>> to_linear_angular([1, 2, 3, 40, 50, 60])
    array([40, 50, 60,  1,  2,  3])
    """
    return components("twist", twist, 6)[..., SWAPPED]


def from_linear_angular(twist: ArrayLike) -> Array:
    """Return twists [ω, v] from twists [v, ω]: the inverse of `to_linear_angular`.

    Parameters
    ----------
    twist : array, shape (..., 6)
        Twist [v, ω].

    Returns
    -------
    array, shape (..., 6)
        Twist [ω, v].

    Examples
    --------
    >>> from dualcay.interop import from_linear_angular
    >>> from_linear_angular([40, 50, 60, 1, 2, 3])
    array([ 1,  2,  3, 40, 50, 60])
    """
    return to_linear_angular(twist)


def to_linear_angular_matrix(matrix: ArrayLike) -> Array:
    """Return 6x6 matrices for twists [v, ω] from those for [ω, v]: rows and columns are swapped by halves.

    Adjoints, Jacobians and covariances are such matrices.

    Parameters
    ----------
    matrix : array, shape (..., 6, 6)
        Matrix that acts on twists [ω, v], or covariance of such.

    Returns
    -------
    array, shape (..., 6, 6)
        The same for twists [v, ω].

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import cayley2
    >>> from dualcay.interop import to_linear_angular, to_linear_angular_matrix
    >>> adjoint, twist = cayley2.adjoint(cayley2.random(rng=0)), np.arange(6)
    >>> np.allclose(to_linear_angular(adjoint @ twist), to_linear_angular_matrix(adjoint) @ to_linear_angular(twist))
    True
    """
    return components("matrix", matrix, 6, 6)[..., SWAPPED[:, None], SWAPPED]


def from_linear_angular_matrix(matrix: ArrayLike) -> Array:
    """Return 6x6 matrices for twists [ω, v] from those for [v, ω]: the inverse of `to_linear_angular_matrix`.

    Parameters
    ----------
    matrix : array, shape (..., 6, 6)
        Matrix that acts on twists [v, ω], or covariance of such.

    Returns
    -------
    array, shape (..., 6, 6)
        The same for twists [ω, v].

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay.interop import from_linear_angular_matrix
    >>> np.diag(from_linear_angular_matrix(np.diag([40, 50, 60, 1, 2, 3])))
    array([ 1,  2,  3, 40, 50, 60])
    """
    return to_linear_angular_matrix(matrix)


def to_cayley_4x4(v: ArrayLike, scale: float = 1.0) -> Array:
    r"""Return the vector whose Cayley map of 4x4 matrices gives the same pose.

    The Cayley map of homogeneous matrices has the same rotation and another translation. For every order n,

    .. math:: T = [(I - A)^{-1} (I + A)]^n, \quad A = \frac{1}{K} \begin{pmatrix} \tilde v & t \\ 0 & 0 \end{pmatrix},
        \quad t = v^\circ - \frac{v \cdot v^\circ}{K^2 + v \cdot v} v

    is the pose of the vector v + ε v° of the chart K tan(α/2n) u.

    Parameters
    ----------
    v : array, shape (..., 6)
        Vector of the chart: real part v, then dual part v°. Any branch.
    scale : float
        K of the chart: 1 for ``cayleyN``, 2n for ``scaledN``. The map with A/2, common for n = 1, has K = 2.

    Returns
    -------
    array, shape (..., 6)
        Vector [v, t]. Defined for every v.

    Examples
    --------
    >>> from dualcay.interop import to_cayley_4x4
    >>> to_cayley_4x4([0, 0, 0.5, 1, 2, 2.5])  # translations differ along the axis alone
    array([0. , 0. , 0.5, 1. , 2. , 2. ])
    """
    array = components("v", v, 6)
    real, dual = array[..., :3], array[..., 3:]
    factor = (real * dual).sum(axis=-1, keepdims=True) / (scale**2 + (real * real).sum(axis=-1, keepdims=True))
    return _joined(real, dual - factor * real)


def from_cayley_4x4(vector: ArrayLike, scale: float = 1.0) -> Array:
    r"""Return the vector of the chart with the pose of a Cayley map of 4x4 matrices: the inverse of `to_cayley_4x4`.

    .. math:: v^\circ = t + \frac{v \cdot t}{K^2} v

    Parameters
    ----------
    vector : array, shape (..., 6)
        Vector [v, t] of the map in `to_cayley_4x4`: rotational half first.
    scale : float
        K of the chart: 1 for ``cayleyN``, 2n for ``scaledN``.

    Returns
    -------
    array, shape (..., 6)
        Vector v, v° of the chart. Defined for every vector.

    Examples
    --------
    >>> from dualcay.interop import from_cayley_4x4
    >>> from_cayley_4x4([0, 0, 0.5, 1, 2, 2])
    array([0. , 0. , 0.5, 1. , 2. , 2.5])
    """
    array = components("vector", vector, 6)
    real, translation = array[..., :3], array[..., 3:]
    factor = (real * translation).sum(axis=-1, keepdims=True) / scale**2
    return _joined(real, translation + factor * real)


def components(name: str, value: ArrayLike, *part: int) -> Array:
    """Return an argument as an array after a check of its component axes; arrays of JAX and CuPy stay what they are."""
    array = cast("Array", value) if hasattr(value, "__array_namespace__") else np.asarray(value)
    if tuple(array.shape)[-len(part) :] != part:
        raise ValueError(f"{name} must have shape (..., {', '.join(map(str, part))}), got {tuple(array.shape)}")
    return array


def _joined(first: Array, second: Array) -> Array:
    found: Array = first.__array_namespace__().concat([first, second], axis=-1)
    return found
