"""Libraries against which kernels are measured; all are optional, and reports name the missing ones.

A call is kept as its text, which is compiled to measure it: pages show exactly what was timed.
"""

from __future__ import annotations

import importlib
import importlib.metadata
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.timing import Call

SWAP = np.array([3, 4, 5, 0, 1, 2])
"""Permutation between translation first and rotation first."""

LOOPED = 1_000
"""Largest number of poses for libraries called in a loop."""

LETTERS = (
    "e, f: exponential coordinates in the order of the library; T: homogeneous matrices; q: dual quaternions; "
    "A, B: transforms of f and e, kept in the library's own type"
)
"""Meaning of the letters in calls."""

Names = dict[str, Any]


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


# --- names that calls use ---------------------------------------------------------------------------------------------


def scipy_names(poses: Poses) -> Names:
    """Return SciPy's class and its arguments; SciPy before 1.16 has no such class."""
    rigid = importlib.import_module("scipy.spatial.transform").RigidTransform
    kept = {"A": rigid.from_exp_coords(poses.other), "B": rigid.from_exp_coords(poses.exponential)}
    return {"RigidTransform": rigid, "e": poses.exponential, "f": poses.other, "T": poses.T, "q": poses.q, **kept}


def pytransform3d_names(poses: Poses) -> Names:
    """Return the functions on trajectories, which take batches alone."""
    module = importlib.import_module("pytransform3d.trajectories")
    e, f = (np.atleast_2d(a) for a in (poses.exponential, poses.other))
    kept = {"A": module.transforms_from_exponential_coordinates(f), "B": poses.T.reshape(-1, 4, 4)}
    return {**vars(module), "e": e, "f": f, "T": poses.T.reshape(-1, 4, 4), **kept}


def jaxlie_names(poses: Poses) -> Names:
    """Return arrays already converted to JAX, in double precision."""
    group = importlib.import_module("jaxlie").SE3
    import jax

    jax.config.update("jax_enable_x64", True)  # type: ignore[no-untyped-call]
    e, f, T = (jax.numpy.asarray(a) for a in (_swapped(poses.exponential), _swapped(poses.other), poses.T))
    return {"SE3": group, "e": e, "f": f, "T": T, "A": group.exp(f), "B": group.exp(e)}


def pinocchio_names(poses: Poses) -> Names:
    module = importlib.import_module("pinocchio")
    e, f = _swapped(poses.exponential), _swapped(poses.other)
    return {**vars(module), "e": e, "f": f, "T": poses.T, "A": _each(module.exp6, f), "B": _each(module.exp6, e)}


def symforce_names(poses: Poses) -> Names:
    group = importlib.import_module("sym").Pose3
    e, f = poses.exponential, poses.other
    return {"Pose3": group, "e": e, "f": f, "A": _each(group.from_tangent, f), "B": _each(group.from_tangent, e)}


def _swapped(screws: Any) -> Any:
    return np.ascontiguousarray(screws[..., SWAP])


def _each(make: Callable[[Any], Any], arrays: Any) -> Any:
    return make(arrays) if arrays.ndim == 1 else [make(array) for array in arrays[:LOOPED]]


# --- manners of calling -----------------------------------------------------------------------------------------------


def at_once(text: str, names: Names, size: int) -> Call:
    """Return a call on whole arrays."""
    call: Call = eval(f"lambda: {text}", names)
    return call


def jitted(text: str, names: Names, size: int) -> Call:
    """Return a call compiled by JAX, which waits for its result."""
    import jax

    given = _given(text, names)
    function = jax.jit(eval(f"lambda {', '.join(given)}: {text}", names))
    return lambda: function(*given.values()).block_until_ready()


def looped(text: str, names: Names, size: int) -> Call | None:
    """Return a call pose by pose, or None for more than `LOOPED`."""
    given = _given(text, names)
    each = f"[{text} for {', '.join(given)}, in zip({', '.join(given)}, strict=True)]"
    return at_once(text if size == 1 else each, names, size) if size <= LOOPED else None


def _given(text: str, names: Names) -> Names:
    """Return the arguments that occur in a call."""
    return {letter: names[letter] for letter in compile(text, "call", "eval").co_names if len(letter) == 1}


@dataclass(frozen=True, slots=True)
class Library:
    """Library with its distribution, the names that its calls use, their texts by function, and how they are called.

    The second text of ``compose`` multiplies kept transforms, and takes no logarithm.
    """

    distribution: str
    names: Callable[[Poses], Names]
    texts: Mapping[str, tuple[str, ...]]
    manner: Callable[[str, Names, int], Call | None] = at_once

    def calls(self, function: str, poses: Poses, size: int) -> dict[str, Call]:
        """Return the calls for a function by their texts; none if the library or the function is missing."""
        try:
            names = self.names(poses) if function in self.texts else {}
        except (ImportError, AttributeError):
            return {}
        made = {text: self.manner(text, names, size) for text in self.texts.get(function, ())}
        return {text: call for text, call in made.items() if call is not None}


LIBRARIES: Mapping[str, Library] = {
    "SciPy": Library("scipy", scipy_names, {
        "pose": ("RigidTransform.from_exp_coords(e).as_matrix()",),
        "quaternion": ("RigidTransform.from_exp_coords(e).as_dual_quat(scalar_first=True)",),
        "from_pose": ("RigidTransform.from_matrix(T).as_exp_coords()",),
        "from_quaternion": ("RigidTransform.from_dual_quat(q, scalar_first=True).as_exp_coords()",),
        "compose": (
            "(RigidTransform.from_exp_coords(f) * RigidTransform.from_exp_coords(e)).as_exp_coords()", "A * B",
        ),
    }),
    "pytransform3d": Library("pytransform3d", pytransform3d_names, {
        "pose": ("transforms_from_exponential_coordinates(e)",),
        "quaternion": ("dual_quaternions_from_transforms(transforms_from_exponential_coordinates(e))",),
        "from_pose": ("exponential_coordinates_from_transforms(T)",),
        "compose": (
            "exponential_coordinates_from_transforms(concat_many_to_many(transforms_from_exponential_coordinates(e), "
            "transforms_from_exponential_coordinates(f)))", "concat_many_to_many(B, A)",
        ),
    }),
    "jaxlie": Library("jaxlie", jaxlie_names, {
        "pose": ("SE3.exp(e).as_matrix()",),
        "from_pose": ("SE3.from_matrix(T).log()",),
        "compose": ("(SE3.exp(f) @ SE3.exp(e)).log()", "(A @ B).parameters()"),
    }, jitted),
    "pinocchio": Library("pin", pinocchio_names, {
        "pose": ("exp6(e).homogeneous",),
        "from_pose": ("log6(T).vector",),
        "compose": ("log6(exp6(f) * exp6(e)).vector", "A * B"),
    }, looped),
    "SymForce": Library("symforce-sym", symforce_names, {
        "pose": ("Pose3.from_tangent(e).to_homogenous_matrix()",),
        "compose": ("Pose3.from_tangent(f).compose(Pose3.from_tangent(e)).to_tangent()", "A.compose(B)"),
    }, looped),
}  # fmt: skip
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
