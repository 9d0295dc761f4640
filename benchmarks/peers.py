"""Libraries against which kernels are measured; all are optional, and reports name the missing ones."""

from __future__ import annotations

import importlib
import importlib.metadata
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from benchmarks.timing import Call

SWAP = np.array([3, 4, 5, 0, 1, 2])
"""Permutation between translation first and rotation first."""

LOOPED = 1_000
"""Largest number of poses for libraries called in a loop."""


@dataclass(frozen=True, slots=True)
class Poses:
    """Sample of N poses in every layout that peers take; attributes with ``_rows`` have components first."""

    v: Any
    w: Any
    exponential: Any
    other: Any
    T: Any
    q: Any
    v_rows: Any
    w_rows: Any
    z_rows: Any

    @classmethod
    def draw(cls, module: Any, size: int) -> Poses:
        """Draw poses of angle up to 3 rad, as vectors v, w and exponential coordinates; one pose has no batch axis."""
        rng = np.random.default_rng(2011)
        batch = () if size == 1 else (size,)

        def twist() -> Any:
            direction = rng.standard_normal((*batch, 3))
            direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
            return np.concatenate([direction * rng.uniform(0, 3, (*batch, 1)), rng.uniform(-1, 1, (*batch, 3))], -1)

        exponential, other = twist(), twist()
        v, w = module.from_exponential(exponential), module.from_exponential(other)
        T, q = module.pose(v), module.quaternion(v)
        rows = [np.ascontiguousarray(a.T) for a in (v, w, other)]
        return cls(v, w, exponential, other, T, q, *rows)


def load(name: str) -> Any:
    """Return a peer's module, or None."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def scipy_call(function: str, poses: Poses) -> Call | None:
    """Return the call of SciPy's ``RigidTransform`` that corresponds to a function of ours."""
    transform = load("scipy.spatial.transform")
    rigid = getattr(transform, "RigidTransform", None)
    if rigid is None:
        return None
    e, other, T, q = poses.exponential, poses.other, poses.T, poses.q
    calls: dict[str, Call] = {
        "pose": lambda: rigid.from_exp_coords(e).as_matrix(),
        "quaternion": lambda: rigid.from_exp_coords(e).as_dual_quat(scalar_first=True),
        "from_pose": lambda: rigid.from_matrix(T).as_exp_coords(),
        "from_quaternion": lambda: rigid.from_dual_quat(q, scalar_first=True).as_exp_coords(),
        "compose": lambda: (rigid.from_exp_coords(other) * rigid.from_exp_coords(e)).as_exp_coords(),
    }
    return calls[function]


def pytransform3d_call(function: str, poses: Poses) -> Call | None:
    trajectories = load("pytransform3d.trajectories")
    if trajectories is None:
        return None
    if function == "pose":
        exponential = np.atleast_2d(poses.exponential)
        return lambda: trajectories.transforms_from_exponential_coordinates(exponential)
    exp = trajectories.transforms_from_exponential_coordinates
    log = trajectories.exponential_coordinates_from_transforms
    if function == "from_pose":
        return partial(log, poses.T.reshape(-1, 4, 4))
    if function != "compose":
        return None
    first, second = np.atleast_2d(poses.exponential), np.atleast_2d(poses.other)
    return lambda: log(trajectories.concat_many_to_many(exp(first), exp(second)))


def _swapped(screws: Any) -> Any:
    return np.ascontiguousarray(screws[..., SWAP])


def jaxlie_call(function: str, poses: Poses) -> Call | None:
    """Return a compiled jaxlie call on arrays already converted to JAX."""
    if load("jaxlie") is None:
        return None
    import jax
    from jaxlie import SE3

    jax.config.update("jax_enable_x64", True)
    maps: dict[str, tuple[Callable[..., Any], tuple[Any, ...]]] = {
        "pose": (lambda e: SE3.exp(e).as_matrix(), (_swapped(poses.exponential),)),
        "from_pose": (lambda T: SE3.from_matrix(T).log(), (poses.T,)),
        "compose": (
            lambda a, b: (SE3.exp(a) @ SE3.exp(b)).log(), (_swapped(poses.other), _swapped(poses.exponential)),
        ),
    }  # fmt: skip
    compute, given = jax.jit(maps[function][0]), [jax.numpy.asarray(array) for array in maps[function][1]]
    return lambda: compute(*given).block_until_ready()


def _looped(count: int, one: Callable[..., object], *arrays: Any) -> Call | None:
    """Return a call pose by pose, or None if there are more than `LOOPED`."""
    if arrays[0].ndim == count:
        return lambda: one(*arrays)
    return (lambda: [one(*each) for each in zip(*arrays, strict=True)]) if len(arrays[0]) <= LOOPED else None


def pinocchio_call(function: str, poses: Poses) -> Call | None:
    pin = load("pinocchio")
    if pin is None:
        return None
    first, second = _swapped(poses.other), _swapped(poses.exponential)
    if function == "pose":
        return _looped(1, lambda e: pin.exp6(e).homogeneous, second)
    if function == "from_pose":
        return _looped(2, lambda T: pin.log6(T).vector, poses.T)
    return _looped(1, lambda a, b: pin.log6(pin.exp6(a) * pin.exp6(b)).vector, first, second)


def symforce_call(function: str, poses: Poses) -> Call | None:
    sym = load("sym")
    if sym is None or function == "from_pose":  # SymForce cannot make a pose from a matrix
        return None
    make = sym.Pose3.from_tangent
    if function == "pose":
        return _looped(1, lambda e: make(e).to_homogenous_matrix(), poses.exponential)
    return _looped(1, lambda a, b: make(a).compose(make(b)).to_tangent(), poses.other, poses.exponential)


@dataclass(frozen=True, slots=True)
class Library:
    """Library with its distribution, how it is called, and the function that makes a call."""

    distribution: str
    manner: str
    call: Callable[[str, Poses], Call | None]

    def label(self, name: str) -> str:
        """Return the name of the library with the manner of its call."""
        return f"{name}, {self.manner}" if self.manner else name


LIBRARIES: Mapping[str, Library] = {
    "SciPy": Library("scipy", "", scipy_call),
    "pytransform3d": Library("pytransform3d", "", pytransform3d_call),
    "jaxlie": Library("jaxlie", "jitted", jaxlie_call),
    "pinocchio": Library("pin", "pose by pose", pinocchio_call),
    "SymForce": Library("symforce-sym", "pose by pose", symforce_call),
}
"""Every library by name; measurements of speed and of accuracy choose from this list."""


def versions(*names: str) -> dict[str, str | None]:
    """Return the version of each named library, None for a missing one."""
    found: dict[str, str | None] = {}
    for name in names:
        try:
            found[name] = importlib.metadata.version(LIBRARIES[name].distribution)
        except importlib.metadata.PackageNotFoundError:
            found[name] = None
    return found
