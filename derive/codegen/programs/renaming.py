"""Programs with other names, for languages whose words or rules of case forbid some."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from typing import Any

from .program import Assignment, Program, Statement


def renamed(program: Program, names: Mapping[str, str]) -> Program:
    def new(operands: Iterable[Any]) -> tuple[Any, ...]:
        return tuple(names.get(operand, operand) for operand in operands)

    def statement(old: Statement) -> Statement:
        if isinstance(old, Assignment):
            return replace(old, name=names.get(old.name, old.name), args=new(old.args))
        (result,), truths = new([old.result]), frozenset(new(old.truths))
        return replace(old, names=new(old.names), args=new(old.args), truths=truths, result=result)

    return replace(
        program,
        inputs=tuple((argument, new(parts)) for argument, parts in program.inputs),
        statements=tuple(map(statement, program.statements)),
        outputs=new(program.outputs),
    )


def lower_case(program: Program, reserved: Collection[str] = ()) -> Program:
    """Return a program with lower-case names, none of them ``reserved``; trailing underscores keep names apart.

    Names in capital letters (N, I, R1) may be macros in C, and are warned about in Rust.
    """
    names = {step.name for step in program.steps}.union(*(parts for _, parts in program.inputs))
    names.update(name for call in program.calls for name in (*call.names, call.result))
    good = {name for name in names if name == name.lower() and name not in reserved}
    taken = good | {argument.lower() for argument, _ in program.inputs} | set(reserved)
    new: dict[str, str] = {}
    for name in sorted(names - good):
        new[name] = name.lower()
        while new[name] in taken:
            new[name] += "_"
        taken.add(new[name])
    lowered = renamed(program, new)
    return replace(lowered, inputs=tuple((argument.lower(), parts) for argument, parts in lowered.inputs))
