"""Render templates, which contain only layout, and write pages with their facts as JSON beside them.

Each template receives exactly the names it uses. A file without holes stands in the folder ``runtime`` of its target
and is copied, so that linters and editors see it where it is written.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import files

if TYPE_CHECKING:
    import jinja2


def folder() -> Path:
    """Return the folder of templates: inside the installed package, or beside it in a checkout."""
    packaged = Path(__file__).parent.parent / "_templates"
    return packaged if packaged.is_dir() else packaged.parent.parent / "templates"


@cache
def environment() -> jinja2.Environment:
    import jinja2  # a claim is decided without

    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(folder(), encoding="utf-8"),
        undefined=jinja2.StrictUndefined,
        autoescape=jinja2.select_autoescape(("html.j2",), default=False),
        keep_trailing_newline=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )


def source(name: str) -> str:
    """Return the path below ``templates/`` of a generated file: its template, or a file in ``runtime`` to be copied."""
    target, _, file = name.partition("/")
    copied = f"{target}/runtime/{file}"
    return copied if (folder() / copied).is_file() else f"{name}.j2"


def generated(name: str, header: str, /, **data: Any) -> str:
    """Return the text of a generated file: its template rendered, or the file itself beneath the header."""
    path = source(name)
    if path.endswith(".j2"):
        return render(path, header=header, **data)
    if data:
        raise TypeError(f"templates/{path} has no holes, got data for {', '.join(sorted(data))}")
    return f"{header}\n{(folder() / path).read_text(encoding='utf-8')}"


def render(name: str, /, **data: Any) -> str:
    """Render a template, e.g. ``numpy/chart.py.j2``.

    The data must be exactly the names used by the template and its included templates.
    """
    asked = holes(name)
    if asked != data.keys():
        missing, unused = (", ".join(sorted(names)) or "none" for names in (asked - data.keys(), data.keys() - asked))
        raise TypeError(f"templates/{name}: holes left open: {missing}; data without a hole: {unused}")
    return environment().get_template(name).render(data)


@cache
def holes(name: str) -> frozenset[str]:
    """Return the names that a template and its referenced templates use, without macros that the template defines."""
    from jinja2 import meta, nodes

    tree = environment().parse((folder() / name).read_text(encoding="utf-8"), name)
    names = set(meta.find_undeclared_variables(tree))
    defined = {node.name for node in tree.body if isinstance(node, nodes.Macro)}
    for reference in meta.find_referenced_templates(tree):
        if reference is None:
            raise TypeError(f"templates/{name} refers to a template by a computed name")
        names |= holes(reference) - defined
    return frozenset(names)


def json_rows(**facts: Any) -> str:
    """Return facts as JSON, those of a list on a line each, so that differences of two versions are short.

    Examples
    --------
    >>> print(json_rows(schema=1, sides=[{"left": "α"}, {"left": "β"}]), end="")
    {"schema": 1,
    "sides": [
    {"left": "α"},
    {"left": "β"}
    ]}
    """
    texts = (
        "[\n" + ",\n".join(json.dumps(row, ensure_ascii=False) for row in value) + "\n]"
        if isinstance(value, list) else json.dumps(value, ensure_ascii=False) for value in facts.values()
    )  # fmt: skip
    return "{" + ",\n".join(f'"{name}": {text}' for name, text in zip(facts, texts, strict=True)) + "}\n"


def beside(output: Path, page: str, facts: str) -> dict[str, str]:
    return {output.name: page, output.with_suffix(".json").name: facts}


def stale(output: Path, texts: Mapping[str, str]) -> list[files.Difference]:
    """Return the differences of a page and what stands beside it; other files of the folder do not count."""
    known = {output.parent / name for name in texts}
    return [found for found in files.compare(output.parent, texts) if found.path in known]


def writable(output: Path | None) -> bool:
    """Tell whether a page and its facts can be written, if a page is named; say on stderr why not."""
    try:
        if output is not None:
            files.refuse(output.parent, beside(output, "", ""), force=True)
    except files.RefusedError as error:
        print(f"error: {error}", file=sys.stderr)
        return False
    return True


def deliver(output: Path, texts: Mapping[str, str], check: bool, module: str) -> int:
    """Write a page and its facts, or compare them; the exit code is 1 if a file is stale."""
    if not check:
        files.write(output.parent, texts, force=True)
        return 0
    found = stale(output, texts)
    for difference in found:
        print(f"{difference.path} is stale; accept with:  python -m {module} -o {output}", file=sys.stderr)
    return 1 if found else 0
