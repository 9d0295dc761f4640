"""Tests of mutants of tokens and programs: operators change what is intended, samples are stable, trials end."""

from __future__ import annotations

import contextlib
import io
import os
import signal
import time
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import partial
from itertools import islice
from multiprocessing import get_context
from typing import Any
from unittest import mock

import pytest

from derive.codegen.programs.program import Assignment, Program
from derive.codegen.signatures import lower_chart
from derive.codegen.targets import python
from derive.maps import Cayley, family
from tests.mutants import __main__ as command
from tests.mutants.lines import changes as line_changes
from tests.mutants.mutant import KILLED, SURVIVED, Mutant, Verdict, sampled, tried
from tests.mutants.programs import changes, replaced

STEPS = (Assignment("d", "sub", ("v1", "v2"), False), Assignment("e", "mul", (3, "d"), False))
DIFFERENCE = Program("f", (("v", ("v1", "v2")),), STEPS, ("e", "d"))


def mutant(trial: Callable[[], Verdict], change: str = "") -> Mutant:
    return Mutant("place", "sign", change, trial)


@pytest.mark.smoke
def test_program_changes_are_of_operation_operand_constant_and_outputs() -> None:
    assert {(operator, words) for operator, words, _ in changes(DIFFERENCE)} == {
        ("operation", "d = sub(v1, v2) → d = add(v1, v2)"),
        ("operands swapped", "d = sub(v1, v2) → d = sub(v2, v1)"),
        ("operand", "d = sub(v1, v2) → d = sub(v2, v2)"),
        ("operand", "d = sub(v1, v2) → d = sub(v1, v1)"),
        ("operation", "e = mul(3, d) → e = div(3, d)"),
        ("constant", "e = mul(3, d) → e = mul(4, d)"),
        ("constant", "e = mul(3, d) → e = mul(2, d)"),
        ("constant", "e = mul(3, d) → e = mul(-3, d)"),
        ("operand", "e = mul(3, d) → e = mul(3, v2)"),
        ("order of outputs", "outputs 0 and 1 swapped"),
    }
    assert all(changed != DIFFERENCE for _, _, changed in changes(DIFFERENCE))
    assert replace(DIFFERENCE, outputs=("d", "e")) in {changed for _, _, changed in changes(DIFFERENCE)}


@pytest.mark.parametrize("chart", [Cayley(3), family("exponential")], ids=lambda chart: chart.name)
def test_a_changed_program_is_printed(chart: Any) -> None:
    scalars = lower_chart(chart).scalars
    printed = python.printed_scalars(chart, scalars)
    for program in scalars.values():
        for *_, mutated in islice(changes(program), 1):
            with replaced(program, mutated):
                assert python.printed_scalars(chart, scalars) != printed, program.name


@pytest.mark.parametrize(
    ("line", "changed"),
    [
        ("y = a + b", "y = a - b"),
        ("y = a * b", "y = a / b"),
        ("y = a < b", "y = a <= b"),
        ("if not a:", "if a:"),
        ("y = a[2]", "y = a[3]"),
        ("y = sin(a)", "y = cos(a)"),
        ("{% if n == 1 %}", "{% if n != 1 %}"),
    ],
)
def test_line_changes_swap_a_token(line: str, changed: str) -> None:
    assert changed in {text for *_, text in line_changes(line)}


@pytest.mark.smoke
def test_prose_is_not_mutated() -> None:
    text = '"""One + 1."""\n# 2 * 3\nx = f("4 + 5")  # 6\n{# 7 < 8 #}\ny = a + 9\n'
    assert {line for line, *_ in line_changes(text)} == {5}


def test_added_mutants_leave_the_others_in_the_sample() -> None:
    many = [mutant(partial(Verdict, SURVIVED), str(i)) for i in range(100)]
    first, fewer = sampled(many, 20, 1), sampled(many[1:], 20, 1)
    assert len({*map(str, first)} & {*map(str, fewer)}) >= 19
    assert first != sampled(many, 20, 2)


@pytest.fixture(scope="module")
def run_apart() -> Iterator[Callable[..., Any]]:
    """Run a function in a new interpreter without threads, because trials fork."""
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        yield lambda function, *given: pool.submit(function, *given).result()


def four_trials() -> list[Verdict]:
    def late() -> Verdict:
        time.sleep(0.2)
        return Verdict(SURVIVED)

    def wrong() -> Verdict:
        raise ValueError("no pose")

    trials = [late, wrong, lambda: os.kill(os.getpid(), signal.SIGKILL)]
    return list(tried([mutant(trial) for trial in trials], jobs=3))  # type: ignore[arg-type]


def run_command(kinds: Mapping[str, str], *arguments: str) -> tuple[int, str]:
    """Return exit code and output of the command, for one room with these verdicts."""
    room = [mutant(partial(Verdict, kind, "tests"), change) for change, kind in kinds.items()]
    with mock.patch.object(command, "ROOMS", {"some": lambda: room}), contextlib.redirect_stdout(io.StringIO()) as out:
        return command.main(["--room", "some", *arguments]), out.getvalue()


@pytest.mark.thorough
def test_trials_are_isolated_and_verdicts_come_in_order(run_apart: Callable[..., Any]) -> None:
    found = run_apart(four_trials)
    assert [verdict.kind for verdict in found] == [SURVIVED, KILLED, KILLED]
    assert found[1].by == "exception ValueError: no pose"
    assert found[2].by == "crash"


@pytest.mark.thorough
@pytest.mark.parametrize(("floor", "code"), [("50", 0), ("51", 1)])
def test_command_prints_survivors_and_holds_rooms_to_the_floor(
    floor: str, code: int, run_apart: Callable[..., Any]
) -> None:
    verdicts = {"unchanged": SURVIVED, "a": KILLED, "b": SURVIVED}
    found, said = run_apart(run_command, verdicts, "--floor", floor)
    assert found == code
    assert "some: survives: place: sign: b" in said
    assert "some: 1 of 2 killed (50.0 %; 1 by tests); drawn from 2" in said


@pytest.mark.thorough
def test_unchanged_tree_must_pass(run_apart: Callable[..., Any]) -> None:
    code, _ = run_apart(run_command, {"unchanged": KILLED})
    assert code == 3


def test_unknown_rooms_are_refused() -> None:
    with pytest.raises(SystemExit):
        command.main(["--room", "other"])
