"""Sessions in docstrings and pages, run as they are printed."""

from __future__ import annotations

import doctest
import inspect
from collections.abc import Iterable, Mapping
from typing import Any


def failures(text: str, name: str, names: dict[str, Any] | None = None) -> str:
    """What differs when the examples in a text are run one after the other, nothing where none does.

    Parameters
    ----------
    text, name : str
        The text, and what it is called in what is returned.
    names : dict, optional
        What the examples know; what they assign stays in it.
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
    """Return the failures of the docstrings of functions, each run by itself with the names that examples assume."""
    return "".join(failures(inspect.getdoc(one) or "", one.__qualname__, dict(names or {})) for one in functions)
