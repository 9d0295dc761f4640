"""Rust programs that run the functions of a generated crate on rows of numbers."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tests.support.languages import Case, parted

MANIFEST = """[package]
name = "rows"
version = "0.1.0"
edition = "2021"

[dependencies]
dualcay = {{ path = {folder!r} }}

[profile.dev]
opt-level = 1
"""
PROGRAM = """use std::{{fs, io::Write}};

fn numbers(file: &str) -> Vec<{real}> {{
    let bytes = fs::read(file).unwrap();
    bytes.chunks_exact({size}).map(|b| {real}::from_le_bytes(b.try_into().unwrap())).collect()
}}
{functions}
fn main() {{
    let calls: [fn(&[{real}], &mut [{real}]); {count}] = [{names}];
    for (place, call) in calls.iter().enumerate() {{
        let given = numbers(&format!("{{place}}.in"));
        let mut made = numbers(&format!("{{place}}.out"));
        call(&given, &mut made);
        let bytes: Vec<u8> = made.iter().flat_map(|x| x.to_le_bytes()).collect();
        fs::File::create(format!("{{place}}.out")).unwrap().write_all(&bytes).unwrap();
    }}
}}
"""


def run(folder: Path, cases: Sequence[Case], place: Path, dtype: Any = np.float64) -> list[list[np.ndarray]]:
    """Return the results of a crate in a folder for each case; the program is built in another one."""
    real = "f64" if dtype == np.float64 else "f32"
    texts = [_function(index, case, real) for index, case in enumerate(cases)]
    names = ", ".join(f"call{index}" for index in range(len(cases)))
    program = PROGRAM.format(real=real, size=np.dtype(dtype).itemsize, functions="\n".join(texts), count=len(cases),
                             names=names)  # fmt: skip
    write(place, folder, program)
    shapes = []
    for index, case in enumerate(cases):
        given = case.given(dtype)
        shapes.append((len(given), case.size))
        given.tofile(place / f"{index}.in")
        np.zeros(shapes[-1], dtype).tofile(place / f"{index}.out")
    cargo(place, "run", "--quiet", "--offline")
    made = (np.fromfile(place / f"{index}.out", dtype).reshape(shape) for index, shape in enumerate(shapes))
    return [parted(case, found) for case, found in zip(cases, made)]


def write(place: Path, folder: Path, program: str) -> None:
    """Write a package with a program that uses the crate in a folder."""
    (place / "src").mkdir(parents=True, exist_ok=True)
    (place / "Cargo.toml").write_text(MANIFEST.format(folder=str(folder)), encoding="utf-8")
    (place / "src" / "main.rs").write_text(program, encoding="utf-8")


def cargo(place: Path, *arguments: str) -> str:
    """Run cargo in a folder; return what it says."""
    environment = {**os.environ, "CARGO_TARGET_DIR": str(place / "target")}
    done = subprocess.run(["cargo", *arguments], cwd=place, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout + done.stderr


def _function(index: int, case: Case, real: str) -> str:
    """Return a function that calls the form for rows, with a row at a time; this form calls that for a value."""
    row = case.row
    given, made = (sum(array.size for array in arrays) for arrays in (row.arguments, row.results))
    passed, at = [], 0
    for array in row.arguments:
        part = f"a[{at}]" if array.size == 1 else f"a[{at}..{at + array.size}].try_into().unwrap()"
        passed.append(f"&[{part}]")
        at += array.size
    branch = [str(case.branch)] * row.branch
    module = "::".join(filter(None, ("dualcay", case.table, case.chart)))
    rooms, stored, at = [], [], 0
    for place, array in enumerate(row.results):
        rooms.append(f"let mut m{place} = [{'0.0' if array.size == 1 else f'[0.0; {array.size}]'}];")
        one = f"m{place}" if array.size == 1 else f"m{place}[0]"
        stored.append(f"r[{at}..{at + array.size}].copy_from_slice(&{one});")
        at += array.size
    called = ", ".join([*passed, *branch, *(f"&mut m{place}" for place in range(len(rooms)))])
    return (
        f"fn call{index}(given: &[{real}], made: &mut [{real}]) {{\n"
        f"    for (a, r) in given.chunks_exact({given}).zip(made.chunks_exact_mut({made})) {{\n"
        f"        {' '.join(rooms)}\n"
        f"        {module}::{row.name}_rows({called});\n"
        f"        {' '.join(stored)}\n    }}\n}}"
    )
