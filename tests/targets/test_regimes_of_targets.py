"""Law of regimes in every target: each function is right or not finite at the ends of charts and of number types."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from functools import cache, partial
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from benchmarks.c_form import FLAGS, CForm, compiled
from derive.codegen.rows import Table
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.validation.compiled import compiler
from derive.maps import Cayley, family
from derive.maps.chart import Chart
from tests.generated import test_whole_turns as whole_turns
from tests.support import families, native, regimes
from tests.support.libraries import Through
from tests.support.regimes import Call
from tests.support.subjects import REGIMES, Subject, subject

pytestmark = pytest.mark.filterwarnings("ignore:(invalid value|divide by zero|overflow):RuntimeWarning")

TABLES = {"": POSES, "rotation": ROTATIONS}
CHARTS: dict[str, Chart] = {"cayley3": Cayley(3), "lambert": family("lambert"), "exponential": family("exponential")}
QUICKLY = (*FLAGS, "-O1")
"""Flags for quick compilation: the final -O1 overrides earlier levels, and avoids slow vectorization."""

EVERY = (*REGIMES, *regimes.INVERSE_REGIMES[-1:])


class Facade:
    """Kernel module of a target: its functions take and return NumPy arrays, all else is that of the NumPy module."""

    def __init__(self, kernels: ModuleType, table: Table, functions: Callable[[str], Callable[..., Any]]) -> None:
        self._kernels, self._table, self._functions = kernels, table, functions

    def __getattr__(self, name: str) -> Any:
        return self._functions(name) if name in self._table.public else getattr(self._kernels, name)


def of_c(form: CForm, table: Table, dtype: Any, name: str, *given: np.ndarray) -> Any:
    """Call a C function of a type with arrays of any leading axes; shadows are those of branch 1."""
    row = table.public[name]
    shape = given[0].shape[: given[0].ndim - len(row.arguments[0].shape)]
    pairs = zip(given, row.arguments, strict=True)
    flat = [np.ascontiguousarray(a, dtype).reshape(-1, array.size) for a, array in pairs]
    made = tuple(np.empty((len(flat[0]), array.size), dtype) for array in row.results)
    form.call(name, *flat, out=made, branch=int("shadow" in name), layout="aos")
    found = tuple(m.reshape((*shape, *array.shape)) for m, array in zip(made, row.results, strict=True))
    return found if len(found) > 1 else found[0]


Functions = Callable[[str], Callable[..., Any]]
"""Functions of a target by name, on NumPy arrays."""


@pytest.fixture(scope="module")
def functions_of(
    charts: Callable[[str], ModuleType],
    folder: Callable[[str], Path],
    package: Callable[[str], str],
    shared: Callable[[str, Callable[[Path], object]], Path],
    tmp_path_factory: pytest.TempPathFactory,
) -> Iterator[Callable[[str, str, str, Any], Functions]]:
    """Provide a function that returns the functions of a target, a table, a chart and a dtype."""

    @cache
    def with_native() -> str:
        site = shared("regimes_native", lambda place: native.build(place, CHARTS.values(), *native.PLAIN)) / "site"
        return stack.enter_context(native.found("with_native", site))

    def made(target: str, table: str, name: str, dtype: Any) -> Functions:
        path = ".".join(filter(None, (table, name)))
        if target == "c":
            place, real = tmp_path_factory.mktemp("c"), {np.float64: "double", np.float32: "float"}[dtype]
            library = compiled(compiler(), folder("c"), CHARTS[name], real, place, TABLES[table], QUICKLY)
            return partial(partial, of_c, CForm(library, real, TABLES[table]), TABLES[table], dtype)
        if target == "native":
            module = importlib.import_module(f"{with_native()}.{path}")
            assert module.CHART.native
        elif target == "numba":
            module = importlib.import_module(f"{package('numba')}.{path}")
        else:
            module = Through(charts(path), target)
        return partial(getattr, module)

    with ExitStack() as stack:
        yield made


def calls(chart: Subject, place: int, share: int, dtype: Any) -> Iterator[Call]:
    """Yield in every regime a share of the calls of a share of the functions; the next regime takes others."""
    names = [name for name, row in chart.table.public.items() if regimes.takes_vectors(row)]
    names += [name for name in regimes.POSES_OF if name in chart.table.public]
    for turn, regime in enumerate(EVERY, place):
        exact = subject(chart.module.__name__.split(".")[-1], digits=regimes.DIGITS.get(regime, families.DIGITS)).oracle
        at = Subject(chart.module, exact, singles_in_double=False)
        for name in names[(5 * turn) % share :: share]:
            inverse = name in regimes.POSES_OF
            if regime in (regimes.INVERSE_REGIMES if inverse else REGIMES):
                found = list((regimes.inverse_calls if inverse else regimes.calls)(at, name, regime, dtype))
                yield from found[turn % max(len(found), 1) :: share]


def wrong(functions: Functions, table: str, name: str, place: int, share: int, dtype: Any) -> list[str]:
    kernels = subject(name, table)
    module: Any = Facade(kernels.module, TABLES[table], functions)
    chart = Subject(module, kernels.oracle, singles_in_double=False)
    return [reason for reason in (call.judged() for call in calls(chart, place, share, dtype)) if reason]


SAMPLE = [
    ("numpy", "rotation", "lambert", 41), ("numpy", "", "exponential", 41), ("jax traced", "rotation", "cayley3", 123),
]  # fmt: skip
WHOLE = [("rotation", "lambert", np.float64), ("rotation", "lambert", np.float32), ("", "cayley3", np.float64),
         ("rotation", "exponential", np.float64)]  # fmt: skip
SLOW = WHOLE[1:3]
"""JAX and Numba compile every call anew, and run the text that NumPy runs: they try one table in each type, and half of
the calls that others try."""
WITH_COMPILER = [("numba", *one) for one in SLOW] + [(target, *one) for target in ("c", "native") for one in WHOLE]


@pytest.mark.parametrize(("target", "table", "name", "share"), SAMPLE)
def test_a_sample_is_right_or_not_finite(functions_of: Any, target: str, table: str, name: str, share: int) -> None:
    functions = functions_of(target, table, name, np.float64)
    assert wrong(functions, table, name, len(target), share, np.float64) == []


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("target", "table", "name", "dtype"),
    [
        *(("numpy", *one) for one in WHOLE), *(("jax", *one) for one in SLOW),
        *(pytest.param(*one, marks=pytest.mark.compiler) for one in WITH_COMPILER),
    ],
)
def test_functions_are_right_or_not_finite(functions_of: Any, target: str, table: str, name: str, dtype: Any) -> None:
    functions = functions_of(target, table, name, dtype)
    share = 26 if target in ("jax", "numba") else 13
    assert wrong(functions, table, name, WHOLE.index((table, name, dtype)), share, dtype) == []


@pytest.mark.parametrize("target", ["numpy", pytest.param("c", marks=(pytest.mark.thorough, pytest.mark.compiler))])
def test_steps_beside_whole_turns_have_the_pose(functions_of: Any, target: str) -> None:
    kernels = subject("cayley3")
    module: Any = Facade(kernels.module, POSES, functions_of(target, "", "cayley3", np.float64))
    assert max(whole_turns.cases(Subject(module, kernels.oracle), np.float64, 3))[0] <= 1


@pytest.mark.parametrize(
    "target",
    [
        "numpy", "jax traced", pytest.param("numba", marks=pytest.mark.thorough),
        pytest.param("c", marks=[pytest.mark.compiler, pytest.mark.thorough]),
    ],
)
def test_an_axis_of_zeros_gives_nan(functions_of: Any, target: str) -> None:
    for table, name, parts in (("", "from_screw", 6), ("rotation", "from_angle_axis", 3)):
        function = functions_of(target, table, "lambert", np.float64)(name)
        angles, axes = np.repeat([0, 0.5, 2.0], 2), np.tile(np.eye(parts)[:2], (3, 1))
        axes[::2, 0] = 0
        found = function(np.c_[angles, angles] if parts == 6 else angles, axes)
        assert np.array_equal(np.isfinite(found), np.tile([[False], [True]], (3, parts))), name
        assert np.isnan(found[::2]).all(), name


def test_a_target_that_takes_nan_for_zero_is_seen() -> None:
    """Control: the law refuses an angle that is finite for NaN."""
    known = subject("lambert", "rotation")
    module: Any = Facade(known.module, ROTATIONS, lambda name: lambda v: known.module.angle(np.nan_to_num(v)))
    assert any(call.judged() for call in regimes.calls(Subject(module, known.oracle), "angle", "not finite"))
