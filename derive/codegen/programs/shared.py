"""Steps that several programs share, moved to helper programs, so that each is printed once.

A helper holds the steps that all of its callers need, and no others: callers compute the same values as before.
"""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import reduce
from operator import or_
from typing import Any

from .program import Assignment, Call, Program, Statement

LEAST_SAVING = 10  # least number of printed lines that a helper saves
HEAD = 5  # number of printed lines of a helper in addition to its steps: comment, head, result, blank lines
OPERATIONS_PER_CALL = 31
"""Least number of operations for each helper that a program calls beyond two, since a call takes time."""

MOST_PASSED = 12  # largest number of arguments of a helper, and of its results
Steps = Mapping[str, Any]  # named steps of a program with their inline steps written out, by name


def with_helpers(programs: Mapping[str, Program]) -> tuple[dict[str, Program], dict[str, Program]]:
    """Return helper programs, named by their results, and the programs that call them."""
    helpers = dict[str, Program]()
    found = {name: _with_inline_zero(program) for name, program in programs.items()}
    for back in (False, True):
        while best := _best(_with_room(found, programs), {*programs, *helpers}, back):
            helper, group, shared = best
            helpers[helper.name] = helper
            found |= {key: _caller(found[key], helper, shared) for key in group}
    return helpers, found


def _with_room(found: Mapping[str, Program], programs: Mapping[str, Program]) -> dict[str, Program]:
    """Return the programs in ``found`` that may call one more helper, by the number of their original steps."""
    most = {name: len(program.steps) // OPERATIONS_PER_CALL for name, program in programs.items()}
    return {name: program for name, program in found.items() if len(program.calls) < max(most[name], 2)}


def _with_inline_zero(program: Program) -> Program:
    """Mark each zero ``x - x`` that is read once: it is printed inline, as in programs that do not name it."""
    reads = Counter([*(arg for statement in program.statements for arg in statement.args), *program.outputs])
    zeros = {s: replace(s, inline=True) for s in program.steps if s.op == "sub" and s.args[0] == s.args[1]}
    once: dict[Statement, Statement] = {step: inline for step, inline in zeros.items() if reads[step.name] == 1}
    return replace(program, statements=tuple(once.get(statement, statement) for statement in program.statements))


def _best(
    programs: Mapping[str, Program], taken: set[str], back: bool
) -> tuple[Program, Sequence[str], set[str]] | None:
    """Return the helper that saves most lines, its callers and the names that it holds; None if none saves enough."""
    written = {key: dict.fromkeys(_written_out(program).items()) for key, program in programs.items()}
    steps = dict.fromkeys(itertools.chain.from_iterable(written.values()))
    groups = dict.fromkeys(tuple(key for key, found in written.items() if step in found) for step in steps)
    common = [{*written[group[0]]}.intersection(*(written[key] for key in group[1:])) for group in groups]
    saved = [(_saving(group, shared), place) for place, (group, shared) in enumerate(zip(groups, common, strict=True))]
    best, found, listed = (LEAST_SAVING - 1, 0), None, list(groups)
    for most, place in sorted(saved, key=lambda one: (-one[0], one[1])):
        if most < max(best[0], LEAST_SAVING):
            break
        group = listed[place]
        helper, shared = _helper_of(group, {letter for letter, _ in common[place]}, programs, taken, back)
        if helper and (_saving(group, shared), -place) > best:
            best, found = (_saving(group, shared), -place), (helper, group, shared)
    return found


def _saving(group: Sequence[str], shared: Collection[Any]) -> int:
    return (len(group) - 1) * len(shared) - len(group) - HEAD


def _helper_of(
    group: Sequence[str], shared: set[str], programs: Mapping[str, Program], taken: set[str], back: bool
) -> tuple[Program | None, set[str]]:
    """Return a helper for a group of programs and its names; they are narrowed if too many values would be passed."""
    callers = [programs[key] for key in group]
    for narrowed in (False, True):
        shared = _closed_in_all(_narrow(shared, callers[0]) if narrowed else shared, callers, back)
        if _saving(group, shared) < LEAST_SAVING:
            break
        helper = _helper(taken, callers[0], shared, callers)
        if max(len(helper.inputs), len(helper.outputs)) <= MOST_PASSED:
            return helper, shared
    return None, shared


def _narrow(shared: set[str], program: Program) -> set[str]:
    """Return the largest set of shared names on which one of them depends, and of which others read few names."""
    steps = [step for step in program.steps if step.name in shared]
    bits: dict[Any, int] = {step.name: 1 << place for place, step in enumerate(steps)}
    above, through, readers = dict[Any, int](), dict[Any, int](), dict[Any, int](dict.fromkeys(bits, 0))
    for statement in program.statements:
        own = bits.get(statement.name, 0) if isinstance(statement, Assignment) else 0
        read = _union(bits.get(arg, 0) | through.get(arg, 0) for arg in statement.args)
        if isinstance(statement, Assignment):
            above[statement.name] = own | _union(above.get(arg, 0) for arg in statement.args)
            if statement.inline:
                through[statement.name] = read
                continue
        for name in (name for name, bit in bits.items() if bit & read):
            readers[name] |= own or 1 << len(steps)

    def passed(inside: int) -> int:
        return sum(1 for name, bit in bits.items() if bit & inside and readers[name] & ~inside)

    few = [above[name] for name in bits if passed(above[name]) <= MOST_PASSED]
    best = max(few, key=int.bit_count, default=0)
    return {name for name, bit in bits.items() if bit & best}


def _union(masks: Iterable[int]) -> int:
    return reduce(or_, masks, 0)


def _closed_in_all(shared: set[str], programs: Sequence[Program], back: bool) -> set[str]:
    """Return the shared names that a helper can hold for all programs; see `_closed`."""
    before = set[str]()
    while shared != before:
        before = shared
        shared = shared.intersection(*(_closed(shared, program, back) for program in programs))
    return shared


def _written_out(program: Program) -> Steps:
    inlined, named = dict[Any, Any](), dict[str, Any]()
    for step in program.steps:
        found = step.op, tuple(inlined.get(arg, arg) for arg in step.args)
        (inlined if step.inline else named)[step.name] = found
    return named


def _closed(shared: set[str], program: Program, back: bool) -> set[str]:
    """Return the shared names, less each that depends, or if ``back`` is depended on, through steps not shared."""
    inside, outside, kept = set[Any](), set[Any](), set[str]()
    moved = {step.name for step in _moved(program, shared)}
    for statement in program.statements[:: -1 if back else 1]:
        before, after = (statement.args, _assigned(statement))[:: -1 if back else 1]
        if not outside.isdisjoint(before):
            outside.update(after)
        elif isinstance(statement, Assignment) and statement.name in moved:
            inside.update(after)
            kept.add(statement.name)
        elif not inside.isdisjoint(before):
            outside.update(after)
    return kept & shared


def _assigned(statement: Statement) -> tuple[str, ...]:
    if isinstance(statement, Assignment):
        return (statement.name,)
    return tuple(name for name in statement.names if name != "_")


def _moved(program: Program, shared: set[str]) -> list[Assignment]:
    needed, found = set[Any](shared), []
    inline = {step.name for step in program.steps if step.inline}
    for step in reversed(program.steps):
        if step.name in needed:
            found.append(step)
            needed |= inline.intersection(step.args)
    return found[::-1]


def _helper(taken: set[str], program: Program, shared: set[str], callers: Sequence[Program]) -> Program:
    moved = _moved(program, shared)
    made = {step.name for step in moved}
    given = dict.fromkeys(arg for step in moved for arg in step.args if isinstance(arg, str) and arg not in made)
    read = set[Any]().union(*(_read_elsewhere(caller, shared) for caller in callers))
    outputs = tuple(step.name for step in moved if step.name in shared & read)
    return Program(_name(outputs, taken), tuple((letter, (letter,)) for letter in given), tuple(moved), outputs)


def _name(outputs: Sequence[str], taken: set[str]) -> str:
    """Return a name that tells the first and the last result: ``s_and_w``, ``p_to_h``, ``p_to_h_2``."""
    name = ("_and_" if len(outputs) == 2 else "_to_").join(dict.fromkeys((outputs[0], outputs[-1])))
    numbered = itertools.chain([name], (f"{name}_{number}" for number in itertools.count(2)))
    return next(free for free in numbered if free not in taken)


def _read_elsewhere(program: Program, shared: set[str]) -> set[Any]:
    return {arg for other in _others(program, _moved(program, shared)) for arg in other.args} | set(program.outputs)


def _others(program: Program, moved: Collection[Assignment]) -> list[Statement]:
    names = {step.name for step in moved}
    return [other for other in program.statements if not isinstance(other, Assignment) or other.name not in names]


def _caller(program: Program, helper: Program, shared: set[str]) -> Program:
    """Return a program that calls a helper for its shared steps, with statements in a valid order."""
    moved, read = _moved(program, shared), _read_elsewhere(program, shared)
    names = tuple(str(output) if output in read else "_" for output in helper.outputs)
    call = Call(names, helper.name, tuple(letter for letter, _ in helper.inputs))
    pending = [call if other is moved[0] else other for other in _others(program, moved[1:])]
    known = {letter for _, letters in program.inputs for letter in letters}
    ordered: list[Statement] = []
    while pending:
        ready = next(s for s in pending if all(not isinstance(arg, str) or arg in known for arg in s.args))
        pending.remove(ready)
        ordered.append(ready)
        known.update(_assigned(ready))
    return replace(program, statements=tuple(ordered))
