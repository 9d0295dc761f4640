"""Execute a C header as text: every function on exact elements and at 50 digits, in all the ways it may be called."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import mpmath
import sympy

from ...maps import Cayley
from ..signatures import SIGNATURES
from . import digits, exact
from .c_calls import Flat, Kernel
from .c_interpreter import UNSET, CError, Pointer, Unit, load
from .digits import Decimal
from .exact import Expectation
from .run import ValidationFailed

SEED = 1863
ROWS = 3
SAMPLES = 2
"""Batches of each function, at most, on which results overlap arguments."""

ALIASES = {
    "dcay": "tangent", "dcay_rows": "tangent_rows", "dcay_inv": "tangent_inv", "dcay_inv_rows": "tangent_inv_rows",
}  # fmt: skip

Agree = Callable[[Any, Any], bool]


def validate(folder: Path, cayley: Cayley) -> int:
    """Interpret the header of an order; return how many calls equal the formula.

    Both forms are called: the rational functions on symbols, the others on numbers of 50 digits. On such numbers results
    are then laid over arguments, at every distance and row by row, and must not change by a bit.

    Raises
    ------
    ValidationFailed
        Naming the function, or the line that is no C, divides integers, leaves an array, reads what was not written.
    """
    header = f"cayley{cayley.order}.h"
    try:
        unit = load(f'#include "{header}"\n', folder)
        with mpmath.workdps(digits.DIGITS):
            calls = _values(unit, cayley) + _layouts(unit, cayley)
            _constants(unit, cayley)
    except CError as error:
        raise ValidationFailed(f"{header}: {error}") from error
    if unit.idle:
        raise ValidationFailed(f"{header}: nothing calls {', '.join(unit.idle)}, so nothing says what they compute")
    return calls


def _prefix(cayley: Cayley) -> str:
    return f"dualcay_cayley{cayley.order}_"


def _kernel(unit: Unit, cayley: Cayley, function: str) -> Kernel:
    """The function an expectation names, with its branch."""
    name, *branch = function.split()
    default = [0] if SIGNATURES[name].branch and not branch else []
    return Kernel(unit, _prefix(cayley), name, tuple(map(int, branch or default)))


def _values(unit: Unit, cayley: Cayley) -> int:
    """Compare both forms of every function with what it must return."""
    exactly = sum(_batch(unit, cayley, (case,), _same) for case in exact.expectations(cayley))
    closely = (tuple(map(_decimal, batch)) for batch in digits.expectations(cayley))
    return exactly + sum(_batch(unit, cayley, batch, digits.close) for batch in closely)


def _batch(unit: Unit, cayley: Cayley, batch: Sequence[Expectation], agree: Agree) -> int:
    kernel = _kernel(unit, cayley, batch[0].function)
    for case in batch:
        _compare(case.function, kernel.plain(case.arguments), case.result, agree)
    for row, case in zip(kernel.rows([case.arguments for case in batch]), batch, strict=True):
        _compare(f"{case.function}, rows", row, case.result, agree)
    return len(batch) + 1


def _layouts(unit: Unit, cayley: Cayley) -> int:
    """Lay results over arguments, and choose branches by other integers: not a bit of the plain result may change."""
    calls = 0
    for function, batch in _samples(cayley):
        kernel = _kernel(unit, cayley, function)
        expected = [kernel.plain(arguments) for arguments in batch]
        room = sum(array.size for array in (*kernel.signature.arguments, *kernel.signature.results))
        for start in range(room):
            _compare(f"{function}, overlapping", kernel.shared(batch[0], start), expected[0], _same)
        for over in (None, *range(len(batch[0]))):
            for row, result in zip(kernel.rows(batch, over), expected, strict=True):
                _compare(f"{function}, rows over argument {over}", row, result, _same)
        for turns in (-1, 2) if kernel.branch else ():
            other = Kernel(unit, kernel.prefix, kernel.name, (kernel.branch[0] + turns * cayley.order,))
            _compare(f"{function}, branch {other.branch[0]}", other.plain(batch[0]), expected[0], _same)
        calls += room + len(batch[0]) + 1 + 2 * len(kernel.branch)
    return calls


def _samples(cayley: Cayley) -> Iterator[tuple[str, list[tuple[Flat, ...]]]]:
    """Arguments of 50 digits for every function: the seeded ones of two branches, any for a rational function."""
    taken: Counter[str] = Counter()
    for batch in digits.expectations(cayley):
        function = batch[0].function
        _, *branch = function.split()
        taken[function] += 1
        if taken[function] <= SAMPLES and branch in ([], ["0"], ["1"]):
            yield function, [_decimal(case).arguments for case in (batch * ROWS)[:ROWS]]
    draw = random.Random(SEED)
    for name, signature in SIGNATURES.items():
        if name not in {function.split()[0] for function in taken}:
            sizes = [array.size for array in signature.arguments]
            yield name, [tuple(_drawn(draw, size) for size in sizes) for _ in range(ROWS)]


def _drawn(draw: random.Random, size: int) -> Flat:
    return tuple(Decimal(mpmath.mpf(draw.uniform(-0.5, 0.5))) for _ in range(size))


def _constants(unit: Unit, cayley: Cayley) -> None:
    """What the macros of the header stand for, and the singular angles."""
    ratios = [angle / sympy.pi for angle in cayley.singular_angles]
    macro = _prefix(cayley).upper()
    expected = {f"{macro}ORDER": str(cayley.order), f"{macro}SINGULAR_ANGLES": str(len(ratios))}
    expected |= {_prefix(cayley) + alias: _prefix(cayley) + name for alias, name in ALIASES.items()}
    for name, text in expected.items():
        if unit.source.expand(name) != text:
            raise ValidationFailed(f"{name} is {unit.source.expand(name)}, not {text}")
    angles = [UNSET] * len(ratios)
    if unit.call(f"{_prefix(cayley)}singular_angles", Pointer.to(angles)) != len(ratios):
        raise ValidationFailed(f"singular_angles does not return {len(ratios)}")
    _compare("singular_angles", angles, [mpmath.pi * int(r.p) / int(r.q) for r in ratios], digits.close)


def _decimal(case: Expectation) -> Expectation:
    arguments = tuple(tuple(map(Decimal, argument)) for argument in case.arguments)
    return Expectation(case.function, arguments, case.result)


def _compare(where: str, found: Sequence[Any], expected: Sequence[Any], agree: Agree) -> None:
    for index, (got, wanted) in enumerate(zip(found, expected, strict=True)):
        if not agree(got, wanted):
            raise ValidationFailed(f"{where}, component {index}: {got} is not {wanted}")


def _same(got: Any, expected: Any) -> bool:
    return bool(got == expected)
