"""Exchange with other libraries: SciPy, ROS, files of poses, the order of a twist, the Cayley vector of 4x4 matrices.

Names say the target (``to_``, ``write_``) or the source (``from_``, ``read_``). Functions of a chart take its kernel
module first.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._arguments import vector_size
from ._kernel import Array
from ._other_vectors import (
    from_cayley_4x4,
    from_linear_angular,
    from_linear_angular_matrix,
    to_cayley_4x4,
    to_linear_angular,
    to_linear_angular_matrix,
)
from ._pose_files import read_euroc, read_kitti, read_tum, write_kitti, write_tum
from ._pose_graph import PoseGraph, read_g2o, write_g2o
from ._ros import from_ros, from_ros_message, to_ros, to_ros_message

__all__ = [
    "PoseGraph", "from_cayley_4x4", "from_linear_angular", "from_linear_angular_matrix", "from_rigid_transform",
    "from_ros", "from_ros_message", "from_rotation", "read_euroc", "read_g2o", "read_kitti", "read_tum",
    "to_cayley_4x4", "to_linear_angular", "to_linear_angular_matrix", "to_rigid_transform", "to_ros",
    "to_ros_message", "to_rotation", "write_g2o", "write_kitti", "write_tum",
]  # fmt: skip


def to_rotation(module: Any, v: ArrayLike) -> Any:
    """Return the rotations of a vector as ``scipy.spatial.transform.Rotation``.

    Parameters
    ----------
    module : module
        Kernel module, of poses or of rotations alone.
    v : array, shape (..., 6), or (..., 3) for rotations alone
        Vector of the chart, real part first. SciPy before 1.17 takes at most one leading axis.

    Returns
    -------
    Rotation
        Rotation from body to space axes, in float64. The translation of a pose is left out.

    Raises
    ------
    ImportError
        If SciPy is missing or older than 1.16.

    Examples
    --------
    >>> from dualcay.interop import to_rotation
    >>> from dualcay.rotation import cayley2
    >>> to_rotation(cayley2, [0.1, 0.2, 0.3]).as_mrp()
    array([0.1, 0.2, 0.3])
    """
    vector_size(module)
    return _scipy("Rotation").from_quat(module.quaternion(v)[..., :4], scalar_first=True)


def from_rotation(module: Any, rotation: Any, branch: int = 0) -> Array:
    """Return the vectors of ``scipy.spatial.transform.Rotation``.

    Parameters
    ----------
    module : module
        Kernel module, of poses or of rotations alone.
    rotation : Rotation
        Rotation from body to space axes, of any shape (...).
    branch : int
        k of ``φ(α + 2kπ) u``; 0 is principal.

    Returns
    -------
    array, shape (..., 6), or (..., 3) for rotations alone
        Vector of the chart, for poses without translation.

    Examples
    --------
    >>> from dualcay.interop import from_rotation
    >>> from dualcay.rotation import exponential
    >>> from scipy.spatial.transform import Rotation
    >>> from_rotation(exponential, Rotation.from_rotvec([0.1, 0.2, 0.3]))
    array([0.1, 0.2, 0.3])
    """
    size, q = vector_size(module), rotation.as_quat(scalar_first=True)
    if size == 6:
        q = np.concatenate([q, np.zeros_like(q)], axis=-1)
    return np.asarray(module.from_quaternion(q, branch))


def to_rigid_transform(module: Any, v: ArrayLike) -> Any:
    """Return the poses of a vector as ``scipy.spatial.transform.RigidTransform``.

    Parameters
    ----------
    module : module
        Kernel module of poses; a module of rotations is a TypeError.
    v : array, shape (..., 6)
        Vector of the chart, real part first. SciPy before 1.17 takes at most one leading axis.

    Returns
    -------
    RigidTransform
        Transform that takes points from body to space axes, in float64.

    Raises
    ------
    ImportError
        If SciPy is missing or older than 1.16.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import cayley3
    >>> from dualcay.interop import to_rigid_transform
    >>> v = cayley3.random(5, rng=0)
    >>> np.allclose(to_rigid_transform(cayley3, v).as_matrix(), cayley3.pose(v))
    True
    """
    vector_size(module, poses=True)
    return _scipy("RigidTransform").from_dual_quat(module.quaternion(v), scalar_first=True)


def from_rigid_transform(module: Any, transform: Any, branch: int = 0) -> Array:
    """Return the vectors of ``scipy.spatial.transform.RigidTransform``.

    Parameters
    ----------
    module : module
        Kernel module of poses; a module of rotations is a TypeError.
    transform : RigidTransform
        Transform from body to space axes, of any shape (...).
    branch : int
        k of ``φ(α + 2kπ) u``; 0 is principal.

    Returns
    -------
    array, shape (..., 6)
        Vector of the chart: real part (dimensionless), then dual part (length unit of the transform).

    Examples
    --------
    >>> from dualcay import exponential
    >>> from dualcay.interop import from_rigid_transform
    >>> from scipy.spatial.transform import RigidTransform
    >>> from_rigid_transform(exponential, RigidTransform.from_translation([1, 2, 3]))
    array([0., 0., 0., 1., 2., 3.])
    """
    vector_size(module, poses=True)
    return np.asarray(module.from_quaternion(transform.as_dual_quat(scalar_first=True), branch))


def _scipy(name: str) -> Any:
    """Return a class of SciPy; raise ImportError with the command that installs it."""
    try:
        from scipy.spatial import transform  # type: ignore[import, unused-ignore]

        return getattr(transform, name)
    except (ImportError, AttributeError) as error:
        raise ImportError(f'{name} needs SciPy 1.16 or later: pip install "scipy>=1.16"') from error
