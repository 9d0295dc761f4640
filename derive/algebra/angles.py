"""Exact sine and cosine of rational multiples of given angles, by the tangent of a fraction of each angle."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

import sympy

from .element import Element, NotExactError
from .exact import RationalFunctions


class AngleField(RationalFunctions):
    """Field Q(names, angles, tangents, π), with independent generators and an integer M for each angle.

    Sines and cosines of integer multiples of angle/M are elements. An angle and its tangent ``tan(angle/2M)`` are
    algebraically independent generators.
    """

    def __init__(self, names: Sequence[str], angles: Mapping[str, int] | None = None) -> None:
        self.angles = dict(angles or {})
        names = (*names, *(g for name in self.angles for g in (name, f"tan_{name}")), "pi")
        super().__init__(names, {name: self._reference(i, name) for i, name in enumerate(names)})

    def _reference(self, index: int, name: str) -> Fraction:
        """Return a positive reference value; the values of an angle and its ``tan(angle/2M)`` nearly agree."""
        if name == "pi":
            return Fraction(355, 113)
        if name in self.angles:
            return 2 * self.angles[name] * Fraction(1, 37 + 3 * (index + 1))
        return Fraction(1, 37 + 3 * index) if name.startswith("tan_") else Fraction(int(sympy.prime(index + 2)), 3)

    def cos(self, a: Element) -> Element:
        """Return the cosine of a rational multiple of an angle of the field."""
        return self._circle(a)[0]

    def sin(self, a: Element) -> Element:
        """Return the sine of a rational multiple of an angle of the field."""
        return self._circle(a)[1]

    def atan2(self, y: Element, x: Element) -> Element:
        """Return the angle of the point (x, y) as k/M times an angle of the field, |k| ≤ 2M, or raise NotExactError."""
        for name, steps in self.angles.items():
            for k in range(-2 * steps, 2 * steps + 1):
                multiple = self.symbol(name) * Fraction(k, steps)
                cosine, sine = self._circle(multiple)
                if y * cosine == x * sine and (y * sine + x * cosine).sign() > 0:
                    return multiple
        raise NotExactError(f"no multiple of an angle: that of ({x!r}, {y!r})")

    def _circle(self, a: Element) -> tuple[Element, Element]:
        """Return cosine and sine of a sum of rational multiples of angles."""
        turns, *multiples = a.combination([self.symbol(name) for name in ("pi", *self.angles)])
        steps = [multiple * count for multiple, count in zip(multiples, self.angles.values(), strict=True)]
        if any(part.denominator != 1 for part in (2 * turns, *steps)):
            raise NotExactError(f"no rational multiple of an angle: {a!r}")
        c, s = self._turned(None, 0, int(2 * turns) % 4)
        for name, count in zip(self.angles, steps, strict=True):
            if not count:
                continue
            cosine, sine = self._turned(name, int(count), 0)
            c, s = c * cosine - s * sine, c * sine + s * cosine
        return c, s

    def _turned(self, name: str | None, steps: int, quarters: int) -> tuple[Element, Element]:
        """Return cosine and sine of ``steps · angle/M`` plus `quarters` quarter turns."""
        c, s = self.constant(1), self.constant(0)
        if steps:
            t = self.symbol(f"tan_{name}")
            cosine, sine = (1 - t * t) / (1 + t * t), (2 if steps > 0 else -2) * t / (1 + t * t)
            for _ in range(abs(steps)):
                c, s = c * cosine - s * sine, c * sine + s * cosine
        for _ in range(quarters):
            c, s = -s, c
        return c, s
