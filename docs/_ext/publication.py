"""Version, source and citation of the site: the footer, the edit button, links from the reference to the code."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

import yaml
from docutils import nodes

from derive.output.files import put

ROOT = Path(__file__).parents[2]
INTERFACES = {"dualcay.cayley2": "dualcay._interface", "dualcay.rotation.cayley2": "dualcay.rotation._interface"}
"""Module whose methods are the functions of a kernel module, by the kernel module that the reference shows."""
MOVED = {
    "conditioning": "explanation/conditioning.html",
    "explanation/no_series": "explanation/conditioning.html#why-are-small-angles-no-special-case",
    "howto/verify_equation": "howto/check_formula.html#an-equation-of-the-two-papers",
    "parameterizations": "howto/choose_chart.html#all-charts-in-figures",
}
"""Places to which pages have moved."""
FEW_HEADINGS = 2
"""Largest number of headings below the title for which a page has no list of its headings."""


def repository() -> str:
    """Return the address of the repository from ``[project.urls]`` of pyproject.toml, empty while there is none."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    return str(project.get("urls", {}).get("Repository", "")).rstrip("/")


def theme_options(address: str) -> dict[str, Any]:
    """Return the options of the theme that lead to a repository: none without an address."""
    if not address:
        return {}
    return {
        "icon_links": [{"name": "Repository", "url": address, "icon": "fa-solid fa-code-branch"}],
        "use_edit_page_button": True,
    }


def html_context(address: str) -> dict[str, Any]:
    """Return what the edit button of the theme needs."""
    return {"edit_page_url_template": f"{address}/edit/main/docs/{{{{ file_name }}}}"} if address else {}


def bibtex(citation: str, address: str) -> str:
    """Return the entry of the software in a file CITATION.cff as BibTeX.

    Examples
    --------
    >>> print(bibtex("title: t\\nversion: 1.0\\nlicense: MIT\\nauthors: [{name: We}]", ""))
    @software{dualcay,
      author  = {{We}},
      title   = {t},
      version = {1.0},
      license = {MIT}
    }
    """
    entry = yaml.safe_load(citation)
    authors = (a["name"] if "name" in a else f"{a['family-names']}, {a['given-names']}" for a in entry["authors"])
    fields = {
        "author": " and ".join(f"{{{author}}}" for author in authors),
        "title": entry["title"],
        "version": entry["version"],
        "year": str(entry.get("date-released", ""))[:4],
        "license": entry["license"],
        "url": address,
    }
    found = [f"  {name:<7} = {{{value}}}" for name, value in fields.items() if value]
    return ",\n".join(["@software{dualcay", *found]) + "\n}"


def write(app: Any) -> None:
    """Write the entry that the page on citing includes."""
    folder = Path(app.srcdir) / "reference" / "generated"
    text = bibtex((ROOT / "CITATION.cff").read_text(encoding="utf-8"), repository())
    put(folder / "citation.bib", f"{text}\n")


def redirect(app: Any, error: Exception | None) -> None:
    """Write a page in the place of each one that has moved, which leads on."""
    for old, new in MOVED.items() if error is None else ():
        up = "../" * old.count("/")
        put(Path(app.outdir, f"{old}.html"), f'<!doctype html><meta http-equiv="refresh" content="0; url={up}{new}">\n')


def page_context(app: Any, name: str, template: str, context: dict[str, Any], doctree: Any) -> None:
    """Leave out the edit button of pages that a command writes, and the list of headings where there are few."""
    if name.startswith(("reference/generated/", "examples/", "_modules/")):
        context["page_source_suffix"] = ""
    headings = list(doctree.findall(nodes.section))[1:] if doctree else []
    if len(headings) <= FEW_HEADINGS:
        context["theme_secondary_sidebar_items"] = []


def without_code(app: Any, doctree: Any) -> None:
    """Take the module from objects that have no place of their own: code would lead back to that place."""
    for signature in doctree.findall(nodes.Element):
        if signature.tagname == "desc_signature" and not signature["ids"]:
            signature["module"] = None


def home(app: Any, module: str, name: str) -> str | None:
    """Return a kernel module as the module that shows the code of its functions."""
    return module if module in INTERFACES else None


def source(app: Any, module: str) -> tuple[str, dict[str, Any]] | None:
    """Return the code of a kernel module's interface, and the lines of its methods."""
    if module not in INTERFACES:
        return None
    from sphinx.pycode import ModuleAnalyzer  # tests of this module do without Sphinx

    analyzer = ModuleAnalyzer.for_module(INTERFACES[module])
    analyzer.find_tags()
    return analyzer.code, {re.sub(r"^\w+\.", "", name): lines for name, lines in analyzer.tags.items()}


def setup(app: Any) -> dict[str, bool]:
    """Connect the parts to Sphinx; the theme reads the context of a page later."""
    app.connect("builder-inited", write, priority=400)
    app.connect("build-finished", redirect)
    app.connect("html-page-context", page_context, priority=400)
    app.connect("doctree-read", without_code, priority=400)  # before viewcode
    app.connect("viewcode-follow-imported", home)
    app.connect("viewcode-find-source", source)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
