"""Scalar programs of a chart, which geometry calls: one row each, traced from the chart's own formulas."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy

from ...algebra import Quaternion
from ...maps.chart import Chart, Followed
from ...maps.multiple import FURTHER_POWERS, POWERS
from ...maps.real_constants import NOISE_OF_ANGLE, number, plus
from ..programs.program import Constant, Number, Program
from ..programs.trace import Trace

TABLE = ("limit", "cos", "sin")  # names of the numbers in one row of the table of returns
SQUARES = ("v11", "v22", "v33")
"""Terms of x, passed to maps and operators, since x alone hides its rounding error. Inverse maps take x itself."""


def _at_x(chart: Chart, trace: Trace, *terms: Number) -> Any:
    return chart.scalars(trace.name("x", sum(terms)), trace)


def _at_angle(chart: Chart, trace: Trace, x: Number, fe: Number, angle: Number) -> Any:
    return chart.at_known(x, fe, angle, trace)


@dataclass(frozen=True, slots=True)
class Scalar:
    """Function of a few numbers, with its formula in words: for every chart, and for order n.

    Each formula stands between marks, and `proof.shown` compares it before it is printed. ``compute`` returns a tuple
    of the results, or the chart's `Scalars`, which have them as attributes.
    """

    arguments: tuple[str, ...]
    results: tuple[str, ...]
    every: str
    compute: Callable[..., Any] = _at_x
    of_order: str = ""
    maps: tuple[str, ...] = ()  # maps whose equations are cited
    truths: tuple[str, ...] = ()  # results that are truth values
    slopes: str = ""  # program that returns slopes of its results
    of_steps: bool = False  # True if rules of differentiation need it of the exponential
    idle: Callable[..., tuple[Number, ...]] | None = None  # results for charts that never call it, where geometry does

    def placeholder(self, name: str) -> Program:
        if self.idle is None:
            raise ValueError(f"geometry calls {name}, which the chart lacks")
        trace = Trace()
        arguments = [trace.inputs(argument, [argument])[0] for argument in self.arguments if argument != "table"]
        return trace.program(name, self.idle(trace, *arguments))


def _ray(chart: Chart, trace: Trace, x: Number) -> tuple[Number, ...]:
    at = chart.scalars(x, trace)
    return *at.ray, at.f, at.g, at.h


def _gain(chart: Chart, trace: Trace, *e: Number) -> tuple[Number]:
    return (chart.gain(Quaternion.from_components(e[:4]), e[4], trace),)


def _beyond(chart: Chart, trace: Trace, x: Number, *table: Number) -> tuple[Number, ...]:
    selected, place, turn = chart.beyond(x, table, trace)
    return selected, place, *turn


def _coefficient(chart: Chart, trace: Trace, angle: Number) -> tuple[Number, ...]:
    return *chart.coefficient(angle, trace), chart.known(angle, trace)


def _coefficient_of(chart: Chart, trace: Trace, angle: Number, sine: Number, cosine: Number) -> tuple[Number, ...]:
    return *chart.coefficient_of(angle, sine, cosine, trace), chart.known(angle, trace)


def _followed(chart: Chart, trace: Trace, x: Number, along: Number, *e: Number) -> tuple[Number, ...]:
    size, turn = e[4:]
    return chart.followed(x, along, Quaternion.from_components(e[:4]), size, turn, trace)


def _reached(chart: Chart, trace: Trace, angle: Number) -> tuple[Number]:
    """Return α ≥ 0 unchanged up to the edge; beyond it, subtract the fewest whole turns that end in the chart."""
    if chart.edge.is_infinite:
        return (angle,)
    zero = trace.name("zero", angle - angle)
    pi = trace.name("pi", 2 * trace.atan2(1 + zero, zero))

    def turned(value: Number, other: sympy.Expr, name: str) -> Number:
        """Return a value plus a constant angle; multiples of π have all digits of the number type."""
        share = other / sympy.pi
        if share.is_Rational:
            return trace.name(name, value + trace.div(int(share.p) * pi, int(share.q)))
        return trace.name(name, plus(value, number(other), trace, name))

    off = trace.tan(trace.div(turned(angle, sympy.pi - chart.edge, "off"), 2))
    last = turned(2 * trace.atan2(off, 1), chart.edge - sympy.pi, "last")
    left = turned(-angle, chart.edge, "left")
    beyond = trace.less(left, 0)
    if chart.folds:  # an angle that rounding puts beyond the edge counts as within
        end = trace.name("edge", angle + left)
        beyond = trace.less(trace.beside(end, trace.div(left, NOISE_OF_ANGLE)), end)
    return (trace.name("within", trace.where(beyond, last, angle)),)


E = ("e0", "e1", "e2", "e3")
SCALARS: Mapping[str, Scalar] = {
    "quaternion_scalars": Scalar(
        ("x",), ("s", "w", "sy", "wy"), "unit quaternion `q = s + w v`; slopes `sy = 2 ds/dx`, `wy = 2 dw/dx`",
        of_order="`s = p/(1 + x)^(n/2)`, `w = q/(1 + x)^(n/2)`", maps=("quaternion",),
    ),
    "pose_scalars": Scalar(
        SQUARES, ("f", "g", "h"), "`R = I + f skew(v) + g skew(v)^2`, `T = f I + g skew(v) + h v(x)v`",
        of_order="`f = 2 p q/(1 + x)^n`, `g = 2 q^2/(1 + x)^n`, `h = 2 c/(1 + x)^n`, `x c = n (1 + x)^(n - 1) - p q`",
        maps=("tensor", "tangent"), slopes="tangent_scalars", of_steps=True,
    ),
    "tangent_scalars": Scalar(
        SQUARES, ("f", "g", "h", "fy", "gy", "hy"), "f, g, h of T with slopes `fy = 2 df/dx`, gy, hy",
        maps=("tangent",), slopes="tangent_dot_scalars", of_steps=True,
    ),
    "tangent_dot_scalars": Scalar(
        SQUARES, ("f", "g", "h", "fy", "gy", "hy", "fyy", "gyy", "hyy"),
        "f, g, h of T, slopes `fy = 2 df/dx`, gy, hy, second slopes `fyy = 2 dfy/dx`, gyy, hyy", of_steps=True,
    ),
    "rate_scalars": Scalar(
        ("x",), ("rate",), "`T v = rate v`: `rate = 1/phi' = f + x h`", of_order="`rate = 2n/(1 + x)`", of_steps=True,
        idle=lambda m, x: (1,),
    ),
    "inverse_scalars": Scalar(
        ("x", "fe"), ("fi", "hi"), "`T^-1 = (fi I - skew(v) + hi v(x)v)/2`", lambda c, m, x, fe: c.back(x, fe, m),
        "`fi = p/q`, `hi = d/(n q)`, `x d = (1 + x) q - n p`", ("tangent_inv",), slopes="tangent_inv_scalars",
    ),
    "inverse_at": Scalar(
        ("x", "fe", "angle"), ("hi", "ai"), "hi of T^-1 at a known angle, and for ai `fi + x hi = 2 phi'`", _at_angle
    ),
    "tangent_inv_at": Scalar(
        ("x", "fe", "angle"), ("fi", "hi", "ai", "fiy", "hiy"),
        "fi, hi, ai of T^-1 at a known angle, with slopes `fiy = 2 dfi/dx`, hiy", _at_angle,
    ),
    "tangent_inv_scalars": Scalar(
        ("x",), ("fi", "hi", "fiy", "hiy"), "fi, hi of T^-1 with slopes `fiy = 2 dfi/dx`, hiy", maps=("tangent_inv",),
        slopes="tangent_inv_dot_scalars", of_steps=True,
    ),
    "tangent_inv_dot_scalars": Scalar(
        ("x",), ("fi", "hi", "fiy", "hiy", "fiyy", "hiyy"),
        "fi, hi of T^-1 with slopes fiy, hiy and second slopes fiyy, hiyy", slopes="tangent_inv_dot_scalars",
        of_steps=True,
    ),
    "ray": Scalar(
        ("x",), ("a", "b", "size", "f", "g", "h"),
        "`a + b v = size q` for the unit quaternion q, size > 0, and f, g, h of R and T", _ray, "`a/b = p/q`",
    ),
    "gain": Scalar(
        (*E, "size"), ("gain",), "`v = gain vec q` for a quaternion of this size, size 1: `gain = phi/sin(alpha/2)`",
        _gain,
    ),
    "inside": Scalar(
        ("x",), ("inside",), "factor that takes a vector of square x back to the edge; 1 within the chart",
        lambda c, m, x: (c.inside(x, m),),
    ),
    "direction": Scalar(
        ("x", "y", "r"), ("sign",),
        "sign of the principal axis along v, from the length r of v and y, the product of v and v°",
        lambda c, m, *at: (c.direction(*at, m),), idle=lambda m, *at: (1,),
    ),
    "natural": Scalar(
        ("x", "y", "r"), ("angle", "slope", "sign"),
        "principal angle, d alpha/d r and sign of the axis, from x, y and the length r of v",
        lambda c, m, *at: c.natural(*at, m),
    ),
    "unfolded": Scalar(
        ("x", "r"), ("own",), "angle of `v = r u` on its own branch",
        lambda c, m, *at: (m.name("own", c.unfolded(*at, m)),),
    ),
    "reached": Scalar(("alpha",), ("within",), "alpha reduced by whole turns to the range of the chart", _reached),
    "turned": Scalar(
        ("r", "cos", "sin"), ("rk", "slope", "bend"),
        "coefficient rk of the vector rk u on another branch of r u, drk/dr and d²rk/dr²",
        lambda c, m, r, *turn: c.turned(r, turn, m), idle=lambda m, *at: (0, 0, 0),
    ),
    "beyond": Scalar(
        ("x", "table"), ("beyond", "place", "cosine", "sine"),
        "truth of x > limit, beyond the principal branch, x or the limit, and the turn back", _beyond,
        truths=("beyond",), idle=lambda m, x: (0, m.name("place", 1 + x), 1, 0),  # the place is a number with a root
    ),
    "coefficient": Scalar(
        ("alpha",), ("r", "slope", "known"), "`r = phi(alpha)`, phi', and the number by which alpha is known",
        _coefficient,
    ),
    "coefficient_of": Scalar(
        ("alpha", "sine", "cosine"), ("r", "slope", "known"),
        "`r = phi(alpha)`, phi', the number by which alpha is known, by sine and cosine of alpha/2", _coefficient_of,
    ),
    "followed": Scalar(
        ("x", "along", *E, "size", "turn"), Followed._fields,
        "factors of vec e and v in the vector on the branch nearest v, and fi, by e, for T^-1", _followed,
    ),
}  # fmt: skip
"""Scalar programs by name; `Scalars.ray` defines a, b and size, and `Chart` defines turns and tables."""


def table_names(chart: Chart) -> tuple[str, ...]:
    return tuple(f"{column}{j}" for j in range(1, len(chart.returns()) + 1) for column in TABLE)


def powers_of_factor(name: str) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Return the powers of K that divide the arguments, then the results, of a scalar program of a multiple K w."""
    row, powers = SCALARS[name], POWERS | FURTHER_POWERS
    length = powers["r"] if "r" in row.arguments else 0  # a slope is a derivative by r, if r is given, else by an angle
    first = powers.get(row.results[0], 0)
    powers |= {"slope": first - length, "bend": first - 2 * length}
    arguments = (argument for argument in row.arguments if argument != "table")
    return tuple(-powers.get(argument, 0) for argument in arguments), tuple(powers.get(r, 0) for r in row.results)


def scalar_programs(chart: Chart) -> dict[str, Program]:
    """Return the scalar programs of a chart by name.

    Uncalled programs are left out: `beyond` if every v is principal, and `turned` if each pose has only one v.
    """
    idle = {name for name, called in (("beyond", chart.returns()), ("turned", chart.branches != 1)) if not called}
    return {name: scalar_program(name, chart) for name in SCALARS if name not in idle}


def scalar_program(name: str, chart: Chart) -> Program:
    """Return a scalar program of a chart.

    Constant fractions, and a constant size that `gain` reads, take the type of the first argument. Other
    integers are returned unchanged, since no program divides them.
    """
    row, trace = SCALARS[name], Trace()
    arguments: list[Any] = []
    for argument in row.arguments:
        arguments += trace.inputs(argument, table_names(chart) if argument == "table" else [argument])
    found = row.compute(chart, trace, *arguments)
    results = list(found) if isinstance(found, tuple) else [getattr(found, name) for name in row.results]
    zero = trace.name(trace.free_name("zero"), arguments[0] - arguments[0])
    one = trace.name(trace.free_name("one"), zero + 1)
    for i, (letter, result) in enumerate(zip(row.results, results, strict=True)):
        divided = letter == "size" and "size" in scalar_program("gain", chart).operands
        if isinstance(result, Constant) and (result.denominator != 1 or divided):
            results[i] = trace.name(trace.free_name(letter), result * one)
    return trace.program(name, results)
