"""Entries for the equations of two papers; `verify` computes the status of each.

=====================  ========================================================================
numbers                fields in which formulas are evaluated, and values of symbols
language               terms, operators, values and evaluation of formulas
equation               entries for printed equations and claims, and papers with their sections
result                 verdicts and status of an entry
condurache_popa_2023   formulas of CP23, one module for each section, and the words of its equations in a file
karakilic_2010.toml    claims of K10, in the same form as the files of users
deciding               one claim: points where it may fail, conditions, regions, changes that mend it, proof
decide                 decision of an entry
entry_certificate      certificate of an entry: both sides of its equations as integer lists
transcript             equations of a file that follows a paper's text, with stated conditions
sheet                  papers as TOML files, read to entries
run                    decision of a file's equations in worker processes
report                 results as text, JSON, Markdown, HTML and LaTeX
=====================  ========================================================================

Each module imports only from modules above it in the table. The package of a paper has its own table:

===========  ================================================================================
text.toml    words of its equations: lines and characters of the extracted text, titles, remarks
notation     symbols used throughout the paper, and operators of this paper only
definitions  definitions of symbols, against which printed formulas are checked
sections     formulas in printed order; a section may use symbols of earlier sections
===========  ================================================================================
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Collection, Iterable, Sequence
from contextlib import nullcontext
from pathlib import Path

from .. import about
from ..output.listing import Listing
from ..output.progress import bar, no_op
from .decide import decide
from .deciding.claim import ORDERS
from .equation import Entry, Paper, Reading, UndecidedError, equation
from .language.abbreviations import ClaimError
from .result import Result, Status, Verdict
from .run import SECONDS, decide_each
from .sheet import Sheet, SheetError, claim_alone, load, sheet


def registered(slug: str) -> Paper:
    """Return a paper of this folder: a file of claims, or a package."""
    name = slug.replace("-", "_")
    file = Path(__file__).parent / f"{name}.toml"
    if not file.exists():
        return Paper.of_package(name)
    return sheet(file.read_text(encoding="utf-8"), f"{__name__.replace('.', '/')}/{file.name}")


PAPERS = tuple(map(registered, about.PAPERS))


def check(claim: str, /, *, domain: str = "", seconds: float = SECONDS, **letters: str) -> Result:
    """Decide one claim.

    Parameters
    ----------
    claim : str
        Relation in plain text, such as ``"R*transpose(R) == I"``. It is parsed, never evaluated.
    domain : str, optional
        Relation that states where the claim is said to hold.
    seconds : float, optional
        Processor time that the claim may take; a slower one is undecided. Windows has no such limit.
    **letters : str
        Kind of each letter, such as ``v="vector"`` or ``n="unit vector"``.

    Returns
    -------
    Result
        Its `status` is "holds", "holds-if" with the condition `found`, "false" with a counterexample and `changes` that
        make the claim true, or "undecided" with the reason as `method`.

    Raises
    ------
    ValueError
        If the claim, the domain or a kind cannot be read: with the column and what was expected.

    Examples
    --------
    >>> import derive
    >>> derive.check("inverse(exp(skew(v))) == exp(skew(-v))", v="vector")
    <Result holds>
    """
    with bar() as step:
        step("claim")
        (result,) = check_sheets([claim_alone(claim, letters, domain)], None, seconds)
    return result


def check_sheets(
    sheets: Sequence[Sheet], numbers: Collection[str] | None = None, seconds: float = SECONDS,
    step: Callable[[str], None] = no_op,
) -> Listing[Result]:
    """Decide the equations of files; `numbers` chooses some, and `step` is called after each."""
    places = [(sheet, place, entry.number) for sheet in sheets for place, entry in enumerate(sheet.entries())]
    items = [(sheet, place) for sheet, place, number in places if numbers is None or number in numbers]
    return Listing(decide_each(items, seconds, step))


def verify(
    paper: str | Path | None = None,
    equations: str | Iterable[str] | None = None,
    orders: Sequence[int] | None = None,
    progress: Callable[[int, int], None] | None = None,
    seconds: float = SECONDS,
) -> Listing[Result]:
    """Decide the equations of the papers, or of a file.

    Parameters
    ----------
    paper : str or Path, optional
        Slug of one paper, or a TOML file; both papers by default. What cannot be read in a file is a warning.
    equations : str or iterable of str, optional
        Numbers or slugs, or one string separated by commas: ``"88,111"``. All by default.
    orders : sequence of int, optional
        Orders n at which statements about n are evaluated; 1 … 5 by default.
    progress : callable, optional
        Function called with (done, total) after each equation. Without one, a terminal or a notebook shows a progress
        bar after two seconds.
    seconds : float, optional
        Processor time that an equation of a file may take; a slower one is undecided. Windows has no such limit.

    Returns
    -------
    list of Result
        One for each equation, with its `status`; a notebook shows a table.

    Raises
    ------
    ValueError
        If the paper or an equation does not exist, or the file is no such file.

    Examples
    --------
    >>> import derive
    >>> derive.verify("condurache-popa-2023", "112")
    [<Result condurache-popa-2023 (112): erratum>]
    """
    papers: list[Paper] = [p for p in PAPERS if paper in (None, p.slug)]
    file = None
    if not papers and paper is not None and Path(paper).suffix == ".toml":
        papers = [file := load(paper)]
        for problem in file.problems:
            warnings.warn(str(problem), stacklevel=2)
    if not papers:
        raise ValueError(f"no paper {str(paper)!r}: expected {' or '.join(p.slug for p in PAPERS)}, or a file *.toml")
    listed = [part.strip() for part in equations.split(",")] if isinstance(equations, str) else equations
    wanted = None if listed is None else [str(number) for number in listed]
    chosen = [(p, e) for p in papers for e in p.entries() if wanted is None or e.number in wanted]
    missing = sorted(set(wanted or ()) - {e.number for _, e in chosen})
    if missing:
        raise ValueError(f"no equation {', '.join(missing)}")
    if file is not None:
        with bar(len(chosen)) as step:
            return check_sheets([file], wanted, seconds, step)
    results: Listing[Result] = Listing()
    with bar(len(chosen)) if progress is None else nullcontext(no_op) as step:
        for done, (source, entry) in enumerate(chosen, 1):
            step(f"equation ({entry.number})")
            results.append(decide(source.slug, entry, source.lost, tuple(orders or ORDERS)))
            if progress is not None:
                progress(done, len(chosen))
    return results


__all__ = [
    "ORDERS", "PAPERS", "SECONDS", "ClaimError", "Entry", "Paper", "Reading", "Result", "Sheet", "SheetError", "Status",
    "UndecidedError", "Verdict", "check", "check_sheets", "claim_alone", "equation", "load", "verify",
]  # fmt: skip
