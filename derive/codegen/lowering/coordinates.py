"""Exponential coordinates α u of a vector on its own branch, and the inverse map: conversion between charts.

A vector k(r) u, r = |v|, has the dual part (k/r) v° + (k' − k/r) (v·v°/v²) v, which is regular at v = 0.
"""

from __future__ import annotations

from ..programs.program import Program
from ..programs.value import Number
from .point import Geometry, Point


def to_exponential(trace: Geometry) -> Program:
    """Exponential coordinates α u of v = φ(α) u, on the branch of v."""
    point = trace.point()
    resting, square, length = _length(trace, point)
    (own,) = trace.ask("unfolded", (point.x, length))
    (rate,) = trace.ask("rate_scalars", (point.x,))
    share = trace.name("share", trace.where(resting, rate, own / length))
    return trace.program("to_exponential", _rescaled(trace, point, square, share, rate))


def from_exponential(trace: Geometry) -> Program:
    """Vector φ(α) u of exponential coordinates α u; α beyond the edge of the chart is reduced by whole turns."""
    point = trace.point("w")
    resting, square, length = _length(trace, point)
    (angle,) = trace.ask("reached", (trace.name("alpha", trace.where(resting, point.x, length)),))
    size, slope = trace.ask("coefficient", (angle,), "n")
    share = trace.name("share", trace.where(resting, slope, size / length))
    return trace.program("from_exponential", _rescaled(trace, point, square, share, slope))


def _length(trace: Geometry, point: Point) -> tuple[Number, Number, Number]:
    """Return whether the length is 0, its square, and the length; both become 1 at 0, to avoid the root of 0."""
    resting = trace.name("resting", trace.equal(point.x, 0))
    square = trace.name("square", trace.where(resting, 1 + point.x, point.x))
    return resting, square, trace.name("length", trace.sqrt(square))


def _rescaled(trace: Geometry, point: Point, square: Number, share: Number, slope: Number) -> tuple[Number, ...]:
    """Return a vector scaled by ``share``, new over old length; ``slope`` is the derivative of the new length."""
    bend = trace.name("bend", (slope - share) * point.y / square)
    return *(share * point.re), *(share * point.du + bend * point.re)
