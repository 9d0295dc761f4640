"""Runs of the example sessions in docstrings and pages."""

from __future__ import annotations

import doctest
import inspect
from collections.abc import Iterable, Mapping
from typing import Any


def failures(text: str, name: str, names: dict[str, Any] | None = None) -> str:
    """Run the examples in a text one after another; return differences from their printed results, '' if all agree.

    Parameters
    ----------
    text, name : str
        Text, and its name in the returned differences.
    names : dict, optional
        Names that the examples may use; the examples add the names they assign.
    """
    test = doctest.DocTestParser().get_doctest(text, names or {}, name, None, 0)
    said: list[str] = []
    if not test.examples:
        return f"{name} has no example\n"
    doctest.DocTestRunner(verbose=False).run(test, out=said.append, clear_globs=False)
    if names is not None:
        names.update(test.globs)
    return "".join(said)


def of_docstrings(functions: Iterable[Any], names: Mapping[str, Any] | None = None) -> str:
    """Return the failures in docstrings of functions; each docstring runs alone, with the given names."""
    return "".join(failures(inspect.getdoc(one) or "", one.__qualname__, dict(names or {})) for one in functions)
