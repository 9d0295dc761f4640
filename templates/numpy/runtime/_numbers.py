"""Functions that kernels call beyond + - * /, for each kind of number that runs pose by pose."""

from __future__ import annotations

import math
from functools import cache
from operator import add
from typing import Any

import numpy as np

from ._kernel import Result

FLOAT = np.dtype(np.float64)
SINGLE = np.dtype(np.float32)

ROUNDOFF = 2.0**-24
"""Unit roundoff of float32, the largest rounding error of a number as a share of it."""


class Floats:
    """Functions that kernels call, for Python floats."""

    @staticmethod
    def reciprocals(like: Any, *integers: int) -> Result:
        return _reciprocals(integers)

    beside = staticmethod(add)
    abs = staticmethod(abs)
    sqrt = staticmethod(math.sqrt)
    tan = staticmethod(math.tan)
    atan2 = staticmethod(math.atan2)
    expm1 = staticmethod(math.expm1)
    log1p = staticmethod(math.log1p)

    @staticmethod
    def where(condition: Any, a: Any, b: Any) -> Any:
        return a if condition else b


@cache
def _reciprocals(integers: tuple[int, ...]) -> Result:
    return tuple(1 / integer for integer in integers)


class Singles(Floats):
    """Functions that kernels call, for Python floats that hold data of float32."""

    @staticmethod
    def beside(size: float, term: float) -> float:
        """Return size + term, or the size where float32 would: for terms up to half the spacing of its numbers there.

        The size is 0 or in the normal range of float32, and not negative. The spacing below a power of two is half of
        that above. Rounding the sum would also round a size between numbers of float32, and any term could move it.
        """
        share, power = math.frexp(size)
        half = math.ldexp(share and (1 if share > 0.5 or term > 0 else 0.5), power - 25)
        return size if -half <= term <= half else size + term


class Objects:
    """Functions that kernels call, for objects with their own ``sqrt``, ``tan`` and the like."""

    @staticmethod
    def reciprocals(like: Any, *integers: int) -> Result:
        return tuple((like - like + 1) / integer for integer in integers)

    beside = staticmethod(add)
    abs = staticmethod(abs)
    sqrt = staticmethod(np.sqrt)
    tan = staticmethod(np.tan)
    atan2 = staticmethod(np.arctan2)
    expm1 = staticmethod(np.expm1)
    log1p = staticmethod(np.log1p)
    where = staticmethod(Floats.where)


class Scalars(Objects):
    """Functions that kernels call, for NumPy's numbers of longdouble."""


FUNCTIONS: dict[np.dtype[Any], type[Floats | Objects]] = {
    np.dtype(np.longdouble): Scalars,
    SINGLE: Singles,
    FLOAT: Floats,  # last, for platforms where longdouble is equal to it
}
"""Functions by which a few poses of these dtypes run one by one."""
