"""Run JavaScript functions of a generated folder in node on rows of numbers, with the elementary functions of libm.

Operations of JavaScript are those of C, and node's elementary functions are others than those of libm. A program asks
for values of libm that it lacks; it runs again with these until it lacks none.
"""

from __future__ import annotations

import ctypes
import json
import subprocess
from collections.abc import Sequence
from ctypes.util import find_library
from pathlib import Path
from typing import Any

import numpy as np

from tests.support import node
from tests.support.languages import Case, parted

LIBM = {"tan": 1, "expm1": 1, "log1p": 1, "atan2": 2}
"""Elementary functions with their numbers of arguments."""
PROGRAM = """
import { readFileSync, writeFileSync } from "node:fs";
const place = process.argv[2];
const read = file => new Float64Array(new Uint8Array(readFileSync(`${place}/${file}`)).buffer);
const { folder, libm, cases } = JSON.parse(readFileSync(`${place}/cases.json`));
const asked = {}, own = {}, key = (x, y) => `${Object.is(x, -0) ? "-0" : x} ${Object.is(y, -0) ? "-0" : y}`;
for (const name of Object.keys(libm)) {
    const known = new Map(), values = read(name);
    for (let i = 0; i < values.length; i += 3) known.set(key(values[i], values[i + 1]), values[i + 2]);
    own[name] = Math[name];
    asked[name] = new Map();
    Math[name] = (x, y = 0) => {
        const found = known.get(key(x, y));
        if (found === undefined && x === x && y === y) asked[name].set(key(x, y), [x, y, own[name](x, y)]);
        return found === undefined ? NaN : found;
    };
}
if (process.argv[3] === "own") Object.assign(Math, own);
const given = read("given"), made = [];
let at = 0;
for (const { module, name, count, sizes, branch } of cases) {
    const run = (await import(`${folder}/${module}`))[name];
    for (let row = 0; row < count; row++) {
        const taken = sizes.map(size => size === 1 ? given[at++] : given.subarray(at, at += size));
        const found = run(...taken, ...branch);
        for (const part of Array.isArray(found) ? found : [found]) made.push(...(part.length ? part : [part]));
    }
}
writeFileSync(`${place}/made`, new Float64Array(made));
for (const name of Object.keys(libm))
    writeFileSync(`${place}/${name}.asked`, new Float64Array([...asked[name].values()].flat()));
"""


def run(folder: Path, cases: Sequence[Case], place: Path, own: bool = False) -> list[list[np.ndarray]]:
    """Return the results of each case, run in a further folder; with ``own``, by node's elementary functions."""
    return results(folder, cases, place, own)[0]


def results(folder: Path, cases: Sequence[Case], place: Path, own: bool = False) -> tuple[list[Any], dict[str, Any]]:
    """Return the results of each case, and the calls of elementary functions: arguments, libm's value, node's value."""
    described = [
        {
            "module": f"{case.table or '.'}/{case.chart}.js",
            "name": case.function,
            "count": len(case.arguments[0]),
            "sizes": [array.size for array in case.row.arguments],
            "branch": [case.branch] * case.row.branch,
        }
        for case in cases
    ]
    place.mkdir(parents=True, exist_ok=True)
    (place / "run.mjs").write_text(PROGRAM, encoding="utf-8")
    np.concatenate([case.given().ravel() for case in cases]).tofile(place / "given")
    data = {"folder": folder.resolve().as_uri(), "libm": LIBM, "cases": described}
    (place / "cases.json").write_text(json.dumps(data), encoding="utf-8")
    known: dict[str, np.ndarray] = {name: np.empty((0, 4)) for name in LIBM}
    while True:
        for name, rows in known.items():
            rows[:, :3].tofile(place / name)
        subprocess.run([str(node.find()), str(place / "run.mjs"), str(place), *["own"] * own], check=True)
        new = {name: _of_libm(name, np.fromfile(place / f"{name}.asked").reshape(-1, 3)) for name in LIBM}
        if not any(map(len, new.values())):
            break
        known = {name: np.concatenate([known[name], rows]) for name, rows in new.items()}
    ends = np.cumsum([len(case.arguments[0]) * case.size for case in cases])
    *parts, rest = np.split(np.fromfile(place / "made"), ends)
    assert not rest.size
    return [parted(case, rows.reshape(-1, case.size)) for case, rows in zip(cases, parts)], known


def _of_libm(name: str, asked: np.ndarray) -> np.ndarray:
    """Return arguments, the value of libm, and node's value."""
    function = getattr(ctypes.CDLL(find_library("m")), name)
    function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double] * LIBM[name]
    values = [function(*arguments[: LIBM[name]]) for arguments in asked.tolist()]
    return np.column_stack([asked[:, :2], np.array(values, float), asked[:, 2]])
