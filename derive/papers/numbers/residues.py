"""Letters as residues of one large prime: a point at which formulas that are equal for all values are equal.

The values are those of `numbers.generic`, with a residue in place of each independent symbol, so that arithmetic costs
what integers cost. Different formulas agree with odds of about their degree to 2⁶¹: what agrees is decided elsewhere.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import Any

from derive.algebra.exact import NotExactError

from .fields import Exact, Field
from .generic import Generic

PRIME = 2305843009213691579
"""(PRIME − 1)/2 is a prime too: −1 is no square, and odd roots are unique."""

Angle = dict[str, Fraction]


def is_square(a: int) -> bool:
    """Whether a residue has a square root."""
    return square_root(a % PRIME) is not None


def square_root(a: int) -> int | None:
    """The root that is a square itself, which takes the place of the positive one."""
    root = pow(a, (PRIME + 1) // 4, PRIME)
    return root if root * root % PRIME == a else None


class Residue:
    """A residue; one that is a rational combination of angles knows which, for its sine and cosine."""

    __slots__ = ("angle", "value")

    def __init__(self, value: int, angle: Angle | None = None) -> None:
        self.value = value
        self.angle = angle

    def _with(self, other: Any, f: Callable[[int, int], int]) -> Residue:
        value = residue(other)
        return NotImplemented if value is None else Residue(f(self.value, value) % PRIME)

    def __add__(self, other: Any) -> Residue:
        if self.angle is None and type(other) is Residue:
            return Residue((self.value + other.value) % PRIME)
        total = self._with(other, lambda a, b: a + b)
        if self.angle is not None and isinstance(other, Residue) and other.angle is not None:
            names = {**self.angle, **other.angle}
            total.angle = {name: self.angle.get(name, _0) + other.angle.get(name, _0) for name in names}
        elif self.angle is not None and not isinstance(other, Residue) and other == 0:
            total.angle = self.angle
        return total

    __radd__ = __add__

    def __neg__(self) -> Residue:
        return self.__mul__(-1)

    def __pos__(self) -> Residue:
        return self

    def __sub__(self, other: Any) -> Residue:
        if self.angle is None and type(other) is Residue:
            return Residue((self.value - other.value) % PRIME)
        if self.angle is None:
            return self._with(other, lambda a, b: a - b)
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Residue:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> Residue:
        if type(other) is Residue:
            return Residue(self.value * other.value % PRIME)
        product = self._with(other, lambda a, b: a * b)
        if self.angle is not None and isinstance(other, int | Fraction):
            product.angle = {name: c * other for name, c in self.angle.items()}
        return product

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Residue:
        value = residue(other)
        if value is None:
            return NotImplemented
        if value == 0:
            raise ZeroDivisionError("division by zero")
        if isinstance(other, int | Fraction):
            return self.__mul__(Fraction(1) / other)
        return Residue(self.value * pow(value, -1, PRIME) % PRIME)

    def __rtruediv__(self, other: Any) -> Residue:
        value = residue(other)
        return NotImplemented if value is None else Residue(value) / self

    def __pow__(self, exponent: int) -> Residue:
        if exponent < 0 and self.value == 0:
            raise ZeroDivisionError("a negative power of zero")
        return Residue(pow(self.value, exponent, PRIME))

    def __eq__(self, other: object) -> bool:
        value = residue(other)
        return NotImplemented if value is None else self.value == value

    def __hash__(self) -> int:
        return hash(self.value)

    def __bool__(self) -> bool:
        return self.value != 0

    def __abs__(self) -> Residue:
        return self if is_square(self.value) else -self

    def __repr__(self) -> str:
        return f"{self.value} mod {PRIME}"


_0 = Fraction(0)


def residue(a: Any) -> int | None:
    """The residue of a number; none of anything else."""
    if isinstance(a, Residue):
        return a.value
    if isinstance(a, int):
        return a % PRIME
    return a.numerator * pow(a.denominator, -1, PRIME) % PRIME if isinstance(a, Fraction) else None


class Symbols:
    """What `Generic` asks of the functions of its field: constants and the angles with their divisors."""

    def __init__(self, angles: Mapping[str, int]) -> None:
        self.angles = dict(angles)

    def constant(self, value: int | Fraction) -> Residue:
        """A rational number."""
        return Residue(residue(value) or 0)


class Residues(Exact):
    """The field of `PRIME` elements. Squares take the place of positive numbers: all symbols are squares."""

    name = "residues"

    def __init__(self, names: Sequence[str] = (), angles: Mapping[str, int] | None = None) -> None:
        self.functions: Any = Symbols(angles or {})
        self._squares: dict[int, Residue] = {}
        for name in (*self.functions.angles, "pi"):
            self._squares.update({(a * a).value: a for a in self._multiples(name)})

    def symbol(self, name: str) -> Any:
        return Residue(_letter(name), {name: Fraction(1)} if name in self.functions.angles or name == "pi" else None)

    def power(self, base: Any, exponent: Any) -> Any:
        if isinstance(exponent, Fraction) and exponent.denominator > 2 and isinstance(base, Residue):
            raise NotExactError("a root of higher order")
        return Field.power(self, base, exponent)

    def _multiples(self, name: str) -> list[Residue]:
        steps = self.functions.angles.get(name, 1)
        return [self.symbol(name) * Fraction(k, steps) for k in range(1, 4 * steps + 1)]

    def _sqrt(self, a: Any) -> Any:
        value = residue(a) or 0
        if value in self._squares:
            return self._squares[value]
        root = square_root(value)
        if root is None:
            raise NotExactError("not a square")
        return Residue(root)

    def _sin(self, a: Any) -> Any:
        return self._turned(a)[1]

    def _cos(self, a: Any) -> Any:
        return self._turned(a)[0]

    def _atan2(self, y: Any, x: Any) -> Any:
        raise NotExactError("arc tangent")

    def _turned(self, a: Any) -> tuple[Residue, Residue]:
        """Cosine and sine of a combination of the angles."""
        if a == 0 and not isinstance(a, Residue):
            return Residue(1), Residue(0)
        if not isinstance(a, Residue) or a.angle is None:
            raise NotExactError("no rational multiple of an angle")
        c, s = 1, 0
        for name, multiple in a.angle.items():
            steps = multiple * (2 if name == "pi" else self.functions.angles[name])
            if steps.denominator != 1:
                raise NotExactError(f"{multiple} of an angle")
            d, t = _unit_power(name, int(steps) % 4 if name == "pi" else int(steps))
            c, s = (c * d - s * t) % PRIME, (c * t + s * d) % PRIME
        return Residue(c), Residue(s)


@cache
def _letter(name: str, positive: tuple[int, int] = (0, 0)) -> int:
    """A residue that is a square, drawn by the name."""
    for attempt in range(1000):
        drawn = int.from_bytes(hashlib.sha256(f"{name} {attempt}".encode()).digest()[:8], "big") ** 2 % PRIME
        if all(is_square(1 + sign * drawn * drawn) for sign in positive):
            return drawn
    raise ValueError(f"no residue for {name}")


@cache
def _unit_power(name: str, steps: int) -> tuple[int, int]:
    """Cosine and sine of that many steps of an angle, or of quarter turns."""
    if name == "pi":
        return ((1, 0), (0, 1), (-1, 0), (0, -1))[steps]
    t = _letter(f"tan {name}", (1, -1))
    below = pow(1 + t * t, -1, PRIME)
    cosine, sine = (1 - t * t) * below % PRIME, 2 * t * below % PRIME
    c, s = 1, 0
    for _ in range(abs(steps)):
        c, s = (c * cosine - s * sine) % PRIME, (c * sine + s * cosine) % PRIME
    return c, s if steps >= 0 else -s % PRIME


class Reduced(Generic):
    """Generic values as residues."""

    def _field(self, steps: int) -> Exact:
        return Residues((), self._angles(steps))
