"""Tumbling body with poses and twists in closed form: a screw about the third axis after a screw about the first.

The angles are f and g, so the whole rotation angle α has ``cos(α/2) = cos(f/2) cos(g/2)``. It stays below 2.64, where
no chart is singular.
"""

from __future__ import annotations

import importlib
from types import ModuleType
from typing import Any

import numpy as np

from derive.motion_equations import MotionEquation

PITCHES = 0.5, 0.8  # translation per radian along each axis


def angles(t: Any, library: ModuleType = np) -> tuple[Any, Any, Any, Any]:
    """Return f, g and their rates."""
    return 2.4 * library.sin(t), 1.6 * library.sin(3 * t), 2.4 * library.cos(t), 4.8 * library.cos(3 * t)


def pose(t: float) -> np.ndarray:
    """Return the homogeneous matrix at a time."""
    (f, g, *_), (h, k) = angles(t), PITCHES
    first = np.array([[1, 0, 0, k * g], [0, np.cos(g), -np.sin(g), 0], [0, np.sin(g), np.cos(g), 0], [0, 0, 0, 1]])
    last = np.array([[np.cos(f), -np.sin(f), 0, 0], [np.sin(f), np.cos(f), 0, 0], [0, 0, 1, h * f], [0, 0, 0, 1]])
    return last @ first


def space_twist(t: Any, library: ModuleType = np) -> Any:
    """Return the twist in space, for NumPy or ``jax.numpy``: the last screw carries the axis of the first."""
    (f, _, f_dot, g_dot), (h, k) = angles(t, library), PITCHES
    cosine, sine = g_dot * library.cos(f), g_dot * library.sin(f)
    lever = h * f
    return library.stack([cosine, sine, f_dot, k * cosine - lever * sine, k * sine + lever * cosine, h * f_dot])


def body_twist(t: Any, library: ModuleType = np) -> Any:
    """Return the twist in the body: the first screw, undone, carries the axis of the last."""
    (_, g, f_dot, g_dot), (h, k) = angles(t, library), PITCHES
    cosine, sine = f_dot * library.cos(g), f_dot * library.sin(g)
    lever = k * g
    return library.stack([g_dot, sine, cosine, k * g_dot, h * sine + lever * cosine, h * cosine - lever * sine])


TWISTS = {"space": space_twist, "body": body_twist}


def kernels(equation: MotionEquation) -> Any:
    """Return the kernels of the chart of an equation, or those of n = 2."""
    return importlib.import_module(f"dualcay.{equation.chart.name if equation.chart else 'cayley2'}")


def state(equation: MotionEquation, v: np.ndarray) -> np.ndarray:
    """Return the state of a kinematic equation at a vector of its kernels; an equation of vectors has v itself."""
    module = kernels(equation)
    found: np.ndarray = {18: module.tensor, 8: module.quaternion, 6: np.asarray}[equation.states](v)
    return found.ravel()


def start(equation: MotionEquation, t: float = 0.0) -> np.ndarray:
    """Return the state of a kinematic equation at a time of the tumbling body."""
    return state(equation, kernels(equation).from_pose(pose(t)))


def reached(equation: MotionEquation, y: np.ndarray) -> np.ndarray:
    """Return the homogeneous matrices of states, the columns of y, of shape (..., 4, 4)."""
    module, rows = kernels(equation), np.moveaxis(y, 0, -1)
    if equation.states == 18:
        rows = module.from_tensor(rows.reshape(*rows.shape[:-1], 2, 3, 3))
    poses: np.ndarray = module.pose(module.from_quaternion(rows) if equation.states == 8 else rows)
    return poses
