"""Seeded numbers, vectors and quaternions of 60 digits."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import mpmath

from ...algebra import Dual, Quaternion, Vector
from .fields import Decimal60


class Draw:
    """Source of 60-digit numbers with `digits` random decimals, all determined by the seed.

    Coefficients carry time derivatives if `moving`, as in `derive.papers.language.environment.Env`.
    """

    def __init__(self, seed: str, moving: bool = False, digits: int = 30) -> None:
        self.random = random.Random(seed)
        self.moving = moving
        self.digits = digits

    def real(self, low: float = 0.2, high: float = 0.9) -> Any:
        """Return a positive number."""
        scale = 10**self.digits
        return mpmath.mpf(self.random.randint(int(low * scale), int(high * scale))) / scale

    def signed(self) -> Any:
        """Return a number of either sign, away from 0."""
        return self.real() * self.random.choice((-1, 1))

    def signed3(self) -> tuple[Any, Any, Any]:
        """Return three numbers of either sign."""
        return self.signed(), self.signed(), self.signed()

    def plain(self, value: Any, slope: Any = 0) -> Any:
        """Return a coefficient, with the time derivative `slope` if symbols move."""
        return Dual(mpmath.mpf(value), mpmath.mpf(slope)) if self.moving else mpmath.mpf(value)

    def scalar(self, value: Any) -> Any:
        """Return a real number; in motion with a random rate, and with dual part 0."""
        return self.lifted(self.plain(value, self.signed())) if self.moving else value

    def lifted(self, part: Any) -> Any:
        """Return a real part as a number: in motion, with dual part 0."""
        return Dual(part, 0 * part) if self.moving else part

    def number(self, re: Any, du: Any | None = None) -> Any:
        """Return a dual number with a random dual part by default; parts of moving symbols get random rates."""
        du = self.signed() if du is None else du
        rate = self.signed if self.moving else int
        return Dual(self.plain(re, rate()), self.plain(du, rate()))

    def vector(self, re: tuple[Any, ...] | None = None, du: tuple[Any, ...] | None = None) -> Vector:
        """Return a dual vector; parts that are not given are random."""
        a = re or self.signed3()
        b = du or self.signed3()
        return Vector(*(self.number(s, t) for s, t in zip(a, b, strict=True)))

    def still(self, re: tuple[Any, ...], du: tuple[Any, ...]) -> Vector:
        """Return a dual vector with zero time derivatives."""
        return Vector(*(Dual(self.plain(s), self.plain(t)) for s, t in zip(re, du, strict=True)))

    def unit(self) -> Vector:
        """Return a unit dual vector, by stereographic projection from two dual numbers."""
        return sphere(self.number(self.signed()), self.number(self.signed()))

    def quaternion(self, half_angle: Any) -> Quaternion:
        """Return a unit dual quaternion about a random screw axis; `half_angle` is the real part of its half angle."""
        angle, field = self.number(mpmath.mpf(half_angle)), Decimal60()
        return Quaternion(field.cos(angle), self.unit() * field.sin(angle))


def sphere(s: Any, t: Any) -> Vector:
    """Return ``(2s, 2t, 1 − s² − t²)/(1 + s² + t²)``: any unit vector except (0, 0, −1)."""
    square = s * s + t * t
    return Vector(2 * s / (1 + square), 2 * t / (1 + square), (1 - square) / (1 + square))


def jet(value: Any, rates: Sequence[Any]) -> Any:
    """Return a number with its rates: of first order as one dual number, of second order as nested dual numbers."""
    return Dual(jet(value, rates[:-1]), jet(rates[0], rates[1:])) if rates else value


@dataclass(frozen=True)
class Smooth:
    """Differentiable function of plain or dual numbers, with its derivative at plain numbers."""

    value: Callable[[Any], Any]
    derivative: Callable[[Any], Any]

    def __call__(self, a: Any) -> Any:
        return self.value(a)


def polynomial(coefficients: Sequence[Any]) -> Smooth:
    """Return the polynomial with coefficients in ascending order."""

    def horner(numbers: Sequence[Any], a: Any) -> Any:
        return reduce(lambda total, c: total * a + c, reversed(numbers), 0)

    slopes = [k * c for k, c in enumerate(coefficients)][1:]
    return Smooth(lambda a: horner(coefficients, a), lambda a: horner(slopes, a))
