"""Texts of φ drawn from a grammar with a fixed seed, and the edge of each by a search that shares no code with derive.

The search samples φ and φ′ densely on floats, then refines every place where φ′ is small or φ large, in 50 digits. It
evaluates the text with mpmath, so it knows no SymPy either.
"""

from __future__ import annotations

import math
import random
import re
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np

SEED = 43
DIGITS = 130
POINTS = 40_000
CUT = 4 * math.pi
STEP = 1e-60
"""Complex step of slopes; functions of complex numbers keep its digits in twice as many."""
REAL = 1e20
"""Largest slope; a greater one is that of a number that is not real."""
DEEP = 0.05
"""Slope below which a minimum of φ′ on the grid is refined."""


def drawn(count: int) -> list[str]:
    """Return texts of φ: sums, quotients, narrow poles, flat places, poles of several orders, folds beside π, waves."""
    draw, found = random.Random(SEED), dict[str, None]()
    kinds = list(KINDS)
    for place in range(20 * count):
        found[kinds[place % len(kinds)](draw)] = None
        if len(found) == count:
            break
    return list(found)


def _decimal(draw: random.Random, low: float, high: float) -> str:
    return f"{draw.uniform(low, high):.3g}"


def _close_to_one(draw: random.Random, side: int) -> str:
    digits = draw.randrange(2, 7)
    return f"0.{'9' * digits}" if side < 0 else f"1.{'0' * (digits - 1)}1"


def _beside_pi(draw: random.Random) -> str:
    """Return a number just before or just beyond π."""
    return f"{math.pi * (1 + draw.choice((-1, 1)) * 10.0 ** -draw.randrange(2, 7)):.12g}"


KINDS: tuple[Callable[[random.Random], str], ...] = (
    lambda d: f"{_decimal(d, 0.2, 3)}*alpha + {_decimal(d, 0.1, 2)}*sin(alpha/{d.randrange(1, 9)})",
    lambda d: f"alpha*({_decimal(d, 1, 4)} + alpha**2/{d.randrange(9, 90)})/(3 + alpha**2/{d.randrange(9, 90)})",
    lambda d: f"alpha + 1e-{d.randrange(1, 6)}*tan(alpha/{d.choice((2, 3, 4, 5))})",
    lambda d: (lambda k: f"alpha + {_close_to_one(d, -1)}*sin({k}*alpha)/{k}")(d.randrange(1, 12)),
    lambda d: (lambda k: f"alpha + {_close_to_one(d, 1)}*sin({k}*alpha)/{k}")(d.randrange(1, 12)),
    lambda d: f"{_decimal(d, 0.1, 2)}*alpha + alpha/cos(alpha/{d.choice((3, 4, 5, 6))})**{d.randrange(1, 4)}",
    lambda d: (lambda k: f"tan(alpha/{k}) + {_decimal(d, 0.1, 2)}*tan(alpha/{k})**3")(d.randrange(2, 9)),
    lambda d: f"alpha/(1 - alpha**2/{d.randrange(11, 150)})**{d.randrange(1, 4)}",
    lambda d: (lambda c: f"alpha/(1 + alpha**2/{c}**2)")(_beside_pi(d)),
    lambda d: f"sin({_decimal(d, 1.4, 1.6)}*alpha/{_beside_pi(d)}) + alpha/{d.randrange(20, 90)}",
    lambda d: f"alpha + {_decimal(d, 0.2, 0.99)}*sin({d.randrange(9, 40)}*alpha)/40",
    lambda d: f"{d.randrange(2, 9)}*{d.choice(('sinh', 'asinh', 'tanh', 'atan'))}(alpha/{d.randrange(2, 9)})",
    lambda d: f"{d.choice(('atanh', 'asin'))}(alpha/{d.randrange(13, 40)}) + {_decimal(d, 0.1, 1)}*sin(alpha)/9",
    lambda d: f"tan(alpha/{d.choice((3, 4, 5))})*sec(alpha/{d.choice((5, 6, 7))})**2",
    lambda d: f"alpha*csc(alpha/{d.randrange(3, 6)} - pi/2)**2 + {d.randrange(1, 7)}/cot(alpha/9)",
    lambda d: f"alpha*exp(-alpha**2/{d.randrange(9, 200)}) + {_decimal(d, 0.01, 0.3)}*sin({d.randrange(2, 7)}*alpha)/9",
    lambda d: f"alpha*cbrt(1 + alpha**2/{d.randrange(9, 90)})",
    lambda d: f"alpha/sqrt(cos(alpha/{d.choice((4, 5, 6))})) + {_decimal(d, 0.1, 1)}*alpha",
    lambda d: f"sin(alpha/{d.randrange(2, 6)}) + {_decimal(d, 0.05, 0.4)}*sin({d.randrange(2, 5)}*alpha)/9",
    lambda d: f"alpha*sqrt(1 - alpha**2/{d.randrange(10, 300)})",
    lambda d: f"{d.choice(('tan', 'sinh', 'atan'))}({d.choice(('sin', 'asinh', 'tanh'))}(alpha/{d.randrange(2, 7)}))",
    lambda d: f"alpha + tanh({d.randrange(2, 30)}*alpha)/{d.randrange(2, 9)}",
    lambda d: f"alpha*exp(-alpha**2/(2*{_beside_pi(d)}**2))",
)
"""Forms of φ with random numbers."""


REMOVABLE = {
    "(3*(alpha - sin(alpha))/4)**(1/3)": ("fold", "2*pi"),
    "alpha*(6*(alpha - sin(alpha))/alpha**3)**(1/3)": ("fold", "2*pi"),
    "-(sin(alpha) - alpha)**(1/3)": ("fold", "2*pi"),
    "(alpha**3 + alpha**5)**(1/3)": ("cut", "4*pi"),
    "(sinh(alpha/2) - sin(alpha/2))**(1/3)": ("cut", "4*pi"),
    "(alpha**3 + tan(alpha/6)**5)**(1/3)": ("pole", "3*pi"),
    "alpha*sqrt(2*(1 - cos(alpha))/alpha**2)": ("fold", "pi"),
    "(1 - cos(alpha))/alpha": ("fold", "2.331122370414"),
    "sin(alpha/2)**2/alpha": ("fold", "2.331122370414"),
    "alpha**2*csc(alpha/4)": ("pole", "4*pi"),
    "3*(1/alpha - cot(alpha/4)/4)": ("pole", "4*pi"),
}
"""Kind and edge of φ whose texts are 0/0, or roots of 0, at α = 0."""

SUMS = {
    "alpha + alpha/(9 - alpha**2)": ("pole", "3"),
    "alpha*(1 + 1/(4 - alpha**2))": ("pole", "2"),
    "alpha + alpha/(16 - alpha**2)**3": ("pole", "4"),
    "alpha + alpha/(9 - alpha**2)**(1/3)": ("pole", "3"),
    "tan(alpha/4) + alpha/(50 - alpha**2)": ("pole", "2*pi"),
    "atan(alpha) + alpha/(1 - alpha**2/20)": ("pole", "2*sqrt(5)"),
}
"""Kind and edge of sums of a bounded term and a pole."""


# --- edges by a search --------------------------------------------------------------------------------------------


def edge(text: str) -> tuple[Any, str]:
    """Return the edge up to 4π to 30 digits, and its kind: fold, pole, end (finite, φ′ infinite) or cut.

    On the grid an edge shows as a fall of φ, a slope ≤ 0, a value that is not real, or a deep minimum of φ′.
    """
    angles = np.linspace(0, CUT, POINTS + 1)[1:]
    with np.errstate(all="ignore"):
        at = _evaluated(text, angles + 1j * STEP, ARRAYS)
        values, slopes = at.real, at.imag / STEP
    bad = ~((np.diff(values, prepend=0) > 0) & (slopes > 0) & (slopes < REAL))
    last = int(np.argmax(bad)) if bad.any() else POINTS
    deep = np.flatnonzero((slopes[1:-1] <= slopes[:-2]) & (slopes[1:-1] <= slopes[2:]) & (slopes[1:-1] < DEEP)) + 1
    with mpmath.workdps(DIGITS):
        for k in deep[deep < last]:
            low, least = mpmath.mpf(angles[k - 1]), _least(text, angles[k - 1], angles[k + 1])
            if not slope(text, least) > 0:
                return _bisected(text, low, least), "fold"
        if last == POINTS:
            return 4 * mpmath.pi, "cut"
        low = mpmath.mpf(angles[last - 2]) if last > 1 else mpmath.mpf(0)  # slopes of arrays are less accurate
        found = _bisected(text, low, low + 4 * CUT / POINTS)
        before = found - mpmath.mpf(10) ** -30
        kind = "pole" if value(text, before) > 10**6 else "fold" if slope(text, before) < 10**-6 else "end"
        return found, kind


def value(text: str, angle: Any) -> Any:
    """Return φ of an mpmath number; a NaN at a pole."""
    try:
        return mpmath.re(_evaluated(text, angle, NUMBERS))
    except ZeroDivisionError:
        return mpmath.nan


def slope(text: str, angle: Any) -> Any:
    """Return φ′ by a complex step; a NaN where φ is not real."""
    if mpmath.im(_evaluated(text, angle, NUMBERS)):
        return mpmath.nan
    return _evaluated(text, mpmath.mpc(angle, STEP), NUMBERS).imag / STEP


def _bisected(text: str, low: Any, high: Any) -> Any:
    """Return the end of the range in which φ increases from its value at ``low``."""
    start = value(text, low)
    for _ in range(130):
        middle = (low + high) / 2
        rises = value(text, middle) > start and slope(text, middle) > 0
        low, high = (middle, high) if rises else (low, middle)
    return low


def _least(text: str, low: float, high: float) -> Any:
    """Return the minimum of φ′ between two angles, by golden sections."""
    a, b, ratio = mpmath.mpf(low), mpmath.mpf(high), (mpmath.sqrt(5) - 1) / 2
    for _ in range(100):
        c, d = b - ratio * (b - a), a + ratio * (b - a)
        a, b = (a, d) if slope(text, c) < slope(text, d) else (c, b)
    return a


def _evaluated(text: str, angle: Any, functions: dict[str, Any]) -> Any:
    exact = functions is NUMBERS
    text = re.sub(r"(?<![\w.])\d+(\.\d+)?(e-?\d+)?", lambda digits: f"number('{digits[0]}')", text) if exact else text
    return eval(text, {"alpha": angle, **functions})  # the texts stand in tests


def _functions(library: Any, **others: Any) -> dict[str, Any]:
    pi = {"pi": library.pi, "number": mpmath.mpf}
    names = ("sin", "cos", "tan", "sinh", "tanh", "exp", "log", "sqrt")
    shared = {name: getattr(library, name) for name in names}
    quotients = {"sec": lambda a: 1 / library.cos(a), "csc": lambda a: 1 / library.sin(a)}
    quotients["cot"] = lambda a: 1 / library.tan(a)
    return {**pi, **shared, **quotients, "cbrt": lambda a: library.exp(library.log(a) / 3), **others}


ARCS = ("asin", "atan", "asinh", "atanh")
ARRAYS = _functions(np, **{name: getattr(np, f"arc{name[1:]}") for name in ARCS})
ARRAYS["asin"] = lambda a: np.arcsin(a.real) + 1j * a.imag / np.sqrt(1 - a.real**2)  # NumPy's loses a complex step
NUMBERS = _functions(mpmath, **{name: getattr(mpmath, name) for name in ARCS})
