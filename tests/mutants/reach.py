"""Which checks reach which lines of source, and which templates: what none reaches, none of them can kill."""

from __future__ import annotations

import functools
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any
from unittest.mock import patch

import coverage
import jinja2

Names = set[str]

COMPILERS = ("cc", "gcc", "g++", "clang", "clang++")
"""Programs that are started by checks and run nothing of the toolkit."""


class Reach:
    """Records while it is open; every check runs `by` its name.

    What runs outside of all checks (imports, tables made by them) is reached by every check. A cached function is
    reached by all that call it, whoever was first. ``starters`` are checks that start a Python of their own, or a
    browser: what that reaches is not seen, and other limits of time hold for it.
    """

    def __init__(self, root: Path, sources: Sequence[str]) -> None:
        self.root = root
        self._coverage = coverage.Coverage(
            data_file=None, config_file=False, messages=False, include=[f"{root}/{source}" for source in sources]
        )
        self._names = [""]
        self._uses: dict[str, Names] = {}
        self._templates: dict[str, Names] = {}
        self.starters: Names = set()

    @contextmanager
    def open(self) -> Iterator[Reach]:
        """Record; the toolkit must not have been imported before."""
        sys.addaudithook(self._started)
        with ExitStack() as patched:
            lru_cache = self._watched_cache(functools.lru_cache)
            patched.enter_context(patch.object(functools, "lru_cache", lru_cache))
            patched.enter_context(patch.object(functools, "cache", lru_cache(None)))
            get_template = self._watched_loading(jinja2.Environment.get_template)
            patched.enter_context(patch.object(jinja2.Environment, "get_template", get_template))
            self._coverage.start()
            self._coverage.switch_context("")
            try:
                yield self
            finally:
                self._coverage.stop()

    def _started(self, event: str, arguments: tuple[Any, ...]) -> None:
        if event == "subprocess.Popen" and self._names[-1] and Path(str(arguments[0])).name not in COMPILERS:
            self.starters.add(self._names[-1])

    def _watched_loading(self, get_template: Any) -> Any:
        def watched(environment: Any, name: Any, *arguments: Any, **options: Any) -> Any:
            template = get_template(environment, name, *arguments, **options)
            path = Path(template.filename or "")
            if path.is_relative_to(self.root):
                self._templates.setdefault(str(path.relative_to(self.root)), set()).add(self._names[-1])
            return template

        return watched

    def _watched_cache(self, lru_cache: Any) -> Any:
        def watched(*options: Any, **named: Any) -> Any:
            made = lru_cache(*options, **named)
            if options and callable(options[0]):
                return self._watch(options[0], made)
            return lambda function: self._watch(function, made(function))

        return watched

    def _watch(self, function: Any, cached: Any) -> Any:
        code = getattr(function, "__code__", None)  # modules of tests have names of their own: files tell what is ours
        if code is None or not Path(code.co_filename).is_relative_to(self.root):
            return cached
        name = f"cache of {function.__module__}.{function.__qualname__}"

        @functools.wraps(function)
        def watched(*arguments: Any, **named: Any) -> Any:
            self._uses.setdefault(self._names[-1], set()).add(name)
            with self.by(name):
                return cached(*arguments, **named)

        for method in ("cache_clear", "cache_info"):
            setattr(watched, method, getattr(cached, method))
        return watched

    @contextmanager
    def by(self, name: str, *uses: str) -> Iterator[None]:
        """What runs inside is reached by this check, and so is what it uses."""
        self._uses.setdefault(name, set()).update(uses)
        self._names.append(name)
        self._coverage.switch_context(name)
        try:
            yield
        finally:
            self._names.pop()
            self._coverage.switch_context(self._names[-1])

    def _used(self, name: str) -> Names:
        """A check and all that it uses, at any depth."""
        found, waiting = {name}, [name]
        while waiting:
            new = self._uses.get(waiting.pop(), set()) - found
            found |= new
            waiting += new
        return found

    def contexts(self) -> dict[tuple[str, int], Names]:
        """By file and line (0 for a template): the names it ran by, "" for outside of all."""
        data = self._coverage.get_data()
        found = {(path, 0): names for path, names in self._templates.items()}
        for file in data.measured_files():
            path = os.path.relpath(file, self.root)
            found |= {(path, line): set(names) for line, names in data.contexts_by_lineno(file).items()}
        return found

    def table(self, checks: Sequence[str]) -> Table:
        """By file and line: the checks that reach it."""
        users: dict[str, Names] = {"": set(checks)}
        for check in checks:
            for name in self._used(check) | self._used(""):
                users.setdefault(name, set()).add(check)

        def of(names: Names) -> Names:
            return set().union(*(users.get(name, set()) for name in names))

        return Table({place: of(names) for place, names in self.contexts().items()})


class Table:
    """Checks by what they reach."""

    def __init__(self, lines: dict[tuple[str, int], Names]) -> None:
        self.lines = lines

    def checks(self, path: str, lines: tuple[int, int]) -> Names:
        """All checks that reach one of the lines."""
        reached = (self.lines.get((path, line), set()) for line in range(lines[0], lines[1] + 1))
        return set().union(*reached)
