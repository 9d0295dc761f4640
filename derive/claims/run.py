"""Decision of claims in worker processes, each within a limit of processor time.

A worker reads requests from its standard input: what makes a sheet, and the place of an equation in it. Exact
polynomials may take long inside one call of a library, so a worker that exceeds the limit ends and is replaced.
"""

from __future__ import annotations

import os
import pickle
import queue
import subprocess
import sys
import threading
from collections.abc import Callable, Collection, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import suppress
from typing import Any

from ..output.shown import Listing, bar, no_op
from ..workers import ALONE, cores, limit, stopped
from .equation import UndecidedError
from .kept import Store, folder
from .result import Result, undecided
from .sheet import Sheet, claim_alone

SECONDS = 60.0
"""Processor time that an equation may take."""


def decide_each(
    items: Sequence[tuple[Sheet, int]], seconds: float = SECONDS, step: Callable[[str], None] = lambda line: None,
    store: Store | None = None,
) -> list[Result]:  # fmt: skip
    """Return the results of entries by sheet and place, in order; a slow one is undecided.

    Results that the store has are not decided again. A process that is `ALONE` decides all itself, without a limit.
    """
    if ALONE:
        alone = []
        for sheet, place in items:
            alone.append(found_here(sheet, place))
            step(f"equation {sheet.entries()[place].number}")
        return alone
    store = store or Store(None, seconds)
    kept = [store.find(sheet, sheet.entries()[place]) for sheet, place in items]
    for result in filter(None, kept):
        step(f"equation {result.equation.number}")
    stop, idle = threading.Event(), queue.SimpleQueue[_Worker]()
    crew = [_Worker(stop) for _ in range(min(cores(), kept.count(None)))]
    for worker in crew:
        idle.put(worker)

    def decided(sheet: Sheet, place: int) -> tuple[Result, bool]:
        worker = idle.get()
        try:
            return worker.decide(sheet, place, seconds)
        finally:
            idle.put(worker)

    with ThreadPoolExecutor(max(len(crew), 1)) as pool:
        found = {pool.submit(decided, *items[i]): i for i, result in enumerate(kept) if result is None}
        try:
            for future in as_completed(found):
                i, (result, settled) = found[future], future.result()
                kept[i] = result
                if settled:
                    store.keep(items[i][0], result)
                step(f"equation {result.equation.number}")
        finally:
            stop.set()
            for worker in crew:
                worker.kill()
            pool.shutdown(cancel_futures=True)
            for worker in crew:
                worker.close()
            store.shrink()
    return list(filter(None, kept))


def check(claim: str, /, *, domain: str = "", seconds: float = SECONDS, **letters: str) -> Result:
    """Decide one claim.

    Parameters
    ----------
    claim : str
        Relation in plain text, such as ``"R*transpose(R) == I"``. It is parsed, never evaluated.
    domain : str, optional
        Relation that states where the claim is said to hold.
    seconds : float, optional
        Processor time that the claim may take; a slower one is undecided. Windows and browsers have no such limit.
    **letters : str
        Kind of each letter, such as ``v="vector"`` or ``n="unit vector"``.

    Returns
    -------
    Result
        Its `status` is "holds", "holds-if" with the condition `found`, "false" with a counterexample and `changes` that
        make the claim true, or "undecided" with the reason as `method`.

    Raises
    ------
    ValueError
        If the claim, the domain or a kind cannot be read: with the column and what was expected.

    Examples
    --------
    >>> import derive
    >>> derive.check("inverse(exp(skew(v))) == exp(skew(-v))", v="vector")
    <Result holds>
    """
    with bar() as step:
        step("claim")
        (result,) = check_sheets([claim_alone(claim, letters, domain)], None, seconds, keep=True)
    return result


def check_sheets(
    sheets: Sequence[Sheet], numbers: Collection[str] | None = None, seconds: float = SECONDS,
    step: Callable[[str], None] = no_op, keep: bool = False,
) -> Listing[Result]:  # fmt: skip
    """Decide the equations of files; `numbers` chooses some, and `step` is called after each.

    With `keep`, results stay in the user's cache, and those that are there are not decided again.
    """
    places = [(sheet, place, entry.number) for sheet in sheets for place, entry in enumerate(sheet.entries())]
    items = [(sheet, place) for sheet, place, number in places if numbers is None or number in numbers]
    return Listing(decide_each(items, seconds, step, Store(folder() if keep else None, seconds)))


class _Worker:
    """Process that decides one entry at a time; after its death a new one begins."""

    def __init__(self, stop: threading.Event) -> None:
        self.stop = stop
        self.process: subprocess.Popen[bytes] | None = None

    def close(self) -> None:
        """Kill the process and close its pipes; one thread at a time does this."""
        self.kill()
        if self.process is not None:
            self.process.communicate()
            self.process = None

    def kill(self) -> None:
        """Kill the process; any thread may."""
        if self.process is not None:
            self.process.kill()

    def decide(self, sheet: Sheet, place: int, seconds: float) -> tuple[Result, bool]:
        """Return the result of an entry, and whether it is all that its processor time gives.

        A result found before the worker died or was slow stands, else the entry is undecided.
        """
        own: dict[str, Any] = {}
        if self.process is None:
            paths = os.pathsep.join(path or os.getcwd() for path in sys.path)
            self.process = subprocess.Popen(
                [sys.executable, "-P", "-c", f"from {__name__} import serve; serve()"],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, env={**os.environ, "PYTHONPATH": paths},
            )  # fmt: skip
            assert self.process.stdout is not None
            if self.stop.is_set():
                self.kill()
            with suppress(EOFError):
                pickle.load(self.process.stdout)  # it is ready; loading does not count as time of an equation
        process, slug, entry, settled = self.process, sheet.slug, sheet.entries()[place], True
        assert process.stdin is not None
        assert process.stdout is not None
        try:
            pickle.dump((sheet.request, place, seconds), process.stdin)
            process.stdin.flush()
            final = False
            while not final:
                final, own = pickle.load(process.stdout)
        except (EOFError, OSError, pickle.UnpicklingError):
            self.close()
            settled = stopped(process.returncode)
            if not own:
                reason = f"not decided within {seconds:g} s of processor time" if settled else "its process died"
                return undecided(slug, entry, reason), settled
        return Result(slug, entry, **own), settled


def serve() -> None:
    """Decide what the standard input asks for, until it ends."""
    try:
        _serve()
    except (KeyboardInterrupt, BrokenPipeError):
        os._exit(0)


def _receive(requests: queue.SimpleQueue[Any]) -> None:
    """Put requests into a queue; end the process with the main process, which closes the standard input."""
    try:
        while True:
            requests.put(pickle.load(sys.stdin.buffer))
    except EOFError:
        os._exit(0)


def found_here(sheet: Sheet, place: int, early: Callable[[Result], None] = lambda result: None) -> Result:
    """Return the result of an entry, decided in this process; one found before an error is kept."""
    from .decide import decide

    slug, entry, told = sheet.slug, sheet.entries()[place], list[Result]()

    def tell(result: Result) -> None:
        told.append(result)
        early(result)

    try:
        return decide(slug, entry, sheet.lost, early=tell)
    except UndecidedError as error:
        return undecided(slug, entry, str(error))
    except Exception:
        return told[-1] if told else undecided(slug, entry, "it cannot be evaluated")


def _serve() -> None:
    from . import decide  # noqa: F401  loaded before the first limit

    requests: queue.SimpleQueue[Any] = queue.SimpleQueue()
    answers, sys.stdout = sys.stdout.buffer, sys.stderr
    sheets: dict[str, Sheet] = {}
    pickle.dump("ready", answers)
    answers.flush()
    threading.Thread(target=_receive, args=(requests,), daemon=True).start()

    def answer(result: Result, final: bool = False) -> None:
        pickle.dump((final, result.own), answers)
        answers.flush()

    while True:
        request, place, seconds = requests.get()
        limit(seconds)
        if (known := repr(request)) not in sheets:
            sheets[known] = Sheet.made(request)
        result = found_here(sheets[known], place, answer)
        limit(0)
        answer(result, True)
