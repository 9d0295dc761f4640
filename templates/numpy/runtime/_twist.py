"""Twist of a motion: samples joined by a spline, or a function of time whose values are checked."""

from __future__ import annotations

import math
import pickle
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike

from ._arguments import finite
from ._kernel import Array
from ._motion import MotionError


class Twist(Protocol):
    """Twist [ω, v] as a function of time, with its derivative (T, 6) at times (T,); None if it is unknown.

    It is smooth between times called ``knots``.
    """

    @property
    def knots(self) -> Array: ...

    def __call__(self, time: float) -> Sequence[float]: ...

    def derivative(self, t: Array) -> Array | None: ...


@dataclass(frozen=True)
class Sampled:
    """Twist by a spline."""

    spline: Any
    knots: Array

    def __call__(self, time: float) -> Sequence[float]:
        omega: Sequence[float] = self.spline(time).tolist()
        return omega

    def derivative(self, t: Array) -> Array:
        return np.asarray(self.spline.derivative()(t))


@dataclass(frozen=True)
class Called:
    """Twist by a user's function, which copies share. If pickle cannot save or load it, `Lost` takes its place."""

    function: Callable[[float], ArrayLike]
    knots: Array

    def __call__(self, time: float) -> Sequence[float]:
        """Return six finite floats; raise MotionError for any other value."""
        found: Any = self.function(time)
        value = found.tolist() if isinstance(found, np.ndarray) else found
        six = isinstance(value, (list, tuple)) and len(value) == 6
        if six and all(isinstance(part, float) and math.isfinite(part) for part in value):  # the usual case, fast
            return value  # type: ignore[no-any-return]
        try:
            checked: Sequence[float] = finite("twist", found, (6,)).tolist()
        except (TypeError, ValueError) as error:
            raise MotionError(f"{error} at t = {time:.9g}", time) from error
        return checked

    def derivative(self, t: Array) -> None:
        return None

    def __deepcopy__(self, memo: Any) -> Called:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        try:
            saved = pickle.dumps(self.function)
        except Exception:  # any error of a user's object
            saved = b""
        return _loaded, (saved, repr(self.function), self.knots)


@dataclass(frozen=True)
class Lost:
    """Function in place of a twist that pickle could not save or load; ``name`` is what the twist was."""

    name: str

    def __call__(self, time: float) -> ArrayLike:
        raise MotionError(
            f"the twist {self.name} was not saved with the motion, so only order=0 is known: "
            "take a function of an importable module, or samples",
            time,
        )


def _loaded(saved: bytes, name: str, knots: Array) -> Called:
    try:
        return Called(pickle.loads(saved), knots)
    except Exception:  # no bytes, or a function that this process does not have
        return Called(Lost(name), knots)


def twist_of(twist: Callable[[float], ArrayLike] | ArrayLike, t: Array, knots: ArrayLike | None) -> Twist:
    """Return the twist of a motion from a function, from one value, or from samples at the times t."""
    if callable(twist):
        finite("twist at the first time", twist(t[0]), (6,))
        times: ArrayLike = () if knots is None else knots
        return Called(twist, np.unique(finite("knots", times, (np.size(times),))))
    if knots is not None:
        raise TypeError("knots are for a callable twist: samples have theirs at the times t")
    from scipy.interpolate import CubicSpline  # type: ignore[import, unused-ignore]

    shape = np.shape(twist)
    if shape == (6,):
        return Sampled(CubicSpline(t[[0, -1]], np.tile(finite("twist", twist, (6,)), (2, 1))), t[[0, -1]])
    if shape != (len(t), 6):
        raise ValueError(f"twist must have shape ({len(t)}, 6), got {shape}; a constant one has (6,)")
    return Sampled(CubicSpline(t, finite("twist", twist, shape)), t)
