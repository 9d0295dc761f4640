"""Recorder of programs: operations, selections by bits and booleans, constants, shared entries, order, rows."""

from __future__ import annotations

import math
import signal
import sys
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from functools import partial
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import pytest
from numpy.typing import NDArray

from dualcay import _kernel, _packed, _prepared, _program, _recorder, cayley1, cayley2, cayley3
from dualcay._numbers import Floats, Objects, Scalars
from dualcay._program import Program
from dualcay._recorder import Number, record

Text = Callable[..., tuple[Any, ...]]
DTYPES = [np.float32, np.float64, np.longdouble, np.complex64, np.complex128]
REAL = DTYPES[:3]


def run(program: Program, *arguments: NDArray[Any], outputs: int) -> list[NDArray[Any]]:
    """Run a program in fresh memory filled with NaN; return its outputs."""
    shape, dtype = arguments[0].shape, program.dtype
    found = [np.full(shape, np.nan, dtype) for _ in range(outputs)]
    scratch = [np.full(shape, np.nan, dtype) for _ in range(program.scratch)]
    masks = program.mask_rows(np.zeros((program.masks, *shape), dtype))
    program.run([*arguments, *program.constants, *found, *scratch, *masks])
    return found


def recorded(text: Text, dtype: Any, *arguments: Any, outputs: int = 1) -> list[NDArray[Any]]:
    """Record a program written for single numbers; return its results on arrays."""
    arrays = [np.array(a, dtype) for a in arguments]
    program = record(lambda m, *groups: text(m, *(a for (a,) in groups)), [1] * len(arrays), np.dtype(dtype))
    return run(program, *arrays, outputs=outputs)


ARITHMETIC: dict[str, Callable[[Any, Any], Any]] = {
    "a + b": lambda a, b: a + b,
    "2 + a": lambda a, b: 2 + a,
    "a - b": lambda a, b: a - b,
    "2 - a": lambda a, b: 2 - a,
    "a * b": lambda a, b: a * b,
    "3 * a": lambda a, b: 3 * a,
    "a / b": lambda a, b: a / b,
    "1 / a": lambda a, b: 1 / a,
    "b / 4": lambda a, b: b / 4,
    "b / 3": lambda a, b: b / 3,
    "-a": lambda a, b: -a,
}


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("operation", ARITHMETIC)
def test_arithmetic_matches_numpy(operation: str, dtype: type) -> None:
    a, b = np.array([1.5, -2.0, 0.25], dtype), np.array([3.0, 7.0, -0.5], dtype)
    (found,) = recorded(lambda m, a, b: (ARITHMETIC[operation](a, b),), dtype, a, b)
    expected = ARITHMETIC[operation](a, b)
    np.testing.assert_array_equal(found, expected)
    np.testing.assert_array_equal(*(np.signbit(z.view(z.real.dtype)) for z in (found, expected)))  # of zeros
    assert found.dtype == dtype


@pytest.mark.parametrize("dtype", REAL)
@pytest.mark.parametrize(
    ("name", "ufunc", "count"),
    [("abs", np.absolute, 1), ("sqrt", np.sqrt, 1), ("tan", np.tan, 1), ("atan2", np.arctan2, 2),
     ("expm1", np.expm1, 1), ("log1p", np.log1p, 1), ("beside", np.add, 2)],
)  # fmt: skip
def test_functions_match_numpy(name: str, ufunc: np.ufunc, count: int, dtype: type) -> None:
    arguments = [np.array([0.5, 1.5, 2.5], dtype), np.array([2.0, 0.25, 1.0], dtype)][:count]
    (found,) = recorded(lambda m, *a: (getattr(m, name)(*a),), dtype, *arguments)
    np.testing.assert_array_equal(found, ufunc(*arguments))


@pytest.mark.parametrize("dtype", DTYPES)
def test_reciprocals_are_those_of_the_dtype(dtype: type) -> None:
    z = np.array([0.5, 1.5, 2.5], dtype)
    (found,) = recorded(lambda m, z: (m.reciprocals(z, 3, 49)[1] * z,), dtype, z)
    np.testing.assert_array_equal(found, 1 / dtype(49) * z)
    for functions, of in ((Floats, float), (Objects, Fraction), (Objects, mpmath.mpf), (Scalars, np.longdouble)):
        (value,) = functions.reciprocals(of(2), 49)
        assert (value, type(value)) == (1 / of(49), of)


@pytest.mark.parametrize("dtype", REAL)
def test_selection_keeps_every_bit_of_the_chosen_side(dtype: type) -> None:
    a = [1.5, math.inf, -0.0, math.nan, 2.0]
    b = [-1.0, 3.0, 0.0, 4.0, math.nan]
    (found,) = recorded(lambda m, c, a, b: (m.where(c < 1, a, b),), dtype, [0, 0, 0, 1, 1], a, b)
    np.testing.assert_array_equal(found, np.array([1.5, math.inf, -0.0, 4.0, math.nan], dtype))
    assert np.signbit(found[2])


CONDITIONS: dict[str, Callable[[Any, Any], Any]] = {
    "a < b": lambda a, b: a < b,
    "a > b": lambda a, b: a > b,
    "0 < a": lambda a, b: a > 0,
    "a == b": lambda a, b: a == b,
    "a == 1": lambda a, b: a == 1,
    "(a < b) & (0 < a)": lambda a, b: (a < b) & (a > 0),
    "(a < b) | (a == 3)": lambda a, b: (a < b) | (a == 3),
    "(a < b) & (0 < 1)": lambda a, b: (a < b) & (0 < 1),  # programs may compare constants
    "(a < b) | (0 < 0)": lambda a, b: (a < b) | (0 < 0),
    "(0 < 0) & (a < b)": lambda a, b: (0 < 0) & (a < b),
}


@pytest.mark.parametrize("dtype", REAL)
@pytest.mark.parametrize("condition", CONDITIONS)
def test_conditions_select_as_in_numpy(condition: str, dtype: type) -> None:
    a, b = np.array([1.0, 3.0, -1.0, 2.0, math.nan], dtype), np.array([2.0, 3.0, 0.0, -2.0, 1.0], dtype)
    ask = CONDITIONS[condition]
    (found,) = recorded(lambda m, a, b: (m.where(ask(a, b), a, 7),), dtype, a, b)
    np.testing.assert_array_equal(found, np.where(ask(a, b), a, np.array(7, dtype)))


@pytest.mark.parametrize("dtype", REAL)
def test_conditions_themselves_are_selected(dtype: type) -> None:
    a = np.array([1.0, 3.0, -1.0, 2.0], dtype)
    (found,) = recorded(lambda m, a: (m.where(m.where(a < 2, a < 0, a > 2), 1, 0),), dtype, a)
    np.testing.assert_array_equal(found, [0, 1, 1, 0])


def repeated(pattern: Sequence[str], m: Any, v: Sequence[Any]) -> list[Any]:
    """Return one output per letter of the pattern: the argument, one of two other values, or a constant."""
    values = {"a": v[0], "s": v[0] + 2, "t": v[0] * v[0], "5": 5}
    return [values[letter] for letter in pattern]


def test_outputs_repeat_in_any_pattern() -> None:
    a, generator = np.array([[1.0, 2.0]]), np.random.default_rng(0)
    for _ in range(100):
        pattern = generator.choice([*"ast5"], 12, p=[0.1, 0.4, 0.4, 0.1])
        values = {"a": a[0], "s": a[0] + 2, "t": a[0] * a[0], "5": np.full(2, 5.0)}
        wanted = np.array([values[letter] for letter in pattern])
        program = record(partial(repeated, pattern), [1], a.dtype)
        found = np.full_like(wanted, np.nan)
        _prepared.Prepared(program, [(1,)], 0, wanted.shape[:1], a.shape[1:], axis=0).run([a], found)
        np.testing.assert_array_equal(found, wanted)
        np.testing.assert_array_equal(run(program, a[0], outputs=len(pattern)), wanted)


def test_constants_keep_their_sign_and_type() -> None:
    found = recorded(lambda m, a: (a * -0.0, a * 0), np.float64, [1.0], outputs=2)
    assert [bool(np.signbit(row[0])) for row in found] == [True, False]


def test_equal_operations_are_entered_once() -> None:
    tape = _recorder.Tape(np.dtype(float))
    a, b = tape.argument(), tape.argument()
    assert (a + b).index == (b + a).index
    assert (a - b).index != (b - a).index
    assert tape.negative(tape.negative(a)).index == a.index
    assert [(a - -b).index, (a + -b).index] == [(a + b).index, (a - b).index]
    assert sum(operation is not None for operation in tape.operations) == 5  # with two negatives


def test_row_is_not_reused_while_it_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    """Compare random programs with NumPy; rows freed one step early would give other results."""
    assert all(_agrees(seed) for seed in range(60))
    release = _program.Rows._release

    def early(self: Any, step: int, operands: Any, places: Any) -> None:
        release(self, step, [i for i in operands if self.last[i] == step], places)
        self.scratch.free += [row for kind, row in places.values() if kind == "scratch"][:1]

    monkeypatch.setattr(_program.Rows, "_release", early)
    assert not all(_agrees(seed) for seed in range(60))


def _agrees(seed: int, by_packing: bool = False) -> bool:
    choices = np.random.default_rng(seed).integers(0, 1 << 30, (60, 3))

    def text(m: Any, *values: Any) -> tuple[Any, ...]:
        made = [*values, 0, 1, -1]
        for kind, i, j in choices:
            a, b = made[i % len(made)], made[j % len(made)]
            made.append([a + b, a - b, a * b, m.where(a < b, b, a), -a, a / 4][kind % 6])
        return tuple(made[-9:])

    arguments = np.random.default_rng(seed).normal(size=(4, 3))
    program = record(lambda m, values: text(m, *values), [4], np.dtype(float))
    with np.errstate(all="ignore"):
        expected = np.array(np.broadcast_arrays(*text(np, *arguments)))
        found = packed(program, arguments) if by_packing else run(program, *arguments, outputs=9)
    return bool(np.array_equal(found, expected, equal_nan=True))


def packed(program: Program, arguments: NDArray[Any]) -> NDArray[Any]:
    """Run the packed calls of a program; return its outputs."""
    given, result, calls = _packed.Packing(program.listing).calls(arguments.shape[1])
    given[...] = arguments
    for one in calls:
        one()
    return result


def test_packed_row_is_not_reused_while_it_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    """Compare random programs with NumPy; rows written over while a later step reads them would give other results."""
    assert all(_agrees(seed, by_packing=True) for seed in range(60))
    monkeypatch.setattr(_packed.Packing, "_is_free", lambda *_: True)
    assert not all(_agrees(seed, by_packing=True) for seed in range(60))


@pytest.mark.parametrize(("chart", "least"), [(cayley1, 1.4), (cayley2, 1.4), (cayley3, 1)])
def test_integer_scalars_and_factors_of_a_chart_shorten_its_programs(
    monkeypatch: pytest.MonkeyPatch, chart: ModuleType, least: float
) -> None:
    """Compare calls for rates and their Jacobians with those where 0 and 1 count as any number."""

    def calls() -> int:
        monkeypatch.setattr(chart.CHART, "_recorded", {})
        programs = [chart.CHART.recorded(name, np.dtype(float), 0, (1, 0.5)[:count]) for name, count in RATES]
        return sum(len(functions) for program in programs for functions, _ in program.runs)

    present = calls()
    monkeypatch.setattr(_recorder, "_is", lambda *_: False)
    assert calls() > least * present


RATES = (("rate", 2), ("rate_jacobian", 1))


def test_recorded_number_has_no_truth_value() -> None:
    tape = _recorder.Tape(np.dtype(float))
    with pytest.raises(TypeError, match=r"m\.where"):
        bool(Number(tape, 0) < 1)


def test_program_is_recorded_once_for_each_dtype() -> None:
    chart = cayley3.KERNELS._chart
    first = chart.recorded("pose", np.dtype(np.float64), 0)
    assert chart.recorded("pose", np.dtype(np.float64), 0) is first
    assert chart.recorded("pose", np.dtype(np.float32), 0) is not first


@pytest.mark.parametrize("runs", [1, 2, 100])
def test_prepared_program_takes_new_arguments_constants_and_layouts(runs: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_prepared, "RUNS_BEFORE_PACKING", runs)
    _prepared._kept.clear()
    v = np.random.default_rng(0).normal(size=(3, 40, 6)) / 4

    def results() -> list[Any]:
        turned = [cayley3.shadow(v[0], k) for k in (1, 2, 1)]
        broadcast = cayley3.compose(v[:, :1], v[:1]), cayley3.compose(v, v[0]), cayley3.compose(v.T, v.T, axis=0)
        v[0, 20:] = np.nan  # earlier results stay as they are
        return [*turned, *broadcast, cayley3.shadow(v[0], 1), cayley3.pose(v[0].astype(np.float32)), cayley3.pose(v[0])]

    found = results()
    v[0, 20:] = np.random.default_rng(0).normal(size=(3, 40, 6))[0, 20:] / 4
    monkeypatch.setattr(_kernel, "PREPARED_MAX", -1)
    for one, expected in zip(found, results(), strict=True):
        np.testing.assert_array_equal(one, expected)


def test_few_prepared_programs_are_kept() -> None:
    for count in range(20, 20 + 2 * _prepared.KEPT_MAX):
        cayley3.pose(np.zeros((count, 6)))
    assert len(_prepared._kept) == _prepared.KEPT_MAX


@pytest.mark.parametrize("count", [100, 5000])
def test_threads_agree_with_one_another(monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    v = np.random.default_rng(0).normal(size=(count, 6)) / 4
    given = [v / share for share in range(1, 9)]
    expected = [cayley3.pose(one) for one in given]
    monkeypatch.setattr(cayley3.KERNELS._chart, "_recorded", {})
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)  # threads change places between any two operations
    try:
        with ThreadPoolExecutor(8) as pool:
            found = list(pool.map(cayley3.pose, given * 20))
    finally:
        sys.setswitchinterval(before)
    assert all(np.array_equal(one, wanted) for one, wanted in zip(found, expected * 20, strict=True))


@pytest.mark.parametrize("count", [100, 20_000])
def test_signal_handler_may_call_kernels(count: int) -> None:
    v = np.random.default_rng(0).normal(size=(count, 6)) / 4
    expected, inner = cayley3.pose(v), []

    def handler(*_: Any) -> None:
        inner.append(cayley3.pose(-v[:100]))
        np.seterr(all="raise")  # it holds for the interrupted call at most

    former = signal.signal(signal.SIGPROF, handler)
    with np.errstate():
        try:
            signal.setitimer(signal.ITIMER_PROF, 1e-3, 1e-3)
            results = [cayley3.pose(v) for _ in range(400_000 // count)]
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
            signal.signal(signal.SIGPROF, former)
    with np.errstate(all="raise"):
        assert np.isnan(cayley3.pose(np.full((count, 6), 1e200))).any()
    assert all(np.array_equal(result, expected) for result in results)
    assert inner
    assert all(np.array_equal(result, cayley3.pose(-v[:100])) for result in inner)
