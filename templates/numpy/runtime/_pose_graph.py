"""Files of g2o: a graph of poses and of measured motions between them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ._arguments import finite, require_one_of, vector_size
from ._kernel import Array
from ._other_vectors import from_linear_angular_matrix, to_linear_angular_matrix
from ._pose_files import QUATERNION, ROUNDED, File, lines, numbers, position_quaternions, vectors, whole, write

TRIANGLE = np.triu_indices(6)
EDGE = f"{QUATERNION} {' '.join(f'i{row}{column}' for row, column in zip(*(one + 1 for one in TRIANGLE)))}"

UNITS = {name: np.outer(side, side) for name, side in (("g2o", np.repeat([0.5, 1], 3)), ("gtsam", np.ones(6)))}
"""Factors from the listed information to that of a rotation vector and a translation, by convention."""

VERTEX, MEASURED, FIX = "VERTEX_SE3:QUAT", "EDGE_SE3:QUAT", "FIX"
KINDS = {VERTEX: (1, QUATERNION), MEASURED: (2, EDGE), FIX: (None, "")}
"""Number of ids and layout of the numbers that follow them, by kind of line; any number of ids for None."""

UNUSED = ("PARAMS_SE3OFFSET",)
"""Lines of sensors, which these vertices and edges do not use."""


class Line(NamedTuple):
    """Line of a g2o file: ``file:line``, ids of poses, numbers."""

    place: str
    ids: list[int]
    numbers: list[float]


@dataclass(frozen=True, eq=False)
class PoseGraph:
    """Poses, and measured motions between them with their information.

    The residual of an edge from x1 to x2 is the step that is left, ``body_local(between(x2, x1), motion)``.

    Parameters
    ----------
    ids : array of int, shape (N,)
        Numbers of the poses in the file.
    v : array, shape (N, 6)
        Vectors of the poses.
    edges : array of int, shape (E, 2)
        Rows of x1 and x2 in ``v``, for each edge.
    motions : array, shape (E, 6)
        Vectors of the measured motions R(x1)⁻¹ R(x2).
    information : array, shape (E, 6, 6)
        Inverse covariances of small steps [rotation, translation] in the body.
    fixed : array of int, shape (F,)
        Rows of poses that stay where they are.
    """

    ids: Array
    v: Array
    edges: Array
    motions: Array
    information: Array
    fixed: Array


def read_g2o(module: Any, file: File, *, convention: str = "g2o", check: bool | float = ROUNDED) -> PoseGraph:
    """Return the graph of a g2o file with lines ``VERTEX_SE3:QUAT``, ``EDGE_SE3:QUAT`` and ``FIX``.

    An edge lists the upper triangle of its information row by row, translation first. Its rotation is the vector part
    of a unit quaternion, half of a small rotation vector. The result has the order [rotation, translation] and belongs
    to the rotation vector. GTSAM takes the listed numbers as those of a rotation vector.

    Parameters
    ----------
    module, file, check
        As in `read_tum`.
    convention : {"g2o", "gtsam"}
        Meaning of the listed information.

    Returns
    -------
    PoseGraph
        Poses, edges and information. Vectors are principal.

    Raises
    ------
    ValueError
        If a line is of another kind, its fields are wrong, or a pose is missing. The message names file and line.

    Examples
    --------
    >>> from io import StringIO
    >>> from dualcay import cayley2, interop
    >>> triangle = "1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 4 0 0 4 0 4"
    >>> text = f"VERTEX_SE3:QUAT 7 0 0 0 0 0 0 1\\nVERTEX_SE3:QUAT 8 1 2 3 0 0 0 1\\nEDGE_SE3:QUAT 7 8 1 2 3 0 0 0 1 "
    >>> graph = interop.read_g2o(cayley2, StringIO(text + triangle))
    >>> graph.ids, graph.edges, graph.information[0].diagonal()
    (array([7, 8]), array([[0, 1]]), array([1., 1., 1., 1., 1., 1.]))
    """
    vector_size(module, poses=True)
    unit = UNITS[require_one_of("convention", convention, tuple(UNITS))]
    found = _parsed(file)
    vertices, measured = found[VERTEX], found[MEASURED]
    rows: dict[int, int] = {}
    for place, (name,), _ in vertices:
        if name in rows:
            raise ValueError(f"{place}: expected another id, got {name} again")
        rows[name] = len(rows)
    (v, _), (motions, listed) = (_vectors(module, some, check) for some in (vertices, measured))
    information = np.zeros((len(measured), 6, 6))
    for row, column in (TRIANGLE, TRIANGLE[::-1]):
        information[:, row, column] = listed
    _require_positive(information, lambda edge, row: f"{measured[edge].place}: i{row + 1}{row + 1}")
    edges = np.array([_rows(rows, line) for line in measured], int).reshape(-1, 2)
    fixed = np.array([row for line in found[FIX] for row in _rows(rows, line)], int)
    return PoseGraph(np.array([*rows], int), v, edges, motions, from_linear_angular_matrix(information) * unit, fixed)


def write_g2o(module: Any, file: File, graph: PoseGraph, *, convention: str = "g2o") -> None:
    """Write a graph as a g2o file, which `read_g2o` reads with the same convention.

    Parameters
    ----------
    module, file, convention
        As in `read_g2o`. An existing file is replaced.
    graph : PoseGraph
        Poses, edges and information.

    Raises
    ------
    ValueError
        If a shape is wrong, a number is not finite, or a diagonal of information is negative. Nothing is written then.

    Examples
    --------
    >>> import sys
    >>> import numpy as np
    >>> from dualcay import cayley2, interop
    >>> none = np.empty((0, 2), int), np.empty((0, 6)), np.empty((0, 6, 6))
    >>> graph = interop.PoseGraph(np.array([7]), np.zeros((1, 6)), *none, fixed=np.array([0]))
    >>> interop.write_g2o(cayley2, sys.stdout, graph)
    VERTEX_SE3:QUAT 7 0.0 0.0 0.0 0.0 0.0 0.0 1.0
    FIX 7
    """
    if not isinstance(graph, PoseGraph):
        raise TypeError(f"graph must be a PoseGraph, got {type(graph).__name__}")
    unit = UNITS[require_one_of("convention", convention, tuple(UNITS))]
    ids, count = np.asarray(graph.ids), len(graph.edges)
    poses, motions = (position_quaternions(module, name, getattr(graph, name)) for name in ("v", "motions"))
    information = finite("information", graph.information, (count, 6, 6), rows=True)
    _require_positive(information, lambda edge, row: f"information[{edge}, {row}, {row}]")
    triangles = to_linear_angular_matrix(information / unit)[:, TRIANGLE[0], TRIANGLE[1]].tolist()
    ends = ids[np.asarray(graph.edges, int).reshape(-1, 2)].tolist()
    write(file, [
        *((VERTEX, name, *pose) for name, pose in zip(ids.tolist(), poses.tolist(), strict=True)),
        *((FIX, name) for name in ids[np.asarray(graph.fixed, int)].tolist()),
        *((MEASURED, *pair, *z, *one) for pair, z, one in zip(ends, motions.tolist(), triangles, strict=True)),
    ])  # fmt: skip


def _parsed(file: File) -> dict[str, list[Line]]:
    """Return the lines of a file by their kind."""
    found: dict[str, list[Line]] = {kind: [] for kind in KINDS}
    for place, (kind, *fields) in lines(file):
        if kind in UNUSED:
            continue
        if kind not in KINDS:
            raise ValueError(f"{place}: expected {', '.join(KINDS)}, got {kind!r}")
        count, layout = KINDS[kind]
        ids = [whole(place, "id", text) for text in fields[:count]]
        found[kind].append(Line(place, ids, numbers(place, fields[len(ids):], layout)))
    return found


def _require_positive(information: Array, name: Callable[[int, int], str]) -> None:
    """Raise an error that names an edge and a row if the diagonal of its information has a negative number."""
    diagonal = np.diagonal(information, axis1=-2, axis2=-1)
    for edge, row in np.argwhere(diagonal < 0)[:1]:
        raise ValueError(f"{name(edge, row)} on the diagonal must not be negative, got {diagonal[edge, row]:g}")


def _vectors(module: Any, found: list[Line], check: bool | float) -> tuple[Array, Array]:
    """Return the vectors of poses in lines, and the numbers after each pose."""
    table = np.array([line.numbers for line in found] or np.empty((0, 28)), float)
    return vectors(module, [line.place for line in found], table[:, :3], table[:, 3:7], check), table[:, 7:]


def _rows(rows: dict[int, int], line: Line) -> list[int]:
    """Return the rows of the poses that a line names."""
    missing = [name for name in line.ids if name not in rows]
    if missing:
        raise ValueError(f"{line.place}: expected the id of a {VERTEX}, got {missing[0]}")
    return [rows[name] for name in line.ids]
