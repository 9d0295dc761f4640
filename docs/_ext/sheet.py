"""Formula sheet beside the site's pages: as HTML, and as PDF where a browser prints it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from derive.pages import sheet_files as sheet


def write(app: Any, error: Exception | None) -> None:
    """Write the sheet into the folder of a complete site."""
    if error is not None:
        return
    sheet.write_html(Path(app.outdir, "formula-sheet.html"))
    if sheet.find_browser():
        sheet.write_pdf(Path(app.outdir, "formula-sheet.pdf"))
    else:
        print("skipped: the sheet as PDF needs Chromium or Chrome")


def setup(app: Any) -> dict[str, bool]:
    """Connect the sheet to Sphinx; pages link to the PDF under the tag ``pdf`` alone."""
    if sheet.find_browser():
        app.tags.add("pdf")
    app.connect("build-finished", write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
