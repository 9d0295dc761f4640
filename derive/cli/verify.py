"""``dualcay verify``: decide the papers' equations and write the report."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import click

from ..codegen import catalogue
from ..maps import Cayley
from ..output import files
from ..papers import PAPERS, Paper, Status, UndecidedError
from ..papers import verify as decide
from ..papers.report import FORMATS, Report
from ..proof import Proof, proofs, theorems
from . import display, options


class NotDecided(click.ClickException):
    """An entry that cannot be given a status."""

    exit_code = 1


@click.command()
@click.option("--paper", type=click.Choice([paper.slug for paper in PAPERS]), help="One paper; all by default.")
@click.option("--eq", "equations", help="Numbers or slugs, e.g. 88,111; all by default.")
@click.option("-n", "orders", callback=options.orders, help="Orders at which statements about n are executed and the "
              "formulas proved, e.g. 1-8.")  # fmt: skip
@click.option("--format", "form", type=click.Choice(tuple(FORMATS)), default="text", show_default=True)
@click.option("-o", "output", type=click.Path(path_type=Path, dir_okay=False), help="File to write; else stdout.")
@click.option("--check", is_flag=True, help="Write nothing; exit 1 if the file of -o is not what would be written.")
@click.option("--strict", is_flag=True, help="Exit 1 for an erratum too.")
@click.option("--max-n", default=catalogue.MAX_ORDER, show_default=True, type=click.IntRange(min=1))
def verify(
    paper: str | None,
    equations: str | None,
    orders: tuple[int, ...],
    form: str,
    output: Path | None,
    check: bool,
    strict: bool,
    max_n: int,
) -> None:
    """Decide every equation of the papers: which hold, under what condition, and what the wrong ones should say."""
    options.require_cap(orders, max_n)
    if check and output is None:
        raise click.UsageError("--check needs the file that -o names")
    papers = [p for p in PAPERS if paper in (None, p.slug)]
    report = _report(papers, _chosen(papers, equations), orders, output)
    text = FORMATS[form](report)
    stale = _deliver(text, output, f"python -m derive verify --format {form} -o {output}" if check else "")
    wrong = any(result.status is Status.ERRATUM for result in report.results)
    if stale or report.failed or (strict and wrong):
        raise click.exceptions.Exit(1)


def _chosen(papers: Sequence[Paper], equations: str | None) -> list[str]:
    """The numbers asked for, each once, in the papers' order."""
    known = dict.fromkeys(entry.number for paper in papers for entry in paper.entries())
    if equations is None:
        return list(known)
    wanted = {part.strip() for part in equations.split(",")}
    unknown = sorted(wanted - set(known))
    if unknown:
        numbers, slugs = (", ".join(n for n in known if n.isdecimal() is decimal) for decimal in (True, False))
        raise click.BadParameter(
            f"no equation {', '.join(map(repr, unknown))}; there are {numbers}; and {slugs}", param_hint="--eq"
        )
    return [number for number in known if number in wanted]


def _report(papers: Sequence[Paper], equations: list[str], orders: tuple[int, ...], output: Path | None) -> Report:
    total = sum(entry.number in equations for paper in papers for entry in paper.entries())
    everything = sum(len(paper.entries()) for paper in papers)
    slug = papers[0].slug if len(papers) == 1 else None
    with display.progress(total + len(orders) + 1) as step:
        step("equations")
        try:
            results = decide(slug, equations, orders or None, lambda done, _: step(f"equation {done} of {total}"))
        except UndecidedError as error:
            raise NotDecided(str(error)) from error
        cited = None if total == everything or orders else _cited(papers, equations)
        found = {(proof.name, proof.scope): proof for proof in _proofs(orders, cited, step)}
    return Report.of(papers, results, found.values(), _root(output))


def _cited(papers: Sequence[Paper], equations: list[str]) -> set[int]:
    """The numbers that theorems may cite: they are those of the first paper."""
    return {int(number) for number in equations if number.isdecimal()} if PAPERS[0] in papers else set()


def _proofs(orders: tuple[int, ...], cited: set[int] | None, step: Callable[[str], None]) -> Iterator[Proof]:
    """The theorems for all n, those that cite an equation asked for; and everything about the orders asked for."""
    if cited is None or cited:
        yield from (proof for proof in theorems() if cited is None or cited & set(proof.equations))
    for n in orders:
        step(f"proofs at n = {n}")
        yield from proofs(Cayley(n))


def _root(output: Path | None) -> str:
    """The way from the report to the sources: none for one on stdout or outside a checkout."""
    if output is None or not catalogue.is_checkout():
        return ""
    return Path(os.path.relpath(catalogue.CHECKOUT, output.resolve().parent)).as_posix()


def _deliver(text: str, output: Path | None, check: str) -> bool:
    """Print or write the text, or only check the file, with the command that writes it; return whether it is stale."""
    if output is None:
        click.echo(text, nl=False)
        return False
    if not check:
        files.write(output.parent, {output.name: text}, force=True)
        return False
    found = [d for d in files.compare(output.parent, {output.name: text}) if d.path == output]
    if found:
        display.differences(found, check)
    return bool(found)
