"""Programs in C++ that compare derivatives by jets with the emitted Jacobians, for every function that has one."""

from __future__ import annotations

import importlib
from collections.abc import Iterator

import numpy as np

from derive.codegen.rows import Function
from derive.codegen.signatures import POSES
from derive.codegen.validation.c_text import prefix
from derive.maps.chart import Chart

SMALL = (0.0, *(10.0**-k for k in (300, 200, 100, 20, 16, 12, 8, 4, 2, 1)), 1.0)
ANGLES = (*SMALL, *(np.pi + step for step in (-1e-3, -1e-9, 1e-9, 1e-3)), np.pi, 2 * np.pi - 1e-3)
"""Angles of the points of the law, as far as the chart reaches."""

TRANSLATIONS = (1.0, 1e6)

ROUND_TRIPS = (
    ("quaternion", "from_quaternion", "0, "), ("tensor", "from_tensor", "0, "), ("pose", "from_pose", "0, "),
    ("to_exponential", "from_exponential", ""),
)  # fmt: skip

HEAD = """#include "scalars.h"
#include "{header}"
using namespace dualcay;
static double larger(double a, double b) {{ return a < b || b != b ? b : a; }}
static const double points[][6] = {{
{points}
}}, second[] = {{0.2, -0.3, 0.1, 0.7, -1.1, 0.4}};
static double off(const Jet<6> *found, const double *jacobian, int rows, int columns)
{{
    double scale = 0, error = 0;
    for (int i = 0; i < rows * columns; ++i) scale = larger(scale, std::fabs(jacobian[i]));
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < columns; ++k) error = larger(error, std::fabs(found[i].v[k] - jacobian[columns * i + k]));
    return error / scale;
}}
int main()
{{
    for (unsigned p = 0; p < sizeof points / sizeof *points; ++p) {{
{calls}
    }}
}}
"""


def pairs() -> Iterator[tuple[Function, Function]]:
    """Yield each function with the function of its Jacobians."""
    for name, row in POSES.public.items():
        base = name.removesuffix("s").removesuffix("_jacobian")
        if base != name.removesuffix("s"):
            yield POSES.public[base], row


def points(chart: Chart) -> Iterator[tuple[float, float, tuple[float, ...]]]:
    """Yield angle, translation and vector of the points of the law."""
    module = importlib.import_module(f"dualcay.{chart.name}")
    for angle in ANGLES:
        if angle < 0.99 * float(chart.edge):
            re = module.from_screw([angle, 0.0], [0.6, 0.0, 0.8, 0, 0, 0])[:3]
            yield from ((angle, size, (*re, size, -2 * size, 3 * size)) for size in TRANSLATIONS)


def program(chart: Chart) -> str:
    """Return a program that prints, per function, argument and point, the error relative to the largest entry."""
    calls = "\n".join((*(text for pair in pairs() for text in _calls(chart, *pair)), *_round_trips(chart)))
    values = "\n".join("    {" + ", ".join(repr(float(c)) for c in v) + "}," for _, _, v in points(chart))
    return HEAD.format(header=f"{chart.name}.h", points=values, calls=calls)


def _calls(chart: Chart, base: Function, jacobian: Function) -> Iterator[str]:
    """Yield the comparison by each argument that has a Jacobian; the point stands in its place, or in all places."""
    begin = prefix(chart, POSES)
    for place, made in enumerate(jacobian.results):
        arrays, by = base.arguments, base.arguments[place]
        for everywhere in (False, True)[: 1 + (len([a for a in arrays if a.vector]) > 1)]:
            lines = []
            for i, array in enumerate(arrays):
                at = "points[p]" if everywhere or i == place else "second"
                at = at if array.vector or (i == place and array.size == 6) else "second"
                seed = "Jet<6>(a, k)" if i == place else "Jet<6>(a)"
                lines.append(
                    f"Jet<6> j{i}[{array.size}]; double d{i}[{array.size}]; for (int k = 0; k < {array.size}; ++k) "
                    f"{{ const double a = {at}[k]; d{i}[k] = a; j{i}[k] = {seed}; }}"
                )
            branch = ", 1" * base.branch
            jets, doubles = (", ".join(f"{letter}{i}" for i in range(len(arrays))) for letter in "jd")
            results = ", ".join(f"r{i}" for i in range(len(jacobian.results)))
            lines += [f"double {', '.join(f'r{i}[{a.size}]' for i, a in enumerate(jacobian.results))};"]
            lines += [f"Jet<6> found[{base.results[0].size}];", f"{begin}_{base.name}({jets}{branch}, found);"]
            lines += [f"{begin}_{jacobian.name}({doubles}{branch}, {results});"]
            rows, columns = made.shape
            label = f"{base.name} {by.name} {'both' if everywhere else 'one'}"
            lines += [f'std::printf("{label} %u %.3g\\n", p, off(found, r{place}, {rows}, {columns}));']
            yield f"        {{ {' '.join(lines)} }}"


def _round_trips(chart: Chart) -> Iterator[str]:
    """Yield comparisons with I of the derivatives of maps there and back."""
    unit = "double unit[36] = {0}; for (int i = 0; i < 6; ++i) unit[7 * i] = 1;"
    given = "Jet<6> v[6], there[18], back[6]; for (int k = 0; k < 6; ++k) v[k] = Jet<6>(points[p][k], k);"
    for there, back, branch in ROUND_TRIPS:
        run = f"{prefix(chart, POSES)}_{there}(v, there); {prefix(chart, POSES)}_{back}(there, {branch}back);"
        said = f'std::printf("{back} v trip %u %.3g\\n", p, off(back, unit, 6, 6));'
        yield f"        {{ {unit} {given} {run} {said} }}"


LOSING = {
    **dict.fromkeys(("compose", "from_quaternion", "from_tensor", "from_pose"), ("exponential", "sine3")),
    "from_exponential": None,
}
"""Functions whose derivatives by jets lose digits where the result is near the identity: in some charts, or in all."""


def wrong(chart: Chart, said: str, allowed: float) -> dict[str, float]:
    """Return the functions with an error above the allowed one, where the law holds, and their largest error."""
    found: dict[str, float] = {}
    at = list(points(chart))
    for line in said.splitlines():
        name, by, way, place, error = line.split()
        angle, size, _ = at[int(place)]
        charts = LOSING.get(name, ())
        losing = way != "one" and (charts is None or chart.name in charts)
        if losing and (angle < 0.01 or abs(angle - np.pi) < 0.01):
            continue  # twice half a turn is near the identity, too
        if (way == "trip" and angle > 3.1) or (name == "shadow" and not _turns(chart, angle)):
            continue  # branch 0 of another branch, and shadows of no rotation or at the pole
        bound = allowed * (1 + size * (way == "trip") / (angle if losing else 1))
        if not float(error) <= bound:
            found[f"{name} by {by}, {way}"] = max(found.get(f"{name} by {by}, {way}", 0), float(error) / bound)
    return found


def _turns(chart: Chart, angle: float) -> bool:
    """Tell whether v has a shadow with a finite derivative, in double precision."""
    return angle > 1e-50 and abs((angle + 2 * np.pi) % (2 * np.pi * chart.order) - np.pi * chart.order) > 1e-6
