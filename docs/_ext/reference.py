"""Parts of the reference that come from the code: facts about charts, options of the command, functions in C."""

from __future__ import annotations

import inspect
import math
import re
import textwrap
from pathlib import Path
from typing import Any

import click
from docutils import nodes

import dualcay
from derive.claims.language.letters import LETTERS
from derive.claims.language.operations import OPERATIONS
from derive.cli.commands import cli
from derive.codegen.catalogue import committed
from derive.codegen.signatures import POSES, lower_chart
from derive.codegen.targets.c import levels, shared_geometry
from derive.output import pages
from derive.output.files import put
from dualcay import cayley2
from dualcay.rotation import cayley2 as rotation

from . import chart_examples, function_pages, reference_figures

GENERATED = "reference/generated"
CODE = 98
"""Characters in a line of code at a width of 1280 px."""
HOMES = (dualcay, cayley2, rotation)
"""Modules in which the docstrings' bare names are looked up, after the module of the docstring."""


def functions(module: Any) -> list[str]:
    """Return the functions of a kernel module that every chart has."""
    return [name for name in dir(type(module.KERNELS)) if not name.startswith("_")]


def charts() -> list[str]:
    """Return the names of the committed kernel modules."""
    return [name for name in dir(dualcay) if hasattr(getattr(dualcay, name), "KERNELS")]


def angle(radians: float) -> str:
    """Return an angle as a multiple of π where it is one, else in radians.

    Examples
    --------
    >>> angle(6.283185307179586), angle(4.5)
    ('2π', '4.5 rad')
    """
    turns = radians / math.pi
    return f"{'' if round(turns) == 1 else round(turns)}π" if abs(turns - round(turns)) < 1e-9 else f"{radians:.6g} rad"


def facts(name: str) -> dict[str, str]:
    """Return properties of a chart, read and computed from its module."""
    module = getattr(dualcay, name)
    header, *lines = Path(inspect.getfile(module)).read_text(encoding="utf-8").splitlines()
    polynomials = [f"``{line.removeprefix('#   ')}``" for line in lines if re.match("#   [pq] = ", line)]
    half_turn = abs(module.from_exponential([math.pi, 0, 0, 0, 0, 0])[0])
    further = sorted(set(module.__all__) - set(functions(module)))
    aliases = [f"``{alias}`` of ``{getattr(module, alias).__name__}``" for alias in further]
    return {
        "Scalars": ", ".join(polynomials) or "defined in the :ref:`conventions <conventions>`",
        "Vectors of a pose": str(module.KERNELS._chart.branches or "one for every integer k"),
        "Singular angles": ", ".join(map(angle, module.singular_angles())) or "none",
        "Size of v at half a turn": f"{half_turn:.4g}" if half_turn < 1e9 else "infinite",
        "Further names": ", ".join(aliases) or "none",
        "Written by": f"``{header.removeprefix('# ').replace('python -m derive', 'dualcay')}``",
    }


def escaped(text: str) -> str:
    """Return plain text as Markdown."""
    return re.sub(r"([*|\\])", r"\\\1", text)


def command_page() -> str:
    """Return the options of every command, in Markdown."""
    parts = []
    for name, command in cli.commands.items():
        parts.append(f"## dualcay {name}\n\n{command.help}\n\n```{{program}} dualcay {name}\n```\n")
        for option in command.params:
            if not (record := option.get_help_record(click.Context(command))):  # of an argument
                continue
            flags, text = record
            parts.append(f":::{{option}} {flags}\n{escaped(text)}\n:::\n")
    return "\n".join(parts)


def kinds_page() -> str:
    """Return the table of the kinds of letters in claims, in Markdown."""
    rows = [f"| `{kind}` | {words} |" for kind, (_, _, words) in LETTERS.items()]
    return "\n".join(["| kind | value |", "|---|---|", *rows, ""])


def operations_page() -> str:
    """Return the table of the operations in claims, in Markdown."""
    rows = [f"| `{r.example}` | {', '.join(r.takes)}{' …' * r.many} | {escaped(r.says)} |" for r in OPERATIONS.values()]
    return "\n".join(["| example | takes | value |", "|---|---|---|", *rows, ""])


def c_header() -> str:
    """Return the header of the functions in C for poses."""
    return pages.render("c/geometry.h.j2", header="", **shared_geometry(POSES))


def c_functions(header: str) -> list[tuple[str, list[tuple[str, str, str]]]]:
    """Return the sections of a header, with name, parameters and comment of each function."""
    _, *parts = re.split(r"^// --- (.+?) -+$", header, flags=re.MULTILINE)
    pattern = re.compile(r"((?:^// .*\n)+)DUALCAY_FUNCTION void DUALCAY_NAME\((\w+)\)\((.*)\)$", re.MULTILINE)
    found = [
        (title, [(name, parameters, comment.replace("// ", "")) for comment, name, parameters in pattern.findall(text)])
        for title, text in zip(parts[::2], parts[1::2])
    ]
    return [(title, functions) for title, functions in found if functions]


def c_page() -> str:
    """Return the arrays and the functions of the C headers for poses, in Markdown."""
    header = c_header()
    (arrays,) = re.findall(r"then the dual part:\n//\n((?://   .+\n)+)", header)
    lines = arrays.replace("//   ", "").splitlines()
    parts = ["```text", *(textwrap.fill(line, CODE, subsequent_indent=" " * 22) for line in lines), "```\n"]
    for title, found in c_functions(header):
        parts.append(f"## {title[0].upper()}{title[1:]}\n")
        for name, parameters, comment in found:
            parts.append(f"```{{c:function}} void dualcay_cayley2_{name}({parameters})\n\n{escaped(comment)}```\n")
    return "\n".join(parts)


def c_left_out_page() -> str:
    """Return the functions of poses that the C headers of each committed chart lack without math.h, in Markdown."""
    charts: dict[str, list[str]] = {}
    for chart in committed():
        needed = levels(lower_chart(chart, POSES))
        sides: tuple[list[str], list[str]] = ([], [])
        for name, row in {**POSES.public, **POSES.composed}.items():
            sides[needed[row.kernel] > 1].append(f"`{name}`")
        kept, lost = map(", ".join, sides)
        charts.setdefault(f"all but {kept}" if len(kept) < len(lost) else lost, []).append(f"`{chart.name}`")
    rows = (f"| {', '.join(names)} | {lost} |" for lost, names in charts.items())
    return "\n".join(["| charts | functions |", "|---|---|", *rows, ""])


def write(app: Any) -> None:
    """Write the included texts and the figures into the folder of generated pages."""
    folder = Path(app.srcdir) / GENERATED
    pages = (command_page, c_page, c_left_out_page, kinds_page, operations_page)
    for name, text in ((f"{page.__name__.removesuffix('_page')}.inc", page()) for page in pages):
        put(folder / name, text)
    reference_figures.draw(folder)


def resolve(app: Any, env: Any, node: Any, content: Any) -> nodes.Node | None:
    """Resolve a bare name in a docstring: a function of the package or of charts, or the interface of charts."""
    builder, source, target = app.builder, node["refdoc"], node.get("reftarget", "")
    if target in ("PoseKernels", "RotationKernels"):
        uri = builder.get_relative_uri(source, "reference/functions")
        return nodes.reference("", "", content, refuri=f"{uri}#conventions", internal=True)
    for home in HOMES:
        full = f"{home.__name__}.{target}"
        if node.get("refdomain") == "py" and full in env.domains["py"].objects:
            return env.domains["py"].resolve_xref(env, source, builder, "obj", full, node, content)
    return None


def context() -> dict[str, Any]:
    """Return what the templates of generated pages need."""
    return {
        "facts": {f"dualcay.{name}": facts(name) for name in charts()},
        "rotations": functions(rotation),
        "figures": {name: draw.__name__ for name, draw in reference_figures.FIGURES.items()},
        "formulas": function_pages.formulas(),
        "related": {name: function_pages.related(name) for name in functions(cayley2)},
        "words": function_pages.words(),
        "targets": {name: function_pages.targets(name) for name in functions(cayley2)},
        "examples": {name: chart_examples.script(name, charts()) for name in functions(cayley2)},
        "captions": {name: inspect.getdoc(draw) for name, draw in reference_figures.FIGURES.items()},
    }


def setup(app: Any) -> dict[str, bool]:
    """Connect the parts of the reference to Sphinx."""
    app.config.autosummary_context = context()
    app.connect("builder-inited", write, priority=400)  # before autosummary looks for pages
    app.connect("missing-reference", resolve)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
