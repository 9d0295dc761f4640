"""Tracer: ordinary arithmetic on symbolic inputs, recorded as a straight-line program.

A :class:`Trace` hands out symbolic inputs and records each operation on them once (value numbering). Constants are
folded, and operations that no output needs are dropped. Formulas are lowered with this arithmetic
(``algebra.arithmetic``). The result is a frozen :class:`~derive.codegen.programs.program.Program`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from .folding import Folding
from .program import Call, Constant, Operand, Program, Statement, Step
from .value import Number, Value

COMMUTATIVE = frozenset({"add", "mul", "eq", "and", "or"})


class UnnamedValueError(ValueError):
    """Error for a value that is used more than once but lacks the name that printed source needs."""


class _Const(NamedTuple):
    value: Constant


class _Node(NamedTuple):
    op: str
    args: tuple[int | _Const, ...]


class Trace(Folding):
    """Record of the operations on the values that it hands out."""

    def __init__(self) -> None:
        self._nodes: list[_Node] = []
        self._numbered: dict[_Node, int] = {}
        self._names: dict[int, str] = {}
        self._named: set[str] = set()
        self._taken: set[str] = set()
        self._inputs: list[tuple[str, tuple[str, ...]]] = []
        self._calls: dict[int, Call] = {}
        self._results: dict[int, tuple[int, ...]] = {}
        self._programs: dict[str, Program] = {}
        self._rest = ""
        self._corrected: set[int] = set()

    def inputs(self, argument: str, names: Sequence[str]) -> tuple[Value, ...]:
        """Declare an argument of the program, with one component for each name."""
        values = []
        for name in names:
            self._nodes.append(_Node("input", ()))
            values.append(Value(self, len(self._nodes) - 1))
            self._rename(values[-1], name)
        self._inputs.append((argument, tuple(names)))
        self._taken.add(argument)
        return tuple(values)

    def input_name(self, value: Value) -> str | None:
        """Return the name of a component of an argument; None for any other value."""
        return self._names[value.index] if self._nodes[value.index].op == "input" else None

    def name(self, name: str, value: Number) -> Number:
        """Name a value; constants, and values that already have a name, stay unchanged."""
        if isinstance(value, Value) and value.index not in self._names:
            self._rename(value, name)
        return value

    def free_name(self, name: str) -> str:
        """Return the name, with trailing underscores if it is taken."""
        while name in self._taken:
            name += "_"
        return name

    def corrected(self, value: Number) -> Number:
        """Mark a named value whose rounding the program corrects afterwards, as in a step of Newton's method."""
        if isinstance(value, Value):
            self._corrected.add(value.index)
        return value

    def rounded_off(self, value: Number) -> Number:
        """Return the rounding error of a sum and of nested sums, by the error-free sum of two terms."""
        node = self._nodes[value.index] if isinstance(value, Value) else None
        if node is None or node.op != "add":
            return 0
        first, second = map(self._operand, node.args)
        whole = self.name(self.free_name("part"), value)
        letter = isinstance(second, Value) and self._names.get(second.index)
        share = self.name(self.free_name(f"{letter or 'second'}_in"), whole - first)
        return self.rounded_off(first) + self.rounded_off(second) + ((first - (whole - share)) + (second - share))

    def name_rest(self, letter: str) -> None:
        """Set the letter that, with a number, names unnamed values that are used more than once."""
        self._rest = letter

    def _rename(self, value: Value, name: str) -> None:
        if name in self._named:
            raise ValueError(f"the name {name!r} is already taken in this program")
        self._names[value.index] = name
        self._named.add(name)
        self._taken.add(name)

    def negated(self, value: Number) -> Number:
        """Return −value if the value was recorded as a negative; None otherwise."""
        if not isinstance(value, Value):
            return -value if value < 0 else None
        node = self._nodes[value.index]
        if value.index in self._names:
            return None
        if node.op == "neg":
            return self._operand(node.args[0])
        first = node.args[0] if node.op == "mul" else None
        if isinstance(first, _Const) and first.value < 0:
            return self.mul(-first.value, self._operand(node.args[1]))
        return None

    # --- recording --------------------------------------------------------------------------------------------

    def call(
        self, function: str, args: Sequence[Number], names: Sequence[str], truths: Iterable[str] = (), rest: str = ""
    ) -> tuple[Value, ...]:
        """Return the named results of a scalar program, applied to named values and inputs."""
        call = Call(tuple(names), function, (), rest, frozenset(truths))
        return self._called(f"call {function}", args, call, names)

    def call_program(
        self, program: Program, result: str, names: Sequence[str], arguments: Sequence[Number | Sequence[Number]]
    ) -> tuple[Value, ...]:
        """Return the named results of another program for numbers and lists; ``result`` names the list of results."""
        lists = tuple(len(given) if isinstance(given, tuple) else 0 for given in arguments)
        self._programs[program.name] = program
        flat = [number for given in arguments for number in (given if isinstance(given, tuple) else (given,))]
        call = Call((), program.name, (), lists=lists, result=result, context=program.context)
        return self._called(f"apply {program.name}", flat, call, names)

    def _called(self, op: str, args: Sequence[Number], call: Call, names: Sequence[str]) -> tuple[Value, ...]:
        index = self.record(op, *args).index
        if index not in self._calls:
            result = self.free_name(call.result) if call.result else ""
            self._taken.add(result)
            self._calls[index] = replace(call, result=result)
            results = [self.record("result", Value(self, index), number) for number in range(len(names))]
            self._results[index] = tuple(value.index for value in results)
            for name, value in zip(names, results, strict=True):
                self._rename(value, self.free_name(name) if call.result else name)
        return tuple(Value(self, place) for place in self._results[index])

    def record(self, op: str, *operands: Number) -> Value:
        """Return the value of ``op(*operands)``, and record it if it is new."""
        args = tuple(v.index if isinstance(v, Value) else _Const(v) for v in operands)
        key = _Node(op, tuple(sorted(args, key=_order)) if op in COMMUTATIVE else args)
        if key not in self._numbered:
            self._nodes.append(_Node(op, args))
            self._numbered[key] = len(self._nodes) - 1
        return Value(self, self._numbered[key])

    def _operand(self, arg: int | _Const) -> Number:
        return arg.value if isinstance(arg, _Const) else Value(self, arg)

    def program(self, name: str, outputs: Iterable[Number]) -> Program:
        """Return the program of the operations that the outputs need."""
        results = tuple(outputs)
        uses = self._uses(results)
        for index, count in sorted(uses.items()):
            if count > 1:
                self._name_multiple(index)
        scalars = (index for index in uses if index in self._calls and not self._calls[index].result)
        calls = (self._nodes[index] for index in scalars)
        passed = {arg for call in calls for arg in call.args if not isinstance(arg, _Const)}
        shared: set[int] = {index for index, count in uses.items() if count > 1 and index not in self._calls}
        for index in sorted(shared | passed) if self._rest else ():
            if index not in self._names:
                self._rename(Value(self, index), self.free_name(f"{self._rest}{index}"))
        self._require_names(shared | passed, name)
        labels = {i: self._names.get(i, f"t{i}") for i in uses}

        def label(arg: int | _Const) -> Operand:
            return arg.value if isinstance(arg, _Const) else labels[arg]

        finals = tuple(labels[v.index] if isinstance(v, Value) else v for v in results)
        found = (self._statement(index, labels, label) for index in sorted(uses))
        statements: tuple[Statement, ...] = tuple(filter(None, found))
        corrected = frozenset(labels[index] for index in self._corrected & labels.keys())
        functions = dict.fromkeys(statement.function for statement in statements if isinstance(statement, Call))
        called = tuple(self._programs[function] for function in functions if function in self._programs)
        return Program(name, tuple(self._inputs), statements, finals, corrected, called)

    def _require_names(self, indices: Iterable[int], program: str) -> None:
        unnamed = [index for index in sorted(indices) if index not in self._names]
        if unnamed:
            values = ", ".join(map(self._describe, unnamed))
            raise UnnamedValueError(f"program {program!r} uses unnamed values more than once or in a call: {values}")

    def _statement(
        self, index: int, labels: Mapping[int, str], label: Callable[[int | _Const], Operand]
    ) -> Statement | None:
        """Return the step or call that makes a value; None for inputs and for results of a call."""
        node = self._nodes[index]
        if index in self._calls:
            names = tuple(labels.get(result, "_") for result in self._results[index])
            return replace(self._calls[index], names=names, args=tuple(map(label, node.args)))
        if node.op in ("input", "result"):
            return None
        return Step(labels[index], node.op, tuple(map(label, node.args)), index not in self._names)

    def _uses(self, results: Sequence[Number]) -> dict[int, int]:
        """Count the reads of each value, outputs included; values that are not read are absent."""
        uses: Counter[int] = Counter(v.index for v in results if isinstance(v, Value))
        for index in range(len(self._nodes) - 1, -1, -1):
            if uses[index]:
                uses.update(arg for arg in self._nodes[index].args if not isinstance(arg, _Const))
        return {index: count for index, count in uses.items() if count}

    def _name_multiple(self, index: int) -> None:
        """Name a shared value that is the negative, an integer multiple or a product of named values."""
        node, last = self._nodes[index], self._nodes[index].args[-1:]
        base = self._names.get(last[0]) if last and not isinstance(last[0], _Const) else None
        if base is None or index in self._names:
            return
        if node.op == "neg":
            self._rename(Value(self, index), f"minus_{base}")
        elif node.op == "mul" and isinstance(node.args[0], _Const):
            self._rename(Value(self, index), f"{base}_by_{node.args[0].value}".replace("-", "minus_"))
        elif node.op == "mul":
            first = None if isinstance(node.args[0], _Const) else self._names.get(node.args[0])
            if first is not None:
                self._rename(Value(self, index), self.free_name(f"{first}_{base}"))

    def _describe(self, index: int) -> str:
        node = self._nodes[index]
        args = (str(a.value) if isinstance(a, _Const) else self._names.get(a, "…") for a in node.args)
        return f"{node.op}({', '.join(args)})"


def _order(arg: int | _Const) -> tuple[int, Constant]:
    return (0, arg.value) if isinstance(arg, _Const) else (1, arg)
