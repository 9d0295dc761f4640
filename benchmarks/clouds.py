"""Times of moving clouds of points: one vector for many points, many vectors for one point, and pairs of both."""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from benchmarks.maps import COMPILED, COPY, NUMPY, drawn, name
from benchmarks.peers import load
from benchmarks.times import CHARTS, Data, Key, Timed, shown, timed
from benchmarks.timing import Call, markdown

PART, MATRICES = "clouds", "NumPy, ready matrices"
SIZES = (1_000, 100_000)
PAIRINGS = {"one v, many r": (False, True), "many v, one r": (True, False), "pairs": (True, True)}
"""Whether there are many vectors, and many points, by the name of a pairing."""

TEXTS: Mapping[str, Mapping[str, str]] = {
    MATRICES: {"one v, many r": "r @ Q.T + d", "many v, one r": "Q @ r + d", "pairs": "np.matvec(Q, r) + d"},
    "SciPy": dict.fromkeys(PAIRINGS, "A.apply(r)"),
    "pytransform3d": {"one v, many r": "transform(T, vectors_to_points(r))"},
    COPY: dict.fromkeys(PAIRINGS, "np.copyto(out, r)"),
}
"""Calls of others by pairing; all take transforms that are ready."""


def measure(packages: Mapping[str, str], sizes: Sequence[int] = SIZES) -> Iterator[Timed]:
    """Yield the times of all calls; packages of kernels by their form."""
    cases = ((pairing, size) for size in sizes for pairing in PAIRINGS)
    yield from timed(PART, ((pairing, size, calls(packages, pairing, size)) for pairing, size in cases))


def calls(packages: Mapping[str, str], pairing: str, size: int) -> dict[Key, Call]:
    """Return our calls for a pairing, and those of others for the same poses and points."""
    vectors, points = (slice(None) if many else 0 for many in PAIRINGS[pairing])
    r = np.random.default_rng(3).uniform(-1, 1, (size, 3))[points]
    found: dict[Key, Call] = {}
    for form, chart in [(form, chart) for form in (NUMPY, COMPILED) if form in packages for chart in CHARTS]:
        kernel = importlib.import_module(f"{packages[form]}.{chart}").transform_point
        found[form, chart, f"{chart}.transform_point(v, r)"] = partial(kernel, drawn(chart, size).v[vectors], r)
    T = drawn(CHARTS[0], size).T[vectors]
    ready: dict[str, Any] = {"np": np, "r": r, "T": T, "Q": T[..., :3, :3], "d": T[..., :3, 3]}
    names = {**ready, "out": np.empty((size, 3)), **_of_libraries(T)}
    for by, texts in TEXTS.items():
        if by in names.get("missing", ()) or pairing not in texts:
            continue
        found[by, "", texts[pairing]] = eval(f"lambda: {texts[pairing]}", names)
    return found


def _of_libraries(T: Any) -> dict[str, Any]:
    """Return the names that calls of libraries use, and the libraries that are missing."""
    scipy, functions = load("scipy.spatial.transform"), load("pytransform3d.transformations")
    rigid = getattr(scipy, "RigidTransform", None)
    missing = [name for name, found in (("SciPy", rigid), ("pytransform3d", functions)) if found is None]
    names = {"missing": missing, **(vars(functions) if functions else {})}
    return names | ({"A": rigid.from_matrix(T)} if rigid else {})


def section(data: Data) -> str:
    """Return the table: a line for each call."""
    columns = [(pairing, size) for pairing in PAIRINGS for size in SIZES]
    lines = dict.fromkeys((of.by, of.chart) for of in data.find(PART))
    rows = []
    for by, chart in lines:
        mine = {of.function: of for of in data.find(PART, by, "", chart)}
        times = [mine[p].ns.get(size) if p in mine else None for p, size in columns]
        texts = dict.fromkeys(f"`{of.call}`" for of in mine.values())
        label = name(next(iter(mine.values())))
        rows.append([label, *("–" if ns is None else shown(ns) for ns in times), ", ".join(texts)])
    head = ("`transform_point`, ns per point", *(f"{pairing}, N = {size:,}" for pairing, size in columns), "call")
    return f"{markdown('Clouds of points', head, rows)}\n" + (
        "N points are moved. Ours start from v and never form a matrix; what depends on one v alone is computed once. "
        "The others start from transforms that are ready: rotation matrices Q with translations d, SciPy's A, "
        "homogeneous matrices T.\n"
    )
