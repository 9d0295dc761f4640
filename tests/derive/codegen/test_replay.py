"""The replay on floats: what only floats execute is wrong once, and it is seen."""

from __future__ import annotations

import dataclasses
import itertools
import re
import sys
from pathlib import Path

import mpmath
import numpy as np
import pytest

from derive.codegen.build import build
from derive.codegen.cases import samples
from derive.codegen.lowered import lower_chart
from derive.codegen.targets import TARGETS
from derive.codegen.validation import NUMPY, Seen, ValidationFailed, validate
from derive.codegen.validation.known import Analysis, require_sharp
from derive.codegen.validation.rounding import Ball, Rounding
from derive.maps import Cayley
from derive.output import files
from tests.support.packages import unvalidated

pytestmark = pytest.mark.thorough

CHART = Cayley(3)
TARGET = TARGETS["numpy"]
KERNEL, RUNTIME, BRANCHES = "_kernel.py", "_runtime.py", "_branches.py"
INTERFACE, MODULE = "_interface.py", "cayley3.py"


@pytest.fixture(scope="module")
def texts():
    return build([Cayley(3), Cayley(4)], unvalidated(TARGET)).texts


def broken(texts, folder: Path, file: str, pattern: str, replacement: str) -> Path:
    """The package with every match of a pattern in one of its files replaced."""
    changed, count = re.subn(pattern, replacement, texts[file])
    assert count
    files.write(folder, {**texts, file: changed})
    return folder


# what survived exact validation and every test of the kernels
HOLES = {
    "missing batch axes at the wrong end": (KERNEL, r"array\[\(slice\(None\),\) \* len\(part\) \+ ", "array[(...,) + "),
    "two results split at 3": (INTERFACE, r"screw\[:2, \.{3}\], screw\[2:, \.{3}\]", "screw[:3, ...], screw[3:, ...]"),
    "1/N of single poses": (MODULE, r"N / N / N", "1 / N"),
    "1/N of batches": (MODULE, r"div\(div\(N, N, \w+\), N", "div(n1, N"),
    "scratch of two calls": (KERNEL, r"self\._free\.pop\(\)", "self._free[-1]"),
}


@pytest.mark.parametrize("hole", HOLES)
def test_what_exact_validation_cannot_see_fails_the_replay(texts, tmp_path: Path, hole: str):
    folder = broken(texts, tmp_path, *HOLES[hole])
    assert validate(folder, CHART)
    with pytest.raises(ValidationFailed, match=r"cayley3\.\w+ \(float"):
        TARGET.replay(folder, CHART, all_ways=True)


OTHERS = {
    "order of arguments of a few": (
        RUNTIME, r"kernel\.plain\(Floats, chart\.plain, \*pose",
        r"kernel.plain(Floats, chart.plain, *pose[::-1]",
    ),
    "selection on floats": (
        RUNTIME, r"return a if condition else b",
        "return b if condition else a",
    ),
    "a wrong way round for a few": (
        RUNTIME, r"range\(-len\(batch\), 0\)\)\)",
        "range(-len(batch), 0)))[::-1]",
    ),
    "scratch not counted": (
        KERNEL, r"staged, scratch = _cut\(scratch, math\.prod\(part\)\)",
        "staged, _ = _cut(scratch, math.prod(part))",
    ),
    "the last block": (
        KERNEL, r"range\(0, length, step\)",
        "range(0, length - step, step)",
    ),
    "blocks of all rows but the first": (
        KERNEL, r"in np\.ndindex\(batch\[: axis - 1\]\)",
        "in list(np.ndindex(batch[: axis - 1]))[:1]",
    ),
    "a zero with a sign": (
        "_selection.py", r"np\.copyto\(out, np\.equal\(a, b\)\)",
        "np.copyto(out, np.equal(a, b) & (np.signbit(a) == np.signbit(b)))",
    ),
    "what is given in place of a result": (
        BRANCHES, r"array\.copy\(\) if out is None",
        "array if out is None",
    ),
    "another array than out where v stands": (
        BRANCHES, r"else filled\(array, out\)",
        "else array.copy()",
    ),
    "another array than out in another order": (
        RUNTIME, r"filled\(q\.take\(SCALAR_LAST\[:size\], axis\), out\)",
        "filled(q.take(SCALAR_LAST[:size], axis), None)",
    ),
    "overlap not seen": (
        RUNTIME, r"if out is None or overlaps else out",
        "if out is None else out",
    ),
    "out not written": (
        RUNTIME, r"out\[\.\.\.\] = found\n",
        "pass\n",
    ),
    "another array than out": (
        RUNTIME, r"    return out\n",
        "    return out.copy()\n",
    ),
    "out of another type": (
        KERNEL, r"rows\.dtype == dtype and \(",
        "(",
    ),
    "an alias": (
        MODULE, r"dcay = KERNELS\.tangent\b",
        "dcay = KERNELS.tangent_inv",
    ),
    "branches below 0": (
        BRANCHES, r"index %= chart\.branches",
        "index = abs(index) % chart.branches",
    ),
    "NaN of an element": (
        KERNEL, r"np\.copyto\(target, staged\.reshape\(target\.shape\)",
        "np.copyto(target, np.nan_to_num(staged.reshape(target.shape))",
    ),
    "NaN beside it": (
        KERNEL, r"np\.copyto\(staged\.reshape\(part \+ shape\), block\)",
        "np.copyto(staged.reshape(part + shape), block + 0 * block.sum(-1, keepdims=True))",
    ),
    "digits of longdouble": (
        RUNTIME, r"np\.longdouble if dtype == np\.longdouble else float",
        "float",
    ),
    "selection by flags": (
        "_selection.py", r"np\.where\(mask, a, b\)",
        "np.where(mask, b, a)",
    ),
    "overflow of a product": (
        MODULE, r"sinq = ss / sin",
        "sinq = sin",
    ),
    "order of a quaternion given": (
        RUNTIME, r"take\(SCALAR_FIRST\[:size\], axis\)",
        "take(SCALAR_LAST[:size], axis)",
    ),
    "order of a quaternion returned": (
        RUNTIME, r"q\.take\(SCALAR_LAST\[:size\], axis\)",
        "q",
    ),
    "real numbers alone": (
        "_geometry.py", r"real=False",
        "real=True",
    ),
    "a check of nothing": (
        "_checks.py", r"if not len\(bad\):",
        "if True:",
    ),
    "a check that allows too much": (
        "_checks.py", r"np\.logical_not\(size <= allowed\)",
        "np.logical_not(size <= 1e8 * allowed)",
    ),
    "where a check fails": (
        "_checks.py", r"bad\[0\]",
        "bad[-1] * 0",
    ),
    "a check of what is right": (
        "_checks.py", r"T\[15\] - 1",
        "T[15]",
    ),
    "a warning": (
        RUNTIME, r'all="ignore"',
        'all="warn"',
    ),
}


@pytest.mark.parametrize("hole", OTHERS)
def test_what_only_floats_execute_is_replayed(texts, tmp_path: Path, hole: str):
    with pytest.raises(ValidationFailed, match=r"cayley3\.\w+ \(float"):
        TARGET.replay(broken(texts, tmp_path, *OTHERS[hole]), CHART, all_ways=True)


def test_untouched_kernels_pass_and_further_charts_are_sampled(texts, tmp_path: Path):
    files.write(tmp_path, texts)
    trace = sys.gettrace()
    every = TARGET.replay(tmp_path, CHART, all_ways=True)
    some = [TARGET.replay(tmp_path, chart, all_ways=False) for chart in (CHART, Cayley(4))]
    assert every > 2 * some[0] > 1000
    assert some[1] > 500
    assert sys.gettrace() is trace


def test_a_further_chart_is_asked_for_its_own_names(texts, tmp_path: Path):
    folder = broken(texts, tmp_path, "cayley4.py", r"\ntwist = KERNELS\.twist", "\ntwist = KERNELS.body_twist")
    seen = Seen()
    seen.leave(CHART, TARGET.tables)
    with pytest.raises(ValidationFailed, match="twist is not the function twist"):
        validate(folder, Cayley(4), seen.new)


@pytest.mark.parametrize("dtype", NUMPY.dtypes, ids=str)
def test_results_off_by_more_than_rounding_fail_in_every_type(texts, tmp_path: Path, dtype):
    """A thousand units are added in one type only; the others do not see it."""
    off = 1000 * float(np.finfo(dtype).eps)
    entry = "sub(n1, mul(g, x23, k7), o1)"
    wrong = f"add({entry}, {off!r} * (o1.dtype == '{dtype}'), o1)"
    folder = broken(texts, tmp_path, "_geometry.py", re.escape(entry), wrong)
    with pytest.raises(ValidationFailed, match=rf"tensor \({dtype}"):
        TARGET.replay(folder, CHART, all_ways=False)


def test_a_bound_that_says_nothing_is_an_error():
    analysis = Analysis(CHART, lower_chart(CHART), NUMPY.dtypes)
    found = {(s.function, s.branch): s for s in samples(CHART)}
    pose = found["from_pose", (1,)]
    require_sharp(analysis.known(pose))
    rows = tuple((*row[:3], row[3] * 10**9, *row[4:]) for row in pose.arguments[0])  # beside its own result
    vague = dataclasses.replace(pose, arguments=(rows,))
    with pytest.raises(ValueError, match="from_pose: rounding may change too many digits of v"):
        require_sharp(analysis.known(vague))


RANDOM = np.random.default_rng(7)


EXACT = {
    "add": lambda a, b: a + b, "sub": lambda a, b: a - b, "mul": lambda a, b: a * b, "div": lambda a, b: a / b,
    "atan2": mpmath.atan2, "sqrt": mpmath.sqrt, "tan": mpmath.tan, "expm1": mpmath.expm1, "log1p": mpmath.log1p,
}  # fmt: skip


def test_errors_of_operands_and_of_the_operation_stay_within_the_bound():
    """Operands at both ends of their errors, computed to 50 digits; and the sum of them all is not far above."""
    rounding = Rounding((np.dtype(np.float64),))
    for (name, exact), relative in itertools.product(EXACT.items(), (1e-3, 1e-9)):
        operands = 2 if name in ("add", "sub", "mul", "div", "atan2") else 1
        values, errors = RANDOM.uniform(0.2, 1.4, (operands, 50)), relative * RANDOM.uniform(0, 1, (operands, 50))
        found = getattr(rounding, name)(*(Ball(v.astype(np.longdouble), e[None]) for v, e in zip(values, errors)))
        with mpmath.workdps(50):
            for i in range(50):
                middle, wide = values[:, i].astype(object) * mpmath.mpf(1), errors[:, i].astype(object)
                ends = (exact(*(middle + wide * signs)) for signs in itertools.product((-1, 1), repeat=operands))
                worst, bound = max(abs(end - exact(*middle)) for end in ends), float(found.error[0, i])
                assert worst <= bound * (1 + 1e-12), name
                assert bound <= 1.5 * float(worst) + 1e-14, name
