"""Traces of geometry programs, which call scalar programs and one another, and the vectors of a trace.

A recipe is a function of a trace that returns the results of a program. A mapping gives the names of the results; other
results are named by `LAYOUTS`. The recipe's name is the program's name, and its docstring the program's contract. The
first paragraph describes the whole result, the second one the dual part. Formulas mark dual parts by °. Names of dual
parts end in ``o``, or in °, which is not printed: ``rho1°`` becomes ``rho1``.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache, cached_property
from typing import NamedTuple

from ...algebra import Dual, Tensor, Vector
from ..programs.program import Call, Number, Program, Statement, Value
from ..programs.trace import Trace
from .scalar_programs import SCALARS, SQUARES

Numbers = tuple[Number, ...]
Results = Iterable[Number] | Mapping[str, Number]
Recipe = Callable[["Geometry"], Results]

NINE = tuple(f"{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3))
LAYOUTS = {
    3: ("1", "2", "3"),
    4: ("0", "1", "2", "3"),
    6: ("1", "2", "3", "1o", "2o", "3o"),
    9: NINE,
    18: (*NINE, *(f"{place}o" for place in NINE)),
    36: tuple(f"{i}{j}" for i in range(1, 7) for j in range(1, 7)),
}
"""Suffixes of component names: vector, quaternion, dual vector, tensor, dual tensor, matrix."""

REAL_NAMES = {"dual_product": "matrix_product", "composed": "quaternion_product"}
"""Names of programs for rotations, by name of the program for poses; all other names are equal for both."""

TABLE = "table"  # argument that holds constants, which have no dual part


class Geometry(Trace):
    """Trace of geometry, which all charts share; scalar programs and other geometry programs appear as calls."""

    real = False
    """True if dual parts are the constant 0."""

    def ask(self, function: str, arguments: Sequence[Number], mark: str = "") -> tuple[Number, ...]:
        """Return the results of a scalar program, under their own names followed by a mark."""
        row = SCALARS[function]
        names, truths = ([name + mark for name in group] for group in (row.results, row.truths))
        return self.call(function, arguments, names, truths, TABLE if TABLE in row.arguments else "")

    def apply(self, recipe: Recipe, pattern: str, *arguments: Number | Iterable[Number]) -> tuple[Number, ...]:
        """Return the results of another geometry program, named by a pattern such as ``T{}`` or ``{}_2``."""
        program = traced(recipe)
        names = [pattern.format(name) for name in program.results]
        groups = [tuple(given) if isinstance(given, Iterable) else given for given in arguments]
        return self.call_program(program, _list_name(pattern, program), names, groups)

    def program(self, name: str, outputs: Iterable[Number], results: Sequence[str] = ()) -> Program:
        """Freeze the operations that the outputs need; ``results`` are the output names, by default from `LAYOUTS`."""
        program = super().program(name, outputs)
        count = len(program.outputs)
        names = tuple(results) or LAYOUTS.get(count, tuple(map(str, range(1, 1 + count))))
        return replace(program, results=tuple(result.rstrip("°") for result in names))

    def numbers(self, *names: str) -> tuple[Number, ...]:
        return tuple(self.inputs(name, [name])[0] for name in names)

    def components(self, argument: str, letter: str, count: int) -> tuple[Number, ...]:
        """Declare an argument with ``count`` components."""
        return self.inputs(argument, [f"{letter}{place}" for place in LAYOUTS[count]])

    def point(self, argument: str = "v", letter: str = "") -> Point:
        """Declare a dual vector, by default v."""
        return Point(self, self.components(argument, letter or argument, 6))

    def real_vector(self, argument: str, letter: str = "", dual: str = "") -> Vector:
        """Declare a vector of three numbers; with ``dual="°"`` they are dual parts, 0 for rotations alone."""
        return Vector(*self.inputs(argument, [f"{letter or argument}{i}{dual}" for i in (1, 2, 3)]))

    def inputs(self, argument: str, names: Sequence[str]) -> tuple[Number, ...]:
        """Declare an argument; drop the mark ° from its names."""
        return super().inputs(argument, [name.rstrip("°") for name in names])

    def name(self, name: str, value: Number) -> Number:
        """Name a value, or both parts of a dual number; the name of the dual part ends in o."""
        if isinstance(value, Dual):
            return Dual(super().name(name, value.re), super().name(name + "o", value.du))
        return super().name(name, value)

    def vector(self, letter: str, value: Vector) -> Vector:
        return Vector(*(self.name(f"{letter}{i}", component) for i, component in enumerate(value, 1)))

    def inside(self, v: Vector) -> Vector:
        """Return a vector of the chart, taken back to the edge if rounding has put it beyond."""
        made = self.vector("made", v)
        (inside,) = self.ask("inside", (Point(self, (*made, 0, 0, 0), "made").x,))
        kept: Vector = inside * made
        return kept


def dual_tensor(entries: Sequence[Number]) -> Tensor:
    """Return the dual tensor of 18 entries, real parts first."""
    return Tensor.dual(Tensor.from_entries(entries[:9]), Tensor.from_entries(entries[9:]))


class Found(NamedTuple):
    """Source of a pose result in the program for rotations: a result number, an input name or a constant."""

    result: int | None = None
    given: str = ""
    constant: Number = 0


class RealGeometry(Geometry):
    """Trace of a pose recipe for rotations alone: dual parts are the constant 0.

    The recipe needs no change: operations on dual parts fold away or are not read. The program of a ``function`` keeps
    the results at the places ``kept``. Other programs keep all results except dual parts, constants and arguments.
    """

    real = True

    def __init__(self, function: str = "", kept: Sequence[int] | None = None) -> None:
        super().__init__()
        self.function = function
        self.kept = kept
        self.found: tuple[Found, ...] = ()

    def inputs(self, argument: str, names: Sequence[str]) -> tuple[Number, ...]:
        """Declare the components that are not dual parts; return 0 for dual parts."""
        real = [name for name in names if not is_dual(name)]
        declared = dict(zip(real, super().inputs(argument, real) if real or not names else (), strict=True))
        return tuple(declared.get(name, 0) for name in names)

    def apply(self, recipe: Recipe, pattern: str, *arguments: Number | Iterable[Number]) -> tuple[Number, ...]:
        """Return the results of the program traced for rotations, in the order of the pose program's results."""
        values: dict[str, Number] = {}
        for (_, names), given in zip(traced(recipe).inputs, arguments, strict=True):
            values |= zip(names, given if isinstance(given, Iterable) else (given,), strict=True)
        program, found = traced_real(recipe)
        passed = [
            values[argument] if names == (argument,) else tuple(values[name] for name in names)
            for argument, names in program.inputs
        ]
        made: tuple[Number, ...] = ()
        if program.outputs:
            results = [pattern.format(name) for name in program.results]
            made = self.call_program(program, _list_name(pattern, program), results, passed)
        return tuple(
            made[at.result] if at.result is not None else values[at.given] if at.given else at.constant for at in found
        )

    def program(self, name: str, outputs: Iterable[Number], results: Sequence[str] = ()) -> Program:
        """Freeze the operations that the kept outputs need; a program without ``function`` drops unread arguments."""
        given = tuple(outputs)
        names = results or LAYOUTS.get(len(given), ("",) * len(given))
        first: dict[int, int] = {}  # place by index of a value
        for place, (value, result) in enumerate(zip(given, names, strict=True)):
            if isinstance(value, Value) and not is_dual(result) and self.input_name(value) is None:
                first.setdefault(value.index, place)
        self.found = tuple(self._found(value, name, list(first)) for value, name in zip(given, names, strict=True))
        kept = list(first.values()) if self.kept is None else self.kept
        title = self.function or REAL_NAMES.get(name, name)
        program = super().program(title, [given[i] for i in kept], [names[i] for i in kept])
        read = program.operands
        inputs = tuple(group for group in program.inputs if self.function or read.intersection(group[1]))
        return replace(program, inputs=inputs, statements=tuple(map(narrowed, program.statements)))

    def _found(self, value: Number, name: str, made: list[int]) -> Found:
        if is_dual(name) or not isinstance(value, Value):
            return Found(constant=0 if is_dual(name) else value)
        given = self.input_name(value)
        return Found(given=given) if given else Found(made.index(value.index))


def _list_name(pattern: str, program: Program) -> str:
    """Return the name of the list of results: the pattern without its placeholder, or the program's name."""
    head = pattern.format("")
    return head if head[:1].isalpha() else f"{program.name}{head}" if head else "found"


def is_dual(name: str) -> bool:
    return name.endswith(("o", "°"))


@cache
def traced(recipe: Recipe) -> Program:
    """Return the program of a recipe for poses, with its contract."""
    return _program(Geometry(), recipe)


@cache
def traced_real(recipe: Recipe) -> tuple[Program, tuple[Found, ...]]:
    """Return the program of a recipe for rotations alone, and the replacements of the pose program's results."""
    trace = RealGeometry()
    return _program(trace, recipe), trace.found


def traced_kernel(recipe: Recipe, function: str, kept: Sequence[int]) -> Program:
    """Return the program of a function of rotations; ``kept`` are the places of its results."""
    return _program(RealGeometry(function, kept), recipe)


def _program(trace: Geometry, recipe: Recipe) -> Program:
    results = recipe(trace)
    named = results if isinstance(results, Mapping) else {}
    program = trace.program(recipe.__name__, named.values() or results, tuple(named))
    contract, *dual = (inspect.getdoc(recipe) or "").split("\n\n")
    return replace(program, contract=contract if trace.real else "\n".join([contract, *dual]))


def narrowed(statement: Statement) -> Statement:
    """Replace the scalar program of a call by the smallest one with all results that are read."""
    if not isinstance(statement, Call) or statement.result:
        return statement
    row = SCALARS[statement.function]
    read = {result: name for result, name in zip(row.results, statement.names, strict=True) if name != "_"}
    fitting = (
        name
        for name, other in SCALARS.items()
        if other.arguments == row.arguments in (("x",), SQUARES) and read.keys() <= set(other.results)
    )
    function = min(fitting, key=lambda name: len(SCALARS[name].results), default=statement.function)
    names = tuple(read.get(result, "_") for result in SCALARS[function].results)
    return replace(statement, function=function, names=names)


class Point:
    """Traced components of a dual vector v, and values derived from them; each value is computed once."""

    def __init__(self, trace: Geometry, components: Sequence[Number], mark: str = "") -> None:
        self.trace = trace
        self.mark = mark
        self.components = tuple(components)
        self.re = Vector(*components[:3])
        self.du = Vector(*components[3:6])

    def name(self, letter: str, value: Number) -> Number:
        """Name a value by a letter and the mark of this vector."""
        return self.trace.name(letter + self.mark, value)

    @cached_property
    def squares(self) -> tuple[Number, Number, Number]:
        first, second, third = (self.name(name, c * c) for name, c in zip(SQUARES, self.re, strict=True))
        return first, second, third

    @cached_property
    def x(self) -> Number:
        return self.name("x", self.re.dot(self.re))

    @cached_property
    def y(self) -> Number:
        """Return y = v·v°, half the dual part of x."""
        return self.name("y", self.re.dot(self.du))

    @cached_property
    def v(self) -> Vector:
        return Vector.dual(self.re, self.du)

    def lifted(self, function: str, letters: Sequence[str]) -> tuple[Number, ...]:
        """Return some results of a scalar program at the dual x; the dual part of f is its slope fy times y."""
        found = dict(zip(SCALARS[function].results, self.scalars(function), strict=True))
        return tuple(self.lift(name, found[name], found[name + "y"]) for name in letters)

    def lift(self, letter: str, value: Number, slope: Number) -> Dual:
        """Return a function of x at the dual x, and name its dual part."""
        return Dual(value, self.name(letter + "o", slope * self.y))

    def scalars(self, function: str) -> tuple[Number, ...]:
        of_squares = SCALARS[function].arguments == SQUARES
        return self.trace.ask(function, self.squares if of_squares else (self.x,), self.mark)
