"""Site in a real browser: formulas, narrow windows, both themes, and no request to another host."""

from __future__ import annotations

import json
import queue
import re
import subprocess
import threading
from collections.abc import Iterator, Sequence
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from filelock import FileLock

from docs._ext import links
from tests.support import browsers, pages
from tests.support.staying import until

pytestmark = [pytest.mark.browser, pytest.mark.thorough]
SITE = pages.ROOT / "build" / "docs" / "html"
FLAGS = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"),
    *("--disable-background-networking", "--disable-component-update", "--enable-logging=stderr"),
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
)

CUT = r"""const cut = page => [...page.querySelectorAll("article pre, article table:not(:has(.math))")]
  .filter(node => node.scrollWidth > node.clientWidth + 1).map(node => node.textContent.slice(0, 60));
"""
"""Script that finds code, and tables without formulas, which are wider than their place."""

FRAME = r"""<body style="margin: 0"><iframe width="WIDTH" height="900" style="border: 0"></iframe><script>
CUTconst frame = document.querySelector("iframe");
const probe = async () => {
  const view = frame.contentWindow, page = frame.contentDocument, all = what => [...page.querySelectorAll(what)];
  await view.MathJax?.startup?.promise;
  if (view.innerWidth < 1000 && !view.location.hash)  // formulas out of view too, once for each page
    await view.MathJax?.startup?.document.lazyTypesetAll();
  const texts = page.createTreeWalker(page.body, NodeFilter.SHOW_TEXT), raw = [];
  for (let node; node = texts.nextNode();)
    if (/\\[([a-z]/.test(node.data) && !node.parentNode.closest("pre, code, script, mjx-container"))
      raw.push(node.data);
  const words = page.createTreeWalker(page.querySelector("article"), NodeFilter.SHOW_ALL), first = [], second = [];
  for (let node, place = page.createRange(); node = words.nextNode();) {
    const said = node.nodeType === 3 ? node.data : node.tagName === "IMG" ? `[${node.alt}]` : "";
    if (!said) continue;
    place.selectNode(node);
    const { top, bottom } = place.getBoundingClientRect();
    if (bottom > top && top < 2 * view.innerHeight) (top < view.innerHeight ? first : second).push(said);
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
    second: second.join(" ").replace(/\s+/g, " "),
    cut: view.innerWidth < 1000 ? [] : cut(page),
    pictures: all("article img").filter(node => node.src.includes(".svg") && node.checkVisibility()
      && node.classList.contains("only-dark") === (page.documentElement.dataset.theme !== "dark")).length,
    unfolded: all("#gates table").filter(node => node.checkVisibility()).length * page.URL.includes("benchmarks"),
    shown: !target || target.checkVisibility(),
    seconds: view.performance.now() / 1000,
  };
  fetch("/seen", {method: "POST", body: JSON.stringify(seen)});
};
frame.addEventListener("load", probe);
frame.src = "PAGE" + location.hash;
</script>""".replace("CUT", CUT)
"""Page that holds another in a frame, since a window of Chromium is at least 500 px wide, and sends what it shows."""

TOUR = r"""<body style="margin: 0"><iframe width="1280" height="900" style="border: 0"></iframe><script>
CUTconst frame = document.querySelector("iframe"), pages = PAGES, found = {};
frame.sandbox = "allow-same-origin";  // without scripts, a third of the time
frame.addEventListener("load", () => {
  for (const folded of frame.contentDocument.querySelectorAll("details")) folded.open = true;
  const wide = cut(frame.contentDocument);
  if (wide.length) found[frame.contentWindow.location.pathname] = wide;
  if (pages.length) frame.src = pages.pop(); else fetch("/seen", {method: "POST", body: JSON.stringify(found)});
});
frame.src = pages.pop();
</script>""".replace("CUT", CUT)
"""Page that shows all pages of the site one by one, and sends the code and the tables that are cut."""

GOOD = {
    "unrendered": 0, "wrong": [], "raw": [], "elsewhere": [], "overflow": 0, "console": [], "failed": [], "shown": True,
    "cut": [], "pictures": 0, "unfolded": 0,
}  # fmt: skip
"""Contents of a sound page: code fits a wide screen, pictures are those of the theme, gates are folded."""


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
    seen, found = browse(server, f"frame?{width}:{name}#{target}", folder, dark)
    return seen | {"console": [line for line in found if not line.startswith(NOTES)], "failed": [*server.failed]}


def browse(server: Server, page: str, folder: Path, flags: Sequence[str] = ()) -> tuple[dict[str, object], list[str]]:
    """Return what a frame sends from a browser, and the lines of the console."""
    url, log = f"http://127.0.0.1:{server.server_port}/{page}", folder / "log"
    with log.open("w") as stream:
        command = [str(browsers.find()), *FLAGS, *flags, f"--user-data-dir={folder}/profile", url]
        browser = subprocess.Popen(command, stdout=stream, stderr=stream)
        try:
            until(lambda: not server.seen.empty() or browser.poll() is not None)
            seen = server.seen.get_nowait()
        finally:
            browser.terminate()
            browser.wait()
    return seen, re.findall(r"CONSOLE.*?\] (.*)", log.read_text(encoding="utf-8"))


FUNCTION = "reference/generated/dualcay.cayley2.tangent.html"
IN_CHART = "reference/generated/dualcay.cayley2.pose.html?chart=exponential"
ERRATA = sum(
    equation["status"] == "erratum" and equation["paper"].startswith("condurache")
    for equation in json.loads((pages.ROOT / "docs" / "errata.json").read_text(encoding="utf-8"))["equations"]
)
FIRST = {
    "index.html": ("pose in six numbers", "pip install"),
    "field.html": ("formulas of such documents",),
    "genindex.html": ("Index",),
    "howto/spline.html": ("smooth curve through poses",),
    "tutorials/heavy_top.html": ("At the end you have", "download heavy_top.ipynb"),
    FUNCTION: ("dualcay.cayley2. tangent", "[source]", "Parameters"),
    "errata.html": ("What was decided", "erratum", f"CP23 {ERRATA}"),
    "benchmarks.html": ("nanoseconds per pose", "[ns per pose against", "N = 1", "N = 100", "pose", "quaternion"),
    IN_CHART: ("dualcay.exponential. pose",),
    "theorems.html": ("Order n: maps and twists", "theorem formula Coq"),
    "coming_from/gtsam.html": ("GTSAM dualcay", "gtsam.Pose3.Expmap(v).matrix()", "exponential.pose(v)"),
    "accuracy.html": ("digits that are right", "pose of v, below half a turn"),
    "assurance.html": ("target proved executed",),
    "explanation/live.html": ("Move the sliders", "rotation angle (°) 90"),
    "try.html": ("The first question loads", "Examples: Rodrigues' formula", "Letters"),
}
"""Words on the first screen of a page, on a wide screen and on a phone."""
SECOND = {
    "benchmarks.html": ("from_pose", "compose", "fastest other", "Slower than others in:"),
    IN_CHART: ("0.878", "Show the example of cayley2"),
    "accuracy.html": ("[Error of a pose against its angle", "Gates"),
    "errata.html": ("printed, and right", "(56)"),
    "field.html": ("Formulas by name", "exponential of a rotation vector", "inverse left Jacobian"),
    "theorems.html": ("norm", "functions that rest on it"),
}
"""Words on the first two screens of a page."""
LINKED = ("errata.html#condurache-popa-2023-112", "field.html#kindr-411", "theorems.html#rates-of-v")
WITHOUT_FORMULAS = {
    IN_CHART, "index.html", "genindex.html", "howto/spline.html", "benchmarks.html", "accuracy.html", "assurance.html",
    "coming_from/gtsam.html", "explanation/live.html",
}  # fmt: skip


@pytest.mark.parametrize(
    ("page", "width", "theme"),
    # The layout depends on the width alone, and colours on the theme alone.
    [*((page, 1280, "light") for page in FIRST), *((page, 390, "dark") for page in (*FIRST, *LINKED))],
)
def test_page_is_sound(server: Server, tmp_path: Path, page: str, width: int, theme: str) -> None:
    seen = look(server, page, tmp_path, width, theme)
    assert (seen["width"], seen["theme"]) == (width, theme)
    assert bool(seen["formulas"]) == (page not in WITHOUT_FORMULAS)
    assert {name: seen[name] for name in GOOD} == GOOD
    assert [words for words in FIRST.get(page, ()) if words not in str(seen["first"])] == []
    two = f"{seen['first']} {seen['second']}"
    assert [words for words in SECOND.get(page, ()) if words not in two] == []


def test_front_page_is_one_screen(server: Server, tmp_path: Path) -> None:
    seen = look(server, "index.html", tmp_path)
    assert seen["second"] == ""
    links = {"try", "explanation/live", "howto/rust", "howto/javascript", "howto/matlab", "howto/spline", "field"}
    text = (SITE / "index.html").read_text(encoding="utf-8").partition("<article")[2]
    assert [link for link in links if f'href="{link}.html' not in text] == []
    assert 'href="assurance.html#machine-code"' in text


def test_first_screen_without_its_answer_is_seen(server: Server, tmp_path: Path) -> None:
    sound = (SITE / "benchmarks.html").read_text(encoding="utf-8")
    late = sound.replace("<h1>", '<div style="height: 3000px"></div><h1>').replace("<details>", "<details open>")
    server.further["benchmarks_late.html"] = late
    seen = look(server, "benchmarks_late.html", tmp_path)
    for gone in ("[ns per pose against", "quaternion", "Slower than others in:"):
        assert gone not in f"{seen['first']} {seen['second']}"
    assert seen["unfolded"]


def test_code_and_tables_fit_a_wide_screen_on_every_page(server: Server, tmp_path: Path) -> None:
    names = [page.relative_to(SITE).as_posix() for page in sorted(SITE.rglob("*.html"))]
    looked = [name for name in names if not name.startswith(("_modules", "formula-sheet"))]
    wide, line = FUNCTION.replace("tangent", "wide"), "wide " * 99
    server.further[wide] = (SITE / FUNCTION).read_text(encoding="utf-8").replace("<h1>", f"<pre>{line}</pre><h1>")
    server.further["tour"] = TOUR.replace("PAGES", json.dumps([*looked, wide]))
    found, _ = browse(server, "tour", tmp_path)
    assert found == {f"/{wide}": [line[:60]]}


FIND = r"""<body><iframe width="1280" height="900"></iframe><script>
const frame = document.querySelector("iframe"), asked = ASKED, found = {};
frame.addEventListener("load", () => {
  const waiting = setInterval(() => {
    const page = frame.contentDocument, links = page.querySelectorAll("#search-results li a");
    if (!/found/.test(page.querySelector(".search-summary")?.textContent ?? "") || links.length === 0) return;
    clearInterval(waiting);
    found[asked.pop()] = [...links].slice(0, 3).map(link => link.getAttribute("href").split("#")[0]);
    if (asked.length) ask(); else fetch("/seen", {method: "POST", body: JSON.stringify(found)});
  }, 50);
});
const ask = () => { frame.src = `search.html?q=${asked[asked.length - 1]}`; };
ask();
</script>"""
"""Page that searches for words, and sends the first pages that are found for each."""
SOUGHT = {
    "log": "from_pose", "exp": "pose", "hat": "pose", "slerp": "interpolate", "covariance": "compose_covariance",
    "twist": "twist", "adjoint": "adjoint", "left Jacobian": "tangent", "errata": "errata",
}  # fmt: skip
"""Page that is among the first three found for words."""


def test_search_leads_to_functions_first(server: Server, tmp_path: Path) -> None:
    server.further["find"] = FIND.replace("ASKED", json.dumps([*SOUGHT]))
    found, _ = browse(server, "find", tmp_path)
    names = {words: [str(link).removesuffix(".html").rpartition(".")[2] for link in found[words]] for words in SOUGHT}
    assert [words for words, name in SOUGHT.items() if name not in names[words]] == []
    assert not any("field" in links for links in names.values())


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
    "picture of the other theme": ("pictures", '<img class="only-dark" style="display: block !important" src="a.svg">'),
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
