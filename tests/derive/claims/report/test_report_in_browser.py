"""HTML report in a real browser: layout of formulas and filter by status."""

from __future__ import annotations

import html
import json
import re
import subprocess
from pathlib import Path

import pytest

from derive.claims.report import FORMATS, Report
from derive.claims.result import Status
from derive.papers import PAPERS, verify
from tests.support import browsers

pytestmark = pytest.mark.browser
FLAGS = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"),
    *("--disable-background-networking", "--disable-component-update", "--virtual-time-budget=3000"),
)
ENTRIES = ("dimension", "norm", "quadratic-expansion", "b-plus-identity", "rodrigues-matrix", "14", "18", "20", "21",
           "step-19", "positions")  # fmt: skip
"""Equations with every status but undecided, and with fractions."""
PROBE = r"""<script>
addEventListener("load", () => {
  const click = new URLSearchParams(location.search).get("click");
  if (click) document.querySelector(`nav a[href="#${click}"]`).click();
  setTimeout(() => {
    const shown = [...document.querySelectorAll("article")].filter(row => row.offsetHeight > 0);
    const within = what => shown.flatMap(row => [...row.querySelectorAll(what)]);
    const target = location.hash ? document.getElementById(location.hash.slice(1)) : null;
    const light = colour => colour.match(/[\d.]+/g).slice(0, 3).map(c => c / 255)
      .map(c => c <= .03928 ? c / 12.92 : ((c + .055) / 1.055) ** 2.4)
      .reduce((sum, c, i) => sum + c * [.2126, .7152, .0722][i], 0);
    const contrast = style => {
      const [a, b] = [light(style.color), light(style.backgroundColor)].sort();
      return (b + .05) / (a + .05);
    };
    const box = node => node.getBoundingClientRect();
    document.body.dataset.probe = JSON.stringify({
      shown: shown.map(row => row.dataset.status),
      current: document.querySelector("nav [aria-current=true]").textContent,
      formulas: within("math").length,
      flat: within("math").filter(node => box(node).width < 5 || box(node).height < 5).length,
      fractions: within("mfrac").length,
      stacked: within("mfrac").filter(f => box(f.children[0]).bottom <= box(f.children[1]).top + 2).length,
      contrast: contrast(getComputedStyle(document.body)),
      covered: target !== null && box(target).top < box(document.querySelector("nav")).bottom,
      overflow: document.documentElement.scrollWidth - innerWidth,
    });
  }, 300);
});
</script>"""


@pytest.fixture(scope="module")
def browser() -> str:
    return str(browsers.find())


@pytest.fixture(scope="module")
def karakilic() -> Report:
    return Report.of(PAPERS, verify("karakilic-2010", ENTRIES), [])


@pytest.fixture
def statuses(karakilic: Report) -> list[str]:
    return [str(result.status) for result in karakilic.results]


@pytest.fixture
def look(browser: str, karakilic: Report, tmp_path: Path):
    page = FORMATS["html"](karakilic)
    (tmp_path / "errata.html").write_text(page.replace("</body>", f"{PROBE}</body>"), encoding="utf-8")

    def visit(address: str, *flags: str) -> dict[str, object]:
        url = f"file://{tmp_path}/errata.html{address}"
        command = [browser, *FLAGS, *flags, f"--user-data-dir={tmp_path}/profile", "--dump-dom", url]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        found = re.search(r'data-probe="([^"]*)"', done.stdout)
        assert found, f"no page came back: {done.stderr[-2000:]}"
        return dict(json.loads(html.unescape(found.group(1))))

    return visit


def test_everything_shows_and_formulas_are_laid_out(look, statuses) -> None:
    seen = look("")
    assert len(seen["shown"]) == len(statuses)
    assert seen["current"] == "all"
    assert seen["formulas"] >= len(statuses)
    assert seen["flat"] == 0
    assert seen["fractions"] == seen["stacked"] > 10
    assert seen["overflow"] <= 0


@pytest.mark.parametrize(("address", "status"), [("#{}", Status.ERRATUM), ("?click={}", Status.HOLDS)])
def test_filter_by_address_and_by_click(look, statuses, status: Status, address: str) -> None:
    seen = look(address.format(status))
    assert seen["shown"] == [found for found in statuses if found == str(status)]
    assert seen["current"] == str(status)


@pytest.mark.parametrize(("width", "scheme"), [(375, 0), (1280, 1)])
def test_nothing_is_wider_than_the_window(look, statuses, width: int, scheme: int) -> None:
    """Look at one entry, which hides no other, in both colour schemes of the browser: dark is 0."""
    flags = f"--window-size={width},900", f"--blink-settings=preferredColorScheme={scheme}"
    seen = look("#karakilic-2010-14", *flags)
    assert len(seen["shown"]) == len(statuses)
    assert seen["overflow"] <= 0
    assert seen["contrast"] >= 4.5
    assert seen["covered"] is False
