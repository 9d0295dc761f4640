"""Formulas of a chart as ``dualcay show`` prints them: text, LaTeX, Markdown and JSON."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any

import sympy

from .. import about
from ..algebra.latex import latex
from ..maps.chart import Chart


def as_json(chart: Chart, what: Collection[str] = ()) -> dict[str, Any]:
    """Return the chart's name and its formulas with these names, by default all, as data for JSON."""
    return {**_label(chart), **{name: _terms(formula) for name, formula in _formulas(chart, what).items()}}


def lines(chart: Chart, form: str, what: Collection[str] = ()) -> Iterator[str]:
    """Yield the formulas with these names, by default all, as lines of "text", "latex" or "markdown"."""
    heading = ", ".join(f"{key} = {value}" for key, value in _label(chart).items())
    if form != "latex":
        yield heading if form == "text" else f"## {heading}\n"
    for name, value in _formulas(chart, what).items():
        if form == "text":
            terms = _terms(value)
            if isinstance(terms, str):
                yield f"  {name}_{chart.order} = {terms}"
            else:
                yield f"  {name} = {' + '.join(f'({factor}) {basis}' for basis, factor in terms.items())}"
            continue
        formula = f"{name}_{{{chart.order}}} = {latex(value)}" if isinstance(value, sympy.Expr) else value.latex()
        yield f"$${formula}$$\n" if form == "markdown" else formula


def _formulas(chart: Chart, what: Collection[str]) -> dict[str, Any]:
    return {name: getattr(chart, name) for name in what or about.FORMULAS if hasattr(chart, name)}


def _label(chart: Chart) -> dict[str, Any]:
    return {"n": chart.order} if chart.selection[0] == "-n" else {"name": chart.name, "phi": _text(chart.written)}


def _terms(value: Any) -> str | dict[str, str]:
    """Return a polynomial as text, or the coefficients of another formula by basis element."""
    if isinstance(value, sympy.Expr):
        return _text(value)
    basis = ("1", "v") if value.name == "quaternion" else ("I", "skew(v)", "v⊗v")
    return dict(zip(basis, map(_text, value.coefficients), strict=True))


def _text(expression: sympy.Expr) -> str:
    return str(sympy.sstr(expression, order="rev-lex"))
