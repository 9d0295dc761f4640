"""Site in a real browser: formulas, narrow windows, both themes, and no request to another host."""

from __future__ import annotations

import json
import queue
import re
import subprocess
import threading
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from filelock import FileLock

from docs._ext import links
from tests.support import browsers, pages

pytestmark = [pytest.mark.browser, pytest.mark.thorough]
SITE = pages.ROOT / "build" / "docs" / "html"
FLAGS = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"),
    *("--disable-background-networking", "--disable-component-update", "--enable-logging=stderr"),
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
)
SECONDS = 240  # time for a page to come back

FRAME = r"""<body style="margin: 0"><iframe width="WIDTH" height="900" style="border: 0"></iframe><script>
const frame = document.querySelector("iframe");
const probe = async () => {
  const view = frame.contentWindow, page = frame.contentDocument, all = what => [...page.querySelectorAll(what)];
  await view.MathJax?.startup?.promise;
  await view.MathJax?.startup?.document.lazyTypesetAll();  // formulas out of view, too
  const texts = page.createTreeWalker(page.body, NodeFilter.SHOW_TEXT), raw = [];
  for (let node; node = texts.nextNode();)
    if (/\\[([a-z]/.test(node.data) && !node.parentNode.closest("pre, code, script, mjx-container"))
      raw.push(node.data);
  const words = page.createTreeWalker(page.querySelector("article"), NodeFilter.SHOW_TEXT), first = [];
  for (let node, place = page.createRange(); node = words.nextNode();) {
    place.selectNodeContents(node);
    const { top, bottom } = place.getBoundingClientRect();
    if (bottom > top && top < view.innerHeight) first.push(node.data);
  }
  const target = view.location.hash && page.getElementById(view.location.hash.slice(1));
  const seen = {
    width: view.innerWidth,
    theme: page.documentElement.dataset.theme,
    formulas: all("mjx-container").length,
    unrendered: all(".math").filter(node => !node.querySelector("mjx-container")).length,
    wrong: all("mjx-merror").map(node => node.dataset.mjxError),
    raw,
    elsewhere: view.performance.getEntriesByType("resource").map(entry => entry.name)
      .filter(name => !name.startsWith(location.origin) && !name.startsWith("data:")),
    overflow: Math.max(...all("html, body, main, main div:has(> article), article")
      .map(node => node.scrollWidth - node.clientWidth)),
    first: first.join(" ").replace(/\s+/g, " "),
    shown: !target || target.checkVisibility(),
    seconds: view.performance.now() / 1000,
  };
  fetch("/seen", {method: "POST", body: JSON.stringify(seen)});
};
frame.addEventListener("load", probe);
frame.src = "PAGE" + location.hash;
</script>"""
"""Page that holds another in a frame, since a window of Chromium is at least 500 px wide, and sends what it shows."""

GOOD = {
    "unrendered": 0, "wrong": [], "raw": [], "elsewhere": [], "overflow": 0, "console": [], "failed": [], "shown": True,
}  # fmt: skip
"""Contents of a sound page."""


NOTES = ('"[PST]: Changed to auto mode', '"[PST]: Scrolled sidebar')
"""Notes of the theme on the console of every page."""


class Server(ThreadingHTTPServer):
    """Server of the site, of frames around its pages, and of further pages."""

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), partial(Handler, directory=str(SITE)))
        self.further: dict[str, str] = {}
        self.failed: list[str] = []
        self.seen: queue.SimpleQueue[dict[str, object]] = queue.SimpleQueue()


class Handler(SimpleHTTPRequestHandler):
    """Requests of one browser: failed ones are kept, and what a frame sends."""

    server: Server

    def do_GET(self) -> None:
        name, _, query = self.path.lstrip("/").partition("?")
        width, _, page = query.partition(":")
        text = FRAME.replace("WIDTH", width).replace("PAGE", page) if name == "frame" else self.server.further.get(name)
        if text is None:
            return super().do_GET()
        self.send_response(200)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        self.wfile.write(text.encode())
        return None

    def do_POST(self) -> None:
        self.server.seen.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()

    def log_request(self, code: object = "-", size: object = "-") -> None:
        if str(code).startswith(("4", "5")) and self.path != "/favicon.ico":  # the frame has no icon
            self.server.failed.append(self.path)

    def log_message(self, format: str, *args: object) -> None:
        """Log nothing."""


@pytest.fixture(scope="module")
def server() -> Iterator[Server]:
    """Serve the site of `make docs`, which is built if it is missing."""
    SITE.parents[1].mkdir(exist_ok=True)
    with FileLock(SITE.parents[1] / "site.lock"):
        if not (SITE / "index.html").exists():
            subprocess.run(["make", "docs"], cwd=pages.ROOT, check=True)
    with Server() as running:
        threading.Thread(target=running.serve_forever, daemon=True).start()
        yield running
        running.shutdown()


def look(server: Server, page: str, folder: Path, width: int = 1280, theme: str = "light") -> dict[str, object]:
    """Return what a page shows in a browser, what it writes to the console, and its failed requests."""
    server.failed.clear()
    dark = ("--blink-settings=preferredColorScheme=0",) if theme == "dark" else ()
    name, _, target = page.partition("#")
    url = f"http://127.0.0.1:{server.server_port}/frame?{width}:{name}#{target}"
    log = folder / "log"
    with log.open("w") as stream:
        command = [str(browsers.find()), *FLAGS, *dark, f"--user-data-dir={folder}/profile", url]
        browser = subprocess.Popen(command, stdout=stream, stderr=stream)
        try:
            seen = server.seen.get(timeout=SECONDS)
        finally:
            browser.terminate()
            browser.wait(timeout=SECONDS)
    found = re.findall(r"CONSOLE.*?\] (.*)", log.read_text(encoding="utf-8"))
    return seen | {"console": [line for line in found if not line.startswith(NOTES)], "failed": [*server.failed]}


FUNCTION = "reference/generated/dualcay.cayley2.tangent.html"
FIRST = {
    "index.html": ("pose in six numbers", "pip install"),
    "tutorials/heavy_top.html": ("At the end you have", "download heavy_top.ipynb"),
    FUNCTION: ("dualcay.cayley2. tangent", "[source]", "Parameters"),
    "errata.html": ("What was decided", "erratum", "CP23 36"),
    "benchmarks.html": ("Speed",),
    "theorems.html": ("Order n: maps and twists", "theorem formula certificate Coq"),
    "coming_from/gtsam.html": ("GTSAM dualcay", "gtsam.Pose3.Expmap(v).matrix()", "exponential.pose(v)"),
    "accuracy.html": ("digits that are right", "pose of v, below half a turn"),
    "assurance.html": ("target proved executed",),
}
"""Words on the first screen of a page, on a wide screen and on a phone."""
LINKED = ("errata.html#condurache-popa-2023-112", "field.html#kindr-411", "theorems.html#rates-of-v")
WITHOUT_FORMULAS = {"index.html", "benchmarks.html", "accuracy.html", "assurance.html", "coming_from/gtsam.html"}


# The layout depends on the width alone, and colours on the theme alone.
@pytest.mark.parametrize(("width", "theme"), [(1280, "light"), (390, "dark")])
@pytest.mark.parametrize("page", [*FIRST, *LINKED])
def test_page_is_sound(server: Server, tmp_path: Path, page: str, width: int, theme: str) -> None:
    seen = look(server, page, tmp_path, width, theme)
    assert (seen["width"], seen["theme"]) == (width, theme)
    assert bool(seen["formulas"]) == (page not in WITHOUT_FORMULAS)
    assert {name: seen[name] for name in GOOD} == GOOD
    assert [words for words in FIRST.get(page, ()) if words not in str(seen["first"])] == []


def test_text_below_the_first_screen_is_not_seen(server: Server, tmp_path: Path) -> None:
    assert "Kernel functions" not in str(look(server, "theorems.html", tmp_path)["first"])


def test_every_relative_link_exists(server: Server) -> None:
    assert links.dead_links(SITE) == []


FAULTS = {
    "open brace": ("unrendered", r'<span class="math">\(\frac{a\)</span>'),
    "broken formula": ("wrong", r'<span class="math">\(a \right)\)</span>'),
    "unknown command": ("wrong", r'<span class="math">\(\nothing\)</span>'),
    "formula as text": ("raw", r'<b class="mathjax_ignore">\(a\)</b>'),
    "wide element": ("overflow", '<div style="width: 2000px">wide</div>'),
    "other host": ("elsewhere", '<img src="https://example.org/picture.png">'),
    "error of a script": ("console", "<script>missing()</script>"),
    "missing picture": ("failed", '<img src="missing.png">'),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_fault_is_seen(server: Server, tmp_path: Path, fault: str) -> None:
    what, inserted = FAULTS[fault]
    sound = (SITE / FUNCTION).read_text(encoding="utf-8")
    page = FUNCTION.replace("tangent", "fault")
    server.further[page] = sound.replace("<h1>", f"{inserted}<h1>")
    seen = look(server, page, tmp_path, 390)
    assert {name for name in GOOD if seen[name] != GOOD[name]} >= {what}
