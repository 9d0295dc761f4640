"""Exchange with ROS: positions with quaternions, and messages of geometry_msgs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._arguments import vector_size
from ._checks import ROTATION_LAWS, require
from ._kernel import Array
from ._other_vectors import components

FIELDS = {"Pose": ("position", "orientation"), "Transform": ("translation", "rotation")}
"""Fields of the messages of geometry_msgs."""

UNIT = replace(ROTATION_LAWS["from_quaternion"], argument="xyzw")
"""Condition that ``check`` requires of a quaternion of ROS."""


def to_ros(module: Any, v: ArrayLike) -> tuple[Array, Array]:
    """Return position and orientation as ROS orders them: x y z, and the quaternion x y z w.

    Pinocchio stores a pose as the seven numbers of both, in this order.

    Parameters
    ----------
    module : module
        Kernel module of poses; a module of rotations is a TypeError.
    v : array, shape (..., 6)
        Vector of the chart, real part first.

    Returns
    -------
    xyz : array, shape (..., 3)
        Position of the body's origin in space axes.
    xyzw : array, shape (..., 4)
        Unit quaternion with the scalar last, from body to space axes.

    Examples
    --------
    >>> from dualcay import cayley2
    >>> from dualcay.interop import to_ros
    >>> xyz, xyzw = to_ros(cayley2, [0, 0, 0, 0.25, 0.5, 0.75])
    >>> xyz, xyzw
    (array([1., 2., 3.]), array([0., 0., 0., 1.]))
    """
    vector_size(module, poses=True)
    return module.pose(v)[..., :3, 3], module.quaternion(v, scalar_first=False)[..., :4]


def from_ros(module: Any, xyz: ArrayLike, xyzw: ArrayLike, branch: int = 0, *, check: bool | float = False) -> Array:
    """Return the vectors of positions x y z and quaternions x y z w, as ROS orders them.

    Parameters
    ----------
    module : module
        Kernel module of poses; a module of rotations is a TypeError.
    xyz : array, shape (..., 3)
        Position of the body's origin in space axes.
    xyzw : array, shape (..., 4)
        Quaternion with the scalar last, of any norm but 0. Leading axes broadcast with those of ``xyz``.
    branch : int
        k of ``φ(α + 2kπ) u``; 0 is principal.
    check : bool or float
        Largest violation of the unit norm allowed, otherwise ValueError; True is sqrt(eps) of the array type.

    Returns
    -------
    array, shape (..., 6)
        Vector of the chart, with this position. A quaternion of zeros, as of an empty message, gives NaN.

    Examples
    --------
    >>> from dualcay import cayley2
    >>> from dualcay.interop import from_ros
    >>> from_ros(cayley2, [1, 2, 3], [0, 0, 0, 1])
    array([0.  , 0.  , 0.  , 0.25, 0.5 , 0.75])
    """
    vector_size(module, poses=True)
    position, q = components("xyz", xyz, 3), components("xyzw", xyzw, 4)
    if check is not False:
        require(UNIT, q, -1, check)
    unit = _normalized(q)
    vector, scalar = unit[..., :3], unit[..., 3:]
    along = (position * vector).sum(axis=-1, keepdims=True)
    dual = np.concatenate([scalar * position + np.cross(position, vector), -along], axis=-1) / 2  # ½ ρ q
    both = np.concatenate([np.broadcast_to(unit, dual.shape), dual], axis=-1)
    found = np.asarray(module.from_quaternion(both, branch, scalar_first=False))
    return found.astype(np.float32) if np.result_type(position, q) == np.float32 else found


def _normalized(q: Array) -> Array:
    """Return quaternions of unit norm, in float64 at least; NaN for zeros and for components that are not finite."""
    with np.errstate(all="ignore"):
        scaled = q / abs(q).max(axis=-1, keepdims=True).astype(np.result_type(q, np.float64))
        return np.asarray(scaled / np.sqrt((scaled * scaled).sum(axis=-1, keepdims=True)))


def to_ros_message(module: Any, v: ArrayLike, kind: str = "Pose") -> dict[str, dict[str, float]]:
    """Return a pose with the fields of a message of geometry_msgs, as nested dictionaries.

    ``rosidl_runtime_py.set_message_fields`` copies them into a message.

    Parameters
    ----------
    module : module
        Kernel module of poses; a module of rotations is a TypeError.
    v : array, shape (6,)
        Vector of one pose.
    kind : {"Pose", "Transform"}
        Message: ``position`` and ``orientation``, or ``translation`` and ``rotation``.

    Returns
    -------
    dict
        Fields x y z and x y z w.

    Examples
    --------
    >>> from dualcay import cayley2
    >>> from dualcay.interop import to_ros_message
    >>> to_ros_message(cayley2, [0, 0, 0, 0.25, 0.5, 0.75])["position"]
    {'x': 1.0, 'y': 2.0, 'z': 3.0}
    """
    if kind not in FIELDS:
        raise ValueError(f"kind must be one of {', '.join(map(repr, FIELDS))}, got {kind!r}")
    if np.shape(v) != (6,):
        raise ValueError(f"v must have shape (6,), since a message holds one pose, got {np.shape(v)}")
    parts = zip(FIELDS[kind], to_ros(module, v))
    return {name: dict(zip("xyzw", map(float, values))) for name, values in parts}


def from_ros_message(module: Any, message: Any, branch: int = 0, *, check: bool | float = False) -> Array:
    """Return the vector of a message of geometry_msgs, ``Pose`` or ``Transform``.

    Parameters
    ----------
    module : module
        Kernel module of poses; a module of rotations is a TypeError.
    message : object or mapping
        Message, or nested mappings with its fields. Without these fields: TypeError.
    branch, check
        As in `from_ros`.

    Returns
    -------
    array, shape (6,)
        Vector of the chart.

    Examples
    --------
    >>> from dualcay import cayley2
    >>> from dualcay.interop import from_ros_message
    >>> message = {"translation": {"x": 1, "y": 2, "z": 3}, "rotation": {"x": 0, "y": 0, "z": 0, "w": 1}}
    >>> from_ros_message(cayley2, message)
    array([0.  , 0.  , 0.  , 0.25, 0.5 , 0.75])
    """
    for names in FIELDS.values():
        xyz, xyzw = (_field(message, name) for name in names)
        if xyz is not None and xyzw is not None:
            position, q = ([_field(part, name) for name in letters] for part, letters in ((xyz, "xyz"), (xyzw, "xyzw")))
            return from_ros(module, position, q, branch, check=check)
    expected = " or ".join(f"{kind} ({', '.join(names)})" for kind, names in FIELDS.items())
    raise TypeError(f"message must be a {expected}, got {message!r}")


def _field(message: Any, name: str) -> Any:
    """Return a field of a message or of a mapping; None if it is missing."""
    return message.get(name) if isinstance(message, Mapping) else getattr(message, name, None)
