"""What is committed, where, and the commands that make it."""

from __future__ import annotations

import itertools
import re
import shlex
from collections.abc import Iterable
from pathlib import Path

import sympy

from .. import about
from ..maps import Cayley, family, parameterization
from ..maps.chart import Chart
from ..maps.families import alpha
from ..maps.sine import Sine
from . import taken
from .signatures import ROTATIONS

ORDERS, FAMILIES, TARGET, MAX_ORDER = about.ORDERS, about.FAMILIES, about.TARGET, about.MAX_ORDER

CHECKOUT = Path(__file__).parent.parent.parent
COMMITTED = CHECKOUT / "generated" / "dualcay"
"""Where the committed kernels lie in a checkout."""


def is_checkout() -> bool:
    """Whether the toolkit runs from a checkout of the project, whose kernels it may rewrite."""
    return (CHECKOUT / "templates").is_dir() and (CHECKOUT / "pyproject.toml").is_file()


def has_place(target: str) -> bool:
    """Whether kernels of a target have a place of their own: those committed in a checkout, and no other."""
    return target == TARGET and is_checkout()


def command(target: str, *charts: Chart) -> str:
    """The command that writes the modules of some charts, wherever they are put; without any, that of shared files."""
    chosen: dict[str, list[str]] = {}
    for option, value in (chart.selection for chart in charts):
        chosen.setdefault(option, []).append(value)
    options = "".join(f" {option} {','.join(values)}" for option, values in chosen.items())
    largest = max((chart.order for chart in charts), default=0)
    cap = f" --max-n {largest}" if largest > MAX_ORDER else ""
    return f"python -m derive generate{options} --target {target}{cap}"


def charts(
    orders: Iterable[int] = (), families: Iterable[str] = (), phi: str | None = None, name: str | None = None
) -> list[Chart]:
    """The charts of some orders, then those of some families, each once; or that of φ, and of families.

    Of φ an order is the n in it.

    Raises
    ------
    ValueError, TypeError
        For an order or a family that does not exist, a φ that is refused, or a name that is taken.
    """
    named: list[Chart] = [*map(family, dict.fromkeys(families))]
    given = sorted(set(orders))
    if phi is None:
        return [*map(Cayley, given), *named]
    if len(given) > 1:
        raise ValueError(f"n in phi has one value, got {', '.join(map(str, given))}")
    if name and name.split("_")[0] == ROTATIONS.name:  # in C dualcay_rotation_... are functions of rotations
        raise ValueError(f"{name!r} is the name of the folder of rotations, or begins as names of its functions do")
    if name in {chart.name for chart in committed()}:
        raise ValueError(f"{name!r} is the name of a committed module")
    taken.require_free(name or "")
    own: Chart = parameterization(phi, name or "", given[0] if given else None)
    _require_no_other(own)
    return [own, *named]


def _require_no_other(own: Chart) -> None:
    """Refuse the name of another chart; but sin(α/N) may be called sineN, by what divides its angle."""
    other = _called(own.name)
    if other is None or own.phi == other.phi:
        return
    if not (isinstance(other, Sine) and own.phi == sympy.sin(alpha / other.order)):
        raise ValueError(f"{own.name!r} is the name of the chart of phi = {other.phi}: take another for {own.phi}")


def _called(name: str) -> Chart | None:
    """The chart that a name denotes, with or without a φ; None of a name that is free."""
    cayley = re.fullmatch(r"cayley([1-9]\d*)", name)
    try:
        return Cayley(int(cayley[1])) if cayley else family(name)
    except ValueError:
        return None


def committed() -> list[Chart]:
    """The charts whose modules are committed."""
    return charts(ORDERS, FAMILIES)


def chart_of(line: str) -> Chart | None:
    """The chart in the command of a module; None for the command of shared files, and for any other."""
    words = shlex.split(line)
    chosen = dict(itertools.pairwise(words))
    try:
        if "--phi" in chosen:
            order = int(chosen["-n"]) if "-n" in chosen else None
            return parameterization(chosen["--phi"], chosen["--name"], order)
        if "--family" in chosen:
            return family(chosen["--family"])
        return Cayley(int(chosen["-n"])) if "-n" in chosen else None
    except (KeyError, ValueError):
        return None
