"""What a person sees: progress and messages on stderr, tables and formulas on stdout."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from ..codegen import Difference, Package


def console(stderr: bool = False) -> Console:
    """A console that honours NO_COLOR and writes plain text into files and pipes."""
    return Console(stderr=stderr, highlight=False, soft_wrap=True)


@contextmanager
def progress(total: int) -> Iterator[Callable[[str], None]]:
    """A progress bar on a terminal's stderr, silence elsewhere; each call names the step that begins."""
    screen = console(stderr=True)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=screen, transient=True, disable=not screen.is_terminal) as bar:
        task = bar.add_task("", total=total)
        done = -1

        def step(line: str) -> None:
            nonlocal done
            done += 1
            bar.update(task, description=line, completed=done)

        yield step


def written(package: Package, folder: Path) -> Table:
    """What was proved and written, a row per module."""
    table = Table(title=f"kernels in {folder}", title_justify="left")
    table.add_column("module")
    for heading in ("theorems", "proofs at n", "calls validated", "replayed", "compiled", "lines"):
        table.add_column(heading, justify="right")
    for module in package.modules:
        proofs = module.proved.proofs
        general = sum(proof.scope == "all n" for proof in proofs)
        lines = module.text.count("\n")
        counts = (general, len(proofs) - general, module.validated, module.replayed or "-", module.tested or "-", lines)
        table.add_row(module.name, *map(str, counts))
    return table


def not_compiled(package: Package) -> None:
    """Say which modules no compiler has seen: as text they compute their formulas, but their tests did not run."""
    names = [module.name for module in package.modules if module.tested is None]
    if names:
        found = f"no C compiler found (set CC), so validated as text only: {', '.join(names)}"
        console(stderr=True).print(found, markup=False)


def differences(found: list[Difference], command: str) -> None:
    """Print each difference as a diff, and the command that accepts them."""
    out = console()
    for difference in found:
        reason = f" ({difference.reason})" if difference.reason else ""
        out.print(f"{difference.kind}: {difference.path}{reason}", markup=False)
        if difference.diff:
            out.print(difference.diff, markup=False, end="")
    console(stderr=True).print(f"{len(found)} file(s) differ; accept with:  {command}", markup=False)
