"""Which v the kernels of an order take: of larger ones results are NaN."""

from __future__ import annotations

import numpy as np
from numpy.typing import DTypeLike

from derive.maps import Cayley


def largest(order: int, dtype: DTypeLike) -> np.longdouble:
    """Up to which Re|v| powers of 1 + x, with the factors that stand beside them, are numbers of a type."""
    most = np.longdouble(np.finfo(dtype).max) / (4 * order)
    return np.longdouble(Cayley(order).overflow(most)[1])  # type: ignore[arg-type]  # wider than float


def in_range(order: int, v: np.ndarray) -> bool:
    """Whether they are at v."""
    return bool(np.sqrt(1 + np.sum(v[:3].astype(np.longdouble) ** 2)) < largest(order, v.dtype))
