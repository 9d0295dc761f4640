"""Check of a built site: ``python -m docs._ext.links FOLDER`` lists relative links whose file or place is missing."""

from __future__ import annotations

import re
import sys
from html import unescape
from pathlib import Path
from urllib.parse import unquote, urlsplit

LINK = re.compile(r"<[a-z][^<>]*?\s(?:href|src)=\"([^\"]*)\"")
PLACE = re.compile(r"<[a-z][^<>]*?\sid=\"([^\"]*)\"")


def dead_links(site: Path) -> list[str]:
    """Return the dead relative links of the pages that can be reached from the first one, as ``page: link``."""
    places: dict[Path, set[str]] = {}
    waiting, links = [site / "index.html"], []
    while waiting:
        page = waiting.pop()
        if page in places or not page.is_file():
            continue
        text = page.read_text(encoding="utf-8")
        places[page] = {unescape(place) for place in PLACE.findall(text)}
        for link in dict.fromkeys(map(unescape, LINK.findall(text))):
            parts = urlsplit(link)
            if not parts.scheme and not parts.netloc:
                file = (page.parent / unquote(parts.path)).resolve() if parts.path else page
                links.append((page, link, file, unquote(parts.fragment)))
                waiting += [file] if file.suffix == ".html" else []
    return [
        f"{page.relative_to(site)}: {link}"
        for page, link, file, place in links
        if not file.is_file() or (place and file in places and place not in places[file])
    ]


if __name__ == "__main__":
    folder = Path(sys.argv[1]).resolve()
    found = dead_links(folder)
    print(*(f"dead link in {line}" for line in found), sep="\n", end="\n" * bool(found))
    sys.exit(bool(found))
