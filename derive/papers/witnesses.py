"""A second witness for each entry: its value at one seeded point, 30 digits, kept beside the package of its paper.

``python -m derive.papers.witnesses`` writes the files again.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from importlib import resources
from pathlib import Path
from typing import Any

import mpmath

from . import PAPERS, Paper
from .counterexample import is_value, shown, sides
from .decide import ORDERS, decide
from .equation import Equation
from .explore import points
from .language.evaluation import Env
from .language.terms import Term
from .mutation import true_statements
from .numbers.fields import DIGITS

FILE = "witnesses.json"


def witness(paper: Paper, entry: Equation, orders: Sequence[int] = ORDERS) -> dict[str, Any]:
    """The first seeded point of an entry: the letters that vary, and what its true form comes to there.

    Returns
    -------
    dict
        ``point``, its name; ``letters``, the parts of each letter; ``values``, the parts of each side that is a number,
        vector, tensor or quaternion, equal sides once; a claim without such sides has its truth in ``values``.
    """
    statement = true_statements(decide(paper.slug, entry, paper.lost, orders, count=False))[0]
    with mpmath.workdps(DIGITS):
        label, env = next(_inside(entry, statement, orders))
        free = {letter.name: env.value(letter) for letter in entry.free(statement)}
        given = {name: shown(value) for name, value in free.items() if is_value(value)}
        seen = [shown(value) for value in sides(env, statement) if is_value(value)]
        different = [side for i, side in enumerate(seen) if side not in seen[:i]]
        return {"point": label, "letters": given, "values": different or [[str(bool(env.value(statement))).lower()]]}


def witnesses(paper: Paper) -> dict[str, dict[str, Any]]:
    """The witnesses of all entries by number."""
    return {entry.number: witness(paper, entry) for entry in paper.entries()}


def committed(paper: Paper) -> dict[str, dict[str, Any]]:
    """The witnesses that are kept."""
    kept: dict[str, dict[str, Any]] = json.loads(resources.files(paper.package).joinpath(FILE).read_text("utf-8"))
    return kept


def _inside(entry: Equation, statement: Term, orders: Sequence[int]) -> Iterator[tuple[str, Env]]:
    """The seeded points of the claimed domain at which the condition holds."""
    for point in points(entry, statement, orders):
        domain = [part for part in (entry.claimed, entry.condition) if part is not None]
        if all(_holds(lambda part=part, env=point.env: env.value(part)) for part in domain):  # type: ignore[misc]
            yield point.label, point.env


def _holds(value: Callable[[], Any]) -> bool:
    try:
        return bool(value())
    except ArithmeticError:
        return False


def main() -> None:
    """Write the files."""
    for paper in PAPERS:
        path = Path(str(resources.files(paper.package).joinpath(FILE)))
        lines = (f"{json.dumps(number)}: {json.dumps(w, ensure_ascii=False)}" for number, w in witnesses(paper).items())
        path.write_text("{\n" + ",\n".join(lines) + "\n}\n", "utf-8")


if __name__ == "__main__":
    main()
