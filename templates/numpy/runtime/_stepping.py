"""Steps of a motion: a local vector integrated by a Runge–Kutta method of SciPy, and the pose where it is zero."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import pi
from typing import Any, Protocol

import numpy as np
from scipy import integrate  # type: ignore[import, unused-ignore]

from ._derived import LOCAL, normalized, product
from ._geometry import KERNELS
from ._interface import BODY_INV, SPACE_INV
from ._kernel import Array
from ._motion import MotionError, OfModule
from ._numbers import FLOAT, Floats
from ._runtime import constants
from ._switching import switch_angle
from ._twist import Twist

INTEGRATORS = "RK23", "RK45", "DOP853"
"""Solver classes of SciPy that need no values of former steps."""

LARGEST_TURN = 1.0
"""Rotation angle within a step (rad), if the angular velocity keeps its value at the beginning of the step."""

STEP_MIN = 1e-15
"""Smallest bound of a step, as a part of the span; a motion with smaller steps would not end."""

TABLES = {"space": constants(SPACE_INV, FLOAT), "body": constants(BODY_INV, FLOAT)}
"""Table of the program ``rate`` by frame."""


@dataclass(frozen=True)
class Problem(OfModule):
    """Arguments of `propagate` that a step needs."""

    module: Any
    twist: Twist
    frame: str
    integrator: str
    rtol: float
    atol: float
    max_step: float


@dataclass(frozen=True)
class Step:
    """Accepted step; the pose is the local vector's times ``centre``, in the order of the frame.

    Quaternions have eight components. The sign of ``start``, the pose at ``begin``, is continuous along the motion.
    """

    begin: float
    end: float
    local: Callable[[Any], Array]
    centre: Any
    start: Any


class Form(Protocol):
    """Vector that one step integrates, and how it goes on after the step."""

    def rate(self, y: Array, omega: Sequence[float]) -> Any: ...

    def quaternion(self, y: Any) -> Any: ...

    def restart(self, y: Array) -> Array | None:
        """Return the vector of the same pose for the next step, or None for zero about a new centre."""

    def tolerance(self, pose: Sequence[float]) -> Any:
        """Return the absolute tolerance of a step from a pose."""


class Pickled:
    """Form that pickle saves by its problem."""

    problem: Problem

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.problem,)


class LieForm(Pickled):
    """Local vector ``tan(α/4) u`` of the displacement within a step; it restarts at zero after each."""

    def __init__(self, problem: Problem) -> None:
        self.problem, self.table, self.program = problem, TABLES[problem.frame], KERNELS["rate"].plain

    def rate(self, y: Array, omega: Sequence[float]) -> Any:
        return self.program(Floats, LOCAL, y.tolist(), omega, self.table)

    def quaternion(self, y: Any) -> Any:
        return KERNELS["quaternion"].plain(Floats, LOCAL, y)

    def restart(self, y: Array) -> None:
        return None

    def tolerance(self, pose: Sequence[float]) -> Any:
        """Return a quarter of the tolerance of the pose's quaternion, as the local vector is α/4 for small α."""
        size = math.hypot(*pose[4:])
        real, dual = (self.problem.atol + self.problem.rtol * part for part in (1.0, size))
        return np.array([real, real, real, dual, dual, dual]) / 4


class ChartForm(Pickled):
    """Vector of the module's chart; it switches, or restarts at zero where no branch helps."""

    def __init__(self, problem: Problem) -> None:
        module = self.module = problem.module
        self.problem, self.limit = problem, largest_angle(module)
        self.rate = module.rate if problem.frame == "space" else module.body_rate

    def quaternion(self, y: Any) -> Any:
        return self.module.quaternion(y, axis=0)

    def restart(self, y: Array) -> Array | None:
        angle = abs(float(self.module.angle(y)[0]))
        if self.limit > pi:
            return np.asarray(self.module.switch(y)) if angle > self.limit else y
        return y if angle < pi / 2 else None

    def tolerance(self, pose: Sequence[float]) -> Any:
        return self.problem.atol


FORMS: dict[str, Callable[[Problem], Form]] = {"lie": LieForm, "chart": ChartForm}


def largest_angle(module: Any) -> float:
    """Return the rotation angle where v changes its branch; π for a chart that is singular there."""
    return switch_angle(module) if module.singular_angles()[0] > pi * (1 + 1e-9) else pi


def steps(problem: Problem, form: Form, y: Array, centre: Any, start: Any, span: tuple[float, float]) -> Iterator[Step]:
    """Yield the accepted steps over a span of time, from the local vector y about a centre; they end at knots.

    Raises
    ------
    MotionError
        If the steps become too small, or a rate or a pose overflows; its attribute ``motion`` is not set.
    """
    omega: Sequence[float] = ()
    knots, latest = problem.twist.knots, span[1]

    def rhs(t: float, y: Array) -> Any:
        nonlocal omega
        omega = problem.twist(min(t, latest))
        return form.rate(y, omega)

    solver = getattr(integrate, problem.integrator)(
        rhs, span[0], y, span[1], rtol=problem.rtol, atol=form.tolerance(start), max_step=problem.max_step
    )
    _require_finite("rate of v", solver.f, span[0])  # from an infinite one SciPy would search a first step forever
    for end in (*knots[(knots > span[0]) & (knots < span[1])].tolist(), span[1]):
        solver.t_bound, solver.status = end, "running"
        latest = end if end == span[1] else math.nextafter(end, span[0])  # the twist may jump at a knot
        omega = problem.twist(solver.t)
        solver.f = np.asarray(form.rate(solver.y, omega))
        while solver.status == "running":
            speed = math.hypot(*omega[:3])
            solver.max_step = min(problem.max_step, LARGEST_TURN / speed if speed else math.inf)
            endless = solver.max_step < STEP_MIN * (span[1] - span[0])
            message = "the twist turns too fast" if endless else solver.step()
            if endless or solver.status == "failed":
                raise MotionError(f"no step is small enough at t = {solver.t:.9g}: {message}", solver.t)
            last = omega  # a step ends with an evaluation at its end; dense output may evaluate elsewhere
            pose = displaced(Floats, problem.frame, form.quaternion(solver.y.tolist()), centre)
            _require_finite("pose", pose, solver.t)
            yield Step(solver.t_old, solver.t, solver.dense_output(), centre, start)
            start = [-part for part in pose] if sum(a * b for a, b in zip(pose[:4], start[:4])) < 0 else pose
            moved = form.restart(solver.y)
            if moved is None:
                centre, moved = start, np.zeros(6)
            if moved is not solver.y:
                solver.y, solver.f = moved, np.asarray(form.rate(moved, last))
                solver.atol = form.tolerance(start)
            omega = last


def _require_finite(name: str, values: Any, t: float) -> None:
    if not all(map(math.isfinite, values)):
        raise MotionError(f"the {name} is not finite at t = {t:.9g}", t)


def displaced(m: Any, frame: str, local: Any, centre: Any) -> Sequence[Any]:
    """Return the unit dual quaternion of a local displacement of a centre, components first; ``m`` has the root."""
    pose: Sequence[Any] = normalized(m, product(local, centre) if frame == "space" else product(centre, local))
    return pose
