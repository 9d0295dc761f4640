"""Entry for an equation or claim of a paper, and the rules by which it is decided.

An `Equation` is an entry: the printed formula and the definitions of its symbols. Its status is computed.
`decide` executes it and returns a `Result`:

* every reading is evaluated at seeded 60-digit points, with special values of every symbol. One failure refutes it;
* a reading without failure is then proved at generic values of an exact field, for symbolic n if it has an n. Without
  such a field the method says that the points are evidence;
* every reading must be faithful: its characters, without those that the extraction loses, are the extracted text;
* readings are listed by hand, the most charitable first;
* ``holds``: a listed reading is true at all points. ``holds-if``: it is true where the entry's condition is fulfilled,
  and not everywhere else; both sides are tested. ``erratum``: no listed reading is true; then the correction must be.
  ``ambiguous``: a true and a false reading that the text cannot tell apart.

An entry that fits none of these raises `UndecidedError`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from .language.evaluation import Definition
from .language.terms import Symbol, Term, symbols, text
from .numbers.draw import Draw

Points = Callable[[Draw], Mapping[str, Mapping[Symbol, Any]]]


class UndecidedError(Exception):
    """Error of an entry without a status: it lacks a condition, a correction or a faithful reading."""


@dataclass(frozen=True)
class Reading:
    """One way to read a display.

    Attributes
    ----------
    statement : Term
        The formula.
    note : str
        How it differs from the other readings ("the bracket closes before I").
    supported_by : str
        A legible place of the paper that speaks for it, quoted with its line; a false reading that has one makes the
        entry ambiguous.
    """

    statement: Term
    note: str = ""
    supported_by: str = ""


@dataclass(frozen=True)
class Equation:
    """Entry of the report. Use `equation` to make one.

    Attributes
    ----------
    number : str
        The paper's number, or a slug.
    title : str
    line : int
        Line of the extraction where it stands.
    extract : str
        Characters of the text there, empty for a claim in words.
    readings : tuple of Reading
        Readings listed by hand, the most charitable first.
    where : tuple of Definition
        Definitions of symbols; all others are free and take values of their quantity.
    claimed : Term, optional
        The domain that the paper states; points outside it are not tested.
    stated : tuple of int and str, optional
        Line and words that state it, without which none is claimed.
    condition : Term, optional
        The domain that was found.
    corrected : Term, optional
        Correction of an erratum.
    because : Term, optional
        Identity that supports a statement which points alone cannot prove.
    argument : str
        Place of the argument that leads from this identity to the statement, which is then proved.
    also : callable, optional
        Further points: from a `numbers.draw.Draw` to values of free symbols, by name.
    moving : bool
        Whether the symbols are functions of time.
    orders : tuple of int, optional
        Orders that it is about, if not all.
    branches : int, optional
        Number of values of a branch symbol, where that is not n.
    components : bool
        Whether single components occur, so that no frame may be chosen along the vectors.
    lost : str
        Further characters that the extraction lost in this display.
    fixed_by : str
        The legible place that decides between readings, where one does.
    said : str
        The words of the paper, for a claim that no display makes.
    remark : str
        One sentence for the report.
    source : str
        The module that holds the entry, as a path; its paper knows it.
    """

    number: str
    title: str
    line: int
    extract: str
    readings: tuple[Reading, ...]
    where: tuple[Definition, ...] = ()
    claimed: Term | None = None
    stated: tuple[int, str] | None = None
    condition: Term | None = None
    corrected: Term | None = None
    because: Term | None = None
    argument: str = ""
    also: Points | None = field(default=None, compare=False)
    moving: bool = False
    orders: tuple[int, ...] | None = None
    branches: int | None = None
    components: bool = False
    lost: str = ""
    fixed_by: str = ""
    said: str = ""
    remark: str = ""
    source: str = ""

    @property
    def definitions(self) -> dict[Symbol, Definition]:
        """Return the definitions by symbol."""
        return {definition.symbol: definition for definition in self.where}

    def free(self, statement: Term) -> tuple[Symbol, ...]:
        """Return the symbols that vary in a statement: its own and those that its definitions use."""
        parts = (statement, *(part for part in (self.claimed, self.condition) if part is not None))
        seen = dict.fromkeys(symbol for part in parts for symbol in symbols(part))
        queue = list(seen)
        for symbol in queue:
            if symbol in self.definitions:
                new = [argument for argument in self.definitions[symbol].arguments if argument not in seen]
                seen.update(dict.fromkeys(new))
                queue += new
        return tuple(symbol for symbol in queue if symbol not in self.definitions and symbol.quantity.varies)

    def __repr__(self) -> str:
        return f"<Equation ({self.number}): {self.title}>"

    def reading(self, statement: Term) -> Equation:
        """Return the entry with one reading in place of the printed ones: a correction or a mutant."""
        return replace(self, readings=(Reading(statement),), extract="")


def equation(number: str, title: str, line: int, printed: Term | tuple[Reading, ...], **rest: Any) -> Equation:
    """Return an entry; `printed` is the statement, or its readings."""
    readings = printed if isinstance(printed, tuple) else (Reading(printed),)
    rest["where"] = tuple(rest.get("where", ()))
    return Equation(number, title, line, rest.pop("extract", ""), readings, **rest)


def faithful(reading: Term, extract: str, lost: str) -> bool:
    """Return whether a reading has exactly the characters that survive in the extract, in order.

    Parameters
    ----------
    lost : str
        The characters the extraction of this paper lost or scattered; spaces are always ignored. A tilde and the
        index of its symbol come in either order.
    """
    drop = str.maketrans("", "", lost + " ")

    def characters(line: str) -> str:
        return re.sub(r"~(\d+)", r"\1~", line.translate(drop))

    return characters(text(reading)) == characters(extract)
