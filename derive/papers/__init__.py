"""Entries for the equations of two papers; `verify` computes the status of each.

=====================  ========================================================================
numbers                fields in which formulas are evaluated, and values of symbols
language               terms, operators, values and evaluation of formulas
equation               entries for printed equations and claims, and papers with their sections
result                 verdicts and status of an entry
condurache_popa_2023   entries of CP23, one module for each section
karakilic_2010         entries of K10
sharp                  sharpness of a condition, tested by the denominators
explore                truth of a statement at seeded points, special points and poles
decide                 status of an entry
entry_certificate      certificate of an entry: both sides of its equations as integer lists
report                 results as text, JSON, Markdown, HTML and LaTeX
=====================  ========================================================================

Each module imports only from modules above it in the table. The package of a paper has its own table:

===========  ================================================================================
notation     symbols used throughout the paper, characters lost by its text extraction, and operators of this paper only
definitions  definitions of symbols, against which printed formulas are checked
sections     entries in printed order; a section may use symbols of earlier sections
===========  ================================================================================
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import nullcontext

from ..output.listing import Listing
from ..output.progress import bar, no_op
from . import condurache_popa_2023, karakilic_2010
from .decide import ORDERS, decide
from .equation import Entry, Paper, Reading, UndecidedError, equation
from .result import Result, Status, Verdict

PAPERS: tuple[Paper, ...] = (condurache_popa_2023.PAPER, karakilic_2010.PAPER)


def verify(
    paper: str | None = None,
    equations: str | Iterable[str] | None = None,
    orders: Sequence[int] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Listing[Result]:
    """Decide the equations of the papers.

    Parameters
    ----------
    paper : str, optional
        Slug of one paper; both by default.
    equations : str or iterable of str, optional
        Numbers or slugs, or one string separated by commas: ``"88,111"``. All by default.
    orders : sequence of int, optional
        Orders n at which statements about n are evaluated; 1 … 5 by default.
    progress : callable, optional
        Function called with (done, total) after each equation. Without one, a terminal or a notebook shows a progress
        bar after two seconds.

    Returns
    -------
    list of Result
        One for each equation, with its `status`; a notebook shows a table.

    Raises
    ------
    ValueError
        If the paper or an equation does not exist.

    Examples
    --------
    >>> import derive
    >>> derive.verify("condurache-popa-2023", "112")
    [<Result condurache-popa-2023 (112): erratum>]
    """
    papers = [p for p in PAPERS if paper in (None, p.slug)]
    if not papers:
        raise ValueError(f"no paper {paper!r}: expected {' or '.join(p.slug for p in PAPERS)}")
    listed = [part.strip() for part in equations.split(",")] if isinstance(equations, str) else equations
    wanted = None if listed is None else [str(number) for number in listed]
    chosen = [(p, e) for p in papers for e in p.entries() if wanted is None or e.number in wanted]
    missing = sorted(set(wanted or ()) - {e.number for _, e in chosen})
    if missing:
        raise ValueError(f"no equation {', '.join(missing)}")
    results: Listing[Result] = Listing()
    with bar(len(chosen)) if progress is None else nullcontext(no_op) as step:
        for done, (source, entry) in enumerate(chosen, 1):
            step(f"equation ({entry.number})")
            results.append(decide(source.slug, entry, source.lost, tuple(orders or ORDERS)))
            if progress is not None:
                progress(done, len(chosen))
    return results


__all__ = [
    "ORDERS", "PAPERS", "Entry", "Paper", "Reading", "Result", "Status", "UndecidedError", "Verdict", "equation",
    "verify",
]  # fmt: skip
