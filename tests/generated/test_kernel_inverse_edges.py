"""Laws of inverse maps over all charts and dtypes: quaternions of any norm, numbers not finite, half turns, edges.

Batches run the recorded program, single poses the plain one; each law holds for both, with and without dual parts.
"""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from functools import partial
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from derive.maps.named import parameterization
from dualcay import _runtime, unwrap
from tests.support import packages, sampling

POLES = ("cayley1", "scaled1")  # half a turn is at infinity
USER = {
    "beyond": "alpha/(1 + alpha**2/40)", "ending": "sin(alpha/2) + sin(3*alpha/2)/40", "cut": "alpha + sin(alpha)/2"
}  # fmt: skip
"""Formulas of a user: charts that go beyond half a turn, that end there, where dφ/dα = 0, and that are cut at 4π."""

FOLDS = ("orthographic", "lambert", "sine3", "sine4")
SAMPLE = ("cayley1", "cayley2", "cayley3", "exponential", "orthographic", "sine4")
"""Charts of the quick tests, one for each form of the gain; those with other edges are in the thorough ones."""

OTHERS = ("cayley4", "lambert", "sine3", *USER)

LONG = pytest.param(np.longdouble, marks=pytest.mark.thorough)
DTYPES = pytest.mark.parametrize("dtype", [np.float32, np.float64, LONG], ids=lambda dtype: dtype.__name__)
COUNT = 100


@pytest.fixture(
    scope="module",
    params=[*SAMPLE, *(pytest.param(name, marks=pytest.mark.thorough) for name in OTHERS)],
)
def both(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[ModuleType, ModuleType]:
    """Return a module of poses and its module of rotations."""
    name = request.param
    if name in USER:
        poses = packages.imported(parameterization(USER[name], name), tmp_path_factory.mktemp(name))
    else:
        poses = importlib.import_module(f"dualcay.{name}")
    return poses, importlib.import_module(f"{poses.__package__}.rotation.{name}")


def name_of(module: ModuleType) -> str:
    return module.__name__.rpartition(".")[2]


def axes(dtype: Any) -> np.ndarray:
    found = np.concatenate([np.eye(3), -np.eye(3), sampling.unit_vectors(sampling.generator("edges"), (COUNT,))])
    found = found.astype(dtype)
    return found / np.sqrt((found * found).sum(axis=-1, keepdims=True))


def dual_quaternions(dtype: Any) -> np.ndarray:
    """Return unit dual quaternions of screws, at angles from 0.1 to 2.9, in the precision of longdouble."""
    draw = sampling.generator("edges of quaternions")
    u, half = axes(np.longdouble), draw.uniform(0.05, 1.45, (COUNT + 6, 1)).astype(np.longdouble)
    rho = draw.normal(size=u.shape)
    e = np.concatenate([np.cos(half), np.sin(half) * u], axis=-1)
    cross = np.cross(rho, e[:, 1:]) + e[:, :1] * rho
    return np.concatenate([e, np.concatenate([-(rho * e[:, 1:]).sum(-1, keepdims=True), cross], -1) / 2], -1)


class Cut:
    """Module whose batches are cut into one element and batches of ten, which run pose by pose."""

    def __init__(self, module: ModuleType) -> None:
        self._module, self.__name__ = module, module.__name__

    def __getattr__(self, name: str) -> Any:
        found = getattr(self._module, name)
        return partial(self._called, found) if callable(found) else found

    @staticmethod
    def _called(function: Any, *given: Any) -> Any:
        if not (given and np.size(given[0]) and np.ndim(given[0])):
            return function(*given)
        size, few = len(given[0]), _runtime.POINTWISE_MAX
        arrays = [array if np.ndim(array) and len(array) == size else None for array in map(np.asarray, given)]
        places = [0, *(slice(first, first + few) for first in range(1, size, few))]
        made = [function(*(x if a is None else a[p] for x, a in zip(given, arrays))) for p in places]
        made[0] = tuple(x[None] for x in made[0]) if isinstance(made[0], tuple) else made[0][None]
        several = isinstance(made[0], tuple)
        return tuple(map(np.concatenate, zip(*made))) if several else np.concatenate(made)


def forms(module: ModuleType, dtype: Any) -> tuple[Any, ...]:
    """Return a module, and for float32 its form for few poses, which chooses branches on floats of more digits."""
    return (module, Cut(module)) if dtype == np.float32 else (module,)


def calls(function: Any, given: np.ndarray, singles: int = 4) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield the results for a batch, and for some single elements, with their places."""
    yield np.arange(len(given)), function(given)
    places = np.arange(0, len(given), max(1, len(given) // singles))
    yield places, np.stack([function(given[place]) for place in places])


@DTYPES
def test_a_quaternion_of_any_norm_is_its_normalised_form(both: tuple[ModuleType, ModuleType], dtype: Any) -> None:
    """Scale up to the range where squares neither under- nor overflow; add a part along the real part to the dual part.

    Components have errors of eps/2, which the condition of v (at most 6 at 2.9 rad, n = 1) multiplies; 64 eps covers
    them. Beyond that range the result is the same or NaN.
    """
    eps, largest = np.finfo(dtype).eps, float(np.log10(np.finfo(dtype).max)) / 2
    q = dual_quaternions(dtype)
    for module, count in zip(both, (8, 4), strict=True):
        wanted = module.from_quaternion(q[:, :count].astype(dtype))
        for power in (*np.linspace(-0.97 * largest, 0.97 * largest, 9), -1.04 * largest, -1.9 * largest, 1.1 * largest):
            scaled = q * np.longdouble(10) ** power
            scaled[:, 4:] += 0.5 * scaled[:, :4]
            for places, found in calls(module.from_quaternion, scaled[:, :count].astype(dtype)):
                error = abs(found - wanted[places]) / (1 + abs(wanted).max())
                assert ((error < 64 * eps) | (np.isnan(found) & (abs(power) > largest))).all()


@DTYPES
def test_a_screw_with_nan_gives_nan(both: tuple[ModuleType, ModuleType], dtype: Any) -> None:
    """Expect NaN in all components of that element, and in no other, also for a quaternion of zeros."""
    for module, inverse in zip(both, ("screw", "angle_axis"), strict=True):
        v = module.random((3,), rng=1).astype(dtype)
        right = getattr(module, f"to_{inverse}")(v)
        for place, part in enumerate(right):
            for index in np.ndindex(part.shape[1:]):
                screw = [array.copy() for array in right]
                screw[place][(1, *index)] = np.nan
                found = getattr(module, f"from_{inverse}")(*screw)
                assert np.isnan(found[1]).all(), (place, index)
                assert np.isfinite(found[::2]).all(), (place, index)
        for _, found in calls(module.from_quaternion, np.zeros((2, 8 if v.shape[1] == 6 else 4), dtype)):
            assert np.isnan(found).all()


@DTYPES
def test_one_rule_of_sides_at_half_turns(both: tuple[ModuleType, ModuleType], dtype: Any) -> None:
    """A side that one function takes, no other one undoes: not for scalar parts ± eps, nor for vectors φ(π) ± 4 eps."""
    for module in forms(both[1], dtype):
        one_rule_of_sides(both[0], module, dtype)


@DTYPES
def test_an_axis_of_zeros_gives_nan(both: tuple[ModuleType, ModuleType], dtype: Any) -> None:
    """Expect NaN at each angle, as for the quaternion of zeros, in that row alone."""
    for module, name, parts in zip(both, ("from_screw", "from_angle_axis"), (6, 3), strict=True):
        for angle in (0.0, 0.5, 2.0):
            for count in (2, COUNT):
                axes = np.tile(np.eye(parts, dtype=dtype)[2], (count, 1))
                axes[-1, :3] = 0
                angles = np.full((count, 2) if parts == 6 else count, angle, dtype)
                found = getattr(module, name)(angles, axes)
                assert np.isnan(found[-1]).all()
                assert np.isfinite(found[:-1]).all()
                assert np.isnan(getattr(module, name)(angles[-1], axes[-1])).all()


def one_rule_of_sides(poses: ModuleType, module: Any, dtype: Any) -> None:
    if name_of(module) in (*POLES, "ending"):  # where forward maps find the angle by a root, not to all digits
        return
    eps, u = np.finfo(dtype).eps, axes(dtype)
    loss = 1 / np.sqrt(eps) if poses.singular_angles()[-1] < 3.2 else 1  # digits lost beside a fold
    half_turn = 4 * np.arctan(dtype(1))
    for scalar in (0.0, eps / 16, -eps / 16, eps, -eps):
        v = module.from_quaternion(np.concatenate([np.full((len(u), 1), scalar, dtype), u], axis=-1))
        assert ((v * u).sum(axis=-1) > 0).all()  # the given vector part
        sides(module, v, half_turn, 64 * eps * loss)
    tensors = 2 * u[:, :, None] * u[:, None, :] - np.eye(3, dtype=dtype)
    for noise in (0, eps, -eps):
        v = module.from_tensor(tensors + dtype(noise))
        sides(module, v, half_turn, 64 * eps * loss)
        first = np.where(abs(v) > 64 * eps, np.sign(v), 0)
        assert (first[np.arange(len(v)), np.argmax(first != 0, axis=-1)] > 0).all()
    for ulps in range(-4, 5):
        off = v * dtype(1 + ulps * eps)
        if np.isfinite(module.quaternion(off)).all():
            sides(module, off, half_turn, 64 * eps * loss)
            for found in (module.from_quaternion(module.quaternion(off)), module.from_tensor(module.tensor(off))):
                sides(module, found, half_turn, 64 * eps * loss)


def sides(module: ModuleType, v: np.ndarray, half_turn: Any, tolerance: Any) -> None:
    """Compare what functions say of vectors at half a turn: v is principal, on its own side, with the angle π."""
    assert np.isfinite(module.tensor(v)).all()
    np.testing.assert_array_equal(module.principal(v), v)
    np.testing.assert_array_equal(module.switch(v), v)
    followed, branch = unwrap(module, np.stack([v, v]), branch=True)
    np.testing.assert_array_equal(followed, [v, v])
    assert not branch.any()
    angle, axis = module.to_angle_axis(v)
    assert ((axis * v).sum(axis=-1) > 0).all()
    assert (abs(angle - half_turn) < tolerance).all()
    composed = module.compose(v, np.zeros_like(v))
    np.testing.assert_array_equal(module.principal(composed), composed)
    if module.CHART.branches != 1:
        for k in (1, -1):
            found = module.shadow(v, k)
            inside = np.isfinite(module.quaternion(found)).all(axis=-1)
            one, other = module.quaternion(found[inside]), module.quaternion(v[inside])
            assert (np.minimum(abs(one - other), abs(one + other)) < 16 * np.sqrt(np.finfo(v.dtype).eps)).all()


@DTYPES
def test_no_result_is_beyond_the_edge(both: tuple[ModuleType, ModuleType], dtype: Any) -> None:
    """Reach the edge by every function that returns a vector: rounding must not put v·v above its limit."""
    for module in forms(both[1], dtype):
        no_result_is_beyond_the_edge(both[0], module, dtype)


def no_result_is_beyond_the_edge(poses: ModuleType, module: Any, dtype: Any) -> None:
    edge = poses.singular_angles()[-1]
    if name_of(poses) not in (*FOLDS, "ending"):
        return
    half_turn, u = 4 * np.arctan(dtype(1)), axes(dtype)
    last = half_turn * dtype(round(edge / np.pi))
    tiny, part = module.from_exponential(u * dtype(1e-12)), module.from_exponential(u * dtype(0.75))
    rest = u * (last - dtype(0.75))
    found = {
        "from_exponential": module.from_exponential(u * last),
        "from_angle_axis": module.from_angle_axis(np.full(len(u), last), u),
        "retract": module.retract(part, rest),
        "interpolate": module.interpolate(part, module.retract(part, rest), dtype(1)),
    }
    if edge < 4:
        half = np.concatenate([np.zeros((len(u), 1), dtype), u], axis=-1)
        found |= {
            "from_quaternion": module.from_quaternion(half),
            "from_tensor": module.from_tensor(2 * u[:, :, None] * u[:, None, :] - np.eye(3, dtype=dtype)),
            "compose": module.compose(part, module.from_exponential(rest)),
            "between": module.between(part, module.from_exponential(-rest)),
        }
    else:
        for k in range(1, module.CHART.branches):
            found |= {f"shadow {k}": module.shadow(tiny, k), f"branch {k}": module.from_tensor(module.tensor(tiny), k)}
    for name in ("from_exponential", "from_angle_axis"):  # the edge has the side of its axis, despite rounding
        assert ((found[name] * u).sum(axis=-1) > 0).all(), name
    for name, v in found.items():
        if name != "interpolate" or name_of(poses) in FOLDS:
            assert np.isfinite(module.quaternion(v)).all(), name


@DTYPES
def test_angles_beyond_a_cut_lose_a_turn(both: tuple[ModuleType, ModuleType], dtype: Any) -> None:
    """Go beyond the end of a chart at 4π, where φ does not turn back, by one to four roundings."""
    if name_of(both[0]) != "cut":
        return
    for module in forms(both[1], dtype):
        for roundings in range(1, 5):
            angle = 16 * np.arctan(dtype(1)) * (1 + roundings * np.finfo(dtype).eps)
            v = module.from_exponential(axes(dtype) * angle)
            # the angle rounds by 4 eps of 2π, φ′ = 3/2 there; the rest is for an angle by tan and atan2
            np.testing.assert_allclose(abs(v).max(), 8 * np.arctan(dtype(1)), rtol=100 * np.finfo(dtype).eps)
