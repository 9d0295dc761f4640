"""Rotations alone, in comparison with real parts of pose functions, and with textbook formulas for n = 1 and 2."""

from __future__ import annotations

import importlib
import pickle
import re
from types import ModuleType

import numpy as np
import pytest

import dualcay.rotation
from derive import about
from derive.codegen.signatures import ROTATIONS
from tests.support.kernels import BACKENDS
from tests.support.rotation_arguments import ROUNDINGS, arguments

MODULES = (*(f"cayley{n}" for n in about.ORDERS), *about.FAMILIES)
EPS = np.finfo(float).eps

def pair(name: str) -> tuple[ModuleType, ModuleType]:
    """Return the modules of a chart for rotations and for poses."""
    return importlib.import_module(f"dualcay.rotation.{name}"), importlib.import_module(f"dualcay.{name}")


@pytest.mark.parametrize("chart", MODULES)
def test_rotations_are_the_real_parts_of_pose_functions(chart: str) -> None:
    rotations, poses = pair(chart)
    for name, row in ROTATIONS.public.items():
        given = arguments(row, rotations)
        flat = [tuple(np.moveaxis(a.reshape(5, -1), -1, 0)) for a in given]
        embedded = row.embedded(flat, np.zeros(5))
        dual = [
            np.stack(a, axis=-1).reshape(5, *kind.shape) for a, kind in zip(embedded, row.pose.arguments, strict=True)
        ]
        branch = (1,) if row.branch else ()
        found, expected = (
            np.concatenate([part.reshape(5, -1) for part in (r if isinstance(r, tuple) else (r,))], axis=-1)
            for r in (getattr(rotations, name)(*given, *branch), getattr(poses, row.source)(*dual, *branch))
        )
        wanted = np.stack(row.part(list(expected.T)), axis=-1)
        assert np.all(abs(found - wanted) <= ROUNDINGS * EPS * abs(wanted).max(initial=1)), name


@pytest.mark.parametrize("chart", ["cayley1", "exponential"])
@pytest.mark.parametrize("shape", [(), (3,), (2, 30)])
def test_angles_have_every_shape_and_layout(chart: str, shape: tuple[int, ...]) -> None:
    m, _ = pair(chart)
    v = m.random(shape, max_angle=2, rng=5)
    first, place, near = np.moveaxis(v, -1, 0), np.empty(shape), {"rtol": 0, "atol": 1e-12 * max(1, abs(v).max())}
    angle, axis = m.to_angle_axis(v)
    assert angle.shape == shape
    np.testing.assert_allclose(m.from_angle_axis(angle, axis), v, **near)
    np.testing.assert_allclose(m.angle(v), angle, rtol=0, atol=1e-12)
    np.testing.assert_array_equal(m.angle(first, axis=0), m.angle(v))
    assert m.angle(v, out=place) is place
    np.testing.assert_allclose(m.from_angle_axis(*m.to_angle_axis(first, axis=0), axis=0), first, **near)
    np.testing.assert_allclose(m.quaternion(first, axis=0, scalar_first=False)[3], m.quaternion(v)[..., 0], rtol=1e-15)


# --- where nothing turns, and the edge ------------------------------------------------------------------------------


def test_the_identity_has_no_axis_and_the_edge_no_vector() -> None:
    m = dualcay.rotation.cayley3
    angle, axis = m.to_angle_axis(m.identity())
    assert angle == 0
    assert np.isnan(axis).all()
    assert np.isnan(m.shadow(m.identity())).all()
    assert np.isnan(m.from_quaternion([1.0, 0, 0, 0], branch=1)).all()
    assert not m.principal(m.identity()).any()
    assert dualcay.rotation.cayley1.from_quaternion([0.0, 0, 0, 1])[2] == np.inf


@pytest.mark.parametrize("axis", [-1, 0])
@pytest.mark.parametrize(
    ("name", "part"), [("pose", (3,)), ("from_quaternion", (4,)), ("from_pose", (3, 3)), ("from_tensor", (3, 3))]
)
def test_functions_of_poses_say_where_rotations_are(name: str, part: tuple[int, ...], axis: int) -> None:
    shape = (*part, 7) if axis == 0 else (7, *part)
    with pytest.raises(ValueError, match=rf"got {re.escape(str(shape))}; rotations alone: dualcay\.rotation$"):
        getattr(dualcay.cayley2, name)(np.zeros(shape), axis=axis)
    with pytest.raises(ValueError, match=r"got \(\d.*\)$"):
        getattr(dualcay.cayley2, name)(np.zeros((*part, 7)), axis=-1)


@pytest.mark.parametrize(("shape", "axis", "message"), [((6, 3), -1, "first: axis=0"), ((3, 6), 0, "last: axis=-1")])
def test_components_on_the_other_side_are_named(shape: tuple[int, ...], axis: int, message: str) -> None:
    with pytest.raises(ValueError, match=f"; components {message}$"):
        dualcay.cayley2.pose(np.zeros(shape), axis=axis)


def test_rotations_take_three_components_and_an_angle_by_position() -> None:
    m = dualcay.rotation.cayley2
    with pytest.raises(ValueError, match=r"v must have shape \(\.\.\., 3\), got \(6,\)"):
        m.tensor(np.zeros(6))
    with pytest.raises(TypeError, match="positional"):
        m.from_angle_axis(angle=1.0, u=[1.0, 0, 0])


# --- the package ----------------------------------------------------------------------------------------------------


def test_rotation_modules_are_listed_pickled_and_documented() -> None:
    assert dir(dualcay.rotation) == sorted([*MODULES, *dualcay.rotation.__all__])
    assert not {"rotation"} & set(dualcay._modules())
    m = dualcay.rotation.cayley2
    assert dir(m) == sorted(m.__all__)
    assert not {"pose", "from_screw", "to_screw", "transform_line", "from_pose"} & set(m.__all__)
    assert pickle.loads(pickle.dumps(m.rate)) == m.rate
    assert pickle.loads(pickle.dumps(m.KERNELS)) is m.KERNELS
    functions = {getattr(m, name).__name__ for name in m.__all__}  # an alias counts once
    assert list(dualcay.rotation.backend()) == sorted(functions)
    assert set(dualcay.rotation.backend().values()) == BACKENDS
    assert repr(m.KERNELS) == "<RotationKernels of dualcay.rotation.cayley2>"
    for name in m.__all__:
        assert not re.search(r"\.\.\., [268]|\bdual\b|\bRe ", getattr(m, name).__doc__), f"{name} tells of poses"
