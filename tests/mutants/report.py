"""The figures: a table by room, and the survivors."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from . import road
from .checks import FEW, LONG, SLOWER, TOO_LONG
from .mutant import EQUIVALENT, KILLED, MEANINGLESS, PROSE, SURVIVED, TIMEOUT
from .record import Record
from .rooms import ROOMS, Room

STAGES = ("proof", "validation", "execution", "tests", "kernels", "crash")
FIRST = ("proof", "validation", "execution")


@dataclass(frozen=True, slots=True)
class Score:
    """Counts of a room."""

    name: str
    total: int
    tried: int
    killed: Mapping[str, int]
    others: Mapping[str, int]

    @property
    def counted(self) -> int:
        """Mutants that some check should kill."""
        return self.tried - self.others[EQUIVALENT] - self.others[PROSE] - self.others[MEANINGLESS]

    @property
    def share(self) -> float:
        """Per cent of those that were killed, at the time limit included."""
        return self._percent(sum(self.killed.values()) + self.others[TIMEOUT])

    @property
    def first(self) -> float | None:
        """Per cent killed by what is no test; None where a room has tests only."""
        return self._percent(sum(self.killed[stage] for stage in FIRST)) if any(map(self.killed.get, FIRST)) else None

    def _percent(self, count: int) -> float:
        return 100 * count / self.counted if self.counted else 100.0


def score(record: Record) -> Score:
    """Count the fates of a room."""
    fates = [trial.fate for trial in record.trials.values()]
    killed = Counter(fate.stage for fate in fates if fate.kind == KILLED)
    others = Counter(fate.kind for fate in fates if fate.kind != KILLED)
    return Score(record.room, record.total, len(fates), killed, others)


HEAD = (
    "room", "mutants", "tried", "proof", "validation", "execution", "tests", "kernels", "crash", "time limit",
    "equivalent", "prose", "no meaning", "survive", "no test", "killed",
)  # fmt: skip


def rows(scores: Iterable[Score]) -> list[tuple[str, ...]]:
    """The table, a row for each room."""
    return [
        (
            s.name,
            *(str(n) for n in (s.total, s.tried, *(s.killed[stage] for stage in STAGES))),
            *(str(s.others[kind]) for kind in (TIMEOUT, EQUIVALENT, PROSE, MEANINGLESS, SURVIVED)),
            "–" if s.first is None else f"{s.first:.1f} %",
            f"{s.share:.1f} %",
        )
        for s in scores
    ]


def plain(table: Sequence[Sequence[str]]) -> str:
    """The table in columns."""
    widths = [max(map(len, column)) for column in zip(HEAD, *table)]
    return "\n".join("  ".join(cell.rjust(w) for cell, w in zip(row, widths)).rstrip() for row in (HEAD, *table))


PAGE = """# Assurance

Written by `make mutants`: change that, not this page.

How many wrong programs, proofs, maps, printers, templates and statements the checks would notice. A mutant is one
small change. Of each room a sample is drawn among all that the listed operators make; each mutant is tried in a process
of its own on a copy of the tree. Rooms may be measured one by one, each at the state that its section names.

{table}

- **proof**, **validation**, **execution**: killed by what is no test, that is by proofs of the charts with names; by
  emission with validation (n = {orders} and {kinds} for NumPy,
  n = {others} for the other targets; for maps NumPy alone, n = {some}, all families and
  {further}; where a change is in what makes texts, not where the emitted code is the same as without it); by
  executing the statement, or all of them, of which docs/errata.md must say the same. **no test** is
  their share; of maps tests run before emission, which takes longer.
- **tests**: killed by tests of that room only, but for those listed as left out. Of emission {few} cases of
  each test are run. Tests of {long} to {most} s of processor time are asked of what survives all else, and files of
  tests that have changed since of what survived before. **kernels**: killed by {few} cases of each test of
  tests/generated, run on the NumPy kernels that the mutant emits. **crash**: the process died.
- **time limit**: stopped after twice the processor time of the checks that reach the change, and 20 s; counted as
  killed. What is no test fails besides if it takes {slower} s longer than it did.
- **equivalent**: shown to be so by the run. Programs: of the same value at random points of a prime field, functions
  uninterpreted, whichever way comparisons go. Emission: the changed lines make texts and nothing else, and every text
  that is validated is the same. Proof: the changed lines make controls (theorems with one thing wrong) and nothing
  else, and as many of the same theorems fail. Statements: decided exactly to say the same. Python that compiles to the
  same code is not drawn.
- **prose**: what is emitted differs in comments, docstrings, layout and names of variables only; `make check`
  notices.
- **no meaning**: statements that combine what has no such operation.
- **killed** is the share among all but equivalent, prose and meaningless ones.

{rooms}
"""


def page(records: Sequence[Record], known: Mapping[str, Room] = ROOMS) -> str:
    """The page of figures."""
    table = rows(map(score, records))
    lines = ["| " + " | ".join(cells) + " |" for cells in (HEAD, ("---",) * len(HEAD), *table)]
    orders = {"orders": road.ORDERS, "others": road.FEW, "some": road.GEOMETRY}
    listed = {name: ", ".join(map(str, sorted(values))) for name, values in orders.items()}
    listed["kinds"] = ", ".join(road.kinds())
    listed["further"] = ", ".join(f"φ = {phi}" for phi in road.FURTHER.values())
    rooms = "\n\n".join(_section(record, known[record.room].what) for record in records)
    measured = {record.room for record in records}
    if missing := [name for name in known if name not in measured]:
        rooms += f"\n\nNever measured: {', '.join(missing)}."
    seconds = {"slower": round(SLOWER), "long": round(LONG), "most": round(TOO_LONG)}
    return PAGE.format(few=FEW, table="\n".join(lines), rooms=rooms, **seconds, **listed)


def _section(record: Record, what: str) -> str:
    found = record.survivors
    lines = [f"## {record.room}", "", f"{what[0].upper()}{what[1:]}. Seed {record.seed}, state `{record.state}`.", ""]
    if missing := [f"- {name} ({why})" for why, names in record.left_out.items() for name in names]:
        lines += ["Left out:", "", *missing, ""]
    lines += _operators(record)
    if not found:
        return "\n".join([*lines, "No survivor."])
    lines += [f"{len(found)} survive:", "", "| where | operator | change |", "| --- | --- | --- |"]
    return "\n".join(lines + [f"| {m.where} | {m.operator} | {_code(m.change)} |" for m in found])


def _operators(record: Record) -> list[str]:
    """Killed of tried, by operator."""
    tried = Counter(trial.operator for trial in record.trials.values())
    alive = Counter(trial.operator for trial in record.survivors)
    parts = ", ".join(f"{name} {count - alive[name]}/{count}" for name, count in sorted(tried.items()))
    return [f"Operators, noticed of tried: {parts}.", ""]


def _code(text: str) -> str:
    """Code in a cell of a table."""
    shown = text.replace("|", "\\|")
    return f"`` {shown} ``" if "`" in shown else f"`{shown}`"
