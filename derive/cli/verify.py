"""``dualcay verify``: decide the papers' equations and write the report."""

from __future__ import annotations

import difflib
import os
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

import click

from ..maps import Cayley
from ..output import files
from ..output.tables import columns
from ..papers import PAPERS, Paper, Status
from ..papers import verify as decide
from ..papers.report import FORMATS, Report, as_text
from ..proof import Proof, citing, proofs, theorems
from . import display, options

NEAREST = 3
"""Names that are proposed for one that does not exist."""


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
    """Do what the command says; its parameters are the options."""
    options.require_cap(orders, max_n)
    if check and output is None:
        raise click.UsageError("--check needs the file that -o names")
    papers = [p for p in PAPERS if paper in (None, p.slug)]
    report = _report(papers, _chosen(papers, equations), orders, output)
    text = as_text(report, columns()) if form == "text" and output is None else FORMATS[form](report)
    stale = _deliver(text, output, check)
    if output is not None and not check:
        click.echo(f"{output}: {counted(report)}", err=True)
    wrong = any(result.status is Status.ERRATUM for result in report.results)
    if stale or report.failed or (strict and wrong):
        raise click.exceptions.Exit(1)


def _chosen(papers: Sequence[Paper], equations: str | None) -> list[str]:
    """The numbers asked for, each once, in the papers' order."""
    known = dict.fromkeys(entry.number for paper in papers for entry in paper.entries())
    if equations is None:
        return list(known)
    wanted = {part.strip() for part in equations.split(",")}
    unknown = [f"{name!r} (nearest: {_nearest(name, known)})" for name in sorted(wanted - set(known))]
    if unknown:
        raise click.BadParameter(f"no equation {', '.join(unknown)}", param_hint="--eq")
    return [number for number in known if number in wanted]


def _nearest(name: str, known: Iterable[str]) -> str:
    return ", ".join(difflib.get_close_matches(name, known, NEAREST, cutoff=0.0))


def _report(papers: Sequence[Paper], equations: list[str], orders: tuple[int, ...], output: Path | None) -> Report:
    total = sum(entry.number in equations for paper in papers for entry in paper.entries())
    everything = sum(len(paper.entries()) for paper in papers)
    slug = papers[0].slug if len(papers) == 1 else None
    with display.progress(total + len(orders) + 1) as step:
        step("equations")
        results = decide(slug, equations, orders or None, lambda done, _: step(f"equation {done} of {total}"))
        cited = None if total == everything or orders else _cited(papers, equations)
        found = {(proof.name, proof.scope): proof for proof in _proofs(orders, cited, step)}
    return Report.of(papers, results, found.values(), _root(output))


def _cited(papers: Sequence[Paper], equations: list[str]) -> set[int]:
    """The numbers that theorems may cite: they are those of the first paper."""
    return {int(number) for number in equations if number.isdecimal()} if PAPERS[0] in papers else set()


def _proofs(orders: tuple[int, ...], cited: set[int] | None, step: Callable[[str], None]) -> Iterator[Proof]:
    """The theorems for all n, those that cite an equation asked for; and everything about the orders asked for."""
    yield from theorems() if cited is None else citing(cited)
    for n in orders:
        step(f"proofs at n = {n}")
        yield from proofs(Cayley(n))


def _root(output: Path | None) -> str:
    """The way from the report to the sources: none for one on stdout or outside a checkout."""
    if output is None:
        return ""
    from ..codegen import catalogue  # all of the generator, which nothing else here needs

    if not catalogue.is_checkout():
        return ""
    return Path(os.path.relpath(catalogue.CHECKOUT, output.resolve().parent)).as_posix()


def _deliver(text: str, output: Path | None, check: bool) -> bool:
    """Print or write the text, or only check the file; return whether it is stale."""
    if output is None:
        click.echo(text, nl=False)
        return False
    if not check:
        files.write(output.parent, {output.name: text}, force=True)
        return False
    found = [d for d in files.compare(output.parent, {output.name: text}) if d.path == output]
    if found:
        display.differences(found, options.unchecked())
    return bool(found)


def counted(report: Report) -> str:
    """How many equations have each status, and how many proofs there are."""
    counts = Counter(str(result.status) for result in report.results)
    return ", ".join(f"{count} {what}" for what, count in (*counts.items(), ("proofs", len(report.proofs))))
