"""Tracer: ordinary arithmetic on symbolic inputs, recorded as a straight-line program.

Equal operations are recorded once, constants are folded, and operations that no output needs are dropped.
"""

from __future__ import annotations

import keyword
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from .program import Assignment, Call, Folding, Number, Operand, Program, Statement, Value, label

COMMUTATIVE = frozenset({"add", "mul", "eq", "and", "or"})
OF_C = (
    "asm auto bool case catch char const default delete do double enum explicit export extern false float friend goto "
    "inline int long mutable namespace new operator or private protected public register restrict short signed sizeof "
    "static struct switch template this throw true typedef typename union unsigned using virtual void volatile"
)
KEYWORDS = frozenset((*keyword.kwlist, *OF_C.split()))
"""Keywords of Python, C and C++, which name no value: every program is printed in each language."""


class Trace(Folding):
    """Record of the operations on the values that it hands out."""

    def __init__(self) -> None:
        self._values: list[Value] = []
        self._recorded: dict[tuple[str, tuple[Number, ...]], Value] = {}
        self._taken: set[str] = set()
        self._inputs: list[tuple[str, tuple[str, ...]]] = []
        self._calls: dict[Value, Call] = {}
        self._results: dict[Value, tuple[Value, ...]] = {}
        self._programs: dict[str, Program] = {}
        self._rest = ""
        self._corrected: set[Value] = set()

    # --- names ------------------------------------------------------------------------------------------------

    def inputs(self, argument: str, names: Sequence[str]) -> tuple[Value, ...]:
        """Declare an argument of the program, with one component for each name."""
        values = tuple(self._new("input") for _ in names)
        for value, name in zip(values, names):
            self._rename(value, name)
        self._inputs.append((argument, tuple(names)))
        self._taken.add(argument)
        return values

    def input_name(self, value: Value) -> str | None:
        """Return the name of a component of an argument; None for any other value."""
        return value.name if value.op == "input" else None

    def name(self, name: str, value: Number) -> Number:
        """Name a value; constants, and values that already have a name, stay unchanged."""
        if isinstance(value, Value) and not value.name:
            self._rename(value, name)
        return value

    def free_name(self, name: str) -> str:
        """Return the name, with trailing underscores if it is taken."""
        while name in self._taken:
            name += "_"
        return name

    def name_rest(self, letter: str) -> None:
        """Set the letter for numbered names of values that are used more than once but have no name."""
        self._rest = letter

    def _rename(self, value: Value, name: str) -> None:
        if name in self._taken or name in KEYWORDS:
            raise ValueError(f"the name {name!r} is already taken in this program, or is a keyword")
        value.name = name
        self._taken.add(name)

    # --- recording --------------------------------------------------------------------------------------------

    def record(self, op: str, *operands: Number) -> Value:
        """Return the value of ``op(*operands)``, and record it if it is new."""
        key = op, tuple(sorted(operands, key=_order)) if op in COMMUTATIVE else operands
        if key not in self._recorded:
            self._recorded[key] = self._new(op, *operands)
        return self._recorded[key]

    def _new(self, op: str, *operands: Number) -> Value:
        self._values.append(Value(self, len(self._values), op, operands))
        return self._values[-1]

    def corrected(self, value: Number) -> Number:
        """Mark a named value whose rounding the program corrects afterwards, as in a step of Newton's method."""
        if isinstance(value, Value):
            self._corrected.add(value)
        return value

    def rounded_off(self, value: Number) -> Number:
        """Return the rounding error of a sum and of nested sums, by the error-free sum of two terms."""
        if not isinstance(value, Value) or value.op != "add":
            return 0
        first, second = value.args
        whole = self.name(self.free_name("part"), value)
        letter = isinstance(second, Value) and second.name
        share = self.name(self.free_name(f"{letter or 'second'}_in"), whole - first)
        return self.rounded_off(first) + self.rounded_off(second) + ((first - (whole - share)) + (second - share))

    def call(
        self, function: str, args: Sequence[Number], names: Sequence[str], truths: Iterable[str] = (), rest: str = ""
    ) -> tuple[Value, ...]:
        """Return the named results of a scalar program, applied to named values and inputs."""
        return self._called(Call(tuple(names), function, (), rest, frozenset(truths)), args)

    def call_program(
        self, program: Program, result: str, names: Sequence[str], arguments: Sequence[Number | Sequence[Number]]
    ) -> tuple[Value, ...]:
        """Return the named results of another program for numbers and lists; ``result`` names the list of results."""
        lists = tuple(len(given) if isinstance(given, tuple) else 0 for given in arguments)
        flat = [number for given in arguments for number in (given if isinstance(given, tuple) else (given,))]
        self._programs[program.name] = program
        call = Call(tuple(names), program.name, (), lists=lists, result=result, context=program.context)
        return self._called(call, flat)

    def _called(self, call: Call, args: Sequence[Number]) -> tuple[Value, ...]:
        value = self.record(f"{'apply' if call.result else 'call'} {call.function}", *args)
        if value not in self._calls:
            result = self.free_name(call.result) if call.result else ""
            self._taken.add(result)
            self._calls[value] = replace(call, result=result)
            self._results[value] = tuple(self.record("result", value, number) for number in range(len(call.names)))
            for name, made in zip(call.names, self._results[value], strict=True):
                self._rename(made, self.free_name(name) if call.result else name)
        return self._results[value]

    # --- the program ------------------------------------------------------------------------------------------

    def program(self, name: str, outputs: Iterable[Number]) -> Program:
        """Return the program of the operations that the outputs need."""
        results = tuple(outputs)
        uses = self._uses(results)
        calls = [self._calls[value] for value in uses if value in self._calls]
        self._name_all(uses, name)
        called = dict.fromkeys(call.function for call in calls if call.function in self._programs)
        return Program(
            name,
            tuple(self._inputs),
            tuple(filter(None, (self._statement(value, uses) for value in uses))),
            tuple(map(label, results)),
            frozenset(str(label(value)) for value in self._corrected & uses.keys()),
            tuple(self._programs[function] for function in called),
        )

    def _uses(self, results: Sequence[Number]) -> dict[Value, int]:
        """Count the reads of each value, outputs included, in order; values that are not read are absent."""
        uses = dict.fromkeys(self._values, 0)
        for value in results:
            if isinstance(value, Value):
                uses[value] += 1
        for value in reversed(self._values):
            for operand in value.operands if uses[value] else ():
                uses[operand] += 1
        return {value: count for value, count in uses.items() if count}

    def _name_all(self, uses: dict[Value, int], program: str) -> None:
        """Name values that are used more than once or passed to a scalar program; raise if one has no name."""
        shared = {value for value, count in uses.items() if count > 1 and value not in self._calls}
        for value in sorted(shared, key=_order):
            self._name_multiple(value)
        scalars = (value for value in uses if value in self._calls and not self._calls[value].result)
        needed = shared.union(*(value.operands for value in scalars))
        unnamed = [value for value in sorted(needed, key=_order) if not value.name]
        if unnamed and not self._rest:
            values = ", ".join(f"{v.op}({', '.join(map(_shown, v.args))})" for v in unnamed)
            raise ValueError(f"program {program!r} uses unnamed values more than once or in a call: {values}")
        for value in unnamed:
            self._rename(value, self.free_name(f"{self._rest}{value.index}"))

    def _name_multiple(self, value: Value) -> None:
        """Name a shared value that is the negative, an integer multiple or a product of named values."""
        if value.name or value.op not in ("neg", "mul") or not value.args[-1].name:
            return
        first, base = value.args[0], value.args[-1].name
        if value.op == "neg":
            self._rename(value, f"minus_{base}")
        elif not isinstance(first, Value):
            self._rename(value, f"{base}_by_{first}".replace("-", "minus_"))
        elif first.name:
            self._rename(value, self.free_name(f"{first.name}_{base}"))

    def _statement(self, value: Value, read: Collection[Value]) -> Statement | None:
        """Return the step or call that makes a value; None for inputs and for results of a call."""
        args = tuple(map(label, value.args))
        if value in self._calls:
            names = tuple(str(label(result)) if result in read else "_" for result in self._results[value])
            return replace(self._calls[value], names=names, args=args)
        if value.op in ("input", "result"):
            return None
        return Assignment(str(label(value)), value.op, args, inline=not value.name)


def _order(number: Number) -> tuple[int, Number]:
    return (1, number.index) if isinstance(number, Value) else (0, number)


def _shown(number: Number) -> str:
    return (number.name or "…") if isinstance(number, Value) else str(number)


# ---- called programs written out ---------------------------------------------------------------------------------

METHODS = {"lt": "less", "eq": "equal", "and": "both", "or": "either"}
"""Methods of `Trace` by operation, if their names differ."""


def written_out(program: Program) -> Program:
    """Return the program with calls of geometry programs written out; equal operations are recorded once."""
    trace = Trace()
    trace.name_rest("t")
    given = [value for argument, names in program.inputs for value in trace.inputs(argument, names)]
    return trace.program(program.name, _run(trace, program, given))


def _run(trace: Trace, program: Program, given: Sequence[Number]) -> list[Number]:
    known: dict[Operand, Number] = dict(zip((n for _, names in program.inputs for n in names), given, strict=True))
    programs = {called.name: called for called in program.called}
    for statement in program.statements:
        args = [known.get(arg, arg) for arg in statement.args]
        if isinstance(statement, Assignment):
            made = getattr(trace, METHODS.get(statement.op, statement.op))(*args)
            known[statement.name] = made if statement.inline else trace.name(trace.free_name(statement.name), made)
            if statement.name in program.corrected:
                trace.corrected(made)
        elif statement.result:
            known |= zip(statement.names, _run(trace, programs[statement.function], args), strict=True)
        else:
            names = [trace.free_name(f"unread{i}" if n == "_" else n) for i, n in enumerate(statement.names)]
            truths = [new for new, old in zip(names, statement.names, strict=True) if old in statement.truths]
            made = trace.call(statement.function, args, names, truths, statement.rest)
            known |= zip(statement.names, made, strict=True)
    return [known.get(output, output) for output in program.outputs]
