"""Motion of a pose under a given twist: the Poisson–Darboux problem, solved for v at given times."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from ._arguments import FRAMES, Frame, finite, increasing, require_one_of, vector_size
from ._branches import precision, require_symmetric
from ._kernel import Array
from ._motion import Motion, MotionError
from ._tools import PoseModule
from ._twist import twist_of

if TYPE_CHECKING:
    from ._stepping import Step

Progress = Callable[[float], object]


def propagate(
    module: PoseModule, v0: ArrayLike, twist: Callable[[float], ArrayLike] | ArrayLike, t: ArrayLike, *,
    frame: Frame = "space", method: Literal["lie", "chart"] = "lie", rtol: float = 1e-10, atol: float = 1e-12,
    covariance: ArrayLike | None = None, noise: ArrayLike | None = None, max_step: float = math.inf,
    progress: Progress | bool | None = None, integrator: Literal["DOP853", "RK45", "RK23"] = "DOP853",
    knots: ArrayLike | None = None,
) -> Motion:  # fmt: skip
    """Integrate ``Ṙ = skew(ω) R``, or ``Ṙ = R skew(ω)`` in the body frame, for a given dual twist ω; CP23 (70), (74).

    v changes its branch halfway between π and the first singular angle of the chart. A v0 beyond this angle is
    replaced by its principal vector, and the first time is then a switch. Charts that are singular at the angle π
    have no other branch: there v jumps from one end of its axis to the other, while the poses stay accurate.

    Parameters
    ----------
    module : module
        Kernel module of poses, such as ``cayley2``.
    v0 : array, shape (6,)
        Vector of the chart at the first time.
    twist : callable, or array of shape (6,) or (T, 6)
        Twist [ω, v] (rad/s, length/s): a function of time (s), or constant, or samples at the times t, joined by a
        cubic spline. A step ends at each time of samples.
    t : array, shape (T,)
        Times (s), increasing, at least two.
    frame : {"space", "body"}
        Frame of the twist.
    method : {"lie", "chart"}
        ``"lie"`` integrates the displacement within each step and multiplies the poses. ``"chart"`` integrates v
        and switches its branch between steps; charts that are singular at π take a new centre instead.
    rtol, atol : float
        Relative and absolute tolerance of a step.
    covariance : array, shape (6, 6), optional
        Covariance of v0, symmetric and positive semidefinite; 0 if only ``noise`` is given.
    noise : array, shape (6, 6), optional
        Spectral density of white noise of the twist, in the frame of the twist (twist² s).
    max_step : float
        Largest step (s). Set it if a twist has short events that longer steps could pass.
    progress : callable or bool, optional
        Function of the part of the time that is done, from 0 to 1; True writes percents to stderr.
    integrator : {"DOP853", "RK45", "RK23"}
        Runge–Kutta method of SciPy.
    knots : array, shape (K,), optional
        Times (s) at which a callable twist is not smooth. A step ends at each; a step across one loses digits. If the
        twist jumps there, its value at the knot itself is that of the step after.

    Returns
    -------
    Motion
        Vectors, poses, branches and covariances at the times t, and a function of time.

    Raises
    ------
    ValueError, TypeError
        If an argument is wrong; the message names it.
    MotionError
        If the twist at a later time is not six finite numbers, or needs steps that are too small, or if the pose
        overflows.
    ImportError
        If SciPy is missing.

    Examples
    --------
    >>> import numpy as np
    >>> from dualcay import cayley2, exponential, propagate
    >>> omega = np.array([0.3, 0.4, 0, 0, 0, 0.1])
    >>> motion = propagate(cayley2, np.zeros(6), omega, [0, 10, 20])
    >>> np.allclose(motion.pose, exponential.pose(np.outer([0, 10, 20], omega)), rtol=0, atol=1e-9)
    True
    >>> motion.switches.round(3)  # after a turn by 3π/2, |ω| = 0.5; the next is after 7π/2
    array([9.425])
    """
    try:
        from ._stepping import FORMS, INTEGRATORS, Problem, largest_angle, steps
        from ._trajectory import Trajectory
    except ModuleNotFoundError as error:
        raise ImportError('dualcay.propagate needs SciPy: pip install "scipy>=1.16"') from error
    vector_size(module, poses=True)
    for name, value, allowed in (("frame", frame, FRAMES), ("method", method, tuple(FORMS)),
                                 ("integrator", integrator, INTEGRATORS)):  # fmt: skip
        require_one_of(name, value, allowed)
    for name, number in (("rtol", rtol), ("atol", atol), ("max_step", max_step)):
        if not number > 0:
            raise ValueError(f"{name} must be positive, got {number!r}")
    times, v = increasing("t", t), finite("v0", v0, (6,))
    spread, density = (None if P is None else _covariance(name, P)
                       for name, P in (("covariance", covariance), ("noise", noise)))  # fmt: skip
    problem = Problem(module, twist_of(twist, times, knots), frame, integrator, rtol, atol, max_step)
    q = module.quaternion(v)
    angle = _angle(module, v, q)
    form, switched = FORMS[method](problem), angle > largest_angle(module)
    along = (module.principal(v) if switched else v)[:3]
    start = (-q if q[1:4] @ along < 0 else q).tolist()
    restarted = form.restart(v)
    local, centre = (np.zeros(6), start) if restarted is None else (restarted, [1.0, *[0.0] * 7])
    found: list[Step] = []

    def motion() -> Motion:
        path = Trajectory(problem, form, found, times[0], start, switched)
        known = times[times <= path.end]
        P = None
        if spread is not None or density is not None:
            P = path.covariances(known, v, np.zeros((6, 6)) if spread is None else spread, density)
        vectors, poses, branches = path.vectors(known)
        return Motion(known, vectors, poses, branches, path.switches, P, path)

    report = _percents if progress is True else progress or (lambda part: None)
    with np.errstate(all="ignore"):  # overflow ends in an error that says when
        try:
            for step in steps(problem, form, local, centre, start, (times[0], times[-1])):
                found.append(step)
                report(float((step.end - times[0]) / (times[-1] - times[0])))
        except MotionError as error:
            error.motion = motion()
            raise
        return motion()


def _percents(part: float) -> None:
    """Write progress to stderr, and a line break at the end."""
    sys.stderr.write(f"\r{part:4.0%}" + "\n" * (part >= 1))


def _covariance(name: str, value: ArrayLike) -> Array:
    """Return a matrix after a check that it is a covariance, but for rounding errors."""
    P, given = finite(name, value, (6, 6)), np.asarray(value)
    if given.dtype.kind != "f":
        given = P
    require_symmetric(name, given)
    least = np.linalg.eigvalsh(P)[0]
    if least * precision(given) < -abs(P).sum():
        raise ValueError(f"{name} must be positive semidefinite, got the eigenvalue {least:g}")
    return P


def _angle(module: Any, v: Array, q: Array) -> float:
    """Return the rotation angle of v on its own branch, after a check that v is a regular point of the chart."""
    if not np.isfinite(q).all():
        size = math.hypot(*v[:3])
        raise ValueError(f"v0 must be within the edge of the chart and must not overflow, got the real length {size:g}")
    angle = math.hypot(*module.to_exponential(v)[:3])
    for singular in module.singular_angles():
        if not abs(angle - singular) > 1e-9:
            raise ValueError(f"v0 must not be on the singular set of the chart, got the rotation angle {angle:.9g}")
    return angle
