"""Page docs/accuracy.md: the worst error of every function, order and type, with its regime and gate."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from benchmarks.accuracy import certified
from benchmarks.accuracy.curves import Drawn
from benchmarks.accuracy.measure import COUNT, DIGITS, ORDERS, TYPES, Measurement
from benchmarks.accuracy.worst import SHORT, TITLES, Rows, Worst, short_of_gate, table
from derive.codegen.signatures import POSES
from derive.maps.cayley_scalars import HORNER_LIMIT
from tests.support import cases, families
from tests.support.cases import DTYPES
from tests.support.ranges import largest
from tests.support.sampling import OUTSIDE, PRINCIPAL
from tests.support.trial import PROMISED

MEANING = {
    "uniform": "angle 0.05 … 3",
    "angle 1e-12": "angle about 1e-12",
    "angle 1e-7": "angle about 1e-7",
    "middle band": "angle 1e-5 … 1e-2",
    "below pi": "angle π − 1e-7 … π − 1e-2",
    "coordinate axes": "the same, about a coordinate axis",
    "translation 1e6": "translation of 1e6",
    "pure rotation": "dual part zero",
    "pure translation": "angle zero",
    "identity": "v = 0",
    "above pi": "angle π + 1e-7 … π + 1e-2",
    "at pi": "angle π",
    "near 2 pi": "1e-5 … 1e-1 to either side of 2π",
    "shadow": "branches past the principal one, angle at least 0.2 from multiples of π",
}

EVERY = tuple(POSES.public)
DERIVED = ("_dot", "twist_jacobian", "rate_jacobian", "cotangent_jacobian")
DERIVATIVES = tuple(name for name in EVERY if name.endswith(DERIVED))
POSE = ("pose", "tensor", "adjoint", "transform_point", "transform_line")
TANGENT, RATE = ("tangent", "body_tangent"), ("tangent_inv", "body_tangent_inv", "rate", "body_rate")
BACK = ("from_quaternion", "from_tensor", "from_pose", "from_screw", "from_exponential")
KINDS = (
    ("dual quaternion", ("quaternion",)), ("pose, and what it moves", POSE), ("tangent operator", TANGENT),
    ("its inverse, rates", RATE), ("derivatives of T and T⁻¹", DERIVATIVES), ("vector of a pose or a screw", BACK),
    ("all others", tuple(set(EVERY) - {"quaternion", *POSE, *TANGENT, *RATE, *DERIVATIVES, *BACK})),
)  # fmt: skip
"""Kinds of functions with their names."""

ROWS = {table.name: tuple(table.public) for table in cases.TABLES.values()}
"""Names of table rows, for modules of poses and of rotations."""


def gate_text(row: Iterable[Worst]) -> str:
    gates = sorted({worst.gate for worst in row})
    return f"{gates[0]:g}" if len(gates) == 1 else f"{gates[0]:g} … {gates[-1]:g}"


def cell(worst: Worst | None) -> str:
    if worst is None:
        return ""
    return f"**{worst}**" if worst.fraction > 1 else str(worst)


def markdown(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    return ["| " + " | ".join(cells) + " |" for cells in (head, ["---"] * len(head), *rows)] + [""]


def gate_tables(measurements: Sequence[Measurement]) -> Iterator[str]:
    """Yield one table per kind of module, type and range."""
    rows = table(measurements)
    for kind, title in TITLES.items():
        for dtype in TYPES:
            eps = float(np.finfo(DTYPES[dtype]).eps)
            for inside, where in ((True, "principal range, angle below π"), (False, "at π and beyond")):
                found = {name: rows.get((kind, dtype, name, inside), {}) for name in ROWS[kind]}
                orders = [n for n in ORDERS if any(n in row for row in found.values())]
                yield f"<details><summary>{dtype} (eps = {eps:.3g}){title}, {where}</summary>"
                yield ""
                body = [
                    [name, gate_text(row.values()), *(cell(row.get(n)) for n in orders)]
                    for name, row in found.items()
                    if row
                ]
                yield from markdown(["function", "gate", *(f"n = {n}" for n in orders)], body)
                yield from ("</details>", "")


# Questions, rows of the tables that answer them, and whether they are about the principal range.
TWISTS = ("twist", "rate", "body_twist", "body_rate")
QUESTIONS = (
    ("pose of v, below half a turn", ("pose",), True),
    ("v of a pose, below half a turn", ("from_pose",), True),
    ("twist of a rate, rate of a twist, below half a turn", TWISTS, True),
    ("pose of v, at half a turn and on shadows", ("pose",), False),
    ("twist of a rate, rate of a twist, at half a turn and on shadows", TWISTS, False),
)
USUAL = 8
"""Largest order of the first table."""


def answers(rows: Rows) -> list[str]:
    """Return the first table: correct digits for orders up to `USUAL`, and the range of |v|."""
    body = []
    for question, names, inside in QUESTIONS:
        cells = []
        for dtype in ("float64", "float32"):
            found = [rows.get((POSES.name, dtype, name, inside), {}) for name in names]
            most = max((w.error for row in found for n, w in row.items() if n <= USUAL), default=math.nan)
            digits = -math.log10(most * float(np.finfo(DTYPES[dtype]).eps))
            cells.append(f"{digits:.1f} ({most:.2g} eps)")
        body.append([question, *cells])
    ranges = (", ".join(_scale(largest(n, DTYPES[dtype])) for n in (1, 2, 3)) for dtype in ("float64", "float32"))
    body.append(["largest size of v for n = 1, 2, 3", *ranges])
    return markdown(["digits that are right, in the worst case found", "float64", "float32"], body)


def _scale(size: np.longdouble) -> str:
    """Return a size with two digits; longdouble may be beyond the range of Python's floats."""
    return f"{size:.2g}" if size < 1e4 else np.format_float_scientific(size, precision=1, trim="-", exp_digits=1)


def summary(measurements: Iterable[Measurement]) -> Iterator[str]:
    """Yield a table with a row per kind of function and range: largest error, and error nearest to its gate."""
    rows = table(measurements)
    body = []
    for (title, names), inside in itertools.product(KINDS, (True, False)):
        own = [
            worst
            for (kind, _, name, side), row in rows.items()
            if kind == POSES.name and name in names and side == inside
            for worst in row.values()
        ]
        title = title if inside else f"{title}, at π and beyond"
        largest = max(own, key=lambda w: (w.error, w.dtype, w.order))
        nearest = max(own, key=lambda w: (w.fraction, w.dtype, w.order))
        cells = [f"{w.error:.2g}, {w.row}, n = {w.order}, {w.dtype}, {w.regime}" for w in (largest, nearest)]
        cells[1] += f"; gate {nearest.gate:g}"
        verdict = "met" if nearest.fraction <= 1 else "**falls short**"
        body.append([title, gate_text(own), *cells, verdict])
    yield from markdown(["what", "gate", "largest error (eps)", "nearest to its gate", ""], body)


def verdict(measurements: Sequence[Measurement]) -> list[str]:
    """Return a line per missed gate."""
    return short_of_gate(measurements) or ["all gates are met by what is in range"]


def out_of_range() -> Iterator[str]:
    """Yield the section on overflow of powers of 1 + x: largest |v|."""
    yield "## Range"
    yield ""
    yield (
        f"Up to n = {HORNER_LIMIT} the kernels compute p² + x q² = (1 + |v|²)ⁿ in the type they are given, for larger "
        "n (1 + |v|²)⁴: they divide powers out along the way. Where that overflows, results are NaN. Below these |v| "
        "no multiple of it overflows either. Samples beyond are left out of the tables above where they are NaN."
    )
    yield ""
    body = [[dtype, *(_scale(largest(n, DTYPES[dtype])) for n in ORDERS)] for dtype in TYPES]
    yield from markdown(["type", *(f"n = {n}" for n in ORDERS)], body)


INTRODUCTION = """# Accuracy

This page shows how far results of the kernels are from the exact values. The table has the digits that are right in the
worst case found, up to n = 8. The error is counted in eps, the rounding unit of the number type: 2.2e-16 for float64,
1.2e-07 for float32. Below the figure are other libraries, the gate of every function, and bounds that are certified.
[The worst errors](accuracy.json) of each function, order and type are there as JSON, too.
"""

MEASURED = "## How it is measured"
BESIDE = "## Beside other libraries"


def method() -> list[str]:
    """Return the section on arguments, sizes and gates."""
    return [
        MEASURED,
        "",
        f"Each function is compared with {DIGITS}-digit arithmetic that shares no formula with it. Its arguments are "
        f"{COUNT} seeded samples per order, type and regime, and the worst inputs found before "
        "(`benchmarks/worst_cases.json`). "
        "`make accuracy` measures, and writes this page.",
        "",
        "<details><summary>Sizes of errors, and smaller gates</summary>",
        "",
        "Errors are in eps of the type, and of a size. The size of a real or dual part of a result is its norm, plus "
        "the norms of its changes per relative change of every component of the arguments. A product of operators may "
        "also be off by a rounding of each. The larger error of the parts is shown. Roundings of subnormal numbers are "
        "not counted.",
        "",
        f"No function may be off by more than {families.GATE} eps up to n = 8, of which some promise less: "
        + "; ".join(promised())
        + ". On shadows of higher orders p and q are alternating sums, and errors grow with n.",
        "",
        "</details>",
        "",
    ]


def promised() -> Iterator[str]:
    """Yield the smaller gates with their functions."""
    for size in sorted(set(PROMISED.values())):
        yield f"{', '.join(f'`{name}`' for name, own in PROMISED.items() if own == size)} {size:g} eps"


def page(measurements: Sequence[Measurement], figures: Drawn) -> str:
    """Return the whole page."""
    lines = [
        INTRODUCTION,
        *answers(table(measurements)),
        "![Error of a pose against its angle, beside other libraries](figures/accuracy.svg)",
        "",
        *method(),
        "## Gates",
        "",
        "A gate is the largest error allowed. Each row has the largest error, and the one nearest to its gate.",
        "",
        *(f"- {line}" for line in verdict(measurements)),
        "",
        *summary(measurements),
        "## Worst errors in eps, with their regime",
        "",
        "Regimes: " + "; ".join(f"**{SHORT[r]}** {MEANING[r]}" for r in (*PRINCIPAL, *OUTSIDE)) + ".",
        "",
        *gate_tables(measurements),
        *certified.section(),
        *out_of_range(),
    ]
    return beside("\n".join([*lines, BESIDE]), figures)


def beside(page: str, figures: Drawn) -> str:
    """Return the page with new figures in place of its last section."""
    tables, _, _ = page.partition(BESIDE)
    lines = [f"{tables}{BESIDE}", "", *figures.standing, ""]
    for name, caption in figures.captions:
        lines += [caption, "", f"![{caption.split('.')[0]}]({name})", ""]
    return "\n".join(lines)
