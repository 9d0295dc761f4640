"""Orders of the packages of other targets that tests share."""

from __future__ import annotations

ORDERS = {"array-api": (1, 2, 3, 8), "numba": (1, 2, 3, 4, 8), "c": (1, 2, 3, 8, 16)}
