"""Every way to read a display with the marks that survive: how many there are, and which are true.

The listed reading gives the letters and their order; which marks were lost does not matter, they are put in anew. The
readings of each side are compared as residues, where a false one agrees only by accident: what agrees is then decided
like any other reading.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import reduce
from itertools import pairwise
from typing import Any

from derive.algebra import Tensor, Vector
from derive.algebra.exact import NotExactError

from ..equation import Equation
from ..language import values
from ..language.evaluation import Env
from ..language.notation import both, equal, pm, root
from ..language.terms import Apply, Letter, Term, Trait, letters, marked, takes_apart, walk
from ..numbers.kinds import BRANCH, ORDER, SIGN
from ..numbers.residues import PRIME, Reduced
from .items import MEANINGLESS, OpenError, Table, flat, key
from .reach import Reach
from .search import CAP, Side
from .targets import UndecidedSearchError
from .tokens import equations, surviving

ORDER_READ, BRANCH_READ = 7, 3
"""The order and the branch at which residues are compared: numerals of few displays."""
LISTED = 800
"""How many readings of a stretch are listed in a search for one value."""
FEW = 4
"""How many values of the other side are looked for."""
STEPS = 120  # α/2 … α/10 and their halves


@dataclass(frozen=True)
class Readings:
    """What the search found.

    Attributes
    ----------
    count : int
        How many readings differ, at most `search.CAP`.
    complete : bool
        Whether none was left out that could be true.
    true : tuple of Term
        Those that agree with the listed ones' letters at the point of residues; one for each value.
    """

    count: int
    complete: bool
    true: tuple[Term, ...]


class UnreadableError(Exception):
    """The display is no chain of equations between values of the field."""


@contextmanager
def _collector_paused() -> Iterator[None]:
    """No looking for cycles: parts of a formula make none, and looking takes a third of the time of a search."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


@_collector_paused()
def read(entry: Equation, lost: str, search: bool = True) -> Readings:
    """All readings of the display of an entry.

    Parameters
    ----------
    search : bool
        Whether to look beyond the cap for one that is true.

    Raises
    ------
    UnreadableError
        If it is none whose sides have values to compare.
    """
    statement = entry.readings[0].statement
    chains = equations(statement)
    if not chains:
        raise UnreadableError(entry.number)
    try:
        env = _environment(entry, statement)
        found = [_Chain(chain, env, lost, _has_root(entry)) for chain in chains]
    except (NotExactError, *MEANINGLESS) as error:
        raise UnreadableError(f"{entry.number}: {error}") from error
    count = reduce(lambda product, chain: min(CAP, product * chain.count), found, 1)
    if all(chain.true for chain in found):
        true = [equal(*sides) for sides in (chain.true[0] for chain in found)]
        return Readings(count, all(chain.listed for chain in found), (both(*true) if len(true) > 1 else true[0],))
    listed = all(chain.listed for chain in found)
    return Readings(count, listed or (search and any(chain.impossible() for chain in found)), ())


def _environment(entry: Equation, statement: Term) -> Env:
    free = entry.free(statement)
    order = next((letter for letter in free if letter.kind is ORDER), None)
    branch = next((letter for letter in free if letter.kind is BRANCH), None)
    lengths = {letter for part in marked(Trait.LENGTH, statement) for letter in entry.free(part)}
    generic = sorted(
        (a for a in free if a not in (order, branch) and a.kind is not SIGN), key=lambda a: a not in lengths
    )
    dual = takes_apart(statement, *_defined(entry, statement))
    n = max(entry.orders) if entry.orders else ORDER_READ
    point = Reduced(generic, dual, entry.moving, 4 * n if order else STEPS, framed=not entry.components)
    point.fix(order, n)
    point.fix_branch(branch, entry.branches - 1 if entry.branches else BRANCH_READ)
    point.values.update({letter: 1 for letter in free if letter.kind is SIGN})
    return Env(point.field, dict(point.values), entry.definitions, dual, entry.moving)


def _defined(entry: Equation, statement: Term) -> Iterator[Letter]:
    """The defined letters that a statement rests on."""
    queue = list(letters(statement))
    for letter in queue:
        if letter in entry.definitions:
            yield letter
            queue += [argument for argument in entry.definitions[letter].arguments if argument not in queue]


def _has_root(entry: Equation) -> bool:
    """Whether a listed form has a radical: else none is put in."""
    forms = [reading.statement for reading in entry.readings]
    forms += [] if entry.corrected is None else [entry.corrected]
    return any(isinstance(node, Apply) and node.mark is root for form in forms for node in walk(form))


class _Member:
    """A side: a single letter with its value, or one with marks to put in."""

    def __init__(self, term: Term, env: Env, lost: str, radicals: bool) -> None:
        tokens = surviving(term, lost)
        bare = term.arguments[0] if isinstance(term, Apply) and term.mark is pm else term
        self.term, self.either, self.env = term, bare is not term, env
        self.value = env.now(env.value(bare))
        self.fixed = len(tokens) == 1 + self.either or isinstance(self.value, values.Solution | values.Either)
        self.side = Side(tokens, env, radicals, not isinstance(self.value, Tensor))
        self.table: Table | None = None

    def list(self) -> None:
        """Look up all readings; there is no table beyond the cap."""
        if self.fixed:
            return
        try:
            self.table = self.side.readings()
        except OpenError:
            return
        if key(self.value) not in self.table:
            raise NotExactError("the listed reading has a mark that is not put in")

    @property
    def count(self) -> int:
        """How many readings it has."""
        return 1 if self.fixed else self.side.cap if self.table is None else len(self.table)

    def at(self, k: Any) -> Any:
        """The value with that key."""
        if self.table is None:
            return self.value
        value = self.env.now(self.table[k].value)
        return values.Either(value, values.negative(value)) if self.either else value

    def reading(self, k: Any) -> Term:
        """The reading with that value."""
        if self.fixed or self.table is None:
            return self.term
        term = self.table[k].term
        return pm(term) if self.either else term


class _Chain:
    """Sides that should be equal."""

    def __init__(self, sides: Sequence[Term], env: Env, lost: str, radicals: bool) -> None:
        self.env = env
        self.members = [_Member(side, env, lost, radicals) for side in sides]
        for member in self.members:
            member.list()
        self.fixed = [member for member in self.members if member.fixed]
        self.read = [member for member in self.members if not member.fixed]
        self.listed = all(member.table is not None for member in self.read)
        self.count = reduce(lambda n, member: min(CAP, n * member.count), self.members, 1)
        self.either = any(member.either for member in self.members)
        self.missed: bool | None = None
        self.true = [tuple(m.reading(k) for m in self.members) for k in self._common()] if self.listed else []

    def _common(self) -> list[Any]:
        """The values that every side can have."""
        tables = [member.table for member in self.read if member.table is not None]
        if not tables:
            return [None] if all(self._agree(a.value, b.value) for a, b in pairwise(self.fixed)) else []
        shared = [k for k in tables[0] if all(k in table for table in tables[1:])]
        for given in [member.value for member in self.fixed]:
            if isinstance(given, values.Solution | values.Either):
                shared = [k for k in shared if self._agree(given, self.read[0].at(k))]
            else:
                signed = [given, values.negative(given)] if self.either else [given]
                wanted = [key(value) for value in signed]
                shared = [k for k in shared if k in wanted]
        return shared

    def _agree(self, a: Any, b: Any) -> bool:
        try:
            return values.equal(self.env.field, a, b)
        except (NotExactError, *MEANINGLESS):
            return False

    def impossible(self) -> bool:
        """Whether no reading of the chain is true, those beyond the cap included."""
        if self.missed is None:
            unlisted = [member for member in self.read if member.table is None]
            self.missed = any(map(self._misses, unlisted)) if unlisted else not self.true
        return self.missed

    def _misses(self, member: _Member) -> bool:
        """Whether a side that cannot be listed cannot be what another is."""
        wanted = [value for other in self.members if other is not member for value in self._values(other)]
        if not 0 < len(wanted) <= FEW:
            return False
        try:
            reach = Reach(Side(member.side.tokens, self.env, member.side.radicals, member.side.quaternions, LISTED),
                          self._along())  # fmt: skip
            targets = [reach.stretches.target(value) for value in wanted]
            signed = [t for target in targets for t in (target, tuple(-c % PRIME for c in target))]
            return not any(reach.can(0, len(member.side.tokens), t) for t in signed)
        except (UndecidedSearchError, NotExactError, *MEANINGLESS):
            return False

    def _values(self, member: _Member) -> list[Any]:
        """What a side can be: one value, or those that are listed."""
        if isinstance(member.value, values.Solution | values.Either) or (not member.fixed and member.table is None):
            return []
        if member.fixed or member.table is None:
            return [member.value]
        return [self.env.now(item.value) for item in member.table.values()]

    def _along(self) -> int:
        """The length of the vector that the others are along."""
        vectors = [value for value in self.env.values.values() if isinstance(value, Vector)]
        lengths = [flat(v.c1) for v in vectors if flat(v.c2) == 0 == flat(v.c3)]
        return next((length for length in lengths if isinstance(length, int)), 1)
