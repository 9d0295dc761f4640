"""Conditions of jumps after operations on integers, as the helpers of intermediate code compute them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from .trees import Declined
from .words import known, ones, signed


def _flags(group: int, width: int, one: int, two: int) -> tuple[int, bool, bool, bool]:
    """Return the result of a sum, a difference or a logical operation, and its carry, sign and overflow."""
    a, b = one & ones(width), two & ones(width)
    if group not in (0, 1, 4):
        raise Declined("flags of an operation that is not known")
    made, exact = a, signed(a, width)
    if group < 4:
        made, exact = (a + b, exact + signed(b, width)) if group == 0 else (a - b, exact - signed(b, width))
    carry = made > ones(width) if group == 0 else group == 1 and a < b
    result = made & ones(width)
    return result, carry, bool(result >> 8 * width - 1), signed(result, width) != exact


def _condition_amd64(condition: Any, operation: Any, one: Any, two: Any, _: Any) -> int:
    """Return whether a condition holds after an operation on integers, or of flags that were copied."""
    condition, operation, one, two = map(known, (condition, operation, one, two))
    if operation == 0:
        carry, parity, zero, negative, overflow = (bool(one >> bit & 1) for bit in (0, 2, 6, 7, 11))
    else:
        group, size = divmod(operation - 1, 4)
        result, carry, negative, overflow = _flags(group, 1 << size, one, two)
        zero, parity = not result, not (result & 0xFF).bit_count() & 1
    less = negative != overflow
    holds = (overflow, carry, zero, carry or zero, negative, parity, less, less or zero)[condition >> 1]
    return int(holds != bool(condition & 1))


def _condition_arm64(both: Any, one: Any, two: Any, _: Any) -> int:
    """Return whether a condition holds, as `_condition_amd64` does; after a difference the carry is turned."""
    both, one, two = map(known, (both, one, two))
    condition, operation = divmod(both, 16)
    if operation == 0:
        negative, zero, carry, overflow = (bool(one >> bit & 1) for bit in (31, 30, 29, 28))
    else:
        group, size = divmod(operation - 1, 2)
        result, carry, negative, overflow = _flags(group, 8 if size else 4, one, two)
        zero, carry = not result, carry != (group == 1)
    alike = negative == overflow
    holds = (zero, carry, negative, overflow, carry and not zero, alike, alike and not zero, True)[condition >> 1]
    return int(holds != bool(condition & 1) or condition == 15)


CONDITIONS: Mapping[str, Callable[..., int]] = {
    "amd64g_calculate_condition": _condition_amd64,
    "arm64g_calculate_condition": _condition_arm64,
}
"""Helpers of intermediate code by their names."""
