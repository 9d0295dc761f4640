"""What the command takes: declarations, from which help and completion come before anything else is loaded."""

from __future__ import annotations

from typing import Any

import click

from .. import about
from . import options

ALL = ",".join(about.FORMULAS)
EPILOG = """Exit codes: 0 done, 1 stale or a proof failed, 2 usage, 3 could not, 130 interrupted.

\b
Completion in bash, likewise zsh_source and fish_source:
  eval "$(_DUALCAY_COMPLETE=bash_source dualcay)"
"""


class Interrupted(click.ClickException):
    """Ctrl-C, before Click makes an empty line of it."""

    exit_code = 130

    def __init__(self) -> None:
        super().__init__("interrupted")

    def show(self, file: Any = None) -> None:
        click.echo(f"dualcay: {self.message}", file, err=True)


class Commands(click.Group):
    """A group that may be interrupted."""

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except KeyboardInterrupt:
            raise Interrupted from None


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]}, epilog=EPILOG)
@click.version_option(about.__version__, "-V", "--version", prog_name="dualcay")
def cli() -> None:
    """Derive, prove and emit the Cayley parameterization of rigid displacement, for any order n."""


@cli.command()
@click.option("-n", "orders", callback=options.orders, metavar="ORDERS", help="Orders n of v = tan(α/2n) u, e.g. 7 or "
              "1-5,8; by default the committed ones.")  # fmt: skip
@click.option("--family", "families", callback=options.listed, metavar="NAMES", help="Other parameterizations, e.g. "
              "lambert,sine7.")  # fmt: skip
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
    from .generate import generate

    generate(**given)


@cli.command()
@click.option("-n", "orders", callback=options.orders, required=True, metavar="ORDERS",
              help="Orders n of v = tan(α/2n) u, e.g. 3 or 1-5.")  # fmt: skip
@click.option("--what", callback=options.names(about.FORMULAS), default=ALL, metavar="NAMES",
              help=f"Out of {ALL}; all by default.")  # fmt: skip
@click.option("--format", "form", type=click.Choice(("text", "latex", "markdown", "json")), default="text",
              show_default=True, help="How formulas are written.")  # fmt: skip
@options.max_n
def show(**given: Any) -> None:
    """Print the formulas of an order."""
    from .show import show

    show(**given)


@cli.command()
@click.option("-n", "orders", callback=options.orders, metavar="ORDERS", help="Orders n of v = tan(α/2n) u, e.g. 1-4.")
@click.option("--family", "families", callback=options.listed, metavar="NAMES", help="Other parameterizations, e.g. "
              "exponential,lambert; without any, the committed ones.")  # fmt: skip
@click.option("--phi", callback=options.phi, metavar="EXPR", help="One of your own, e.g. 'alpha/(1 + alpha**2/40)'.")
@click.option("--plot", type=options.Place(dir_okay=False), help="File of a plot against the angle, by its ending.")
@click.option("--format", "form", type=click.Choice(("text", "json", "markdown")), default="text", show_default=True,
              help="How the figures are written.")  # fmt: skip
@options.max_n
def compare(**given: Any) -> None:
    """Compare parameterizations: how far they reach, how much they stretch, what they cost."""
    from .compare import compare

    compare(**given)


@cli.command("list")
def list_catalogue() -> None:
    """List targets, committed orders and what a module holds."""
    from .show import list_catalogue

    list_catalogue()


@cli.command()
@click.option("--paper", type=click.Choice(about.PAPERS), help="One paper; all by default.")
@click.option("--eq", "equations", metavar="NAMES", help="Numbers or slugs, e.g. 88,111; all by default.")
@click.option("-n", "orders", callback=options.orders, metavar="ORDERS", help="Orders at which statements about n are "
              "executed and the formulas proved, e.g. 1-8.")  # fmt: skip
@click.option("--format", "form", type=click.Choice(about.FORMATS), default="text", show_default=True,
              help="How the report is written.")  # fmt: skip
@click.option("-o", "output", type=options.Place(dir_okay=False), help="File to write; else stdout.")
@click.option("--check", is_flag=True, help="Write nothing; exit 1 if the file of -o is not what would be written.")
@click.option("--strict", is_flag=True, help="Exit 1 for an erratum too.")
@options.max_n
def verify(**given: Any) -> None:
    """Decide every equation of the papers: which hold, under what condition, and what the wrong ones should say."""
    from .verify import verify

    verify(**given)


def run() -> int:
    """Run the command line and return its exit code; no bad input ends in a traceback."""
    try:
        code = cli.main(prog_name=options.program(), standalone_mode=False)
    except click.exceptions.Exit as stop:
        return stop.exit_code
    except click.Abort:
        Interrupted().show()
        return Interrupted.exit_code
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except Exception as error:
        code = next((code for kind, code in _endings().items() if isinstance(error, kind)), None)
        if code is None:
            raise
        click.echo(f"dualcay: {error}", err=True)
    return code if isinstance(code, int) else 0


def _endings() -> dict[type[Exception], int]:
    """The exit codes of what can go wrong."""
    from ..codegen import RefusedError, ValidationFailed
    from ..papers import UndecidedError
    from ..proof import ProofFailed

    return {ProofFailed: 1, ValidationFailed: 1, UndecidedError: 1, RefusedError: 3, OSError: 3}
