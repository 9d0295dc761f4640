"""Sections of docs/benchmarks.md that are tables of the measured times: maps, rows, derivatives, compiled, gates."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from benchmarks import clouds, gates, kernels, native, slower
from benchmarks.maps import FUNCTIONS, NUMPY, PART, SIZES, SMALL, SMALL_SIZES, name
from benchmarks.peers import LETTERS, LIBRARIES
from benchmarks.times import Data, Timed, shown
from benchmarks.timing import markdown, table

TITLES = {
    "pose": "Vector to pose", "quaternion": "Vector to dual quaternion", "tangent": "Tangent operator",
    "rate": "Twist to rate", "from_pose": "Pose to vector", "from_quaternion": "Dual quaternion to vector",
    "compose": "Product",
}  # fmt: skip


def sections(data: Data) -> dict[str, str]:
    """Return all sections of data by name."""
    return {
        "slower": _slower(data), "maps": _maps(data), "gates": _gates(data),
        "clouds": clouds.section(data), "jacobians": kernels.section_of_jacobians(data),
        "rows": _compared(data, kernels.ON_ROWS, "Rows, a given result", NUMPY,
            (kernels.LAMBDIFY, kernels.FILLED, kernels.C_FORM, kernels.COPY),
            "SymPy's functions are measured in two forms. As lambdify returns them, components are separate arrays: a "
            "zero is a number, and equal components are one array. Filled, they are copied into one array of results, "
            "as ours are. The copy floor is the time of a copy that fills the result, a lower bound. A dash: SymPy "
            "needs minutes, or more than 4 GB."),
        "derivatives": _compared(data, kernels.DERIVATIVES, "Derivatives, components last", NUMPY,
            (kernels.JITTED, kernels.CALLED, kernels.STEPS),
            "JAX in forward mode and complex steps differentiate the same maps. `called` is JAX without compilation, "
            "traced at every call."),
        "given": _compared(data, native.PART, "Compiled functions, a given result", native.OURS, (native.C_LOOP,),
            "The C loop calls the header's function pose by pose, on the same arrays."),
    }  # fmt: skip


def _slower(data: Data) -> str:
    found = slower.every(data)
    texts = ["## Where others are faster\n", f"Calls of others that take less than 1/{slower.MARGIN} of our time.\n"]
    for kind in slower.REASONS:
        lines = [faster.line() for faster in found if faster.why == kind]
        if lines:
            texts += [f"<details><summary>{kind} ({len(lines)})</summary>\n", *lines, "\n</details>\n"]
    return "\n".join(texts)


def _maps(data: Data) -> str:
    """Return a table for each function: a line for each call, ours and those of libraries."""
    texts = [
        "## Beside other libraries\n",
        f"In the calls, {LETTERS}. v and w are our vectors of the same poses. jaxlie is compiled by JAX and on arrays "
        "of JAX; pinocchio and SymForce are called from Python, one pose at a time. SymForce leaves the translation "
        f"as it is, which is less work. Versions: {', '.join(f'{who} {at}' for who, at in data.versions.items())}.\n",
    ]
    for function in FUNCTIONS:
        found = data.find(PART, "", function)
        body = _body(found, SIZES)
        absent = [library for library, of in LIBRARIES.items() if function in of.texts and not data.find(PART, library)]
        body += [[library, *("not installed" for _ in SIZES), f"`{LIBRARIES[library].texts[function][0]}`"]
                 for library in absent]  # fmt: skip
        heads = (f"`{function}`, ns per pose", *(f"N = {n:,}" for n in SIZES), "call")
        title = f"{TITLES[function]}, {function}: {len(body)} calls"
        texts.append(f"<details><summary>{title}</summary>\n\n{table(heads, body)}\n\n</details>\n")
    heads = ("`pose`, ns per pose", *(f"N = {n:,}" for n in SMALL_SIZES), "call")
    small = table(heads, _body(data.find(SMALL), SMALL_SIZES))
    texts.append(f"<details><summary>Small batches, pose</summary>\n\n{small}\n\n</details>\n")
    return "\n".join(texts)


def _body(found: Sequence[Timed], sizes: Sequence[int]) -> list[list[str]]:
    """Return the cells of a table with a line for each call."""
    return [[name(of), *(shown(of.ns[n]) if n in of.ns else "–" for n in sizes), f"`{of.call}`"] for of in found]


def _compared(data: Data, part: str, title: str, ours: str, others: Sequence[str], note: str) -> str:
    """Return a table with a line for each function and number of poses: our time, and others' with the ratio."""
    rows = list(_lines(data, part, ours, others))
    return f"{markdown(title, ('call', 'N', 'ours, ns per pose', *others), rows)}\n{note}\n"


def _lines(data: Data, part: str, ours: str, others: Sequence[str]) -> Iterator[list[str]]:
    for mine in data.find(part, ours):
        theirs = [data.ns(part, other, mine.function, mine.chart) for other in others]
        for size, ns in mine.ns.items():
            yield [f"`{mine.call}`", f"{size:,}", shown(ns), *(_against(of, size, ns) for of in theirs)]


def _against(theirs: Mapping[int, float], size: int, ours: float) -> str:
    return f"{shown(theirs[size])} ({gates.times(theirs[size] / ours)})" if size in theirs else "–"


def _gates(data: Data) -> str:
    every = gates.every(data)
    short = [gate.row() for gate in every if not gate.met]
    listed = markdown("Gates", ("ours against", "times faster", "gate", "reason"), short)
    return (
        f"{listed}\n{len(every) - len(short)} gates are met, and the {len(short)} of the table are not. A gate is the "
        "least ratio of another's time to ours; `1/3 x` means that ours take three times as long.\n"
    )
