"""Files of poses: TUM, KITTI and EuRoC. An error names the file and the line.

Numbers are written so that they are read again to the last bit. Fields are separated by spaces or commas; the text
after # is a comment.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from os import PathLike, fspath
from pathlib import Path
from typing import IO, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from ._arguments import finite, vector_size
from ._checks import LAWS, ROTATION_LAWS, Law, require
from ._kernel import Array
from ._ros import from_ros, to_ros

File: TypeAlias = "str | PathLike[str] | IO[str]"

ROUNDED = 1e-3
"""Violation of the unit norm or of orthogonality that is allowed; numbers of four decimals violate it by up to 2e-4."""

QUATERNION = "tx ty tz qx qy qz qw"
TUM = f"timestamp {QUATERNION}"
KITTI = "r11 r12 r13 tx r21 r22 r23 ty r31 r32 r33 tz"
EUROC = "px py pz qw qx qy qz"


def read_tum(module: Any, file: File, *, check: bool | float = ROUNDED) -> tuple[Array, Array]:
    """Return times and vectors of a TUM file, with a line ``timestamp tx ty tz qx qy qz qw`` for each pose.

    Parameters
    ----------
    module : module
        Kernel module of poses; a module of rotations is a TypeError.
    file : path or text file
        File to read.
    check : bool or float
        Largest violation of the unit norm allowed; True is 1.5e-8, False allows any norm but 0.

    Returns
    -------
    t : array, shape (T,)
        Times (s) as the file has them, also where they decrease.
    v : array, shape (T, 6)
        Principal vectors of the chart. `unwrap` makes them continuous.

    Raises
    ------
    ValueError
        If a line has other fields, or a quaternion is no unit quaternion. The message names file and line.

    Examples
    --------
    >>> from io import StringIO
    >>> from dualcay import cayley2, interop
    >>> interop.read_tum(cayley2, StringIO("0.5 1 2 3 0 0 0 1"))
    (array([0.5]), array([[0.  , 0.  , 0.  , 0.25, 0.5 , 0.75]]))
    """
    vector_size(module, poses=True)
    places, rows = table(file, TUM)
    return rows[:, 0], vectors(module, places, rows[:, 1:4], rows[:, 4:], check)


def write_tum(module: Any, file: File, t: ArrayLike, v: ArrayLike) -> None:
    """Write times and vectors as a TUM file, which `read_tum` reads.

    Parameters
    ----------
    module, file
        As in `read_tum`. An existing file is replaced.
    t : array, shape (T,)
        Times (s).
    v : array, shape (T, 6)
        Vectors of the chart.

    Raises
    ------
    ValueError
        If a shape is wrong, or a pose is not finite. Nothing is written then.

    Examples
    --------
    >>> import sys
    >>> from dualcay import cayley2, interop
    >>> interop.write_tum(cayley2, sys.stdout, [0.5], [[0, 0, 0, 0.25, 0.5, 0.75]])
    0.5 1.0 2.0 3.0 0.0 0.0 0.0 1.0
    """
    if np.ndim(t) > np.ndim(v):
        raise ValueError(f"expected times t (T,), then vectors v (T, 6), got {np.shape(t)}, then {np.shape(v)}")
    poses = position_quaternions(module, "v", v)
    write(file, np.column_stack([finite("t", t, poses.shape[:1], rows=True), poses]).tolist())


def read_kitti(module: Any, file: File, *, check: bool | float = ROUNDED) -> Array:
    """Return the vectors of a KITTI file, with the upper three rows of a homogeneous matrix in each line.

    Parameters
    ----------
    module, file
        As in `read_tum`. The file has no times: KITTI keeps them in another one, ``times.txt``.
    check : bool or float
        Largest violation of orthogonality allowed; True is 1.5e-8, False allows any.

    Returns
    -------
    array, shape (T, 6)
        Principal vectors of the chart. `unwrap` makes them continuous.

    Raises
    ------
    ValueError
        If a line has other fields, or no rotation. The message names file and line.

    Examples
    --------
    >>> from io import StringIO
    >>> from dualcay import cayley2, interop
    >>> interop.read_kitti(cayley2, StringIO("1 0 0 1 0 1 0 2 0 0 1 3"))
    array([[0.  , 0.  , 0.  , 0.25, 0.5 , 0.75]])
    """
    vector_size(module, poses=True)
    places, rows = table(file, KITTI)
    matrices = np.tile(np.eye(4), (len(rows), 1, 1))
    matrices[:, :3] = rows.reshape(-1, 3, 4)
    require_rows(LAWS["from_pose"], matrices, places, check)
    return np.asarray(module.from_pose(matrices))


def write_kitti(module: Any, file: File, v: ArrayLike) -> None:
    """Write vectors as a KITTI file, which `read_kitti` reads.

    Parameters
    ----------
    module, file
        As in `read_tum`. An existing file is replaced.
    v : array, shape (T, 6)
        Vectors of the chart.

    Raises
    ------
    ValueError
        If the shape is wrong, or a pose is not finite. Nothing is written then.

    Examples
    --------
    >>> import sys
    >>> from dualcay import cayley2, interop
    >>> interop.write_kitti(cayley2, sys.stdout, [[0, 0, 0, 0.25, 0.5, 0.75]])
    1.0 0.0 0.0 1.0 0.0 1.0 0.0 2.0 0.0 0.0 1.0 3.0
    """
    vector_size(module, poses=True)
    poses = module.pose(rows_of("v", v))
    write(file, finite("pose", poses[:, :3].reshape(-1, 12), (len(poses), 12), rows=True).tolist())


def read_euroc(module: Any, file: File, *, check: bool | float = ROUNDED) -> tuple[Array, Array]:
    """Return times and vectors of a EuRoC file, with a line ``ns, px, py, pz, qw, qx, qy, qz`` for each pose.

    Further columns, such as velocities and biases of sensors, are left out.

    Parameters
    ----------
    module, file, check
        As in `read_tum`. A file is ``state_groundtruth_estimate0/data.csv``, for example.

    Returns
    -------
    ns : array of int64, shape (T,)
        Times (ns). Their differences are exact, and floats in seconds since 1970 would round them by 100 ns.
    v : array, shape (T, 6)
        Principal vectors of the chart. `unwrap` makes them continuous.

    Raises
    ------
    ValueError
        If a line has other fields, or a quaternion is no unit quaternion. The message names file and line.

    Examples
    --------
    >>> from io import StringIO
    >>> from dualcay import cayley2, interop
    >>> interop.read_euroc(cayley2, StringIO("1403636580838555648,1,2,3,1,0,0,0"))
    (array([1403636580838555648]), array([[0.  , 0.  , 0.  , 0.25, 0.5 , 0.75]]))
    """
    vector_size(module, poses=True)
    places, ns, rows = [], [], []
    for place, fields in lines(file):
        places.append(place)
        ns.append(whole(place, "timestamp", fields[0]))
        rows.append(numbers(place, fields[1:8], EUROC))
    poses = np.array(rows, float).reshape(-1, 7)
    v = vectors(module, places, poses[:, :3], poses[:, 3:], check, EUROC)
    return np.array(ns, np.int64), v


def lines(file: File) -> Iterator[tuple[str, list[str]]]:
    """Yield ``file:line`` and the fields of each line that has any."""
    with _opened(file, "r") as stream:
        name = getattr(stream, "name", "file")
        for number, line in enumerate(stream, 1):
            line = line.partition("#")[0].strip()
            if line:  # an empty field between commas is a field
                yield f"{name}:{number}", [field.strip() for field in line.split(",")] if "," in line else line.split()


def table(file: File, layout: str) -> tuple[list[str], Array]:
    """Return ``file:line`` and the numbers of each line."""
    found = [(place, numbers(place, fields, layout)) for place, fields in lines(file)]
    return [place for place, _ in found], np.array([row for _, row in found], float).reshape(-1, len(layout.split()))


def numbers(place: str, fields: Sequence[str], layout: str) -> list[float]:
    """Return the numbers of a line, after a check that it has those of a layout."""
    names, found = layout.split(), []
    if len(fields) != len(names):
        raise ValueError(f"{place}: expected {len(names)} numbers ({layout}), got {len(fields)}")
    for name, text in zip(names, fields):
        try:
            found.append(float(text))
        except ValueError:
            found.append(math.nan)
        if not math.isfinite(found[-1]):
            raise ValueError(f"{place}: {name} must be a finite number, got {text!r}")
    return found


def whole(place: str, name: str, text: str) -> int:
    try:
        return int(np.int64(int(text)))
    except (ValueError, OverflowError):
        raise ValueError(f"{place}: {name} must be a whole number of 64 bits, got {text!r}") from None


def vectors(
    module: Any, places: Sequence[str], xyz: Array, q: Array, check: bool | float, layout: str = QUATERNION
) -> Array:  # fmt: skip
    """Return the vectors of positions and quaternions, in the order of a layout, after a check of the norms."""
    names = layout.split()[3:]
    require_rows(replace(ROTATION_LAWS["from_quaternion"], argument=" ".join(names)), q, places, check)
    return from_ros(module, xyz, q if names[-1] == "qw" else np.roll(q, -1, axis=-1))


def require_rows(law: Law, rows: Array, places: Sequence[str], check: bool | float) -> None:
    """Raise an error that names file and line unless all rows meet a condition."""
    try:
        require(law, rows, -1, check)
    except ValueError:
        for place, row in zip(places, rows):
            try:
                require(law, row, -1, check)
            except ValueError as error:
                raise ValueError(f"{place}: {error}") from None
        raise


def position_quaternions(module: Any, name: str, v: ArrayLike) -> Array:
    """Return positions and quaternions with the scalar last, side by side, after a check that they are finite."""
    vector_size(module, poses=True)
    poses = np.concatenate(to_ros(module, rows_of(name, v)), axis=-1)
    return finite(f"pose of {name}", poses, poses.shape, rows=True)


def rows_of(name: str, v: ArrayLike) -> Array:
    """Return vectors, one in each row, after a check of their shape and values."""
    shape = np.shape(v)
    if len(shape) != 2:
        raise ValueError(f"{name} must have shape (T, 6), a row for each pose, got {shape}")
    return finite(name, v, (shape[0], 6), rows=True)


def write(file: File, rows: Iterable[Sequence[object]]) -> None:
    """Write rows of numbers and words, each by the shortest text that is read as the same number."""
    text = "".join(" ".join(one if isinstance(one, str) else repr(one) for one in row) + "\n" for row in rows)
    with _opened(file, "w") as stream:
        stream.write(text)


def _opened(file: File, mode: str) -> AbstractContextManager[IO[str]]:
    if isinstance(file, (str, PathLike)):
        encoding = "utf-8-sig" if mode == "r" else "utf-8"
        return Path(fspath(file)).open(mode, encoding=encoding, errors="replace", newline=None if mode == "r" else "\n")
    if not hasattr(file, "write" if mode == "w" else "read"):
        raise TypeError(f"file must be a path or a text file, got {file!r}")
    return nullcontext(file)
