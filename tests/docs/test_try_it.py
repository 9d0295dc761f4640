"""Page on which a reader tries claims, as wide as a phone: once loaded, it answers without the network."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import pytest

from docs._ext import try_it
from tests.docs.test_site import NOTES, SITE, Handler, Server, browse, server  # noqa: F401  a fixture

pytestmark = [pytest.mark.browser, pytest.mark.thorough]
DRIVE = r"""<body style="margin: 0"><iframe width="390" height="900" style="border: 0" src="ADDRESS"></iframe><script>
document.querySelector("iframe").addEventListener("load", async ({ target }) => {
  const page = target.contentDocument, home = page.getElementById("try-it"), found = [];
  for (const [name, values] of QUESTIONS) {
    const form = home.querySelector(`form[name=${name}]`);
    for (const [field, value] of Object.entries(values)) form.elements[field].value = value;
    const answered = new Promise(resolve => home.addEventListener("answered", resolve, { once: true }));
    form.requestSubmit();
    await answered;
    const answer = form.nextElementSibling, all = what => [...answer.querySelectorAll(what)];
    found.push([home.querySelector(".state").textContent, answer.textContent, all("mjx-container").length > 0,
      all("mjx-merror").length]);
    await fetch("/cut");
  }
  const parts = [...page.querySelectorAll("html, body, main, article")];
  const wide = Math.max(...parts.map(node => node.scrollWidth - node.clientWidth));
  fetch("/seen", { method: "POST", body: JSON.stringify({ found, wide }) });
});
</script>"""
"""Page that asks questions on another page, and cuts the network after the first answer."""

PHI, CLAIM = "alpha/(1 + alpha**2/40)", {"letters": "v = vector; w = vector", "claim": "skew(v)*w == cross(w, v)"}
ANSWERS = [  # form, its fields, words of the state and of the answer; the first form is filled by the address
    ("claim", {}, "Ready.", ("false", "fails at", "true with", "cross product swapped")),
    ("claim", {"claim": "norm(v) == acos((trace(exp(skew(v))) - 1)/2)"}, "Ready.", ("holds-if", "where", "outside")),
    ("claim", {"claim": "skew(v)*w == cross(v, w)"}, "Ready.", ("holds", "exact")),
    ("claim", {"claim": "norm(v"}, "Ready.", ("claim, column 5: a claim is no expression",)),
    ("claim", {"claim": "tan(norm(v)) == 1", "seconds": 0.001}, "Not decided within 0.001 s.", ()),
    ("chart", {"chart": PHI, "target": "rust"}, "Ready.", (f"phi = {PHI}", "not run", "lib.rs", "pub fn")),
]  # fmt: skip


def test_page_answers_without_a_network(server: Server, tmp_path: Path, monkeypatch: Any) -> None:  # noqa: F811
    if not (SITE / "_static" / "engine" / try_it.FILES[-1]).exists():
        pytest.skip("the site was built without Pyodide, which `make docs` could not download")
    cut, ordinary = list[str](), Handler.do_GET

    def get(handler: Handler) -> None:
        if handler.path != "/cut":
            return handler.send_error(503) if cut else ordinary(handler)
        cut.append(handler.path)
        handler.send_response(204)
        return handler.end_headers()

    monkeypatch.setattr(Handler, "do_GET", get)
    questions = json.dumps([question[:2] for question in ANSWERS])
    server.further["drive"] = DRIVE.replace("ADDRESS", f"try.html?{urlencode(CLAIM)}").replace("QUESTIONS", questions)
    server.failed.clear()
    seen, console = browse(server, "drive", tmp_path)
    assert (server.failed, seen["wide"], [line for line in console if not line.startswith(NOTES)]) == ([], 0, [])
    for (_, _, said, words), (state, answer, formulas, wrong) in zip(ANSWERS, seen["found"], strict=True):
        assert (state, wrong, formulas) == (said, 0, len(words) > 1)
        assert [word for word in words if word not in answer] == []
