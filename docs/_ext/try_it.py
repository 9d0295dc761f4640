"""Page on which a reader tries claims and charts: the toolkit runs in the browser, by Pyodide.

`make docs` downloads Pyodide and python-flint for it. Here they are packed with the toolkit, as files of the site. The
page of a build without them says so.
"""

from __future__ import annotations

import hashlib
import json
import re
import zipfile
from collections.abc import Iterable, Iterator
from importlib import metadata
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from derive.claims.language.letters import CONSTANT, LETTERS

from .answers import ORDER_MAX
from .in_browser import ROOT, claims

ENGINE = ROOT / "build" / "docs" / "assets" / "engine"
WHEEL = "python_flint-*_wasm32.whl"
FILES = (
    "pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "pyodide-lock.json", "python_stdlib.zip", "libraries.zip",
    "toolkit.zip",
)  # fmt: skip
LIBRARIES = ("sympy", "mpmath", "jinja2", "markupsafe")
"""Distributions whose Python files run in a browser as they are installed here."""

TARGETS = {"": "none", "c": "C", "rust": "Rust", "js": "JavaScript"}
CHARTS = ("3", "alpha/(1 + alpha**2/40)", "sin(alpha/6)")
EXAMPLES = {
    "Rodrigues' formula": "gtsam-liegroups-2073", "a misprint": "kindr-411", "rate of a vector": "basilisk-ms-8",
    "logarithm of a rotation": "vslam-handbook-log-so3", "adjoint of a pose": "vslam-handbook-402",
}  # fmt: skip
"""Formulas in use by their anchors."""


def page() -> str:
    """Return the HTML of both forms, with all that their script reads."""
    engine = [ENGINE / name for name in FILES]
    files = [{"name": f.name, "size": f.stat().st_size, "hash": _hash(f)} for f in engine if f.exists()]
    data = {
        "files": files if len(files) == len(FILES) else [], "constant": CONSTANT, "worker": _text("try_worker.js"),
        "kinds": {name: words for name, (_, _, words) in LETTERS.items()},
        "examples": examples(),
    }  # fmt: skip
    holes = {
        "examples": _buttons(EXAMPLES), "charts": _buttons(CHARTS), "most": str(ORDER_MAX),
        "script": _text("try_it.js"),
        "targets": "".join(f'<option value="{name}">{words}</option>' for name, words in TARGETS.items()),
        "data": json.dumps(data, ensure_ascii=False).replace("</", "<\\/"),
    }  # fmt: skip
    return re.sub(r"\{\{(\w+)\}\}", lambda hole: holes[hole[1]], _text("try_it.html"))


def examples() -> dict[str, dict[str, str]]:
    """Return what each example fills into the form of claims."""
    known = claims()
    return {label: known[place] for label, place in EXAMPLES.items()}


def _buttons(names: Iterable[str]) -> str:
    return " ".join(f'<button type="button" value="{name}">{name}</button>' for name in names)


def _text(name: str) -> str:
    return Path(__file__).with_name(name).read_text(encoding="utf-8")


def _hash(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()[:16]


def pack() -> None:
    """Write the archives of libraries and toolkit beside Pyodide, if it and python-flint are there."""
    wheel, libraries = next(ENGINE.parents[1].glob(WHEEL), None), ENGINE / "libraries.zip"
    if wheel is None or not (ENGINE / FILES[0]).exists():
        return
    if not libraries.exists() or libraries.stat().st_mtime < wheel.stat().st_mtime:
        with zipfile.ZipFile(wheel) as flint:
            names = (name for name in flint.namelist() if "/test" not in name)
            _archive(libraries, {**{name: flint.read(name) for name in names}, **dict(_installed())})
    _archive(ENGINE / "toolkit.zip", toolkit())


def toolkit() -> dict[str, bytes]:
    """Return the files of the toolkit, with its templates, and the answers of the page."""
    answers = {"answers.py": _text("answers.py").encode()}
    return {**_folder("derive", "derive", "*.py"), **_folder("templates", "derive/_templates", "*"), **answers}


def _installed() -> Iterator[tuple[str, bytes]]:
    """Yield the Python files of libraries, without their tests, and their licences."""
    for file in (file for name in LIBRARIES for file in metadata.files(name) or ()):
        if (file.suffix == ".py" and "tests" not in file.parts) or ".dist-info" in str(file.parent):
            yield file.as_posix(), file.read_binary()


def _folder(source: str, name: str, pattern: str) -> dict[str, bytes]:
    files = (file for file in sorted((ROOT / source).rglob(pattern)) if file.is_file() and file.suffix != ".pyc")
    return {f"{name}/{file.relative_to(ROOT / source).as_posix()}": file.read_bytes() for file in files}


def _archive(file: Path, contents: dict[str, bytes]) -> None:
    """Write an archive whose bytes depend on its contents alone, so that browsers keep it."""
    with zipfile.ZipFile(file, "w") as archive:
        for name, content in contents.items():
            archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED, compresslevel=9)


class TryIt(SphinxDirective):
    """Directive that stands for the forms and their answers; each build writes them anew, as it packs the engine."""

    def run(self) -> list[nodes.Node]:
        self.env.note_reread()
        return [nodes.raw("", page(), format="html")]


def setup(app: Any) -> dict[str, bool]:
    """Connect the directive to Sphinx."""
    app.connect("builder-inited", lambda app: pack())
    app.add_directive("try-it", TryIt)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
