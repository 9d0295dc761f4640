"""``dualcay show`` and ``dualcay list``: formulas, and what there is."""

from __future__ import annotations

import json
import textwrap
from typing import Any

import click
import sympy

from .. import about
from ..codegen.signatures import PUBLIC
from ..maps import Cayley
from ..maps.formula import LATEX_ORDER
from ..output.tables import columns
from . import options


def show(orders: tuple[int, ...], what: tuple[str, ...], form: str, max_n: int) -> None:
    """Do what the command says; its parameters are the options."""
    options.require_cap(orders, max_n)
    if form == "json":
        click.echo(json.dumps([_as_json(Cayley(n), what) for n in orders], indent=2))
        return
    for n in orders:
        click.echo("\n".join(_lines(Cayley(n), what, form)))


def list_catalogue() -> None:
    """Print what can be asked for by name."""
    for heading, names in (
        ("targets", ", ".join(about.TARGETS)),
        ("orders", f"any n >= 1; committed: {', '.join(map(str, about.ORDERS))}"),
        ("families", f"also sineN and scaledN for any order N; committed: {', '.join(about.FAMILIES)}"),
        ("formulas", ", ".join(about.FORMULAS)),
        ("functions", ", ".join(PUBLIC)),
    ):
        click.echo(textwrap.fill(f"{heading:<9} {names}", columns(), subsequent_indent=10 * " "))


def _formula(cayley: Cayley, name: str) -> tuple[str, tuple[sympy.Expr, ...], tuple[str, ...]]:
    """Name, coefficients and what they multiply."""
    value = getattr(cayley, name)
    if isinstance(value, sympy.Expr):
        return f"{name}_{cayley.order}", (value,), ("",)
    basis = ("1", "v") if name == "quaternion" else ("I", "skew(v)", "v⊗v")
    return name, value.coefficients, basis


def _lines(cayley: Cayley, what: tuple[str, ...], form: str) -> list[str]:
    lines = [f"n = {cayley.order}"] if form == "text" else [f"## n = {cayley.order}", ""] if form == "markdown" else []
    for name in what:
        value = getattr(cayley, name)
        title, coefficients, basis = _formula(cayley, name)
        if form == "text":
            terms = (f"({_text(c)}) {b}".rstrip() if b else _text(c) for c, b in zip(coefficients, basis, strict=True))
            lines.append(f"  {title} = {' + '.join(terms)}")
            continue
        plain = isinstance(value, sympy.Expr)
        latex = f"{name}_{{{cayley.order}}} = {sympy.latex(value, order=LATEX_ORDER)}" if plain else value.latex()
        lines += [f"$${latex}$$", ""] if form == "markdown" else [latex]
    return lines


def _text(expression: sympy.Expr) -> str:
    return str(sympy.sstr(expression, order="rev-lex"))


def _as_json(cayley: Cayley, what: tuple[str, ...]) -> dict[str, Any]:
    entries: dict[str, Any] = {"n": cayley.order}
    for name in what:
        _, coefficients, basis = _formula(cayley, name)
        values = dict(zip(basis, map(_text, coefficients), strict=True))
        entries[name] = values if len(values) > 1 else values[""]
    return entries
