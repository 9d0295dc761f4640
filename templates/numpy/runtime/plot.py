"""Pictures of poses and motions by Matplotlib: frames, trajectories, ellipsoids of covariance, rotation angles.

Each function draws into given axes and returns them; without axes it makes a figure. Axes may have three dimensions, or
two that show a plane of the space axes. Keywords that are not listed go to ``Axes.plot``. Text and grounds have the
colours of the style sheet in use, and the colours of the lines are visible on light and dark grounds.
"""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._kernel import Array
from ._motion import Motion
from ._other_vectors import components

__all__ = ["angles", "ellipsoids", "frames", "trajectory"]

COLOURS = ("tab:red", "tab:green", "tab:blue")
"""Colours of the axes x, y, z of a frame."""

PART = 0.08
"""Length of the axes of a frame, as a part of the largest extent of the positions."""

TURN = np.linspace(0, 2 * np.pi, 61)
FINE = 1000
"""Least number of times at which the angles of a motion are drawn."""


def frames(
    poses: ArrayLike, axes: Any = None, *, length: float | None = None, plane: str | None = None, **style: Any
) -> Any:
    """Draw the axes x, y, z of poses in red, green and blue, one line of Matplotlib for each colour.

    Parameters
    ----------
    poses : array, shape (..., 4, 4)
        Homogeneous matrices.
    axes : Axes, optional
        Axes to draw into, of two or three dimensions; without them, new ones: of two if a plane is named.
    length : float, optional
        Length of the axes; without it, 0.08 of the largest extent of the positions, or 1 for a single place.
    plane : str, optional
        Space axes to the right and upwards in axes of two dimensions, such as "xz"; "xy" without it.

    Returns
    -------
    Axes
        The axes.

    Examples
    --------
    >>> from dualcay import cayley2, plot
    >>> axes = plot.frames(cayley2.pose(cayley2.random(5, rng=0)))
    >>> len(axes.lines)
    3
    """
    matrices = _poses("poses", poses).reshape(-1, 4, 4)
    origins, directions = matrices[:, :3, 3], matrices[:, :3, :3]
    if length is None:
        length = PART * float(np.ptp(origins, axis=0).max(initial=0.0)) or 1.0
    axes, shown = _space(axes, plane)
    for column, colour in enumerate(COLOURS):
        tips = origins + length * directions[:, :, column]
        _lines(axes, np.stack([origins, tips], axis=1)[..., shown], {"color": colour, **style})
    return axes


def trajectory(motion: Motion | ArrayLike, axes: Any = None, *, plane: str | None = None, **style: Any) -> Any:
    """Draw the way of the origin of the body.

    Parameters
    ----------
    motion : Motion or array, shape (T, 4, 4)
        Motion of `propagate`, drawn straight between its times; or poses, such as ``spline.pose(t)``.
    axes, plane
        As in `frames`.

    Returns
    -------
    Axes
        The axes.

    Examples
    --------
    >>> from dualcay import plot, propagate, cayley2
    >>> motion = propagate(cayley2, cayley2.identity(), [0, 0, 1, 1, 0, 0], [0, 1, 2])
    >>> axes = plot.trajectory(motion, label="circle")
    >>> len(axes.lines[0].get_data_3d()[0])
    3
    """
    poses = _poses("motion", motion.pose if isinstance(motion, Motion) else motion)
    axes, shown = _space(axes, plane)
    _lines(axes, poses[..., :3, 3].reshape(1, -1, 3)[..., shown], style)
    return axes


def ellipsoids(
    points: ArrayLike, covariance: ArrayLike, axes: Any = None, *, deviations: float = 3.0,
    plane: str | None = None, **style: Any,
) -> Any:  # fmt: skip
    """Draw ellipsoids of covariance by their three principal sections; in two dimensions, the outline of their shadow.

    Parameters
    ----------
    points : array, shape (..., 3)
        Centres.
    covariance : array, shape (..., 3, 3)
        Covariances of the points, such as those of `transform_point_covariance`.
    axes, plane
        As in `frames`.
    deviations : float
        Half axes in standard deviations. With 3, an ellipsoid holds 97.1 % of normal points, and an outline 98.9 %.

    Returns
    -------
    Axes
        The axes.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import plot
    >>> axes = plot.ellipsoids([0, 0, 0], np.diag([1, 4, 9]), deviations=1)
    >>> [float(np.nanmax(one)) for one in axes.lines[0].get_data_3d()]
    [1.0, 2.0, 3.0]
    """
    axes, shown = _space(axes, plane)
    centres = components("points", points, 3)[..., shown].reshape(-1, 1, len(shown))
    P = components("covariance", covariance, 3, 3)[..., np.array(shown)[:, None], shown]
    sizes, directions = np.linalg.eigh(P.reshape(-1, len(shown), len(shown)))
    half = deviations * np.sqrt(np.maximum(sizes, 0))[:, None] * directions
    if len(half) != len(centres):
        raise ValueError(f"covariance must have a matrix for each point, got {len(half)} for {len(centres)}")
    circles = [
        centres + half[:, None, :, i] * np.cos(TURN)[:, None] + half[:, None, :, j] * np.sin(TURN)[:, None]
        for i, j in combinations(range(len(shown)), 2)
    ]
    _lines(axes, np.concatenate(circles), {"linewidth": 0.8, **style})
    return axes


def angles(motion: Motion, axes: Any = None, **style: Any) -> Any:
    """Draw the rotation angle of v on its own branch over time, in degrees, with dotted lines at changes of branch.

    Parameters
    ----------
    motion : Motion
        Motion of `propagate`.
    axes : Axes, optional
        Axes to draw into, of two dimensions; without them, new ones.

    Returns
    -------
    Axes
        The axes.

    Examples
    --------
    >>> from dualcay import cayley2, plot, propagate
    >>> axes = plot.angles(propagate(cayley2, cayley2.identity(), [0, 0, 1, 0, 0, 0], [0, 6]))
    >>> axes.get_ylabel(), len(axes.lines)  # the angle, and one change of branch
    ('rotation angle of v (°)', 2)
    """
    if not isinstance(motion, Motion):
        raise TypeError(f"motion must be a Motion of propagate, got {type(motion).__name__}")
    axes = _axes(axes, None)
    t = np.union1d(motion.t, np.linspace(motion.t[0], motion.t[-1], FINE))
    shown = np.degrees(motion.module.angle(motion(t))[:, 0])
    places = np.searchsorted(t, motion.switches)
    axes.plot(np.insert(t, places, motion.switches), np.insert(shown, places, np.nan), **style)
    for time in motion.switches:
        axes.axvline(time, color="tab:gray", linestyle=":", linewidth=0.8)
    axes.set(xlabel="time (s)", ylabel="rotation angle of v (°)")
    return axes


def _poses(name: str, poses: Any) -> Array:
    """Return poses as an array; the error for something else says how to make poses of it."""
    wanted = f"{name} must be poses, of shape (..., 4, 4)"
    if hasattr(poses, "pose"):
        raise TypeError(f"{wanted}, such as those of its pose, got {type(poses).__name__}")
    if (shape := np.shape(poses))[-1:] == (6,):
        raise ValueError(f"{wanted}, such as cayley2.pose(v), got vectors of shape {shape}")
    return components(name, poses, 4, 4)


def _axes(axes: Any, projection: str | None) -> Any:
    """Return given axes after a check, or new ones."""
    if axes is None:
        return _pyplot().figure(layout="constrained").add_subplot(projection=projection)
    if not hasattr(axes, "plot"):
        raise TypeError(f"axes must be Axes of Matplotlib, such as figure.add_subplot(), got {type(axes).__name__}")
    return axes


def _space(axes: Any, plane: str | None) -> tuple[Any, list[int]]:
    """Return axes with names, and the components that they show: three without a plane."""
    if plane is not None and sorted(plane) not in (["x", "y"], ["x", "z"], ["y", "z"]):
        raise ValueError(f"plane must be two of the letters x, y, z, got {plane!r}")
    axes = _axes(axes, None if plane else "3d")
    shown = ["xyz".index(letter) for letter in ("xyz" if axes.name == "3d" else plane or "xy")]
    for direction, index in zip("xyz", shown):
        if not getattr(axes, f"get_{direction}label")():
            axes.set(**{f"{direction}label": "xyz"[index]})
    return axes, shown


def _lines(axes: Any, pieces: Array, style: dict[str, Any]) -> None:
    """Draw pieces (N, points, components) as one line with gaps, and keep one scale for all directions."""
    ended = np.concatenate([pieces, np.full_like(pieces[:, :1], np.nan)], axis=1).reshape(-1, pieces.shape[-1])[:-1]
    axes.plot(*ended.T, **style)
    axes.set_aspect("equal")


def _pyplot() -> Any:
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError('dualcay.plot needs Matplotlib: pip install "matplotlib>=3.9"') from error
    return pyplot
