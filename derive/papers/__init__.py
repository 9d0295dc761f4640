"""Files of claims from the papers and from documents in use; `verify` decides the equations of a paper or of a file.

====================  ============================
condurache_popa_2023  equations and claims of CP23
karakilic_2010        equations and claims of K10
field                 documents in use
====================  ============================

Files of the two papers follow their texts line by line and state conditions; `derive.claims.transcript` reads them.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Sequence
from contextlib import nullcontext
from pathlib import Path

from .. import about
from ..claims.decide import decide
from ..claims.deciding.claim import ORDERS
from ..claims.equation import Entry
from ..claims.result import Result
from ..claims.run import SECONDS, check_sheets
from ..claims.sheet import FILES, Sheet, load, sheet
from ..output.shown import Listing, bar, no_op


def registered(slug: str) -> Sheet:
    file = Path(__file__).parent / f"{slug.replace('-', '_')}.toml"
    return sheet(file.read_text(encoding="utf-8"), f"{__name__.replace('.', '/')}/{file.name}", entry_at)


def entry_at(source: str, number: str) -> Entry:
    """Return the entry of a registered paper by the path of its file, and its number."""
    entries = (entry for paper in PAPERS for entry in paper.entries())
    return next(entry for entry in entries if (entry.source, entry.number) == (source, number))


PAPERS = tuple(map(registered, about.PAPERS))


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
        Slug of one paper, or a file ``.toml``, ``.tex``, ``.md``, ``.rst`` or ``.ipynb``; both papers by default. What
        cannot be read in a file is a warning.
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
    papers = [p for p in PAPERS if paper in (None, p.slug)]
    file = None
    if not papers and paper is not None and Path(paper).suffix.lower() in FILES:
        papers = [file := load(paper)]
        for problem in file.problems:
            warnings.warn(str(problem), stacklevel=2)
    if not papers:
        raise ValueError(f"no paper {str(paper)!r}: expected {', '.join(p.slug for p in PAPERS)} or a file "
                         f"of claims, {', '.join(FILES)}")
    listed = [part.strip() for part in equations.split(",")] if isinstance(equations, str) else equations
    wanted = None if listed is None else [str(number) for number in listed]
    chosen = [(p, e) for p in papers for e in p.entries(wanted)]
    missing = sorted(set(wanted or ()) - {e.number for _, e in chosen})
    if missing:
        raise ValueError(f"no equation {', '.join(missing)}")
    if file is not None:
        with bar(len(chosen)) as step:
            return check_sheets([file], wanted, seconds, step, keep=True)
    results: Listing[Result] = Listing()
    with bar(len(chosen)) if progress is None else nullcontext(no_op) as step:
        for done, (source, entry) in enumerate(chosen, 1):
            step(f"equation ({entry.number})")
            results.append(decide(source.slug, entry, source.lost, tuple(orders or ORDERS)))
            if progress is not None:
                progress(done, len(chosen))
    return results


__all__ = ["PAPERS", "entry_at", "registered", "verify"]
