"""``python -m docs.pages.field``: decide the library of formulas in use, and write its page with JSON beside it.

The exit code is 1 if, with ``--check``, a file is stale, and 3 if the page cannot be written. An equation that is not
decided in its time is on the page.
"""

from __future__ import annotations

import argparse
import re
import sys
import textwrap
import tomllib
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from derive.claims.report.content import example
from derive.claims.report.forms import differing_sides
from derive.claims.result import Result, Status
from derive.output import pages
from derive.output.shown import bar

from .field_facts import COLLECTIONS, TRUE, WRONG, Document, Place, anchor, as_json, correction, decided, sheets

SECONDS = 600.0
"""Processor time that an equation may take: the page holds verdicts of all that can be decided."""

HEAD = """# Formulas in use

Libraries, theses and flight code are written from formula sheets, manuals and documentation. This page lists {count}
formulas of such documents, of code, and of reports by readers: {wrong} are wrong. Each was entered as printed, at a
commit or in a thread, and decided by computation in the conventions of its source. Later versions may differ. An entry
is cited by its anchor, such as `kindr-411`, and [field.json](field.json) holds the same facts for programs.

## Formulas by name

Each line opens to a true formula to copy, and to the sources that print it right or wrong.
"""

DOCUMENTS_HEAD = """
## Documents

Each document opens to its wrong formulas and to a table of all. A wrong formula is shown beside its correction in the
notation of claims, with the differing parts in red, and with numbers at which the sides of the printed formula differ.
`make verify` writes this page. `dualcay verify` with a [file of claims](reference/claims.md) decides your documents.
"""

END = "\n</details>\n"
"""End of what a title folds."""

CODE_HEAD = """
## Series near zero in code

Near zero, code replaces a closed form by a series. The table gives the norm at which it switches. The relative error of
the coefficient is given just below, where the series is used, and just above, where the closed form is used: there it
is the largest found within 3 %. Errors were computed in the given precision against 200 digits. Where a series is true
to its order, "holds" says nothing on the rounding of the closed form.

<details><summary>Switches and errors</summary>

| code | status | precision | switch | error below | error above | formula |
|---|---|---|--:|--:|--:|---|"""

SCORE_HEAD = """## Formulas that readers reported

Readers reported these formulas in public threads: {found} are found wrong here, {missed} are missed, and {alarms} were
false alarms, where the formula is true.

<details><summary>Threads and verdicts</summary>

| thread | formula | verdict |
|---|---|---|"""

NAMES: dict[str, list[str]] = tomllib.loads(Path(__file__).with_name("field_names.toml").read_text(encoding="utf-8"))
"""Anchors of formulas by the names under which readers look for them."""

CODE = 96
"""Characters in a line of code on a wide screen."""

CONDITION_MAX = 90
"""Length of a condition that fits into a table."""


def page(library: Sequence[Document]) -> str:
    """Return the page as Markdown."""
    every = [(of, result) for of in library for result in of.results]
    scores = Counter(of.score(result) for of, result in every)
    code = [(of, result) for of, result in every if of.on(result).get("switch")]
    wrong = sum(of.count(*WRONG) for of in library)
    lines = [HEAD.format(count=len(every), wrong=wrong), *_names(every), DOCUMENTS_HEAD, *_counts(library), ""]
    lines += [line for of in library for line in _document(of)]
    for status, head in ((Status.UNREFUTED, "True at all points, and not proved"), (Status.UNDECIDED, "Undecided")):
        if found := [(of, result) for of, result in every if result.status is status]:
            lines += [f"## {head}\n", *(f"- {_link(of, result)}: {result.method}" for of, result in found)]
    lines += [CODE_HEAD, *(line for of, result in code for line in _switches(of, result)), END]
    lines.append(SCORE_HEAD.format(found=scores["found"], missed=scores["missed"], alarms=scores["false alarm"]))
    lines += [f"| {_thread(of.on(r)['report'])} | {_link(of, r)} | {of.score(r)} |" for of, r in every if of.score(r)]
    lines += [END, "## To cite a document\n", _open("BibTeX of the documents"), "```bibtex"]
    return "\n".join([*lines, *(_in_lines(of.about["bibtex"]) for of in library), "```", END])


def _open(title: str) -> str:
    """Return the start of what a title folds; `END` ends it."""
    return f"<details><summary>{title}</summary>\n"


def _names(every: Sequence[tuple[Document, Result]]) -> Iterator[str]:
    """Yield the formulas that readers look for by name, each with a true one, and with those who print it."""
    known = {anchor(result): (of, result) for of, result in every}
    for name, anchors in NAMES.items():
        found = [known[place] for place in anchors if place in known]
        right, wrong = ([(of, r) for of, r in found if (r.status in WRONG) == side] for side in (False, True))
        if not right:
            continue
        of, best = right[0]
        yield _open(f"<b>{name}</b>: {len(right)} right, {len(wrong)} wrong")
        yield f"- To copy, as printed in {of.short}: {_maths(best.equation.printed)}"
        yield f"- As LaTeX: `{best.equation.printed}`"
        yield from [f"- True where `{best.found}`"] if best.found else []
        yield f"- Right: {', '.join(_link(of, result) for of, result in right)}"
        if wrong:
            yield f"- Wrong: {', '.join(f'{_link(of, result)} ({_error(of, result)})' for of, result in wrong)}"
        yield END


def _in_lines(bibtex: str) -> str:
    """Return an entry with a line for each field, and with two for a long one."""
    lines = re.sub(r", (?=\w+ = \{)", ",\n  ", bibtex).split("\n")
    return "\n".join(textwrap.fill(line, CODE, subsequent_indent=" " * 4) for line in lines)


def _counts(library: Sequence[Document]) -> Iterator[str]:
    """Yield the table of documents: what is proved, proved with a condition, unrefuted, wrong and undecided."""
    yield "| document | equations | proved | conditions | unrefuted | wrong | undecided |"
    yield "|---|--:|--:|--:|--:|--:|--:|"
    kinds = ((Status.HOLDS,), (Status.HOLDS_IF,), (Status.UNREFUTED,), WRONG, (Status.UNDECIDED,))
    for of in sorted(library, key=lambda of: of.slug in COLLECTIONS):
        numbers = [len(of.results), *(of.count(*statuses) for statuses in kinds)]
        yield f"| [{of.short}](#in-{of.slug}) | {' | '.join(map(str, numbers))} |"
    total = [sum(len(of.results) for of in library), *(sum(of.count(*s) for of in library) for s in kinds)]
    yield f"| all | {' | '.join(map(str, total))} |"


def _wrong(of: Document, result: Result) -> Iterator[str]:
    """Yield the lines of a wrong formula: both forms, numbers, and code that has it too."""
    entry, known = result.equation, of.on(result)
    names = [name for name, anchors in NAMES.items() if anchor(result) in anchors]
    yield _open(f"<b>{of.slug} {entry.number}</b> {'; '.join([*names, _error(of, result)])}")
    yield f'<a id="{anchor(result)}"></a>\n'
    yield f"{_at(entry.at, of.place(result))}.\n"
    yield f"- As it stands: {_maths(entry.printed)}"
    if result.corrected:
        printed, corrected = differing_sides(result)
        yield f"- As a claim: {_maths(printed)}\n- Corrected: {_maths(corrected)}"
    if terms := _definitions(result):
        yield f"- Here {terms}"
    if result.counterexample is not None:
        yield f"- Its sides differ at `{'; '.join(example(result.counterexample, entry))}`"
    for code in known.get("code", ()):
        where = f"{code['source']}, {code['at']}"
        yield f"- The same in code: {_at(where, Place.of(where, where))}: {code['error']}."
    if entry.remark:
        yield f"- Note: {entry.remark}."
    yield END


def _definitions(result: Result) -> str:
    """Return the definitions of the document that a claim and its correction name, those that these name included."""
    known = {item.name: item for item in result.equation.abbreviations.values()}
    texts, found = [f"{result.claim} {correction(result)}"], dict[str, str]()
    while texts:
        for name in re.findall(r"[A-Za-z]\w*", texts.pop()):
            if name in known and name not in found:
                found[name] = f"`{known[name].head} = {known[name].text}`"
                texts.append(known[name].text)
    return ", ".join(found.values())


def _switches(of: Document, result: Result) -> Iterator[str]:
    """Yield a row for each precision: the switch and the errors on both of its sides."""
    entry = result.equation
    for precision, (at, below, above) in of.on(result)["switch"].items():
        numbers = f"{at:.3g} | {below:.1e} | {above:.1e}"
        name = f"[{entry.number}]({of.place(result).link})"
        yield f"| {name} | {result.status} | {precision} | {numbers} | {_maths(entry.printed)} |"


def _document(of: Document) -> Iterator[str]:
    """Yield a document, folded: its wrong formulas, and the table of all with their status and condition."""
    wrong = [result for result in of.results if result.status in WRONG]
    yield _open(f"<b>{of.short}</b>: {len(of.results)} formulas, {len(wrong)} wrong")
    yield f'<a id="in-{of.slug}"></a>\n'
    yield f"{of.sheet.citation}. Conventions: {of.about['conventions']}. Licence: {of.about['licence']}.\n"
    yield from (line for result in wrong for line in _wrong(of, result))
    yield "| | status | condition | printed |\n|---|---|---|---|"
    for result in of.results:
        label = result.equation.number
        name = _link(of, result, label) if result.status in WRONG else f'<a id="{anchor(result)}"></a>{label}'
        how = f" ({result.certainty})" if result.status in TRUE else ""
        yield f"| {name} | {result.status}{how} | {_condition(result)} | {_maths(result.equation.printed)} |"
    yield END


def _condition(result: Result) -> str:
    """Return the condition found and the domain stated, as a cell of a table."""
    words = ["in field.json" if len(result.found) > CONDITION_MAX else f"`{result.found}`"] if result.found else []
    return "; ".join([*words, *([f"stated for `{result.domain}`"] if result.domain else [])]).replace("|", "\\|")


def _error(of: Document, result: Result) -> str:
    """Return the kind of an error in words."""
    return str(of.on(result).get("error", "see the numbers"))


def _link(of: Document, result: Result, label: str = "") -> str:
    """Return a link to the entry of a formula: of a true one in HTML, for its anchor is inside a cell."""
    target, words = anchor(result), label or f"{of.slug} {result.equation.number}"
    return f"[{words}](#{target})" if result.status in WRONG else f'<a href="#{target}">{words}</a>'


def _at(words: str, place: Place) -> str:
    """Return a place in words, as a link to the lines if the place is known to the line."""
    return f"[{words}]({place.link})" if place.link else words


def _thread(address: str) -> str:
    """Return a link to a thread."""
    return f"[{address.removeprefix('github.com/')}](https://{address})"


def _maths(latex: str) -> str:
    """Return a formula without bars, which would end the cell of a table."""
    return f"$`{latex.replace(chr(92) + '|', chr(92) + 'Vert ').replace('|', chr(92) + 'vert ')}`$"


def main(arguments: Sequence[str] | None = None) -> int:
    """Decide the library, and write or compare the page and the JSON beside it."""
    parser = argparse.ArgumentParser(prog="python -m docs.pages.field", description="Decide the formulas in use.")
    parser.add_argument("-o", "--output", type=Path, required=True, help="page to write, with JSON beside it")
    parser.add_argument("--check", action="store_true", help="compare the files instead")
    parser.add_argument("--seconds", type=float, default=SECONDS, help="processor time that an equation may take")
    options = parser.parse_args(arguments)
    if not options.check and not pages.writable(options.output):
        return 3
    read, output = sheets(), options.output
    problems = [problem for sheet in read for problem in sheet.problems]
    if problems:
        print(*problems, sep="\n", file=sys.stderr)
        return 2
    with bar(sum(len(sheet.entries()) for sheet in read)) as step:
        library = decided(read, options.seconds, step)
    texts = pages.beside(output, page(library), as_json(library))
    return pages.deliver(output, texts, options.check, "docs.pages.field")


if __name__ == "__main__":
    sys.exit(main())
