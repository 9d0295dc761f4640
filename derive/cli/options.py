"""Parsed options: lists of orders, names to show."""

from __future__ import annotations

import re
from typing import Any

import click


class OrderList(click.ParamType[tuple[int, ...]]):
    """Orders such as ``7``, ``1-5,8``: integers and ranges, separated by commas."""

    name = "orders"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[int, ...]:
        """Return the orders, sorted, each once."""
        if isinstance(value, tuple):
            return value
        orders: set[int] = set()
        for part in str(value).split(","):
            found = re.fullmatch(r"\s*(\d+)\s*(?:-\s*(\d+)\s*)?", part)
            if found is None:
                self.fail(f"expected orders such as 7 or 1-5,8, got {value!r}", param, ctx)
            first = int(found.group(1))
            last = int(found.group(2) or first)
            if first < 1:
                self.fail(f"an order is an integer n >= 1, got {part.strip()}", param, ctx)
            if last < first:
                self.fail(f"the range {part.strip()} runs backwards", param, ctx)
            if last - first > 10_000:
                self.fail(f"the range {part.strip()} holds more than 10000 orders", param, ctx)
            orders.update(range(first, last + 1))
        return tuple(sorted(orders))

class NameList(click.ParamType[tuple[str, ...]]):
    """Names out of a fixed set, separated by commas."""

    name = "names"

    def __init__(self, choices: tuple[str, ...]) -> None:
        self.choices = choices

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[str, ...]:
        """Return the names in the given order."""
        if isinstance(value, tuple):
            return value
        names = tuple(part.strip() for part in str(value).split(","))
        unknown = [name for name in names if name not in self.choices]
        if unknown:
            given = ", ".join(map(repr, unknown))
            self.fail(f"expected names out of {', '.join(self.choices)}, got {given}", param, ctx)
        return names

def require_cap(orders: tuple[int, ...], cap: int) -> None:
    """Refuse an order above the cap, naming the option that raises it."""
    if orders and orders[-1] > cap:

        raise click.BadParameter(f"order {orders[-1]} is above the cap {cap}; raise it with --max-n", param_hint="-n")
