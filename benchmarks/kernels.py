"""Times of kernels relative to peers: medians of calls that take turns in one process, ratios and gates.

Run ``python -m benchmarks.kernels`` from the checkout. Missed gates are named, and the run does not fail.
"""

from __future__ import annotations

import argparse
import importlib
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from benchmarks import derivatives
from benchmarks.forms import ROWS, c_form, compiled, copy_floor, lambdify_call
from benchmarks.peers import Poses, load, pytransform3d_call, scipy_call, versions
from benchmarks.timing import ROUNDS, Call, markdown, medians

ORDERS = (2, 3)
SIZES = (1, 100, 10_000, 1_000_000)
GATED = (1, 10_000)
"""Numbers of poses at which times are tested against gates."""

FAMILIES = ("exponential", "orthographic", "lambert", "breusing", "wiener_milenkovic")
"""Charts measured against libraries, besides the Cayley maps."""

OF_ALGEBRAIC = {
    "pose": (10, 5), "quaternion": (10, 20), "from_pose": (10, 7), "from_quaternion": (10, 20), "compose": (10, 15),
}  # fmt: skip
OF_EXPONENTIAL = {"pose": (6, 3), "from_pose": (6, 3)}
"""Least ratios of SciPy's time to ours, on one pose and on 10^4, by function."""

FORWARD = ("pose", "quaternion")
"""Functions with gates at every order; inverse maps have gates up to n = 2, since beyond they need an arc tangent."""

LARGE, ROUNDS_OF_LARGE = 1_000_000, 5
"""Number of poses from which fewer rounds are timed, and the number of these rounds."""


@dataclass(frozen=True, slots=True)
class Gate:
    """Ratio of a peer's time to ours, and its required value `least`; a value below 1 allows us to be slower.

    No program can exceed the ratio `largest`: the peer's time over the time of copying the result.
    """

    what: str
    ratio: float
    least: float
    largest: float = math.inf

    @property
    def met(self) -> bool:
        return self.ratio >= self.least

    def row(self) -> tuple[str, ...]:
        short = "SHORT" if self.largest >= self.least else f"SHORT, of a copy {_times(self.largest)}"
        return self.what, _times(self.ratio), _times(self.least), "met" if self.met else short


def _times(ratio: float) -> str:
    return f"{ratio:.3g} x" if ratio >= 1 else f"1/{1 / ratio:.3g} x"


def measured(calls: dict[str, Call | None], size: int, kept: bool = True) -> dict[str, float]:
    """Return median seconds by name, skipping calls that are None; ``kept`` keeps the process on one core."""
    present = {name: call for name, call in calls.items() if call is not None}
    count = ROUNDS if size < LARGE else ROUNDS_OF_LARGE
    return dict(zip(present, medians(list(present.values()), count, kept), strict=True))


def fresh(module: Any, function: str, poses: Poses) -> Call:
    """Return a call of our function on poses with components last; it returns a new array."""
    arguments = {
        "from_pose": (poses.T,), "from_quaternion": (poses.q,), "compose": (poses.w, poses.v),
    }.get(function, (poses.v,))  # fmt: skip
    call = getattr(module, function)
    return lambda: call(*arguments)


def label(module: Any) -> str:
    """Return the label of a chart in tables: its name, or the order of a Cayley map."""
    return chart(module).removeprefix("cayley")


def chart(module: Any) -> str:
    """Return the name of a module's chart."""
    return str(module.__name__.rpartition(".")[2])


def least_of(module: Any) -> Mapping[str, tuple[float, float]]:
    """Return the least ratios of SciPy's time to ours for a chart, by function."""
    if chart(module) == "exponential":
        return OF_EXPONENTIAL
    return {name: least for name, least in OF_ALGEBRAIC.items() if module.ORDER <= 2 or name in FORWARD}


def against_libraries(module: Any, size: int) -> Iterator[tuple[tuple[str, ...], list[Gate]]]:
    """Yield, for each function, its line of the table and its gates."""
    poses = Poses.draw(module, size)
    named = f"n = {label(module)}" if label(module).isdigit() else label(module)
    for function in OF_ALGEBRAIC:
        times = measured({
            "ours": fresh(module, function, poses),
            "scipy": scipy_call(function, poses),
            "pytransform3d": pytransform3d_call(function, poses) if function == "pose" else None,
        }, size)  # fmt: skip
        gates = []
        where = f"{function}, {named}, N = {size}"
        least = dict(zip(GATED, least_of(module).get(function, ()), strict=False))
        if "scipy" in times and size in least:
            gates.append(Gate(f"{where}: SciPy RigidTransform", times["scipy"] / times["ours"], least[size]))
        if "pytransform3d" in times and size == 10_000 and chart(module) != "exponential":
            gates.append(Gate(f"{where}: pytransform3d", times["pytransform3d"] / times["ours"], 3))
        peers = [against(times, peer, size) for peer in ("scipy", "pytransform3d")]
        yield (label(module), function, str(size), per_pose(times["ours"], size), *peers), gates


def on_rows(module: Any, size: int) -> Iterator[tuple[tuple[str, ...], list[Gate]]]:
    """Yield lines and gates of functions with components first and ``out``, against lambdify, C and a plain copy."""
    poses = Poses.draw(module, size)
    for function, count in ROWS.items():
        call = getattr(module, function)
        rows = (poses.v_rows, poses.w_rows, poses.z_rows)[:count]
        out = call(*rows, axis=0)
        given = {} if isinstance(out, tuple) else {"out": out}  # functions with two results have no ``out``
        times = measured({
            "ours": partial(call, *rows, axis=0, **given),
            "lambdify": lambdify_call(module.ORDER, function, rows),
            "C": compiled(module.ORDER, function, rows, out),
            "copy": copy_floor(rows, out),
        }, size)  # fmt: skip
        where = f"{function}, rows, n = {module.ORDER}, N = {size}"
        gates = []
        if "lambdify" in times and size >= 10_000:
            least = 1.3 if size < LARGE else 2.5
            ratio, largest = times["lambdify"] / times["ours"], times["lambdify"] / times["copy"]
            gates.append(Gate(f"{where}: lambdify(cse=True)", ratio, least, largest))
        if "C" in times and size == LARGE:
            gates.append(Gate(f"{where}: C form", times["C"] / times["ours"], 1 / 8))
        peers = [against(times, peer, size) for peer in ("lambdify", "C", "copy")]
        yield (str(module.ORDER), function, str(size), per_pose(times["ours"], size), *peers), gates


def of_derivatives(module: Any, size: int) -> Iterator[tuple[tuple[str, ...], list[Gate]]]:
    """Yield lines and gates of derivatives with components last, against JAX in forward mode and complex steps."""
    poses = Poses.draw(module, size)
    jax = load("jax")
    for function, count in derivatives.ARGUMENTS.items():
        given = (poses.v, poses.w, poses.other)[:count]
        steps = derivatives.stepped(module, function)
        times = measured({
            "ours": partial(getattr(module, function), *given),
            **(derivatives.jax_calls(jax, module.ORDER, function, given) if jax else {}),
            "steps": partial(steps, *given) if steps else None,
        }, size, kept=False)  # fmt: skip
        where = f"{function}, n = {module.ORDER}, N = {size}"
        timed = [name for name in ("called", "jitted") if name in times and size == 1]
        gates = [Gate(f"{where}: JAX, {name}", times[name] / times["ours"], 20) for name in timed]
        peers = [against(times, peer, size) for peer in ("jitted", "called", "steps")]
        yield (str(module.ORDER), function, str(size), per_pose(times["ours"], size), *peers), gates


def per_pose(seconds: float, size: int) -> str:
    """Return nanoseconds per pose."""
    return f"{seconds / size * 1e9:.1f}"


def against(times: dict[str, float], peer: str, size: int) -> str:
    """Return a peer's time per pose and its ratio to ours."""
    if peer not in times:
        return "–"
    return f"{per_pose(times[peer], size)} ({_times(times[peer] / times['ours'])})"


def report(orders: Sequence[int], sizes: Sequence[int], families: Sequence[str] = FAMILIES) -> tuple[str, list[Gate]]:
    """Return all tables as Markdown, and all gates."""
    modules = [importlib.import_module(f"dualcay.cayley{order}") for order in orders]
    further = [importlib.import_module(f"dualcay.{name}") for name in families]
    gates: list[Gate] = []
    tables = []
    head = ("n", "function", "N", "ours, ns per pose")  # order, or name of the chart
    every = range(1, 10**9)
    for title, part, peers, measured_at in (
        ("Components last, a new result", against_libraries, ("SciPy RigidTransform", "pytransform3d"), every),
        ("Rows, a given result", on_rows, ("lambdify(cse=True)", "C form", "copy floor"), every[99:]),
        ("Derivatives, components last", of_derivatives, ("JAX, jitted", "JAX, called", "complex steps"), (1, 10_000)),
    ):
        rows = []
        for module in (*modules, *further) if part is against_libraries else modules:
            for size in (size for size in sizes if size in measured_at):
                for row, decided in part(module, size):
                    rows.append(row)
                    gates += decided
        tables.append(markdown(title, (*head, *peers), rows))
    judged = markdown("Gates", ("ours against", "times faster", "gate", ""), [gate.row() for gate in gates])
    return "\n".join([judged, *tables]), gates


def missing() -> list[str]:
    """Return the peers that could not be measured."""
    names = [name for name, version in versions("SciPy", "pytransform3d").items() if version is None]
    transform = load("scipy.spatial.transform")
    if transform is not None and not hasattr(transform, "RigidTransform"):
        names.append("scipy >= 1.16")
    return names + ([] if load("jax") else ["jax"]) + ([] if c_form(ORDERS[0]) else ["a C compiler"])


def section(
    sizes: Sequence[int] = SIZES, orders: Sequence[int] = ORDERS, families: Sequence[str] = FAMILIES
) -> str:
    """Return all tables, the gates missed, and the peers that could not be measured."""
    text, gates = report(orders, sizes, families)
    absent = [f"Not measured, because it is missing: {name}." for name in missing()]
    missed = [gate for gate in gates if not gate.met]
    short = [f"Falls short: {gate.what}, {_times(gate.ratio)} of {_times(gate.least)}." for gate in missed]
    return "\n".join([text, *absent, *(short or ["Every gate is met."]), ""])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-N", type=int, nargs="+", default=SIZES, help="batch sizes")
    parser.add_argument("--orders", type=int, nargs="*", default=ORDERS, help="of Cayley maps")
    parser.add_argument("--families", nargs="*", default=FAMILIES, help="further charts, beside libraries")
    chosen = parser.parse_args()
    print(section(chosen.N, chosen.orders, chosen.families))


if __name__ == "__main__":
    main()
