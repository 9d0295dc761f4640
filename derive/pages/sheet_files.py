"""Formula sheet as a page of HTML with MathML, or printed by a browser as PDF."""

from __future__ import annotations

import os
import re
import shutil
import unicodedata
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from .. import about
from ..output import files
from ..output.pages import render
from ..workers import SlowError, run, scratch
from .sheet import sheet

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
FLAGS = ("--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--no-pdf-header-footer")
SECONDS = 120
"""Processor time that a browser may take."""

SIGN = re.compile(r" (?=(?:[=+-]|\\in) )")
"""Place before a sign, where a formula may go on in the next row."""

DOT = "<mo>&#x002D9;</mo>"
"""Dot of a time derivative."""


def page() -> str:
    """Return the sheet as HTML; raise `ProofFailed` if a line is not proved."""
    return render("report/sheet.html.j2", pages=sheet(), version=about.__version__, mathml=mathml)


def mathml(latex: str) -> str:
    """Return a formula as pieces of MathML, between which a browser may break the row."""
    from latex2mathml.converter import convert  # slow import, needed by this format only

    # the empty group before a sign makes it a sign between two terms
    found = " ".join(convert(f"{{}} {piece}" if i else piece) for i, piece in enumerate(pieces(latex)))
    found = found.replace(DOT, DOT.replace("<mo>", '<mo mathsize="180%">'))  # browsers draw it as small as an index
    return re.sub('<mi mathvariant="bold">([a-z])</mi>', _bold, found)  # browsers know no variant but "normal"


def _bold(letter: re.Match[str]) -> str:
    return f"<mi>{unicodedata.lookup(f'MATHEMATICAL BOLD SMALL {letter[1].upper()}')}</mi>"


def pieces(latex: str) -> Iterator[str]:
    """Yield parts of a formula, separated at signs outside of all brackets."""
    start = 0
    for found in SIGN.finditer(latex):
        before = latex[: found.start()]
        if all(before.count(opening) == before.count(closing) for opening, closing in ("{}", "()", "[]")):
            yield latex[start : found.start()]
            start = found.end()
    yield latex[start:]


def write_html(output: Path) -> None:
    files.put(output, page())


def find_browser() -> str | None:
    """Return the browser that CHROMIUM names, without a check, or else the first one found."""
    return os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)


def write_pdf(output: Path) -> None:
    """Write the sheet as PDF, printed by the browser of `find_browser`."""
    browser = find_browser()
    if browser is None:
        raise files.RefusedError(
            f"cannot write {output}: a PDF needs Chromium or Chrome, named in CHROMIUM or on PATH; "
            f"write {output.with_suffix('.html')}, and print it with any browser"
        )
    text = page()
    with scratch() as folder:
        source, printed = folder / "sheet.html", folder / "sheet.pdf"
        source.write_text(text, encoding="utf-8")
        command = [browser, *FLAGS, f"--user-data-dir={folder}/profile", f"--print-to-pdf={printed}", source.as_uri()]
        try:
            reason = run(command, SECONDS).stderr[-500:]
        except SlowError as error:
            reason = str(error)
        if not printed.is_file():
            raise files.RefusedError(f"cannot write {output}: {browser} printed nothing: {reason}")
        files.put(output, printed.read_bytes())


WRITERS: Mapping[str, Callable[[Path], None]] = {".html": write_html, ".pdf": write_pdf}
"""Function that writes the sheet, by the ending of the file's name."""
