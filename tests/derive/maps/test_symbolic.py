"""Symbolic objects of every chart: matrices and derivatives equal the kernels, LaTeX is whole, orders are symbols."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy

import derive
import dualcay
from derive.about import FAMILIES, ORDERS
from derive.algebra.latex import latex
from tests.support import packages, sampling

MAPS = ("quaternion", "tensor", "tangent", "tangent_inv")
NAMED = [*(f"cayley{n}" for n in ORDERS), *FAMILIES]
OWN = (
    "alpha/(1 + alpha**2/40)", "alpha + alpha**3/100", "3*sin(alpha/6)/2", "2*sin(alpha/4)/sqrt(cos(alpha/4))/3",
    "sinh(alpha/3)", "sin(alpha/4) + alpha/10", "alpha/sqrt(1 + alpha**2/50)", "5*tan(alpha/10)/3", "atan(alpha/3)",
)  # fmt: skip
"""Functions φ with formulas in α: with and without inverse in closed form, folds, poles, multiples of named charts."""

SHARES = (0.0, 1e-200, 1e-5, 0.3, 0.6, 0.95)
"""Shares of the angle min(edge, 5π/2)."""

EPS = np.finfo(float).eps
STEP = 1e-30  # of the complex step, whose square is below any rounding error


KINDS = ("cayley1", "cayley3", "cayley8", "exponential", "lambert", "breusing")
"""Committed charts of every kind of formula; the others differ in numbers."""


def charts(*quick: str) -> list[Any]:
    """Return parameters for charts of every kind, with a marker on those that are not quick."""
    return [pytest.param(name, marks=() if name in quick else pytest.mark.thorough) for name in (*KINDS, *OWN[::2])]


def chart_of(name: str) -> Any:
    if name in OWN:
        return derive.Parameterization(name, f"own{OWN.index(name)}")
    return derive.Cayley(int(name[6:])) if name.startswith("cayley") else derive.family(name)


def kernels_of(name: str, folder: Path) -> Any:
    return packages.imported(chart_of(name), folder) if name in OWN else getattr(dualcay, name)


def vector(chart: Any, share: float) -> np.ndarray:
    edge = float(min(chart.edge, 5 * sympy.pi / 2))
    length = float(chart.phi.subs(derive.alpha, share * edge).evalf()) if share else 0.0
    drawn = sampling.generator("symbolic", chart.name, str(share)).normal(size=6)
    drawn[:3] *= length / np.linalg.norm(drawn[:3])
    return drawn


def parts(found: Any) -> list[np.ndarray]:
    """Return real and dual part of a pair of matrices, or of a kernel's array, as flat arrays."""
    if isinstance(found, np.ndarray):
        return [found[:4], found[4:]] if found.shape == (8,) else [found[0].ravel(), found[1].ravel()]
    return [np.array(part.tolist(), dtype=float).ravel() for part in found]


def slopes(kernel: Any, v: np.ndarray) -> list[list[np.ndarray]]:
    """Return the derivatives of a kernel by each component of v, by complex steps, which cancel no digits."""
    steps = (kernel(v + STEP * 1j * unit) for unit in np.eye(6))
    return [[part.imag / STEP for part in parts(moved)] for moved in steps]


@pytest.mark.parametrize("name", charts("cayley3"))
def test_matrices_equal_the_kernels(name: str, tmp_path: Path) -> None:
    """Compare values, rounded once, with kernels, whose errors are below 8 eps of size and condition.

    The condition is the change per relative change of each component of v.
    """
    chart, kernels = chart_of(name), kernels_of(name, tmp_path)
    for share in SHARES:
        v = vector(chart, share)
        for which in MAPS:
            found, by_v = getattr(chart, which).matrix(v), slopes(getattr(kernels, which), v)
            got, exact = parts(getattr(kernels, which)(v)), parts(found)
            for place, (a, b) in enumerate(zip(got, exact, strict=True)):
                condition = sum(abs(c) * np.linalg.norm(slope[place]) for c, slope in zip(v, by_v, strict=True))
                assert np.linalg.norm(a - b) <= 9 * EPS * (np.linalg.norm(b) + condition), (which, share, place)
            assert getattr(chart, which).matrix(v[:3]) == found[0]


@pytest.mark.parametrize("name", charts("exponential"))
def test_derivatives_equal_those_of_the_kernels(name: str, tmp_path: Path) -> None:
    """Compare half the digits of two entries, in a direction; wrong formulas are off in the second digit.

    Maps are tried near the identity and far from it in turn, each of them in every other chart.
    """
    chart, kernels, t = chart_of(name), kernels_of(name, tmp_path), sympy.Symbol("t")
    for turn, which in enumerate(MAPS, [*KINDS, *OWN].index(name)):
        v, along = vector(chart, (1e-5, 0.6)[turn % 2]), np.round(sampling.generator("along", which).normal(size=6), 2)
        by_v = slopes(getattr(kernels, which), v)
        at = [sympy.Float(a, 60) + t * sympy.Rational(b) for a, b in zip(v, along, strict=True)]
        for place, part in enumerate(getattr(chart, which).matrix(at)):
            for entry in (1, len(part) - 1):
                a = sum(c * slope[place][entry] for c, slope in zip(along, by_v, strict=True))
                b = float(part[entry].diff(t).subs(t, 0).evalf(20))
                size = sum(np.linalg.norm(slope[place]) for slope in by_v)
                assert abs(a - b) <= 1e-8 * size, (which, turn, place, entry)


@pytest.mark.parametrize("name", [*NAMED, *OWN, "cayley7"])
def test_latex_shows_the_scalars_and_defines_its_letters(name: str) -> None:
    chart = chart_of(name)
    lines = [line.removesuffix(" \\\\").split(" &= ") for line in chart.latex().splitlines()[1:-1]]
    assert {r"\alpha", "u"} <= {left for left, _ in lines}
    s, w = chart.quaternion.coefficients
    (fi, _, hi), (f, g, h) = chart.tangent_inv.coefficients, chart.tangent.coefficients
    values = {"s": s, "w": w, "f": f, "g": g, "h": h, "f_i": 2 * fi, "h_i": 2 * hi, r"\varphi(\alpha)": chart.written}
    values |= {f"{letter}_{{{chart.order}}}": value for letter, value in chart.letters}
    known = {"alpha", "u", "a", "n"}
    for left, right in lines:
        if left in values:
            assert right == latex(values.pop(left)), left
        known |= set(letters(left)) | set(letters(right.partition(r"\qquad")[2]))
        assert set(letters(right)) <= known, (left, right)
    assert not {*values} - {"s", "w", "f", "g", "h", "f_i", "h_i"}
    assert not values or chart.cayley
    for which in MAPS:
        formula = getattr(chart, which)
        explicit = formula.latex().split(r" \qquad ")[0].rpartition(" = ")[2]
        assert explicit == formula.explicit


def letters(text: str) -> list[str]:
    """Return letters with their indices, without words and commands."""
    text = re.sub(r"\\(text|mathrm|operatorname)\{[^}]*\}|\\(?!alpha|varphi)[a-zA-Z]+", " ", text)
    return [found.removeprefix("\\") for found in re.findall(r"\\?[a-zA-Z]+(?:_\{?\w+\}?)?", text)]


# --- symbolic order -------------------------------------------------------------------------------------------------


def test_symbolic_order_is_every_order() -> None:
    symbol = sympy.Symbol("n")  # without assumptions; the next test has them
    found = derive.Cayley(symbol)
    assert isinstance(found, derive.Cayley)
    assert found.p.has(sympy.Sum)
    for n in (1, 2, 6, 7):
        chart = found.subs(symbol, n)
        assert chart == derive.Cayley(n)
        assert all(getattr(found, name).subs(symbol, n) == getattr(chart, name) for name in "pqcd")
        for name in MAPS:
            pairs = zip(getattr(found, name).coefficients, getattr(chart, name).coefficients, strict=True)
            assert all(sympy.cancel(sympy.together(a.subs(symbol, n) / b)) == 1 for a, b in pairs if b != 0)
    assert {proof.scope for proof in found.prove()} == {"all n"}


def test_limits_of_a_symbolic_order_are_those_of_the_paper() -> None:
    """Compare with CP23 (88), (89) at x = 0, by SymPy's limits of the formulas and by derivatives of φ."""
    n, x = sympy.Symbol("n", integer=True, positive=True), derive.x
    m = derive.Cayley(n)
    tangent = 2 * n, 2 * n**2, 4 * n * (n**2 - 1) / 3
    inverse = 1 / (2 * n), -sympy.Rational(1, 2), (n**2 + 2) / (6 * n)
    for formula, limits, expected in zip((m.tangent, m.tangent_inv), m.limits, (tangent, inverse), strict=True):
        for c, limit, wanted in zip(formula.coefficients, limits, expected, strict=True):
            assert sympy.simplify(limit - wanted) == 0
            assert sympy.simplify(sympy.expand_func(sympy.limit(c, x, 0)) - wanted) == 0
    assert m.p.diff(x).subs(x, 0) == -sympy.binomial(n, 2)
    assert m.tensor.matrix([0, 0, 0, 1, 0, 0])[1][2, 1] == 2 * n


@pytest.mark.parametrize("order", [derive.x, -sympy.Symbol("n", positive=True), sympy.Symbol("n", integer=False)])
def test_other_expressions_are_no_order(order: sympy.Expr) -> None:
    with pytest.raises(ValueError, match="the order n must be an integer >= 1, or an expression"):
        derive.Cayley(order)


@pytest.mark.parametrize("name", [*NAMED, *OWN])
def test_range_is_a_length_or_infinite(name: str) -> None:
    chart = chart_of(name)
    assert chart.range == sympy.oo or chart.range.is_positive
    near = chart.phi.subs(derive.alpha, min(chart.edge, 1000) * (1 - sympy.Rational(1, 10**12))).evalf()
    assert near > 100 if chart.range == sympy.oo else abs(near / chart.range - 1) < 1e-6
