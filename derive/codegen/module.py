"""The texts of a package of kernels: shared files, modules of charts, and what accompanies them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from .. import about
from ..maps.chart import Chart
from ..output import render
from . import catalogue
from .facts import Facts, comment, head
from .targets.target import Target

HASHED = (".txt", ".cmake", ".py", ".pyi", ".toml", ".build", ".options")
"""Ends of the names of files whose comments begin with #, in every target."""


def shared_texts(target: Target) -> Mapping[str, str]:
    """Render the files every package of a target holds, ``_geometry.py`` and the like.

    Raises
    ------
    ValueError
        If they define other functions than the table.
    """
    texts = {}
    for name, data in target.shared().items():
        template = f"{target.name}/{name}.j2"
        lines = head(catalogue.command(target.name), template)
        if name == target.entry:  # in no other file, so that a release changes one
            lines.append(f"Version {about.__version__}.")
        texts[name] = render(template, header=comment(lines, _mark(name, target)), **data)
    target.require_complete(texts)
    return texts


def _mark(name: str, target: Target) -> str:
    return "#" if name.endswith(HASHED) else target.comment


def module_name(chart: Chart, target: Target) -> str:
    """File name of the module of a chart."""
    return f"{chart.name}.{target.extension}"


def module_text(facts: Facts, target: Target) -> str:
    """Render the module of a proved chart."""
    template = f"{target.name}/chart.{target.extension}.j2"
    lines = facts.header(catalogue.command(target.name, facts.chart), template)
    return render(template, header=comment(lines, target.comment), **target.module(facts))


def notices(charts: Sequence[Chart], target: Target) -> dict[str, str]:
    """Render what stands in the place of a package's entry while its other files are exchanged, by name."""
    template = f"interrupted/{target.entry}.j2"
    command = catalogue.command(target.name, *charts)
    header = "\n".join(f"{_mark(target.entry, target)} {line}" for line in head(command, template))
    return {target.entry: render(template, header=header, command=command)}


def companion_texts(facts: Facts, target: Target) -> dict[str, str]:
    """Render the files that accompany a module, by name."""
    texts = {}
    for name, (companion, data) in target.companions(facts).items():
        template = f"{target.name}/{companion}.j2"
        header = comment(head(catalogue.command(target.name, facts.chart), template), target.comment)
        texts[name] = render(template, header=header, **data)
    return texts
