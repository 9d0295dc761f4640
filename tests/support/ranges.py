"""Range of v that the kernels of an order accept; longer vectors give NaN."""

from __future__ import annotations

import numpy as np
from numpy.typing import DTypeLike

from derive.maps import Cayley


def largest(order: int, dtype: DTypeLike) -> np.longdouble:
    """Return the largest |Re v| for which powers of 1 + x and their multiples are finite in a type."""
    most = np.longdouble(np.finfo(dtype).max) / (4 * order)
    return np.longdouble(Cayley(order).overflow(most)[1])  # type: ignore[arg-type]  # wider than float


def in_range(order: int, v: np.ndarray) -> bool:
    """Return whether v lies in the range."""
    return bool(np.sqrt(1 + np.sum(v[:3].astype(np.longdouble) ** 2)) < largest(order, v.dtype))
