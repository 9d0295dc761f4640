"""Pages of functions: lists with what each takes and gives, formulas of theorems, targets that have a function."""

from __future__ import annotations

import inspect
import re
from itertools import chain
from pathlib import Path
from typing import Any

from docutils import nodes

import dualcay.dask
from derive.codegen.signatures import POSES
from derive.codegen.targets import TARGETS
from derive.codegen.targets.python import PythonTarget
from derive.pages import sheet
from derive.pages.explain import COVERAGE
from derive.proof import theorems
from derive.proof.identity import Proof
from dualcay import cayley2
from dualcay.rotation import cayley2 as rotation

GLOSSARY = Path(__file__).parents[1] / "glossary.md"
LISTS = "reference/functions"
"""Page with the lists of the functions of a chart."""
BODY = "body_"
SHAPE = re.compile(r"^(?:(.+) : )?array, shape \((?:\.\.\.(?:, )?)?(.*?),?\)")
RELATED, NEAR = 5, 0.15
"""Most functions under "See also", and the nearness that each must exceed."""
ARRAYS = {
    name: tuple({each.name.rstrip("12") for each in arrays} for arrays in (row.arguments, row.results))
    for name, row in POSES.public.items()
}
"""Names of the arrays that a function takes and gives."""
WITH = ("Rate", "Jacobian", "Transition", "Twist")
MOTION = tuple(heading for heading in sheet.MOTION_OF_ORDER if heading.startswith(WITH))
"""Parts of the formula sheet with the formulas of functions whose docstrings have none."""


def section(text: str, heading: str) -> list[str]:
    """Return the lines of a section of a docstring that name its arrays."""
    lines = text.partition(f"{heading}\n{'-' * len(heading)}\n")[2].partition("\n\n")[0].splitlines()
    return [line for line in lines if not line.startswith(" ")]


def arrays(lines: list[str]) -> str:
    """Return names and shapes of arrays.

    Examples
    --------
    >>> arrays(["v2, v1 : array, shape (..., 6)", "t : array, shape (...)", "check : bool or float"])
    'v2, v1 (6), t'
    """
    found = (SHAPE.match(line) for line in lines)
    return ", ".join(f"{m[1] or ''} {f'({m[2]})' if m[2] else ''}".strip() for m in found if m)


def takes_and_gives(name: str) -> tuple[str, str]:
    """Return the arrays that a function takes and gives, without leading axes."""
    home = cayley2 if hasattr(cayley2, name) else rotation
    text = inspect.getdoc(getattr(home, name)) or ""
    gives = section(text, "Returns")
    return arrays(section(text, "Parameters")), arrays(gives) or ", ".join(gives)


def targets(name: str) -> list[str]:
    """Return the targets that have a function, and Dask where `dualcay.dask` runs it."""
    found = []
    for target in TARGETS.values():
        if isinstance(target, PythonTarget):
            has = name in (*POSES.public, *target.plain)
        else:
            has = name in {**POSES.public, **({} if target.name == "native" else POSES.composed)}
        found += [target.name] * has
    return [*found, *["Dask"] * (name in dualcay.dask.SIGNATURES["PoseKernels"])]


def related(name: str) -> list[str]:
    """Return the functions nearest to one: its twin of the other frame, its inverse, its derivatives, common theorems.

    Examples
    --------
    >>> related("twist")
    ['body_twist', 'rate', 'twist_dot', 'twist_jacobian', 'tangent']
    """
    stem = name.removeprefix(BODY)

    def nearness(other: str) -> float:
        if name.startswith(BODY) != other.startswith(BODY) and {BODY + stem, name} <= COVERAGE.keys():
            return 8.0 * (other.removeprefix(BODY) == stem)
        root = other.removeprefix(BODY)
        derived = stem.startswith(f"{root}_") or root.startswith(f"{stem}_")
        own, others = ({*COVERAGE[each].theorems} for each in (name, other))
        return 4 * _undoes(name, other) + 2 * derived + len(own & others) / len(own)

    if name not in ARRAYS:
        return []
    found = {other: nearness(other) for other in POSES.public if other != name and other in COVERAGE}
    nearest = sorted(found, key=lambda other: -found[other])[:RELATED]
    return [other for other in nearest if found[other] > NEAR]


def _undoes(one: str, other: str) -> bool:
    """Tell whether each of two functions takes what the other gives."""
    (takes, gives), (other_takes, other_gives) = ARRAYS[one], ARRAYS[other]
    both = gives <= other_takes and other_gives <= takes and gives != other_gives
    return both or f"from_{one}" == other or f"from_{other}" == one


def words() -> dict[str, list[str]]:
    """Return the words of the glossary for which readers search, by the full names that its table gives for them."""
    table = GLOSSARY.read_text(encoding="utf-8").partition("## Words that you may search for")[2].partition("\n## ")[0]
    found: dict[str, list[str]] = {}
    for given, answer in re.findall(r"^\| (.+?) \| (.+) \|$", table, re.M):
        for name in re.findall(r"<(dualcay[\w.]*)>", answer):
            found.setdefault(name, []).extend(given.replace("`", "").split(", "))
    return found


def formulas() -> dict[str, list[str]]:
    """Return definitions and claims of theorems on derivatives as LaTeX, by the functions that rest on them."""
    known: dict[str, Proof] = {proof.name: proof for proof in theorems()}
    wanted = {row[0]: row for row in chain(*(sheet.MOTION_OF_ORDER[heading] for heading in MOTION))}
    return {
        name: [formula for line in lines for formula in line.formulas]
        for name, covered in COVERAGE.items()
        if (lines := [line for t in covered.theorems if t in wanted for line in sheet.lines([wanted[t]], known)])
    }


def cell(*content: nodes.Node) -> nodes.entry:
    """Return a cell of a table."""
    return nodes.entry("", nodes.paragraph("", "", *content))


def reshape(app: Any, doctree: Any) -> None:
    """Leave out "Return the" in lists of functions; on the page of a chart's functions, join twins and add arrays."""
    merged = app.env.current_document.docname == LISTS
    for table in (node for node in doctree.findall(nodes.comment) if node.tagname == "autosummary_table"):
        group = next(table.findall(nodes.tgroup))
        rows: dict[str, nodes.row] = {}
        for row in list(group.findall(nodes.row)):
            name, said = row.children
            first = next(said.findall(nodes.Text), None)
            if first is not None and (kept := re.sub(r"^Return (?:the |an? )?", "", first)) != first:
                first.parent.replace(first, nodes.Text(kept[:1].upper() + kept[1:]))
            if not merged:
                continue
            title = name.astext()
            twin = rows.get(title.removeprefix(BODY))
            if twin is not None and title.startswith(BODY):
                twin[0][0] += [nodes.Text(", "), *name[0].children]
                row.parent.remove(row)
            else:
                rows[title] = row
                row += [cell(nodes.Text(text)) for text in takes_and_gives(title)]
        if merged:
            for _ in range(2):
                group.insert(0, nodes.colspec(colwidth=20))
            group["cols"] = 4
            titles = ("function", "", "takes", "gives")
            head = nodes.thead("", nodes.row("", *(cell(nodes.Text(title)) for title in titles)))
            group.insert(group.index(next(group.findall(nodes.tbody))), head)


def setup(app: Any) -> dict[str, bool]:
    """Connect the lists to Sphinx."""
    app.connect("doctree-read", reshape)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
