"""The papers, as data, and documents in use; `verify` decides the equations of a paper or of a file.

=====================  ======================================================================
condurache_popa_2023   formulas of CP23, one module for each section, and their words in a file
karakilic_2010.toml    claims of K10, in the same form as the files of users
field                  documents in use, as files of claims
=====================  ======================================================================

The package of a paper has its own table:

===========  ================================================================================
text.toml    words of its equations: lines and characters of the extracted text, titles, remarks
notation     symbols used throughout the paper, and operators of this paper only
definitions  definitions of symbols, against which printed formulas are checked
sections     formulas in printed order; a section may use symbols of earlier sections
===========  ================================================================================
"""

from __future__ import annotations

import importlib
import tomllib
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from .. import about
from ..claims.decide import decide
from ..claims.deciding.claim import ORDERS
from ..claims.equation import Entry, Home, Paper
from ..claims.result import Result
from ..claims.run import SECONDS, check_sheets
from ..claims.sheet import load, sheet
from ..output.shown import Listing, bar, no_op


@dataclass(frozen=True)
class Package(Paper):
    """Paper of a package: `words` has the fields of its entries by number."""

    name: str = ""
    home: Home | None = None
    words: Mapping[str, Mapping[str, Any]] = field(default_factory=dict, repr=False)

    @staticmethod
    def read(name: str, home: Home) -> Package:
        """Return the paper of a package; `home` finds its entries again."""
        data = tomllib.loads((Path(__file__).parent / name / "text.toml").read_text(encoding="utf-8"))
        words = {row["number"]: row for row in data["equation"]}
        claims = {int(line): numbers for line, numbers in data["claims"].items()}
        return Package(**data["paper"], claims=claims, reasons=data["reasons"], name=name, home=home, words=words)

    @property
    def sections(self) -> tuple[str, ...]:
        """Modules in ``sections`` that define ``ENTRIES``, in the paper's order."""
        return tuple(sorted(path.stem for path in (Path(__file__).parent / self.name / "sections").glob("s[0-9]*.py")))

    def entries(self) -> tuple[Entry, ...]:
        """Return all entries in the paper's order, each with its words and the path of its module."""
        found: list[Entry] = []
        for section in self.sections:
            module = f"{__package__}.{self.name}.sections.{section}"
            source = f"{module.replace('.', '/')}.py"
            entries = importlib.import_module(module).ENTRIES
            found += [replace(e, source=source, home=self.home, **self.words[e.number]) for e in entries]
        return tuple(found)


def registered(slug: str) -> Paper:
    name = slug.replace("-", "_")
    file = Path(__file__).parent / f"{name}.toml"
    if not file.exists():
        return Package.read(name, entry_at)
    return sheet(file.read_text(encoding="utf-8"), f"{__name__.replace('.', '/')}/{file.name}", entry_at)


def entry_at(source: str, number: str) -> Entry:
    """Return the entry of a registered paper by the path of its module or file, and its number."""
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


__all__ = ["PAPERS", "entry_at", "registered", "verify"]
