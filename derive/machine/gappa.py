"""Scripts of Gappa that bound the rounding errors of emitted C programs, read back from the text on disk.

A script holds a straight-line program twice: with every operation rounded to double, and in real arithmetic. Arguments
have |v| ≤ 1 and a translation of length at most 1.
"""

from __future__ import annotations

import ast
import math
import operator
import re
import shutil
import subprocess
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import sympy

from ..maps import Cayley
from ..maps.polynomials import x
from .c_text import CText
from .definitions import V
from .statements import MachineError
from .terms import Program, ReadError

EPS = Fraction(1, 2**52)
"""Unit of bounds and errors, the distance from 1 to the next double."""

STEPS = 16
"""Steps of a bound per eps."""

SLACK = Fraction(102, 100)
"""Factor from a found bound to its claim. Gappa drops improvements of a result below 1 %, so its own bound may fail."""

SPLITS = 16
"""Parts of the range of |v|, each bounded alone. Twice as many lower the bounds by a sixth, in twice the time."""

TIME_LIMIT = 300
"""Seconds for one script, ten times the time of the slowest."""

NAMES = ("square", "reach", "length", "cosine")
"""Names in premises, which no step of a program may have."""

OPERATIONS: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
}  # fmt: skip


# --- Programs ---------------------------------------------------------------------------------------------------------


def integer(value: Fraction | int) -> str:
    """Return an integer as a term; other constants are refused."""
    if value != int(value):
        raise ReadError(f"{value} is not read here: only integers are")
    return str(int(value))


def read(folder: Path, function: str, order: int) -> Program:
    """Read a function of a C header with the scalar program that it calls."""
    return CText(folder / f"cayley{order}.h", f"dualcay_cayley{order}_", integer).program(function, (V,), {})


def value(term: str, known: Mapping[str, Any], sqrt: Callable[[Any], Any]) -> Any:
    """Return the value of a term on any numbers, by name.

    Examples
    --------
    >>> value("((2 * x) / y)", {"x": Fraction(1), "y": Fraction(3)}, math.sqrt)
    Fraction(2, 3)
    """

    def of(node: ast.AST) -> Any:
        match node:
            case ast.Constant(value=int() as constant):
                return constant
            case ast.Name(id=name):
                return known[name]
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return -of(operand)
            case ast.BinOp(left=left, op=operation, right=right):
                return OPERATIONS[type(operation)](of(left), of(right))
            case ast.Call(func=ast.Name(id="sqrt"), args=[argument]):
                return sqrt(of(argument))
        raise ReadError(f"{term} is not read here")

    return of(ast.parse(term, mode="eval").body)


def values(program: Program, inputs: Mapping[str, Any], sqrt: Callable[[Any], Any]) -> dict[str, Any]:
    """Return the values of all steps of a program on any numbers, by name."""
    known = dict(inputs)
    for (name,), term in program.steps:
        known[name] = value(term, known, sqrt)
    return known


def outputs(program: Program) -> tuple[int, ...]:
    """Return the outputs that are not constant."""
    return tuple(i for i, term in enumerate(program.results) if re.search("[a-z]", term))


# --- Scripts ----------------------------------------------------------------------------------------------------------


def reach(order: int) -> str:
    """Return the largest dual part of v for a translation of length 1, as a term of ``square`` = v·v.

    The dual part is T⁻¹ times the translation. T⁻¹ stretches vectors across v by |p/(2q) + i|v|/2|, which is
    (1 + v·v)^(n/2) / (2q), and vectors along v by (1 + v·v) / (2n), which is not larger for |v| ≤ 1.
    """
    factors = ["(1 + square)"] * (order // 2) + ["sqrt(1 + square)"] * (order % 2)
    q = sympy.horner(Cayley(order).q.subs(x, sympy.Symbol("square")))
    return f"({' * '.join(factors)}) / (2 * ({q}))"


def premises(program: Program, order: int) -> Iterator[str]:
    """Yield what Gappa may assume: ranges, and exact values of steps, which are decided as polynomials.

    v is length times a vector, its dual part is reach times another, both of length at most 1. The cosine is that of
    the angle between them.
    """
    yield "length in [0, 1]"
    yield from (f"{name} in [-1, 1]" for name in ("cosine", *(f"{each}_unit" for each in V)))
    symbols = sympy.symbols(V)
    v, dual = symbols[:3], symbols[3:]
    dot, slope = (sum(a * b for a, b in zip(v, other, strict=True)) for other in (v, dual))
    forms = {
        sympy.expand(dot): "square",
        sympy.expand(slope): "length * reach * cosine",
        sympy.expand((1 + dot) ** order): " * ".join(["(1 + square)"] * order),
    }
    for name, found in values(program, dict(zip(V, symbols, strict=True)), sympy.sqrt).items():
        if found.is_polynomial(*symbols) and (form := forms.get(sympy.expand(found))):
            yield f"{name}_exact - ({form}) in [0, 0]"


def script(program: Program, order: int, claims: Mapping[int, str]) -> str:
    """Return the script of Gappa that proves claims on outputs, such as ``in ?`` or ``in [-1b-50, 1b-50]``."""
    steps = [(name, term) for (name,), term in program.steps]
    steps += [(f"result{i}", program.results[i]) for i in claims]
    lines = ["@rnd = float<ieee_64, ne>;", "square = length * length;", f"reach = {reach(order)};"]
    lines += [f"{name} = {'length' if i < 3 else 'reach'} * {name}_unit;" for i, name in enumerate(V)]
    lines += [f"{name} rnd= {term};" for name, term in steps]
    lines += [f"{name}_exact = {_exact(term)};" for name, term in steps]
    if clashing := {*NAMES, *V, *(f"{each}_unit" for each in V)} & {name for name, _ in steps}:
        raise ReadError(f"{program.place}: the name {min(clashing)} is one of the premises")
    goals = [f"result{i} - result{i}_exact {claim}" for i, claim in claims.items()]
    lines.append(f"{{ {_all(list(premises(program, order)))}\n->\n{_all(goals)} }}")
    ratios = {found for _, term in steps for found in re.findall(r"\((\w+) / \1\)", term)}
    hints = [f"{each} / {each} -> 1 {{{each} <> 0}};" for name in sorted(ratios) for each in (name, f"{name}_exact")]
    return "\n".join([*lines, *hints, f"$ length in {SPLITS};", ""])


def _exact(term: str) -> str:
    """Return a term of the exact values of steps."""
    return re.sub(r"[A-Za-z]\w*", lambda word: word[0] if word[0] in (*V, "sqrt") else f"{word[0]}_exact", term)


def _all(parts: Sequence[str]) -> str:
    return "\n/\\ ".join(parts)


def rounded_up(bound: Fraction) -> float:
    """Return a bound in eps a little larger than a found one, in whole steps."""
    return math.ceil(SLACK * bound / EPS * STEPS) / STEPS


def claim(bound: float) -> str:
    """Return the claim that an error is within a bound in eps."""
    steps = round(bound * STEPS)
    scale = int(math.log2(EPS / STEPS))
    return f"in [-{steps}b{scale}, {steps}b{scale}]"


# --- Gappa ------------------------------------------------------------------------------------------------------------


def require() -> None:
    """Raise `MachineError` if Gappa is missing."""
    if shutil.which("gappa") is None:
        raise MachineError("Gappa is needed, and no gappa is found: install it with  apt-get install gappa", 3)


def run(text: str) -> tuple[dict[int, Fraction], str]:
    """Run a script; return the bounds that Gappa prints, by output, and its words on unproved claims."""
    command = ["gappa", "-Edichotomy=0", "-Wno-null-denominator"]
    try:
        done = subprocess.run(command, input=text, capture_output=True, text=True, timeout=TIME_LIMIT, check=False)
    except subprocess.TimeoutExpired:
        return {}, f"Gappa took longer than {TIME_LIMIT} s"
    printed = done.stdout + done.stderr
    _, failed, unproved = printed.partition("Error: some properties were not satisfied:")
    if done.returncode and not failed:
        raise MachineError(f"Gappa cannot read its script: {' '.join(printed.split())}")
    return bounds_of(printed), " ".join(unproved.split())


def bounds_of(printed: str) -> dict[int, Fraction]:
    """Return the largest sizes of the errors in Gappa's table of results, by output.

    Examples
    --------
    >>> bounds_of("  result2 - result2_exact in [-3b-2 {-0.75, -2^(-0.4)}, 0.5 {0.5, 2^(-1)}]")
    {2: Fraction(3, 4)}
    """
    number = r"(-?[\d.]+(?:b-?\d+)?)(?: \{[^}]*\})?"
    found = re.findall(rf"result(\d+) - result\1_exact in \[{number}, {number}\]", printed)
    return {int(i): max(abs(_rational(low)), abs(_rational(high))) for i, low, high in found}


def _rational(text: str) -> Fraction:
    mantissa, _, exponent = text.partition("b")
    return Fraction(mantissa) * Fraction(2) ** int(exponent or 0)
