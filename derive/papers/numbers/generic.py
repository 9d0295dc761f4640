"""Letters at generic values of an exact field, so that one evaluation decides a statement for all values.

Coordinates are chosen along the vectors at hand: the first vector lies on the first axis, the second in the plane of
the first two. Every operation of the papers is independent of the frame, so nothing is lost. The magnitude X is then no
root, and as the tangent of an angle of the field it leaves ``sqrt(1 + X²)`` rational too. Statements that take dual
numbers apart (ε, Re, Du, real letters) get dual coefficients, and the frame is chosen along the real parts; for all
others an identity of rational functions over Q carries over to dual numbers as it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from derive.algebra import Dual, Quaternion, Tensor, Vector
from derive.proof.ratio import NotExactError

from ..language.evaluation import Definition, Env
from ..language.terms import Apply, Letter, Term, walk
from .every_order import EveryOrder
from .fields import Exact
from .kinds import polynomial, rotation, sphere

SIZES = {
    "real": 1, "real angle": 1, "dual number": 1, "scale": 1, "argument": 1, "angle": 1, "real vector": 3,
    "dual vector": 3, "unit vector": 2, "quaternion": 4, "unit quaternion": 3, "orthogonal tensor": 3, "rotation": 3,
    "tensor": 9, "smooth function": 4,
}  # fmt: skip
"""How many independent numbers a letter is."""

ANGLES = ("angle", "real angle")
TURNS = ("unit quaternion", "orthogonal tensor", "rotation")
_VECTORS = ("dual vector", "real vector", "quaternion")
STEPS = 4  # sine and cosine of α/4 and its multiples are exact


def takes_apart(*statements: Term) -> bool:
    """Whether real and dual parts occur one by one: ε, Re, Du, a real letter, a claim in words."""
    nodes = (node for statement in statements for node in walk(statement))
    return any(
        (isinstance(node, Apply) and node.head in ("Re", "Du"))
        or (isinstance(node, Letter) and (node.name == "epsilon" or node.kind.startswith(("real", "proposition"))))
        for node in nodes
    )


class Generic:
    """Generic values of some letters.

    Parameters
    ----------
    free : iterable of Letter
    dual, moving : bool
        Layout of the coefficients, as in `derive.papers.language.evaluation.Env`.
    steps : int
        Sine and cosine of multiples of ``angle/steps`` are exact.
    framed : bool
        Whether a frame may be chosen along the vectors.
    """

    def __init__(
        self, free: Iterable[Letter], dual: bool, moving: bool, steps: int = STEPS, framed: bool = True
    ) -> None:
        self.dual, self.moving = dual, moving
        self.letters = tuple(free)
        self.framed = framed and not any(letter.kind == "tensor" for letter in self.letters)
        self.first = next((letter.name for letter in self.letters if letter.kind in _VECTORS), None)
        self.field = self._field(steps)
        self._vectors = 0  # how many vectors the frame is already fixed by
        self.values: dict[Letter, Any] = {letter: self._value(letter) for letter in self.letters}

    def fix(self, letter: Letter | None, value: Any) -> None:
        """Give one more letter a value."""
        if letter is not None:
            self.values[letter] = value

    def fix_branch(self, branch: Letter | None, k: int) -> None:
        """Let α + 2kπ be the generic angle, so that α is that less k turns."""
        self.fix(branch, k)
        if branch is not None:
            turned = {letter: value - 2 * k * self.field.pi for letter, value in self.values.items()
                      if letter.kind in ANGLES}
            self.values.update(turned)

    def env(self, definitions: Mapping[Letter, Definition]) -> Env:
        """The environment of these values."""
        return Env(self.field, dict(self.values), definitions, self.dual, self.moving)

    def _field(self, steps: int) -> Exact:
        angles = {letter.name: steps for letter in self.letters if letter.kind in (*ANGLES, *TURNS)}
        if self.first is not None:
            angles[f"arctan {self.first}"] = 1
        return Exact(self._names(), angles)

    def _names(self) -> list[str]:
        for letter in self.letters:
            if letter.kind not in SIZES:
                raise NotExactError(f"no generic {letter.kind}")
        parts = [f"{part}{slope}" for part in (("", "°") if self.dual else ("",)) for slope in self._slopes]
        stems = [f"{letter.name}{i}" for letter in self.letters for i in range(SIZES[letter.kind])]
        return [f"{stem}{part}" for stem in stems for part in parts]

    @property
    def _slopes(self) -> tuple[str, ...]:
        return ("", "˙") if self.moving else ("",)

    def _number(self, name: str, at: Any = None) -> Any:
        """A generic coefficient, dual and with a time derivative as the layout says; `at` fixes its value."""

        def plain(part: str) -> Any:
            value = at if at is not None and not part else self.field.symbol(f"{name}{part}")
            return Dual(value, self.field.symbol(f"{name}{part}˙")) if self.moving else value

        return Dual(plain(""), plain("°")) if self.dual else plain("")

    def _value(self, letter: Letter) -> Any:
        match letter.kind:
            case "angle":
                return self._number(f"{letter.name}0", at=self._angle(letter))
            case "real angle":
                return self._real(self._number(f"{letter.name}0", at=self._angle(letter)))
            case "real":
                return self._real(self._number(f"{letter.name}0"))
            case "dual number":
                return self._number(f"{letter.name}0")
            case "scale":
                return self._number(f"{letter.name}0", at=self._scale())
            case "argument":
                return self._number(f"{letter.name}0", at=self._argument())
            case "real vector":
                return self._vector(letter).map(self._real)
            case "dual vector":
                return self._vector(letter)
            case "unit vector":
                return self._unit(letter)
            case "quaternion":
                return Quaternion(self._number(f"{letter.name}3"), self._vector(letter))
            case "tensor":
                return Tensor.from_entries(self._number(f"{letter.name}{i}") for i in range(9))
            case "smooth function":
                return polynomial([self._real(self._number(f"{letter.name}{i}")) for i in range(SIZES[letter.kind])])
        if self.moving:
            raise NotExactError(f"a moving {letter.kind}: give it by a definition")
        return self._turn(letter)

    def _turn(self, letter: Letter) -> Any:
        """A unit quaternion, or the tensor of one, by half angle and axis."""
        if letter.name in self.field.functions.angles:
            half = self._number(f"{letter.name}2", at=self.field.symbol(letter.name))
            unit = Quaternion(self.field.cos(half), self._unit(letter) * self.field.sin(half))
        else:
            whole = Quaternion(1, self._vector(letter))
            unit = whole * whole / whole.norm2()
        if letter.kind == "rotation":
            return rotation(unit).map(self._real)
        return unit if letter.kind == "unit quaternion" else rotation(unit)

    def _angle(self, letter: Letter) -> Any:
        return self.field.symbol(letter.name)

    def _scale(self) -> Any:
        return None

    def _argument(self) -> Any:
        return None

    def _first(self) -> Any:
        """The magnitude of the first vector: the tangent of an angle."""
        angle = self.field.symbol(f"arctan {self.first}")
        return angle.sin() / angle.cos()

    def _vector(self, letter: Letter) -> Vector:
        names = [f"{letter.name}{i}" for i in range(3)]
        if not self.framed or letter.kind not in _VECTORS:
            return Vector(*(self._number(name) for name in names))
        self._vectors += 1
        zero = self.field.functions.constant(0)
        at = [self._first() if self._vectors == 1 and letter.name == self.first else None, None, None]
        at = [*at[: self._vectors], zero, zero][:3]
        return Vector(*(self._number(name, value) for name, value in zip(names, at, strict=True)))

    def _unit(self, letter: Letter) -> Vector:
        zero, names = self.field.functions.constant(0), [f"{letter.name}{i}" for i in range(2)]
        if self.framed:
            self._vectors += 1
        if self.framed and self._vectors == 1:
            u = sphere(*(self._number(name, zero) for name in names))
            return Vector(u.c3, u.c1, u.c2)
        if self.framed and self._vectors == 2:
            return sphere(self._number(names[0]), self._number(names[1], zero))
        return sphere(*(self._number(name) for name in names))

    def _real(self, number: Any) -> Any:
        if self.moving:
            raise NotExactError("real letters in motion")
        return number.re if self.dual else number


class GenericOrder(Generic):
    """Generic values for a symbolic order n: of one vector or one angle, and whatever else has no power with n."""

    field: EveryOrder

    def __init__(self, free: Iterable[Letter], order: Letter, moving: bool) -> None:
        super().__init__(free, False, moving)
        self.fix(order, self.field.n)

    def _field(self, steps: int) -> Exact:
        return EveryOrder(self._names())

    def _angle(self, letter: Letter) -> Any:
        return 2 * self.field.n * self.field.theta

    def _scale(self) -> Any:
        return self.field.scale

    def _argument(self) -> Any:
        return self.field.X

    def _first(self) -> Any:
        return self.field.X
