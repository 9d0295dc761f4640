"""Commands and their options, declared so that help and completion need no other module."""

from __future__ import annotations

import importlib
import shutil
import textwrap
from collections.abc import Callable
from typing import Any, TypeAlias

import click

from .. import about
from . import options

Decorator: TypeAlias = Callable[[Callable[..., Any]], Callable[..., Any]]

ALL = ",".join(about.FORMULAS)
EPILOG = """Exit codes: 0 done, 1 stale or a proof failed, 2 usage, 3 could not, 130 interrupted.

\b
Completion in bash, likewise zsh_source and fish_source:
  eval "$(_DUALCAY_COMPLETE=bash_source dualcay)"
"""


class Commands(click.Group):
    """Group of commands that reports an interrupt by one line and the exit code 130."""

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except KeyboardInterrupt:  # Click would print an empty line
            click.echo("dualcay: interrupted", err=True)
            ctx.exit(130)


def orders(text: str) -> Decorator:
    return click.option("-n", "orders", callback=options.orders, metavar="ORDERS", help=text)


def form(choices: tuple[str, ...], text: str) -> Decorator:
    return click.option("--format", "form", type=click.Choice(choices), default="text", show_default=True, help=text)


def families(text: str) -> Decorator:
    return click.option("--family", "families", callback=options.listed, metavar="NAMES", help=text)


def run_module(module: str, command: str, given: dict[str, Any]) -> None:
    getattr(importlib.import_module(f"derive.cli.{module}"), command)(**given)


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]}, epilog=EPILOG)
@click.version_option(about.__version__, "-V", "--version", prog_name="dualcay")
def cli() -> None:
    """Derive, prove and emit the Cayley parameterization of rigid displacement, for any order n."""


@cli.command()
@orders("Orders n of v = tan(α/2n) u, e.g. 7 or 1-5,8; by default the committed ones.")
@families("Other parameterizations, e.g. lambert,sine7.")
@click.option("--phi", callback=options.phi, metavar="EXPR", help="A parameterization v = φ(α) u of your own, e.g. "
              "'alpha/(1 + alpha**2/40)'; -n is the n in it.")  # fmt: skip
@click.option("--name", metavar="NAME", help="Name of its module.")
@click.option("--target", type=click.Choice(about.TARGETS), default=about.TARGET, show_default=True,
              help="What the kernels run on; a folder holds those of one.")  # fmt: skip
@click.option("-o", "output", type=options.Place(file_okay=False), help="Folder of the package; without, that of the "
              "committed kernels in a checkout.")  # fmt: skip
@click.option("--check", is_flag=True, help="Prove and print again, but write and execute nothing; exit 1 if a file is "
              "stale, missing or foreign.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite files which do not bear the generated header.")
@options.max_n
def generate(**given: Any) -> None:
    """Prove formulas and write their kernels, or check the ones on disk."""
    run_module("charts", "generate", given)


@cli.command()
@orders("Orders n of v = tan(α/2n) u, e.g. 3 or 1-5.")
@families("Other parameterizations, e.g. lambert,sine7.")
@click.option("--phi", callback=options.phi, metavar="EXPR", help="A parameterization v = φ(α) u of your own, e.g. "
              "'alpha/(1 + alpha**2/40)'; -n is the n in it.")  # fmt: skip
@click.option("--what", callback=options.formulas, metavar="NAMES",
              help=f"Out of {ALL}; by default all of the chart. Or {about.SHEET}: four pages of formulas.")  # fmt: skip
@form(("text", "latex", "markdown", "json"), "How formulas are written.")
@click.option("-o", "output", type=options.Place(dir_okay=False), help="File of the sheet, .html or .pdf.")
@options.max_n
def show(**given: Any) -> None:
    """Print the formulas of charts, or write the formula sheet."""
    run_module("charts", "show", given)


@cli.command()
@orders("Orders n of v = tan(α/2n) u, e.g. 1-4.")
@families("Other parameterizations, e.g. exponential,lambert; without any, the committed ones.")
@click.option("--phi", callback=options.phi, metavar="EXPR", help="One of your own, e.g. 'alpha/(1 + alpha**2/40)'.")
@click.option("--plot", type=options.Place(dir_okay=False), help="File of a plot against the angle, by its ending.")
@form(("text", "json", "markdown"), "How the figures are written.")
@options.max_n
def compare(**given: Any) -> None:
    """Compare parameterizations by largest angle, stretch and cost."""
    run_module("charts", "compare", given)


@cli.command("list")
@click.option("--claims", is_flag=True, help="List the kinds of letters and the operations of claims instead.")
def list_catalogue(claims: bool) -> None:
    """List targets, committed orders and the contents of a module, or what claims may contain."""
    width = min(shutil.get_terminal_size((120, 0)).columns, 120)
    rows, left = (_of_claims(), 32) if claims else (_of_kernels(), 10)
    for heading, text in rows:
        click.echo(textwrap.fill(f"{heading:<{left - 1}} {text}", width, subsequent_indent=min(left, width // 2) * " "))


def _of_kernels() -> list[tuple[str, str]]:
    from ..codegen.signatures import PUBLIC

    others = ", ".join(about.OTHER_FAMILIES)
    return [
        ("targets", ", ".join(about.TARGETS)),
        ("orders", f"any n >= 1; committed: {', '.join(map(str, about.ORDERS))}"),
        ("families", f"{others}, also sineN and scaledN for any order N; committed: {', '.join(about.FAMILIES)}"),
        ("formulas", ", ".join(about.FORMULAS)),
        ("functions", ", ".join(PUBLIC)),
    ]


def _of_claims() -> list[tuple[str, str]]:
    from ..claims.language.letters import LETTERS
    from ..claims.language.operations import OPERATIONS

    kinds = ((kind, words) for kind, (_, _, words) in LETTERS.items())
    operations = ((row.example, row.says) for row in OPERATIONS.values())
    return [("KIND", "value"), *kinds, ("OPERATION", "value"), *operations]


@cli.command()
@click.argument("sheets", nargs=-1, metavar="[FILE]...", type=click.Path())
@click.option("--paper", type=click.Choice(about.PAPERS), help="One paper; all by default.")
@click.option("--claim", metavar="TEXT", help="One claim, e.g. 'R*transpose(R) == I'.")
@click.option("--let", "letters", metavar="NAME=KIND", multiple=True, help="Kind of a letter, e.g. R=rotation.")
@click.option("--domain", metavar="TEXT", help="Domain of the claim, e.g. 'norm(v) != 0'.")
@click.option("--seconds", type=click.FloatRange(min=0, min_open=True), default=60.0, show_default=True,
              help="Processor time that each equation of a file may take.")  # fmt: skip
@click.option("--eq", "equations", metavar="NAMES", help="Numbers or slugs, e.g. 88,111; all by default.")
@orders("Orders at which statements about n are executed and the formulas proved, e.g. 1-8.")
@form(about.FORMATS, "How the report is written.")
@click.option("-o", "output", type=options.Place(dir_okay=False), help="File to write; else stdout.")
@click.option("--data", "beside", is_flag=True, help="Write the facts too, beside the file of -o, with ending .json.")
@click.option("--check", is_flag=True, help="Write nothing; exit 1 if a file is not what would be written.")
@click.option("--strict", is_flag=True, help="Exit 1 for an equation that is false or not proved too.")
@click.option("--no-cache", is_flag=True, help="Decide each claim of a file again, and keep no result.")
@options.max_n
def verify(**given: Any) -> None:
    """Decide every equation of the papers, of files, or one claim: true, true where, or false and how to mend it.

    A FILE has claims in TOML, or in comments beside its equations: .tex, .md, .rst, .ipynb.
    """
    run_module("verify", "verify", given)


ALONE = ("letters", "domain", "form", "output", "strict")
"""Options of `verify` that belong to one claim."""


@cli.command(params=[click.Argument(["claim"]), *(option for option in verify.params if option.name in ALONE)])
def check(**given: Any) -> None:
    """Decide one claim, as `verify --claim` does: true, true where, or false and how to mend it."""
    run_module("verify", "verify", given)


@cli.command()
@click.argument("document", metavar="FILE", type=click.Path())
@click.option("-o", "output", type=options.Place(dir_okay=False), help="File of claims to write; else stdout.")
@click.option("--let", "letters", metavar="NAME=KIND", multiple=True, help="Kind of a letter, e.g. v=vector, beside "
              "those in comments of the document.")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite the file of claims.")
def draft(**given: Any) -> None:
    """Write a file of claims with each displayed equation of a document, and a claim where its LaTeX is surely read."""
    run_module("verify", "draft", given)


def run() -> int:
    """Run the command line and return its exit code; bad input never ends in a traceback."""
    try:
        code = cli.main(prog_name=options.program(), standalone_mode=False)
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except Exception as error:
        code = next((code for kind, code in _exit_codes().items() if isinstance(error, kind)), None)
        if code is None:
            raise
        said = f"{error.filename}: {error.strerror}" if isinstance(error, OSError) and error.filename else error
        click.echo(f"dualcay: {said}", err=True)
    return code if isinstance(code, int) else 0


def _exit_codes() -> dict[type[Exception], int]:
    from ..claims.equation import UndecidedError
    from ..codegen import RefusedError, ValidationFailed
    from ..proof import ProofFailed

    return {ProofFailed: 1, ValidationFailed: 1, UndecidedError: 1, RefusedError: 3, OSError: 3}
