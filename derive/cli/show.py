"""``dualcay show``: the formulas of an order."""

from __future__ import annotations

import json
from collections.abc import Iterator

import click
import sympy

from ..maps import Cayley
from ..maps.formula import LATEX_ORDER
from . import options


def show(orders: tuple[int, ...], what: tuple[str, ...], form: str, max_n: int) -> None:
    """Run the command; parameters are its options."""
    options.require_cap(orders, max_n)
    if form == "json":
        click.echo(json.dumps([_as_json(Cayley(n), what) for n in orders], indent=2))
        return
    for n in orders:
        click.echo("\n".join(_lines(Cayley(n), what, form)))


def _terms(cayley: Cayley, name: str) -> dict[str, str]:
    """Return the coefficients of a formula by basis element; a polynomial has the empty text as its key."""
    value = getattr(cayley, name)
    if isinstance(value, sympy.Expr):
        return {"": _text(value)}
    basis = ("1", "v") if name == "quaternion" else ("I", "skew(v)", "v⊗v")
    return dict(zip(basis, map(_text, value.coefficients), strict=True))


def _lines(cayley: Cayley, what: tuple[str, ...], form: str) -> Iterator[str]:
    if form != "latex":
        yield f"n = {cayley.order}" if form == "text" else f"## n = {cayley.order}\n"
    for name in what:
        value = getattr(cayley, name)
        polynomial = isinstance(value, sympy.Expr)
        if form == "text":
            terms = [f"({factor}) {basis}" if basis else factor for basis, factor in _terms(cayley, name).items()]
            yield f"  {name}{f'_{cayley.order}' if polynomial else ''} = {' + '.join(terms)}"
            continue
        latex = f"{name}_{{{cayley.order}}} = {sympy.latex(value, order=LATEX_ORDER)}" if polynomial else value.latex()
        yield f"$${latex}$$\n" if form == "markdown" else latex


def _text(expression: sympy.Expr) -> str:
    return str(sympy.sstr(expression, order="rev-lex"))


def _as_json(cayley: Cayley, what: tuple[str, ...]) -> dict[str, int | str | dict[str, str]]:
    terms = {name: _terms(cayley, name) for name in what}
    return {"n": cayley.order, **{name: found.get("", found) for name, found in terms.items()}}
