"""Judgement of results in the regimes of `subjects`.

Results are compared with an oracle that shares no code with the kernels. The allowed error is `families.GATE` roundings
of the norm of a part of the result, plus its change per relative change of every component of the arguments.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import mpmath
import numpy as np

from derive.codegen.rows import Function
from tests.support import errors, families, sampling
from tests.support.rotation_arguments import ROUNDINGS
from tests.support.subjects import OUTSIDE, REGIMES, RIGHT, SINGULAR, Subject, subject

SIDED = ("principal", "shadow", "shadow_jacobian", "to_screw")
"""Functions with two right results at half a turn."""
OF_AXIS = ("shadow", "shadow_jacobian", "to_screw")
"""Functions that lose digits near the identity, as the axis does, and are not finite there."""
UNDECIDED = {"whole turns": ("interpolate",), "edge": ("interpolate",), "overflow": ("interpolate",)}
"""Functions by regime that the oracle does not decide: its steps are too long next to whole turns and edges."""
DIGITS = {"tiny": 700, "overflow": 700}
"""Digits of the oracle by regime, where squares of squares meet 1; `families.DIGITS` elsewhere."""
NOISE = 1e4  # rounding errors of the oracle, whose `tie` is the root of one
OF_ANY_VECTOR = ("inverse",)
"""Functions that are right for every vector: −v is the inverse wherever v has a pose."""


@dataclass(frozen=True)
class Call:
    """Call of a function with a vector of a regime in one place, and ordinary values in the others."""

    chart: Subject
    row: Function
    given: tuple[np.ndarray, ...]
    fate: str
    violation: float = 0.0  # rounding of entries of a matrix, which is then no exact rotation
    branch: tuple[int, ...] = ()
    gate: float = families.GATE

    def run(self, *arrays: np.ndarray) -> tuple[np.ndarray, ...]:
        """Return the results of the function, also of batches."""
        return _tuple(getattr(self.chart.module, self.row.name)(*arrays, *self.branch))

    def among(self) -> tuple[np.ndarray, ...]:
        """Return the results in a batch that runs recorded programs."""
        return tuple(part[-1] for part in self.run(*(np.repeat(a[None], sampling.CROWD, axis=0) for a in self.given)))

    def judged(self) -> str:
        """Return why the single result or one in a batch is wrong; an empty string if both are right."""
        alone, among = self.run(*self.given), self.among()
        reason = self._wrong(among)
        doubles = alone[0].dtype == np.float32 and self.chart.singles_in_double
        if doubles and (self.fate == OUTSIDE or not self.row.real):  # equal to float64, rounded
            reason = reason or self._rounded(alone)
            if self.fate == OUTSIDE and reason:  # where a root is not real, the single runs in float32 too
                reason = self._wrong(among) or self._wrong(alone)
        elif not (reason := reason or self._wrong(alone)) and [*map(_finite, alone)] != [*map(_finite, among)]:
            reason = "" if doubles else f"single and batch are finite in other places: {alone}, {among}"
        return f"{self.row.name}{self.given}{self.branch}, {self.fate}: {reason}" if reason else ""

    def _rounded(self, alone: tuple[np.ndarray, ...]) -> str:
        """Return why a single result is not that in double precision, rounded once; the range is that of doubles."""
        doubles = self.run(*(array.astype(np.float64) for array in self.given))
        with np.errstate(over="ignore"):
            expected = [array.astype(np.float32) for array in doubles]
        same = all(np.array_equal(one, two, equal_nan=True) for one, two in zip(alone, expected, strict=True))
        return "" if same else f"not the result of doubles rounded once: {alone}, {doubles}"

    def _wrong(self, found: tuple[np.ndarray, ...]) -> str:
        finite = [bool(np.isfinite(array).all()) for array in found]
        if self.fate == OUTSIDE:
            inside = all(np.isfinite(array.ravel()[:3]).all() for array in self.given)  # only dual parts are not finite
            allowed = self.row.source in OF_ANY_VECTOR or not (all(finite) if inside else any(finite))
            return "" if allowed else f"finite: {found}"
        if self.fate == SINGULAR and not all(finite):
            return ""
        dtypes = {array.dtype for array in self.given} | {array.dtype for array in found}
        if len(dtypes) > 1:
            return f"of another type: {found}"
        values = self._values
        if not all(finite):
            return f"not finite: {found}" if self._must_be_finite(found) else ""
        if not np.isfinite(max(errors.norm(part) for part in values[0])):
            return f"finite: {found}" if any(map(_unknown, values[0])) else ""
        for sizes in (norms, self._scales):  # norms are parts of the scales, cheap, and most often enough
            error = self.error(found, sizes)
            if error <= self.gate:
                return ""
        return f"{error:.3g} eps, allowed {self.gate}: {found}, {values[0]}"

    def finite(self) -> bool:
        """Return whether a call in a batch has a finite result, or must have one."""
        found = self.among()
        return self._must_be_finite(found) or all(np.isfinite(part).all() for part in found)

    def _must_be_finite(self, found: tuple[np.ndarray, ...]) -> bool:
        largest = max(errors.norm(part) for part in self._values[0])
        return self.fate == RIGHT and largest < float(np.finfo(found[0].dtype).max) / 8

    def bound(self) -> float:
        """Return a quick upper bound of the error in a batch."""
        return self.error(self.among(), norms)

    @cached_property
    def _values(self) -> list[list[np.ndarray]]:
        """Return the right results: one, or those of both sides at half a turn."""
        return [self._exact(*self.given), *self._other_side()]

    def error(self, found: tuple[np.ndarray, ...], sizes: Callable[[Any], list[float]] | None = None) -> float:
        """Return the largest error of a part, in roundings of its size, for the nearest of the right results.

        Without ``sizes``, this is the norm of a part plus its changes. With `norms`, the error is larger, and quick.
        """
        got = families.parts(found if len(found) > 1 else found[0]) if self.row.pose is None else found
        limits = np.finfo(found[0].dtype)
        length = 1 + min(max(errors.norm(array) for array in self.given), 1e60)
        lost = ROUNDINGS * float(limits.smallest_subnormal) * length**4 + NOISE * self.chart.oracle.tie**2
        unit, scales = max(float(limits.eps), self.violation), (sizes or self._scales)(self._values[0])
        off = ([max(0.0, _distance(*pair) - lost) for pair in zip(got, exact, strict=True)] for exact in self._values)
        return min(max(errors.ratio(far, unit * size) for far, size in zip(one, scales, strict=True)) for one in off)

    def _scales(self, exact: list[np.ndarray]) -> list[float]:
        """Return the norm of each part of a result, plus its changes by rounding of arguments and factors."""
        sizes = families.scale(self._exact, list(self.given), exact)
        if self.row.source in families.BY_FACTORS:
            further = families.scale_of_factors(self.chart.oracle, self.row.source, *self._of_poses(*self.given))
            sizes = [a + b for a, b in zip(sizes, further[:: 4 // len(sizes)], strict=True)]
        if (any(self.branch) and self.row.source in POSES_OF) or self.row.source == "interpolate":  # rounds its angle
            known = self.chart.oracle
            turned = known.to_exponential(getattr(known, self.row.source)(*self._of_poses(*self.given), *self.branch))
            moved = families.scale(partial(self._at_share, turned), [np.ones(1)], exact)
            sizes = [a + b for a, b in zip(sizes, moved, strict=True)]
        return sizes

    def _at_share(self, w: np.ndarray, share: np.ndarray) -> list[np.ndarray]:
        known = self.chart.oracle
        return self._parts(known.from_exponential(known.field.number(share[0]) * w))

    def _of_poses(self, *given: Any) -> list[Any]:
        """Return the arguments of the function of poses, with dual parts 0 for rotations."""
        arrays = (self.row.pose or self.row).arguments
        embedded = self.row.embedded([tuple(np.ravel(array)) for array in given], 0.0)
        return [np.array(part, object).reshape(a.shape) for part, a in zip(embedded, arrays, strict=True)]

    def _exact(self, *given: Any) -> list[np.ndarray]:
        return self._parts(getattr(self.chart.oracle, self.row.source)(*self._of_poses(*given), *self.branch))

    def _parts(self, result: Any) -> list[np.ndarray]:
        """Return the parts of a result of the oracle: real and dual ones, or one for each array of rotations."""
        if self.row.pose is None:
            return families.parts(result)
        flat = self.row.part(np.concatenate([np.ravel(array) for array in _tuple(result)]))
        return np.split(np.array(flat), np.cumsum([array.size for array in self.row.results])[:-1])

    def _other_side(self) -> list[list[np.ndarray]]:
        """Return the other right results at half a turn: the opposite axis, the angle or the edge on its other side."""
        name, given, known = self.row.source, self._of_poses(*self.given), self.chart.oracle
        sided = name in SIDED or name in POSES_OF
        if sided and not self._is_half_turn(getattr(known, name)(*given) if name in POSES_OF else given[0]):
            return []
        if name in POSES_OF and any(self.branch):  # turns about the opposite axis are counted from the other side
            return [self._parts(getattr(known, name)(*given, -1 - self.branch[0]))]
        if name == "principal" or name in POSES_OF:
            return [self._parts(known.shadow(getattr(known, name)(*given), branch)) for branch in (1, -1)]
        if name == "to_screw":
            angle, axis = known.to_screw(*given)
            return [self._parts((np.array([2 * known.field.pi - angle[0], -angle[1]]), -axis))]
        if name in families.STEPS and known.order == 2 and self._turns_half(given[-1]):
            return [self._parts(getattr(known, name)(*given, other=True))]
        if name == "from_exponential" and self.chart.edge < 3.2 and self._turns_half(given[-1]):
            return [[-part for part in self._exact(*self.given)]]
        return [self._parts(getattr(known, name)(*given, -(self.branch or (1,))[0]))] if name in SIDED else []

    def _is_half_turn(self, v: np.ndarray) -> bool:
        """Tell whether the pose of a vector turns by π to 64 roundings, so that both axes are right."""
        known = self.chart.oracle
        rounding = max(float(np.finfo(self.given[0].dtype).eps), self.violation)
        return bool(abs(known.to_screw(v)[0][0] - known.field.pi) < 64 * rounding)

    def _turns_half(self, delta: np.ndarray) -> bool:
        """Tell whether a step turns by π to 8 roundings, so that both branches are equally near."""
        return bool(abs(np.linalg.norm(delta[:3].astype(float)) / np.pi - 1) < 8 * np.finfo(self.given[0].dtype).eps)


def _tuple(result: Any) -> tuple[Any, ...]:
    return result if isinstance(result, tuple) else (result,)


def _distance(found: np.ndarray, exact: np.ndarray) -> float:
    return errors.norm(np.reshape(exact, np.shape(found)) - found.astype(object))


def norms(exact: list[np.ndarray]) -> list[float]:
    return [errors.norm(part) for part in exact]


def _unknown(part: np.ndarray) -> bool:
    return any(map(mpmath.isnan, np.ravel(part)))


def _finite(array: np.ndarray) -> list[bool]:
    return np.isfinite(array).ravel().tolist()


STEP = ("w", "delta")  # arguments that are vectors of the exponential


def takes_vectors(row: Function) -> bool:
    return any(array.vector or array.name in STEP for array in row.arguments)


def calls(chart: Subject, name: str, regime: str, dtype: Any = np.float64) -> Iterator[Call]:
    """Yield calls of a function of vectors, with the vectors of a regime in each place where one may stand."""
    row = chart.table.public[name]
    undecided = row.source in UNDECIDED.get(regime, ())
    counted = chart.module.CHART.branches != 0  # else shadows may end, and the oracle has no derivative of them
    if (row.source == "shadow_jacobian" and not counted) or (row.source == "angle" and chart.edge == np.inf):
        return
    if regime == "half turn" and abs(chart.edge - 3 * np.pi) < 1 and row.source in ("shadow", "shadow_jacobian"):
        return  # the shadow of half a turn lies at the edge, and both sides of the edge are right
    rng = sampling.generator(name, regime)
    steps = subject("exponential", chart.table.name)
    usual = [_usual(chart, steps, array, rng).astype(dtype) for array in row.arguments]
    for place, array in enumerate(row.arguments):
        if array.vector or array.name in STEP:
            for fate, vectors in REGIMES[regime](chart if array.vector else steps, dtype):
                lost = row.source in OF_AXIS and (regime in ("identity", "tiny") or not counted)
                for v in vectors if fate == OUTSIDE or not undecided else ():
                    may = SINGULAR if lost and fate == RIGHT else fate
                    yield Call(chart, row, (*usual[:place], v, *usual[place + 1 :]), may)


# --- inverse maps -------------------------------------------------------------------------------------------------

POSES_OF = {"from_quaternion": "quaternion", "from_tensor": "tensor", "from_pose": "pose"}
NORMS = (-1.0, 2.0, 1e-3, 1e10)


def inverse_calls(chart: Subject, name: str, regime: str, dtype: Any = np.float64) -> Iterator[Call]:
    """Yield calls of an inverse map with the poses of a regime's vectors, and with others of the same regime."""
    row = chart.table.public[name]
    for given, fate in _poses(chart, getattr(chart.module, POSES_OF[name]), regime, dtype):
        rounded = regime == "few digits" and np.ndim(given) > 1
        yield Call(chart, row, (np.asarray(given, dtype),), fate, 1e-6 * rounded)


def _poses(chart: Subject, forward: Callable[..., Any], regime: str, dtype: Any) -> Iterator[tuple[Any, str]]:
    """Yield representations of poses, and what an inverse map of them may return."""
    usual = forward(chart.at([chart.size(1.0)], np.float64)[0])
    if regime == "not finite":
        for index in np.ndindex(usual.shape):
            for wrong in (np.nan, np.inf, -np.inf):
                given = usual.copy()
                given[index] = wrong
                yield given, OUTSIDE
        if usual.ndim == 1:
            yield 0 * usual, OUTSIDE
    elif regime == "other norms":
        yield from ((norm * usual, RIGHT) for norm in NORMS if usual.ndim == 1)
    elif regime == "half turn":
        for u in () if chart.edge < 3.2 else sampling.unit_vectors(sampling.generator("half turns"), (6,)):
            if usual.ndim == 1:
                yield np.concatenate([[0], u, np.zeros(4)])[: usual.size], RIGHT
                continue
            given = np.zeros(usual.shape) if usual.shape != (4, 4) else np.eye(4)
            (given[0] if usual.ndim == 3 else given)[:3, :3] = 2 * np.outer(u, u) - np.eye(3)
            yield given, RIGHT
    else:
        for fate, vectors in REGIMES[regime](chart, np.float64):
            for v in vectors if fate == RIGHT and np.isfinite(vectors).all() else ():
                given = forward(v)
                if np.isfinite(given).all():
                    yield given.round(6) if regime == "few digits" else given, fate


INVERSE_REGIMES = ("identity", "tiny", "ordinary", "half turn", "few digits", "far", "not finite", "other norms")


def _usual(chart: Subject, steps: Subject, array: Any, rng: np.random.Generator) -> np.ndarray:
    """Return an ordinary value of an argument; vectors are short, so that products stay inside the edge."""
    drawn = rng.uniform(0.1, 1, size=array.shape)
    if array.vector or array.name in STEP:
        size = (chart if array.vector else steps).size(0.3)
        drawn[:3] *= size / np.linalg.norm(drawn[:3])
    return np.asarray(drawn)
