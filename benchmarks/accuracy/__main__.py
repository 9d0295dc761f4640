"""Measure, keep the worst inputs, and write docs/accuracy.md with its figures: ``python -m benchmarks.accuracy``."""

from __future__ import annotations

import tempfile
import time
from functools import partial
from pathlib import Path

import click
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from benchmarks.accuracy import certified, figures, measure, report, worst
from derive.output.files import put
from tests.support import cases, kernels, sampling

DOCS = Path(__file__).parents[2] / "docs"


def progress(console: Console) -> Progress:
    """Return a progress bar that is shown on terminals only."""
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    return Progress(*columns, console=console, disable=not console.is_terminal)


def search(folder: Path, seconds: float, bar: Progress) -> None:
    """Measure random inputs for a number of seconds, and keep the worst ones in the file of cases."""
    kept, seed = cases.read()
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        seed += 1
        # Without shuffling, every short search would try the same orders.
        tasks = measure.sample_tasks(folder, seed)
        sampling.generator("search", seed=seed).shuffle(tasks)
        row = bar.add_task(f"searching, seed {seed}", total=len(tasks))
        found = list(measure.run(tasks, partial(bar.advance, row), deadline))
        kept = cases.worst([*kept, *measure.cases_of(found)])
        cases.write(kept, seed)


def measurements(folder: Path, bar: Progress) -> list[measure.Measurement]:
    """Return the measurements of seeded samples and kept cases; keep the worst ones in the file of cases."""
    kept, searched = cases.read()
    tasks = measure.sample_tasks(folder) + measure.replay_tasks(folder, kept)
    row = bar.add_task("kernels", total=len(tasks))
    found = list(measure.run(tasks, partial(bar.advance, row)))
    cases.write(cases.worst([*kept, *measure.cases_of(found)]), searched)
    return found


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--search", "seconds", type=float, default=0.0, help="First look for worse inputs, so many seconds.")
@click.option("--bounds-only", is_flag=True, help="Write the section of certified bounds, and leave the rest.")
@click.option("--figures-only", is_flag=True, help="Draw the figures, with what is said of them, and leave the tables.")
def main(seconds: float, figures_only: bool, bounds_only: bool) -> None:
    """Write docs/accuracy.md with .json, its figures and benchmarks/worst_cases.json."""
    page = DOCS / "accuracy.md"
    if bounds_only:
        put(page, certified.renewed(page.read_text(encoding="utf-8")))
        return
    console = Console()
    with tempfile.TemporaryDirectory() as name, progress(console) as bar:
        folder = Path(name)
        kernels.write(measure.ORDERS, folder)
        drawn = figures.draw(DOCS, bar, console)
        if figures_only:
            put(page, report.beside(page.read_text(encoding="utf-8"), drawn))
            return
        if seconds:
            search(folder, seconds, bar)
        found = measurements(folder, bar)
    text = report.page(found, drawn)
    put(page, text)
    put(page.with_suffix(".json"), worst.data(text))
    for line in report.verdict(found):
        console.print(line, highlight=False)


if __name__ == "__main__":
    main()
