"""Motion of a pose that `propagate` returns: its vectors, poses, branches and covariances at any time."""

from __future__ import annotations

import importlib
import math
from dataclasses import dataclass, field
from typing import Any, Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._kernel import Array


class OfModule:
    """Base of objects with a kernel module as ``module``, of which pickle and copy save the name."""

    def __getstate__(self) -> dict[str, Any]:
        module = vars(self)["module"]
        return {**vars(self), "module": getattr(module, "__name__", module)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        module = state["module"]
        vars(self).update(state, module=importlib.import_module(module) if isinstance(module, str) else module)


class Path(Protocol):
    """Vectors of a motion and their time derivatives, at times from ``begin`` to ``end``."""

    @property
    def module(self) -> Any: ...

    @property
    def begin(self) -> float: ...

    @property
    def end(self) -> float: ...

    def derivative(self, t: Array, order: int) -> Array: ...


@dataclass(frozen=True, eq=False)
class Motion:
    """Motion of a pose, known at the times ``t`` and, by a call, at any time between.

    ``motion(t, order)`` returns v, v̇ or v̈, for ``order`` 0, 1 or 2. They are continuous between switches.

    A motion can be copied and pickled. A twist that pickle cannot save, such as a lambda, is left out: of the loaded
    motion ``order=0`` alone is known, and the others raise `MotionError`.

    Parameters
    ----------
    t : array, shape (T,)
        Times (s).
    v : array, shape (T, 6)
        Vectors of the chart: real part, then dual part.
    pose : array, shape (T, 4, 4)
        Homogeneous matrices.
    branch : array of int, shape (T,)
        k of ``v = φ(α + 2kπ) u``, modulo the number of branches; 0 is principal.
    switches : array, shape (S,)
        Times where v changes its branch. For charts that are singular at π, times where v jumps there.
    covariance : array, shape (T, 6, 6), or None
        Covariances of v.
    """

    t: NDArray[np.float64]
    v: NDArray[np.float64]
    pose: NDArray[np.float64]
    branch: NDArray[np.int_]
    switches: NDArray[np.float64]
    covariance: NDArray[np.float64] | None
    _path: Path = field(repr=False)

    @property
    def module(self) -> Any:
        """Kernel module of v."""
        return self._path.module

    def __call__(self, t: ArrayLike, order: Literal[0, 1, 2] = 0) -> NDArray[np.float64]:
        """Return v or a time derivative of v at times of any shape.

        The derivative of a callable twist, for ``order=2``, is that of a polynomial through five values of the twist.
        Its error is about 1e-12 of the twist per step of the integrator, if the twist is smooth.

        Parameters
        ----------
        t : array, shape (...)
            Times (s) from the first to the last of the motion; otherwise ValueError.
        order : {0, 1, 2}
            0 for v, 1 for v̇ (1/s), 2 for v̈ (1/s²).

        Returns
        -------
        array, shape (..., 6)
            Real part, then dual part.
        """
        times, path = np.asarray(t, float), self._path
        if order not in (0, 1, 2):
            raise ValueError(f"order must be 0, 1 or 2, got {order!r}")
        outside = times[~((times >= path.begin) & (times <= path.end))]
        if outside.size:
            raise ValueError(f"t must be in [{path.begin:g}, {path.end:g}], got {outside.flat[0]:g}")
        return path.derivative(times.ravel(), order).reshape(*times.shape, 6)


class MotionError(RuntimeError):
    """Failure on the way; ``time`` is where it happened, ``motion`` the `Motion` before."""

    motion: Motion

    def __init__(self, message: str, time: float = math.nan) -> None:
        super().__init__(message)
        self.time = time
