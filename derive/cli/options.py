"""Parsers of options: lists of orders and names, files and folders, and the cap on orders."""

from __future__ import annotations

import os
import re
import shlex
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from .. import about

RANGE_MAX = 10_000
"""Largest number of orders in a range."""

FILE_NAME_MAX = 255
"""Largest number of bytes in the name of a file or folder, on usual file systems."""


def orders(context: click.Context, parameter: click.Parameter, value: str | None) -> tuple[int, ...]:
    """Return the orders in a text such as ``7`` or ``1-5,8``, sorted without repetition; empty for no value."""
    if value is None:
        return ()
    return tuple(sorted({order for part in value.split(",") for order in _range(part.strip(), value)}))


def _range(part: str, value: str) -> range:
    match = re.fullmatch(r"(\d{1,9})\s*(?:-\s*(\d{1,9}))?", part)
    if match is None:
        raise click.BadParameter(f"expected orders such as 7 or 1-5,8, got {value!r}")
    first, last = int(match[1]), int(match[2] or match[1])
    if first < 1:
        raise click.BadParameter(f"an order is an integer n >= 1, got {part!r}")
    if not first <= last < first + RANGE_MAX:
        raise click.BadParameter(f"a range runs upwards over at most {RANGE_MAX} orders, got {part!r}")
    return range(first, last + 1)


def formulas(context: click.Context, parameter: click.Parameter, value: str | None) -> tuple[str, ...]:
    """Return the comma-separated names of formulas, or the name of the sheet alone; empty for no value."""
    given = listed(context, parameter, value)
    if given == (about.SHEET,):
        return given
    if unknown := ", ".join(repr(name) for name in given if name not in about.FORMULAS):
        known = ", ".join(about.FORMULAS)
        raise click.BadParameter(f"expected names out of {known}, or {about.SHEET} alone, got {unknown}")
    return given


def listed(context: click.Context, parameter: click.Parameter, value: str | None) -> tuple[str, ...]:
    """Return the comma-separated names, without repetition; empty for no value."""
    return tuple(dict.fromkeys(part.strip() for part in value.split(","))) if value is not None else ()


def phi(context: click.Context, parameter: click.Parameter, value: str | None) -> str | None:
    """Return the text of φ, with its syntax checked before SymPy is loaded."""
    from ..maps.grammar import PHI, spelled

    if value is None:
        return None
    with refusals("--phi"):
        PHI.tree(spelled(value))
    return spelled(value)


class Place(click.Path):
    """File or folder to write; an empty name, as from an unset variable, and a place below a file are refused."""

    def __init__(self, **kind: bool) -> None:
        super().__init__(path_type=Path, **kind)

    def convert(self, value: Any, parameter: click.Parameter | None, context: click.Context | None) -> Any:
        if value == "":
            self.fail("expected a name, got an empty one", parameter, context)
        from ..output.files import not_a_folder

        place: Any = super().convert(value, parameter, context)
        if long := next((part for part in place.parts if len(os.fsencode(part)) > FILE_NAME_MAX), None):
            self.fail(f"a name has at most {FILE_NAME_MAX} bytes, got {long!r}", parameter, context)
        if file := not_a_folder(place.parent):
            self.fail(f"{str(file)!r} is no folder", parameter, context)
        return place


def require_writable(*places: Path | None) -> None:
    """Raise RefusedError if one of the files to write cannot be written, before any work."""
    from ..output.files import refuse

    for place in filter(None, places):
        refuse(place.parent, {place.name: ""}, force=True)


max_n = click.option(
    "--max-n",
    default=about.MAX_ORDER,
    show_default=True,
    type=click.IntRange(min=1),
    help=f"Largest order that -n may name. Proofs beyond {about.MAX_ORDER} are long, so they are asked for twice.",
)


def require_cap(chosen: tuple[int, ...], cap: int) -> None:
    """Raise a usage error, which names --max-n, for an order above the cap."""
    if chosen and chosen[-1] > cap:
        raise click.BadParameter(f"order {chosen[-1]} is above the cap {cap}; raise it with --max-n", param_hint="-n")


@contextmanager
def refusals(option: str = "") -> Iterator[None]:
    """Turn a refused φ into a usage error of --phi, and other ValueErrors into usage errors of `option`, if given."""
    try:
        yield
    except ValueError as error:
        from ..maps import PhiError

        hint = "--phi" if isinstance(error, PhiError) else option
        if not hint:
            raise
        raise click.BadParameter(str(error), param_hint=hint) from None


def program() -> str:
    """Return the command as typed, without arguments."""
    started = Path(sys.argv[0])
    return "python -m derive" if started.name == "__main__.py" else started.stem


def without_check() -> str:
    """Return the command line without ``--check``: it writes the files that were compared."""
    return f"{program()} {shlex.join(argument for argument in sys.argv[1:] if argument != '--check')}"
