"""Places in which a kernel function lacks its part: ``python -m tests.support.names``, before any work is done."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path

from derive.codegen.rows import BY_TEXT, RULE, Table, inside
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.codegen.targets.array_api import rules_in
from derive.codegen.targets.c import GEOMETRY
from derive.codegen.targets.python import CLASSES, INTERFACE
from derive.codegen.validation.calls import Kind, kind_of
from derive.codegen.validation.expected_values import ALGEBRAIC
from derive.codegen.validation.inverse_maps import MAPS
from derive.output import generated
from derive.pages.explain import COVERAGE
from tests.support.oracle import Oracle

ROOT = Path(__file__).parents[2]
RULES = "templates/array-api/runtime/_rules.py"


@cache
def text_of(target: str, name: str) -> str:
    """Return a file that all packages of a target share."""
    return generated(f"{target}/{name}", "", **TARGETS[target].shared()[name]())


def documented(table: Table) -> Iterator[str]:
    """Yield the methods of a table's interface whose docstrings have an example."""
    for node in ast.walk(ast.parse(text_of("numpy", inside(table, INTERFACE)))):
        if isinstance(node, ast.ClassDef) and node.name == CLASSES[table]:
            methods = (method for method in node.body if isinstance(method, ast.FunctionDef))
            yield from (method.name for method in methods if ">>> " in (ast.get_docstring(method) or ""))


def in_c(table: Table) -> Iterable[str]:
    return re.findall(r"DUALCAY_NAME\((\w+)\)\(", text_of("c", inside(table, GEOMETRY)))


def ruled(table: Table) -> Iterator[str]:
    rules = rules_in((ROOT / RULES).read_text(encoding="utf-8"))
    return (name for name, row in table.public.items() if row.derivatives != RULE or name in rules)


def listed() -> Iterable[str]:
    return re.findall(r"^   (\w+)$", (ROOT / "docs/reference/functions.md").read_text(encoding="utf-8"), re.MULTILINE)


PLACES: Mapping[str, Callable[[], Iterable[str]]] = {
    "derive/codegen/validation/expected_values.py or inverse_maps.py: its expected value": lambda: {*ALGEBRAIC, *MAPS},
    "derive/codegen/validation/calls.py: a Kind, the names of its arguments": lambda: (
        name for name, row in POSES.public.items() if name in ALGEBRAIC or kind_of(row) in set(Kind)
    ),
    "derive/codegen/signatures.py: a decision on derivatives, RULE or BY_TEXT with a reason": lambda: (
        name for name, row in POSES.public.items() if row.shares or row.derivatives.startswith((RULE, BY_TEXT))
    ),
    f"{RULES}: the rule that its row promises": lambda: ruled(POSES),
    "templates/python/interface: a method with an example": lambda: documented(POSES),
    "templates/c/public.h.j2: its comment": lambda: in_c(POSES),
    "derive/pages/explain.py: the theorems on which it rests": lambda: COVERAGE,
    "tests/support/oracle.py or oracle_maps.py: its value by independent code": lambda: dir(Oracle),
    "docs/reference/functions.md: a line": listed,
}
"""Places with a part of every function of poses, each with the names that it has."""

PLACES_OF_ROTATIONS: Mapping[str, Callable[[], Iterable[str]]] = {
    "templates/python/interface, for rotations: a method with an example": lambda: documented(ROTATIONS),
    "templates/c/public.h.j2, for rotations: its comment": lambda: in_c(ROTATIONS),
}


def lacking() -> list[str]:
    """Return the places that lack functions, each with their names."""
    found = []
    for table, places in ((POSES, PLACES), (ROTATIONS, PLACES_OF_ROTATIONS)):
        for place, names in places.items():
            if missing := sorted(table.public.keys() - set(names())):
                found.append(f"{place}: {', '.join(missing)}")
    return found


if __name__ == "__main__":
    found = lacking()
    print("\n".join(found) or "nothing is missing")
    sys.exit(bool(found))
