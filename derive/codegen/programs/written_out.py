"""Programs with their called programs written out, for analyses and fingerprints."""

from __future__ import annotations

from .program import Operand, Program, Step
from .trace import Trace
from .value import Number

OPERATIONS = {"lt": "less", "eq": "equal", "and": "both", "or": "either"}
"""Operations whose `Trace` methods have other names."""


def written_out(program: Program) -> Program:
    """Return the program with calls of geometry programs written out; equal entries are computed once."""
    trace = Trace()
    trace.name_rest("t")
    given = [value for argument, names in program.inputs for value in trace.inputs(argument, names)]
    return trace.program(program.name, _run(trace, program, given))


def _run(trace: Trace, program: Program, given: list[Number]) -> list[Number]:
    """Record the statements of a program on arguments, and return its results."""
    known: dict[str, Number] = dict(zip((name for _, names in program.inputs for name in names), given, strict=True))

    programs = {called.name: called for called in program.called}

    def value(operand: Operand) -> Number:
        return known[operand] if isinstance(operand, str) else operand

    for statement in program.statements:
        args = [value(arg) for arg in statement.args]
        if isinstance(statement, Step):
            made = getattr(trace, OPERATIONS.get(statement.op, statement.op))(*args)
            known[statement.name] = made if statement.inline else trace.name(trace.free_name(statement.name), made)
            if statement.name in program.corrected:
                trace.corrected(known[statement.name])
            continue
        if statement.result:
            made = _run(trace, programs[statement.function], args)
        else:
            named = (f"unread{i}" if name == "_" else name for i, name in enumerate(statement.names))
            names = list(map(trace.free_name, named))
            truths = [new for new, name in zip(names, statement.names, strict=True) if name in statement.truths]
            made = trace.call(statement.function, args, names, truths, statement.rest)
        known |= zip(statement.names, made, strict=True)
    return [value(output) for output in program.outputs]
