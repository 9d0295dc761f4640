"""Arrays of any library: plain Python on arrays of components, with nothing written in place."""

from __future__ import annotations

import ast
import importlib
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from importlib.util import find_spec
from typing import TYPE_CHECKING

from ..lowering.retraction import EXPONENTIAL
from ..lowering.scalar_programs import SCALARS, SQUARES
from ..lowering.slopes import slopes
from ..package import Data, Facts
from ..rows import RULE, Table
from ..signatures import lower_chart
from .python import PythonTarget, printed_scalars

if TYPE_CHECKING:
    from ..validation.replay import Library

STRICT = "array_api_strict"
STORED = {"exponential_scalars": "stored", "followed": "stored", "displacement": "stored", "vector_of": "taken"}
"""Geometry programs with results, or arguments, that many steps read, as they do results of scalar programs."""

NOTHING = re.compile(r"(?<![-+*/] )\b(\w+) - \1(?= \+|\)|$)", re.MULTILINE)
"""Value minus itself: 0, or NaN unless it is finite."""

SCALE = re.compile(r"^    (total|extent) = (m\.abs.*)$", re.MULTILINE)
"""Sum of sizes by which a vector is divided before it is squared; results do not depend on it."""

VALUE = re.compile(r"^    (\w+) = (\(\n(?:        .*\n)+    \)|(?!m\.where).*[*/].*)$", re.MULTILINE)
"""Statement that multiplies or divides."""

READERS = 3
"""Number of steps that read a value, from which it is stored; an expression of several lines always is."""


def slopes_of_steps() -> Data:
    """Return the exponential's scalars and the names of slopes, for the rules of differentiation."""
    scalars = lower_chart(EXPONENTIAL).scalars
    steps = printed_scalars(EXPONENTIAL, {name: scalars[name] for name, row in SCALARS.items() if row.of_steps})
    return {**marked(steps, once), **rules_of_slopes()}


class ArrayApi(PythonTarget):
    """Target that imports no array library and accepts the arrays of any."""

    name = "array-api"
    options = "axis: Axis = -1"
    files = (*PythonTarget.files, "_jax.py", "_libraries.py", "_rules.py", "_torch.py")

    def shared(self) -> dict[str, Callable[[], Data]]:
        return super().shared() | {"_slopes.py": slopes_of_steps}

    def require_complete(self, texts: Mapping[str, str]) -> None:
        """Require, beside the functions of the table, a rule for each kernel that is said to have one, and no other."""
        super().require_complete(texts)
        for table in self.tables:
            said = {name for name, row in table.kernels.items() if row.derivatives == RULE}
            if wrong := sorted(said ^ rules_in(texts["_rules.py"])):
                raise ValueError(f"_rules.py: its rules and the decisions of the table differ for {', '.join(wrong)}")

    def programs(self, facts: Facts) -> Data:
        return marked(super().programs(facts), once)

    def geometry(self, table: Table) -> Data:
        found = super().geometry(table)
        return {**found, **marked({"programs": found["programs"]}, held), "stored": STORED}

    def libraries(self) -> Sequence[Library]:
        """Return NumPy, and the strict reference of the standard if installed."""
        from ..validation.replay import Library

        names = ("numpy", *([STRICT] if find_spec(STRICT) else []))
        return [Library(name, importlib.import_module(name).asarray, silent=False) for name in names]


def rules_in(text: str) -> set[str]:
    """Return the kernels in the tables of rules, RULES and JACOBIANS, of a text."""
    found = [node for node in ast.parse(text).body if isinstance(node, ast.AnnAssign)]
    tables = (node.value for node in found if ast.unparse(node.target) in ("RULES", "JACOBIANS"))
    return {ast.literal_eval(key) for table in tables if isinstance(table, ast.Dict) for key in table.keys if key}


def held(forms: str) -> str:
    """Return the text of a program with zeros of the form ``a - a`` and scales as constants.

    Their derivatives would cancel, at the cost of digits; that by a scale has its square, which may underflow.
    """
    return SCALE.sub(r"    \1 = m.held(\2)", NOTHING.sub(r"m.held(\1 - \1)", forms))


def once(forms: str) -> str:
    """Return the text of a scalar program with marks at values that compilers should store."""

    def marked(found: re.Match[str]) -> str:
        name, value = found.groups()
        long = "\n" in value
        many = long or len(re.findall(rf"\b{name}\b", forms)) > READERS
        return f"    {name} = m.once{value if long else f'({value})'}" if many else found.group()

    return VALUE.sub(marked, held(forms))


def marked(printed: Data, mark: Callable[[str], str]) -> Data:
    return {
        name: [replace(program, forms=mark(program.forms)) for program in programs]
        for name, programs in printed.items()
    }


def rules_of_slopes() -> Data:
    """Return the names of results whose slopes other programs return, and the programs of three squares."""
    towers = {name: row.slopes for name, row in SCALARS.items() if row.slopes}
    results = {name: SCALARS[name].results for name in (*towers, "tangent_dot_scalars")}
    squares = tuple(name for name in towers if SCALARS[name].arguments == SQUARES)
    return {"results": results, "towers": towers, "squares": squares, "slopes": slopes()}
