"""``dualcay verify``: decide the papers' equations and write the report."""

from __future__ import annotations

import difflib
import os
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import click

from .. import about
from ..claims.draft import draft as drafted
from ..claims.language.names import ClaimError
from ..claims.report import FORMATS, LINEWISE, Report, as_text, data
from ..claims.result import Status
from ..claims.run import check_sheets
from ..claims.sheet import FILES, Problem, Sheet, SheetError, claim_alone, load, unreadable
from ..output import files, pages
from ..output.shown import columns, seen
from . import display, options

WRONG = (Status.ERRATUM, Status.FALSE, Status.UNDECIDED, Status.UNREFUTED)
"""Statuses for which --strict exits with 1."""


def verify(
    sheets: tuple[str, ...] = (), paper: str | None = None, claim: str | None = None, letters: tuple[str, ...] = (),
    domain: str | None = None, seconds: float = 60.0, equations: str | None = None, orders: tuple[int, ...] = (),
    form: str = "text", output: Path | None = None, beside: bool = False, check: bool = False, strict: bool = False,
    no_cache: bool = False, max_n: int = 0,
) -> None:  # fmt: skip
    """Run the command; parameters are its options."""
    options.require_cap(orders, max_n)
    if sum(map(bool, (sheets, paper, claim is not None))) > 1:
        raise click.UsageError("give files, --paper or --claim, one of them")
    if claim is None and (letters or domain):
        raise click.UsageError("--let and --domain belong to --claim")
    if (sheets or claim is not None) and orders:
        raise click.UsageError("-n belongs to the papers: in a file, n is a letter of the kind order")
    if (check or beside) and output is None:
        raise click.UsageError(f"{'--check' if check else '--data'} needs the file that -o names")
    if not check:
        options.require_writable(output, output.with_suffix(".json") if output and beside else None)
    stale = []
    if sheets or claim is not None:
        read, problems = _loaded(sheets, form) if sheets else ([_single(claim or "", letters, domain or "")], [])
        report = _of_sheets(read, _chosen(read, equations) if equations else None, seconds, not no_cache)
        report = replace(report, problems=(*problems, *report.problems))
    else:
        report = _of_papers(paper, equations, orders, output)
    text = seen(as_text(report, columns()) if form == "text" and output is None else FORMATS[form](report))
    if output is None:
        click.echo(text, nl=False)
    else:
        texts = pages.beside(output, text, seen(data(report))) if beside else {output.name: text}
        if check:
            stale = pages.stale(output, texts)
            display.differences(stale, output, options.without_check())
        else:
            files.write(output.parent, texts, force=True)
            click.echo(f"{output}: {report.summary}", err=True)
    _complain(report.problems)
    wrong = any(result.status in WRONG for result in report.results)
    if stale or report.failed or (strict and wrong):
        raise click.exceptions.Exit(1)


def _loaded(names: Sequence[str], form: str) -> tuple[list[Sheet], list[Problem]]:
    """Return the files that can be read, each under a name of its own in reports, and a problem for each other file.

    If none can be read, only a report beside the lines of files shows why; in another form it is an error.
    """
    read, problems = dict[str, Sheet](), list[Problem]()
    for name in dict.fromkeys(names):
        try:
            read[name] = load(name)
        except SheetError as error:
            problems.append(unreadable(name, error))
    if not read and form not in LINEWISE:
        raise Unreadable("\n".join(map(str, problems)))
    slugs = Counter(sheet.slug for sheet in read.values())
    return [s if slugs[s.slug] == 1 else replace(s, slug=name, short=name) for name, s in read.items()], problems


class Unreadable(click.ClickException):
    """Error of one line for a file or claim that cannot be read."""

    exit_code = 2


def draft(document: str, output: Path | None, letters: tuple[str, ...], force: bool) -> None:
    """Run the command ``draft``; parameters are its options."""
    options.require_writable(output)
    if output is not None and output.exists() and not force:
        raise click.UsageError(f"{output} exists, with claims of yours perhaps: give another name, or --force")
    try:
        text, problems = drafted(document, _pairs(letters))
    except SheetError as error:
        raise Unreadable(str(unreadable(document, error))) from None
    if output is None:
        click.echo(text, nl=False)
    else:
        files.write(output.parent, {output.name: text}, force=True)
        unread = len(re.findall('^claim = ""', text, re.M))
        click.echo(f"{output}: {text.count('[[equation]]')} equations, {unread} unread", err=True)
    _complain(problems)


def _complain(problems: Sequence[Problem]) -> None:
    for problem in problems:
        click.echo(str(problem), err=True)
    if problems:
        raise click.exceptions.Exit(2)


def _pairs(letters: Sequence[str]) -> dict[str, str]:
    wrong = next((text for text in letters if not all(part.strip() for part in text.partition("="))), None)
    if wrong is not None:
        raise click.BadParameter(f"expected NAME=KIND such as v=vector, got {wrong!r}", param_hint="--let")
    return {name.strip(): kind.strip() for name, _, kind in (text.partition("=") for text in letters)}


def _single(claim: str, letters: Sequence[str], domain: str) -> Sheet:
    try:
        return claim_alone(claim, _pairs(letters), domain)
    except ClaimError as error:
        if Path(claim).suffix in FILES or Path(claim).is_file():
            raise click.UsageError(f"expected a claim, got the name of a file: dualcay verify {claim}") from None
        raise Unreadable(f"claim: {error}") from None


def _of_sheets(sheets: Sequence[Sheet], equations: list[str] | None, seconds: float, keep: bool) -> Report:
    total = sum(equations is None or entry.number in equations for sheet in sheets for entry in sheet.entries())
    unread = [row for sheet in sheets for row in sheet.unread if equations is None or str(row["number"]) in equations]
    with display.progress(total) as step:
        step("equations")
        results = check_sheets(sheets, equations, seconds, step, keep)
    problems = [problem for sheet in sheets for problem in sheet.problems]
    return Report.of(sheets, results, (), "", problems, unread)


def _chosen(papers: Sequence[Sheet], equations: str | None) -> list[str]:
    """Return the requested equations without repetition, in the papers' order."""
    known = dict.fromkeys(number for paper in papers for number in paper.numbers)
    if equations is None:
        return list(known)
    wanted = {part.strip() for part in equations.split(",")}
    unknown = []
    for name in sorted(wanted - known.keys()):
        nearest = ", ".join(difflib.get_close_matches(name, known, n=3, cutoff=0.0))
        unknown.append(f"{name!r} (nearest: {nearest})")
    if unknown:
        raise click.BadParameter(f"no equation {', '.join(unknown)}", param_hint="--eq")
    return [number for number in known if number in wanted]


def _of_papers(slug: str | None, chosen: str | None, orders: tuple[int, ...], output: Path | None) -> Report:
    """Return the report on one paper or all; rooms that files of claims do not need are loaded here."""
    from .. import papers as room
    from ..maps import Cayley
    from ..proof import citing, proofs, theorems

    papers = [paper for paper in room.PAPERS if slug in (None, paper.slug)]
    equations = _chosen(papers, chosen)
    total = sum(number in equations for paper in papers for number in paper.numbers)
    everything = sum(len(paper.numbers) for paper in papers)
    cited = None
    if total < everything and not orders:  # theorems cite the numbers of the first paper
        cited = {int(number) for number in equations if number.isdecimal()} if room.PAPERS[0] in papers else set()
    with display.progress(total + len(orders)) as step:
        step("equations")
        results = room.verify(slug, equations, orders or None, lambda done, _: step("equations"))
        found = list(theorems() if cited is None else citing(cited))
        for n in orders:
            step(f"proofs at n = {n}")
            found += proofs(Cayley(n))
    unique = {(proof.name, proof.scope): proof for proof in found}
    return Report.of(papers, results, unique.values(), _root(output))


def _root(output: Path | None) -> str:
    """Return the relative path from the report to the sources; empty on stdout or outside a checkout."""
    root = about.checkout()
    return Path(os.path.relpath(root, output.resolve().parent)).as_posix() if root and output else ""
