"""Dark pictures: beside each SVG of a page stands one with light ink on the dark ground, for the dark theme."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.osutil import relative_uri

from derive.output.files import put

GROUND, WALL, INK, BLUE = "#14181e", "#262c34", "#ced6dd", "#58a6dc"
DARK = {
    "#ffffff": GROUND, "#f2f2f2": WALL, "#ececec": WALL, "#e6e6e6": WALL, "#000000": INK,
    "#1f77b4": BLUE, "#0072b2": BLUE,
}  # fmt: skip
"""Colours of the dark theme, by those of the light one; the others are visible on both grounds."""


def darkened(svg: str) -> str:
    """Return a picture of Matplotlib with the colours of the dark theme; what has no colour is black there.

    Examples
    --------
    >>> darkened('<svg version="1.1"><path style="fill: #ffffff; stroke: #000000"/></svg>')
    '<svg fill="#ced6dd" version="1.1"><path style="fill: #14181e; stroke: #ced6dd"/></svg>'
    """
    colours = re.compile("|".join(DARK), re.IGNORECASE)
    return colours.sub(lambda found: DARK[found[0].lower()], svg).replace("<svg ", f'<svg fill="{INK}" ', 1)


class DarkPictures(SphinxPostTransform):
    """Add the dark one to each SVG; the theme shows one of both."""

    default_priority = 900  # after images have their files
    formats = ("html",)

    def run(self, **given: Any) -> None:
        builder = self.app.builder
        folder = Path(builder.outdir, builder.imagedir)
        for image in list(self.document.findall(nodes.image)):
            path = Path(self.app.srcdir, image["uri"])
            if path.suffix != ".svg" or not path.is_file():
                continue
            name = f"{path.stem}-dark.svg"
            put(folder / name, darkened(path.read_text(encoding="utf-8")))
            twin = image.deepcopy()
            place = relative_uri(builder.get_target_uri(self.env.current_document.docname), builder.imagedir)
            twin["uri"] = f"{place}/{name}"
            image["classes"].append("only-light")
            twin["classes"].append("only-dark")
            image.parent.insert(image.parent.index(image) + 1, twin)


def setup(app: Any) -> dict[str, bool]:
    """Connect the pictures to Sphinx."""
    app.add_post_transform(DarkPictures)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
