"""Page docs/accuracy.md: the worst error of every function, order and type, with its regime and gate."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from benchmarks.accuracy import certified
from benchmarks.accuracy.curves import Drawn
from benchmarks.accuracy.measure import COUNT, DIGITS, FEW, ORDERS, Measurement, types
from benchmarks.accuracy.worst import PARTS, SHORT, TITLES, Rows, Worst, short_of_gate, table
from derive.codegen.signatures import POSES, ROTATIONS
from derive.maps.cayley_scalars import HORNER_LIMIT
from tests.support import errors, rotations
from tests.support.calculus import CALCULUS, EVERY
from tests.support.cases import DTYPES
from tests.support.ranges import largest
from tests.support.sampling import OUTSIDE, PRINCIPAL

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

DERIVED = ("tangent_dot", "twist_dot", "rate_dot", "twist_jacobian", "rate_jacobian", "cotangent_jacobian")
DERIVATIVES = tuple(name for name in EVERY if name.removeprefix("body_") in DERIVED)
OTHERS = tuple(name for name in CALCULUS if name not in (*DERIVATIVES, "adjoint"))

# Gates: name, rows, and whether the gate is for the principal range.
GATES = (
    ("rotation Q", ("pose: Q", "tensor: Q"), True),
    ("displacement ρ", ("pose: ρ",), True),
    ("dual quaternion", ("quaternion",), True),
    ("tangent operator", ("tangent",), True),
    ("its inverse, rates", ("tangent_inv", "rate", "body_rate"), True),
    ("round trip v → pose → v, n ≥ 2", ("round_trip",), True),
    ("Q, ρ, dual quaternion on shadows", ("pose: Q", "pose: ρ", "tensor: Q", "quaternion"), False),
    ("tangent operator on shadows", ("tangent",), False),
    ("derivatives of T and T⁻¹", DERIVATIVES, True),
    ("derivatives of T and T⁻¹ on shadows", DERIVATIVES, False),
    ("other maps and Jacobians, of the condition", OTHERS, True),
    ("other maps and Jacobians on shadows", OTHERS, False),
)

ROWS = {
    POSES.name: tuple(row for name in EVERY for row in PARTS.get(name, (name,))),
    ROTATIONS.name: tuple(ROTATIONS.sources[name].name for name in rotations.FUNCTIONS),
}
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
        for dtype in types():
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
RATES = ("twist", "rate", "body_twist", "body_rate")
QUESTIONS = (
    ("pose of v, below half a turn", ("pose: Q", "pose: ρ"), True),
    ("v of its pose, below half a turn, n ≥ 2", ("round_trip",), True),
    ("twist of a rate, rate of a twist, below half a turn", RATES, True),
    ("pose of v, at half a turn and on shadows", ("pose: Q", "pose: ρ"), False),
    ("twist of a rate, rate of a twist, at half a turn and on shadows", RATES, False),
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
            first = 2 if names == ("round_trip",) else 1
            most = max((w.error for row in found for n, w in row.items() if first <= n <= USUAL), default=math.nan)
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
    """Yield a table with one row per gate: largest error, and error nearest to the gate, over all types and orders."""
    rows = table(measurements)
    body = []
    for title, names, inside in GATES:
        own = [
            worst
            for (kind, _, name, side), row in rows.items()
            if kind == POSES.name and name in names and side == inside
            for worst in row.values()
            if name != "round_trip" or worst.order > 1
        ]
        largest = max(own, key=lambda w: (w.error, w.dtype, w.order))
        nearest = max(own, key=lambda w: (w.fraction, w.dtype, w.order))
        cells = [f"{w.error:.2g}, {w.row}, n = {w.order}, {w.dtype}, {w.regime}" for w in (largest, nearest)]
        cells[1] += f"; gate {nearest.gate:g}"
        verdict = "met" if nearest.fraction <= 1 else "**falls short**"
        body.append([title, gate_text(own), *cells, verdict])
    yield from markdown(["what", "gate", "largest error (eps)", "nearest to its gate", ""], body)


def left_out(measurements: Iterable[Measurement]) -> dict[tuple[str, int], int]:
    """Return by type and order the number of poses skipped because powers of 1 + x overflow."""
    counts: dict[tuple[str, int], int] = {}
    for m in measurements:
        if m.function == "pose" and m.left_out:
            counts[m.dtype, m.order] = counts.get((m.dtype, m.order), 0) + m.left_out
    return counts


def verdict(measurements: Sequence[Measurement]) -> list[str]:
    """Return a line per missed gate, and a line per type and order with samples out of range."""
    lines = short_of_gate(measurements) or ["all gates are met by what is in range"]
    for (dtype, order), count in sorted(left_out(measurements).items()):
        lines.append(f"out of range, n = {order}, {dtype}: {count} poses on shadows overflow, results there are NaN")
    return lines


def out_of_range(measurements: Sequence[Measurement]) -> Iterator[str]:
    """Yield the section on overflow of powers of 1 + x: largest |v|, and numbers of samples skipped."""
    counts = left_out(measurements)
    yield "## Range"
    yield ""
    yield (
        f"Up to n = {HORNER_LIMIT} the kernels compute p² + x q² = (1 + |v|²)ⁿ in the type they are given, for larger "
        "n (1 + |v|²)⁴: they divide powers out along the way. Where that overflows, results are NaN. Below these |v| "
        "no multiple of it overflows either. Samples beyond are left out of the tables above:"
    )
    yield ""
    body = []
    for dtype in types():
        limits = []
        for n in ORDERS:
            size = largest(n, DTYPES[dtype])
            left = counts.get((dtype, n), 0)
            limits.append(_scale(size) + (f" ({left} left out)" if left else ""))
        body.append([dtype, *limits])
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
    """Return the section on arguments, norms and gates."""
    return [
        MEASURED,
        "",
        f"Each function is compared with {DIGITS}-digit arithmetic that shares no formula with it. Its arguments are "
        f"{COUNT} seeded samples per order, type and regime, and the worst inputs found before "
        "(`benchmarks/worst_cases.json`). "
        "`make accuracy` measures, and writes this page.",
        "",
        "<details><summary>Norms of errors, samples, and gates on shadows</summary>",
        "",
        "Errors are normwise, in eps of the type. That of the real part is ‖Δ‖ / ‖Re‖, that of the dual part ‖Δ‖ / "
        "(sum of the norms of its terms); the larger is shown. For inverse maps, for shadows, and for rates outside "
        "the principal range, these norms include the condition number from the exact Jacobian. `round_trip` is "
        "v → pose → v.",
        "",
        f"Derivatives, group operations, steps, and all functions of rotations alone have {FEW} samples at some "
        "orders. They are compared with a product of exact operators. Their errors are in eps of the product of the "
        f"operators' norms and condition numbers. Their gate in the principal range is {errors.CONDITIONED}.",
        "",
        "Gates on shadows are max(16, 2n) for maps, max(40, 10n) for tangent operators and twists, and five times "
        "that for their derivatives. Slopes fall like |v|⁻⁶ and |v|⁻⁸ for n = 2. In float32 they round to subnormal "
        "numbers and lose digits from |v| = 1e5 on, within 4e-5 of 2π. The norms for derivatives include an allowance "
        "for this.",
        "",
        "</details>",
        "",
    ]


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
        *out_of_range(measurements),
    ]
    return beside("\n".join([*lines, BESIDE]), figures)


def beside(page: str, figures: Drawn) -> str:
    """Return the page with new figures in place of its last section."""
    tables, _, _ = page.partition(BESIDE)
    lines = [f"{tables}{BESIDE}", "", *figures.standing, ""]
    for name, caption in figures.captions:
        lines += [caption, "", f"![{caption.split('.')[0]}]({name})", ""]
    return "\n".join(lines)
