"""What the module of a chart says besides its programs: header, constants, angles, in the words templates ask for."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath
import numpy as np
import sympy

from ..maps import Formula
from ..maps.chart import Chart
from ..proof import Proof, Proved, theorems
from .lowered import Lowered
from .programs.program import summary

DIGITS = 40
"""Decimal digits of printed constants: enough for longdouble, and for validation at 30 digits."""

WIDTH = 110

LICENCE = "SPDX-License-Identifier: BSD-3-Clause"


@dataclass(frozen=True)
class Facts:
    """A proved chart and its programs, as told in its module."""

    proved: Proved
    lowered: Lowered

    @property
    def chart(self) -> Chart:
        return self.proved.formulas

    @property
    def parameter(self) -> str:
        """φ(α) as comments of any language can hold it."""
        return self.chart.parameter.replace("α", "alpha")

    @cached_property
    def turns(self) -> list[tuple[str, str]]:
        """The two numbers of the turn by every branch, as decimals; of one where there is no end of them."""
        with mpmath.workdps(DIGITS + 10):
            first, second = zip(*map(self.chart.turn, range(self.chart.branches) or [1]), strict=True)
            return list(zip(map(_decimal, first), map(_decimal, second), strict=True))

    @cached_property
    def returns(self) -> list[tuple[str, ...]]:
        """The rows of the table of returns, as decimals."""
        with mpmath.workdps(DIGITS + 10):
            return [tuple(map(_decimal, row)) for row in self.chart.returns()]

    @property
    def singular_angles(self) -> list[str]:
        return [_multiple_of_pi(angle) for angle in self.chart.singular_angles]

    @property
    def maps(self) -> tuple[Formula, ...]:
        chart = self.chart
        return chart.quaternion, chart.tensor, chart.tangent, chart.tangent_inv

    def definitions(self, indent: str) -> dict[str, str]:
        """The formulas of the maps in LaTeX, broken into lines."""
        return {
            f.name: f"\n{indent}".join(textwrap.wrap(f"{f.symbol} = {f.definition}", WIDTH, break_long_words=False))
            for f in self.maps
        }

    @property
    def domain(self) -> dict[str, str]:
        return {f.name: f.domain for f in self.maps}

    @property
    def singular(self) -> dict[str, str]:
        return {f.name: f.singular for f in self.maps}

    @property
    def overflow(self) -> str:
        """Why forward maps are NaN for large v."""
        return self.chart.overflow(1)[0]

    @property
    def largest(self) -> dict[str, str]:
        """Up to which Re|v| they are not, by type."""
        largest = ((name, float(np.finfo(name).max)) for name in ("float32", "float64"))
        return {name: f"{self.chart.overflow(most)[1]:.1g}" for name, most in largest}

    def header(self, command: str, template: str) -> list[str]:
        """Lines of the header: command, formulas, what was proved, operation counts."""
        chart = self.chart
        lines = [*head(command, template), "", f"{chart.title}, v = {self.parameter} u; formulas, x = v.v (CP23):"]
        lines += [f"  {letter} = {_plain(value)}" for letter, value in chart.letters]
        for item in self.maps:
            lines.append(f"  {', '.join(filter(None, (item.name, numbers(item.equations))))}:")
            basis = (symbol.replace(r"\tilde{v}", "skew(v)").replace(r" \otimes ", "(x)") for symbol in item.basis)
            pairs = zip(basis, item.coefficients, strict=True)
            lines += [f"    {symbol or '1'}: {_plain(coefficient)}" for symbol, coefficient in pairs]
        lines += ["", "Proved exactly, besides the theorems in the header of the interface:"]
        lines += statements(proof for proof in self.proved.proofs if proof not in theorems())
        lines += ["", "Operations:"]
        lines += [f"  {name}: {summary(count)}" for name, count in self.lowered.operations.items()]
        return lines


def statements(proofs: Iterable[Proof]) -> list[str]:
    """What was proved, a line each."""
    return [f"  [{proof.scope}] {proof.name}: {proof.statement}" for proof in proofs]


def operations(lowered: Lowered) -> list[str]:
    """Lines of the header of a module for another table than that of poses."""
    counts = ", ".join(f"{name} {count.total()}" for name, count in lowered.operations.items())
    return ["What was proved is told in the module for poses. Operations:", f"  {counts}"]


def theorem_lines() -> list[str]:
    """What holds for every order, for the header of the files that all charts share."""
    return ["Proved exactly, for every order n of a Cayley map:", *statements(theorems())]


def head(command: str, template: str) -> list[str]:
    """The first lines of a generated file: what makes it, its licence, where it comes from."""
    return [command, LICENCE, f"Generated by the command above from templates/{template}: change that, not this file."]


def comment(lines: Iterable[str], mark: str) -> str:
    """Lines as comment lines, the long ones broken."""
    wrapped = [part for line in lines for part in _wrap(line)]
    return "\n".join(f"{mark} {line}".rstrip() for line in wrapped)


def numbers(equations: Iterable[int]) -> str:
    """Equation numbers in brackets."""
    return ", ".join(f"({number})" for number in equations)


def _wrap(line: str) -> list[str]:
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    return textwrap.wrap(line, WIDTH, subsequent_indent=indent, drop_whitespace=True) or [""]


def _plain(expression: sympy.Expr) -> str:
    return str(sympy.sstr(expression, order="rev-lex")).replace("**", "^")


def _decimal(value: Any) -> str:
    return str(mpmath.nstr(value, DIGITS, min_fixed=-DIGITS))


def _multiple_of_pi(angle: sympy.Expr) -> str:
    factor = angle / sympy.pi
    if not factor.is_Rational:
        with mpmath.workdps(DIGITS + 10):
            return _decimal(mpmath.mpf(angle.evalf(DIGITS + 10)))
    above = "pi" if factor.p == 1 else f"{factor.p} * pi"
    return above if factor.q == 1 else f"{above} / {factor.q}"  # 3/2 would be 1 in C
