"""``dualcay show``: the formulas of an order, or the formula sheet."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import click
import sympy

from .. import about
from ..algebra.latex import latex
from ..maps import Cayley
from ..pages.sheet_files import WRITERS
from . import options


def show(orders: tuple[int, ...], what: tuple[str, ...], form: str, output: Path | None, max_n: int) -> None:
    """Run the command; parameters are its options."""
    if what == (about.SHEET,):
        write = WRITERS.get(output.suffix) if output and form == "text" and not orders else None
        if output is None or write is None:
            raise click.UsageError(f"the sheet needs -o with an ending {' or '.join(WRITERS)}, and no -n or --format")
        write(output)
        return
    if output is not None:
        raise click.UsageError(f"-o names the file of the sheet: add --what {about.SHEET}")
    if not orders:
        raise click.UsageError("Missing option '-n'.")
    options.require_cap(orders, max_n)
    if form == "json":
        found = ({"n": n, **{name: _terms(Cayley(n), name) for name in what}} for n in orders)
        click.echo(json.dumps(list(found), indent=2))
        return
    for n in orders:
        click.echo("\n".join(_lines(Cayley(n), what, form)))


def _terms(cayley: Cayley, name: str) -> str | dict[str, str]:
    """Return a polynomial as text, or the coefficients of another formula by basis element."""
    value = getattr(cayley, name)
    if isinstance(value, sympy.Expr):
        return _text(value)
    basis = ("1", "v") if name == "quaternion" else ("I", "skew(v)", "v⊗v")
    return dict(zip(basis, map(_text, value.coefficients), strict=True))


def _lines(cayley: Cayley, what: tuple[str, ...], form: str) -> Iterator[str]:
    if form != "latex":
        yield f"n = {cayley.order}" if form == "text" else f"## n = {cayley.order}\n"
    for name in what:
        value = getattr(cayley, name)
        polynomial = isinstance(value, sympy.Expr)
        if form == "text":
            terms = _terms(cayley, name)
            if isinstance(terms, str):
                yield f"  {name}_{cayley.order} = {terms}"
            else:
                yield f"  {name} = {' + '.join(f'({factor}) {basis}' for basis, factor in terms.items())}"
            continue
        formula = f"{name}_{{{cayley.order}}} = {latex(value)}" if polynomial else value.latex()
        yield f"$${formula}$$\n" if form == "markdown" else formula


def _text(expression: sympy.Expr) -> str:
    return str(sympy.sstr(expression, order="rev-lex"))
