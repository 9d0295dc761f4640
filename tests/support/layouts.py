"""Views with axes of length 1 of any stride, which NumPy's flags of contiguity ignore."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from numpy.lib.stride_tricks import as_strided

BATCHES = ((1,), (1, 1), (5, 1), (1, 5), (2, 1, 3), (1, 5, 1))
"""Batch shapes with axes of length 1 in every place."""

STRIDES = (0, 8, -48, 3, 2**45, -(2**62))
"""Strides of views such as ``v[:, None]`` and of reversed ones, and strides between numbers or out of all memory."""


def restrided(array: np.ndarray, first: int = 0) -> Iterator[np.ndarray]:
    """Yield views of the same numbers, with each of `STRIDES` along axes of length 1, the ``first`` before others."""
    for stride in STRIDES[first:] + STRIDES[:first]:
        strides = [stride if count == 1 else own for count, own in zip(array.shape, array.strides, strict=True)]
        yield as_strided(array, array.shape, strides)


def require_strides_of_one_ignored(
    function: Callable[..., Any], arguments: Sequence[np.ndarray], same: Callable[[Any, Any], None], out: bool = True
) -> None:
    """Require the result for plain arrays from views of any stride, each argument with another one, and in ``out``."""
    expected = function(*arguments)
    for given in zip(*(restrided(array, first) for first, array in enumerate(arguments)), strict=True):
        same(function(*given), expected)
    for target in restrided(np.full_like(expected, np.nan)) if out else ():
        target[...] = np.nan
        assert function(*arguments, out=target) is target
        same(target, expected)
