"""The commands. Exit codes: 0 done, 1 stale or a proof failed, 2 usage, 3 could not."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import click
import sympy

from ..codegen import RefusedError, ValidationFailed, catalogue
from ..codegen import check as check_folder
from ..codegen import generate as generate_kernels
from ..codegen.targets import TARGETS
from ..maps import Cayley
from ..maps.formula import LATEX_ORDER
from ..proof import ProofFailed
from . import display, options
from .verify import verify

FORMULAS = ("p", "q", "quaternion", "tensor", "tangent", "tangent_inv")
ALL = ",".join(FORMULAS)
STEPS_PER_ORDER = 3


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="dualcay", prog_name="dualcay")
def cli() -> None:
    """Derive, prove and emit the Cayley parameterization of rigid displacement, for any order n."""


@cli.command()
@click.option("-n", "orders", callback=options.orders, help="Orders, e.g. 7 or 1-5,8; by default the committed ones.")
@click.option("--target", type=click.Choice(tuple(TARGETS)), default="numpy", show_default=True)
@click.option("-o", "output", type=click.Path(path_type=Path, file_okay=False), help="Folder of the package.")
@click.option("--check", is_flag=True, help="Write nothing; exit 1 if a file is stale, missing or foreign.")
@click.option("--force", is_flag=True, help="Overwrite files which do not bear the generated header.")
@click.option("--max-n", default=catalogue.MAX_ORDER, show_default=True, type=click.IntRange(min=1))
def generate(
    orders: tuple[int, ...], target: str, output: Path | None, check: bool, force: bool, max_n: int
) -> None:
    """Prove formulas and write their kernels, or check the ones on disk."""
    options.require_cap(orders, max_n)
    if output is None and (target != catalogue.TARGET or not catalogue.is_checkout()):
        raise click.UsageError(f"name a folder with -o: only {catalogue.TARGET} kernels have a place, in a checkout")
    folder = output or catalogue.COMMITTED
    chosen = orders or catalogue.ORDERS
    with display.progress(STEPS_PER_ORDER * len(chosen)) as step:
        if check:
            found = check_folder(folder, chosen, target, step, max_n)
        else:
            package = generate_kernels(chosen, target, folder, force=force, progress=step)
    if not check:
        display.console().print(display.written(package, folder))
        display.not_compiled(package)
    elif found:
        option = "" if target == catalogue.TARGET else f" --target {target}"
        option += "" if output is None else f" -o {output}"
        display.differences(found, f"python -m derive generate{option}")
        raise click.exceptions.Exit(1)


@cli.command()
@click.option("-n", "orders", callback=options.orders, required=True, help="Orders, e.g. 3 or 1-5.")
@click.option("--what", callback=options.names(FORMULAS), default=ALL, help=f"Out of {ALL}; all by default.")
@click.option("--format", "form", type=click.Choice(("text", "latex", "markdown", "json")), default="text")
@click.option("--max-n", default=catalogue.MAX_ORDER, show_default=True, type=click.IntRange(min=1))
def show(orders: tuple[int, ...], what: tuple[str, ...], form: str, max_n: int) -> None:
    """Print the formulas of an order."""
    options.require_cap(orders, max_n)
    if form == "json":
        click.echo(json.dumps([_as_json(Cayley(n), what) for n in orders], indent=2))
        return
    for n in orders:
        click.echo("\n".join(_lines(Cayley(n), what, form)))


@cli.command("list")
def list_catalogue() -> None:
    """List targets, committed orders and what a module holds."""
    from ..codegen.signatures import PUBLIC

    click.echo(f"targets   {', '.join(TARGETS)}")
    click.echo(f"orders    any n >= 1; committed: {', '.join(map(str, catalogue.ORDERS))}")
    click.echo(f"formulas  {', '.join(FORMULAS)}")
    click.echo(f"functions {', '.join(PUBLIC)}")


cli.add_command(verify)


def run() -> int:
    """Run the command line and return its exit code; no bad input ends in a traceback."""
    try:
        code = cli.main(standalone_mode=False)
    except click.exceptions.Exit as stop:
        return stop.exit_code
    except click.Abort:
        click.echo("aborted", err=True)
        return 3
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except (ProofFailed, ValidationFailed) as error:
        click.echo(f"dualcay: {error}", err=True)
        return 1
    except (RefusedError, OSError) as error:
        click.echo(f"dualcay: {error}", err=True)
        return 3
    return code if isinstance(code, int) else 0


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
