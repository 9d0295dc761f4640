"""Compiled NumPy functions beneath the committed kernels: where they run, their replay, and a switch to disable them.

One distribution contains the functions of poses and of rotations.
"""

from __future__ import annotations

import importlib
import sys
import threading
import time
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.validation.replay import NUMPY, replay
from derive.maps import Cayley, family
from tests.support.kernels import load, said
from tests.support.native import PLAIN, build, found

pytestmark = [pytest.mark.compiler, pytest.mark.thorough]

CHARTS = (Cayley(3), family("exponential"))


@pytest.fixture(scope="module")
def site(shared: Callable[[str, Callable[[Path], object]], Path]) -> Path:
    """Return the folder of the installed package, built once for all test processes."""
    return shared("native", lambda place: build(place, CHARTS, *PLAIN)) / "site"


@pytest.fixture(scope="module")
def package(site: Path) -> Iterator[str]:
    """Yield the name of a package of kernels that uses the compiled functions."""
    with found("dualcay_on_native", site) as name:
        yield name


@pytest.fixture
def native(package: str) -> Callable[[int], ModuleType]:
    return lambda order: importlib.import_module(f"{package}.cayley{order}")


@pytest.mark.parametrize(("where", "table"), [("", POSES), (".rotation", ROTATIONS)], ids=["poses", "rotations"])
def test_backend_says_where_compiled_functions_run(package, where, table):
    native, numpy = (importlib.import_module(f"{name}{where}").backend() for name in (package, "dualcay"))
    assert native.keys() == numpy.keys()
    assert set(numpy.values()) == {"numpy"}
    found = {name for name, runs in native.items() if runs == "native in cayley3, exponential"}
    assert found == table.public.keys()
    assert {native[name] for name in native.keys() - found} == {"numpy"}


def test_reimport_reuses_compiled_functions(native):
    """Check that a second import does not recreate tables of the extension module, because NumPy keeps them."""
    native(3).pose(np.zeros(6))
    name = "dualcay_native.cayley3"
    first = sys.modules.pop(name)
    again = importlib.import_module(name)
    assert again is not first
    assert again.pose is first.pose


@pytest.mark.parametrize("chart", CHARTS, ids=lambda chart: chart.name)
def test_the_replay_agrees_with_the_formulas(package, chart):
    """Replay single poses, batches, components first, and branches."""
    for table in (POSES, ROTATIONS):
        module = importlib.import_module(".".join(filter(None, (package, table.name, chart.name))))
        assert module.CHART.native
        assert replay(package, chart, [NUMPY], [table], geometry=True) > 100


def test_overlapping_results_agree_with_separate_ones(native):
    memory = np.zeros((300, 8))
    v = memory[:, 1:7]
    v[...] = native(3).random(300, rng=1)
    expected = native(3).principal(2 * v)
    v *= 2
    native(3).principal(v, out=memory[:, 2:])
    np.testing.assert_array_equal(memory[:, 2:], expected)


def test_other_number_types_run_in_numpy(native):
    v = native(3).random(4, rng=2)
    for other in (v.astype(complex), v.astype(object)):
        got, expected = native(3).pose(other), load(3).pose(other)
        assert got.dtype == other.dtype
        np.testing.assert_array_equal(got, expected)
    for dtype in (np.float32, np.float64, np.longdouble):
        assert native(3).pose(v.astype(dtype)).dtype == dtype
    assert native(3).compose(v.astype(np.float32), v).dtype == np.float64


def test_singular_points_raise_no_floating_point_error(native):
    pole = np.array([np.sqrt(3.0), 0, 0, 1, 1, 1])  # next to a pole, q is nearly 0
    with np.errstate(all="raise"), warnings.catch_warnings():
        warnings.simplefilter("error")
        assert not np.isfinite(native(3).shadow(np.zeros(6), 1)).any()
        assert np.isnan(native(3).pose(np.array([np.inf, 0, 0, 0, 0, 0]))).any()
        native(3).tangent_inv(pole)
        assert np.isnan(native(3).pose(np.array([[np.nan, 0, 0, 0, 0, 0], pole]))).any(axis=(1, 2)).tolist() == [1, 0]


def test_other_threads_run_during_a_call(native):
    """Check that a long call releases the GIL: a counting thread continues during the call."""
    v, out = np.broadcast_to(native(3).random(rng=3), (400_000, 6)), np.empty((400_000, 6))
    counted, done = [0], threading.Event()

    def count() -> None:
        while not done.is_set():
            time.sleep(0.001)
            counted[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    for _ in range(50):  # a busy machine may let the thread rest during one call
        before = counted[0]
        native(3).CHART.native["compose"].function(v, v, out=out)
        during = counted[0] - before
        if during > 10:
            break
    done.set()
    thread.join()
    assert during > 10


def test_environment_variable_disables_compiled_functions(site):
    assert said(site, DUALCAY_NATIVE="0") == ("{'numpy'}\n", "")
    assert "native in" in said(site)[0]
