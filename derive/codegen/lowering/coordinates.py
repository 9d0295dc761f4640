"""Exponential coordinates α u of a vector on its own branch, and back: the way from chart to chart.

A function of r times u has the dual part of r times its slope along the axis, and no other: regular at no rotation.
"""

from __future__ import annotations

from ..programs.program import Program
from ..programs.value import Number
from .point import Geometry, Point


def to_exponential(trace: Geometry) -> Program:
    """α u of v = φ(α) u, on the branch of v."""
    point = trace.point()
    resting, square, length = _length(trace, point)
    (own,) = trace.ask("unfolded", (point.x, length))
    rate, _ = trace.ask("rate_scalars", (point.x,))
    share = trace.name("share", trace.where(resting, rate, own / length))
    return trace.program("to_exponential", _rescaled(trace, point, square, share, rate))


def from_exponential(trace: Geometry) -> Program:
    """φ(α) u of α u; beyond the edge of the chart, of an α by whole turns less."""
    point = trace.point("w")
    resting, square, length = _length(trace, point)
    (angle,) = trace.ask("reached", (trace.name("alpha", trace.where(resting, point.x, length)),))
    size, slope = trace.ask("coefficient", (angle,), "n")
    share = trace.name("share", trace.where(resting, slope, size / length))
    return trace.program("from_exponential", _rescaled(trace, point, square, share, slope))


def _length(trace: Geometry, point: Point) -> tuple[Number, Number, Number]:
    """Return whether the length is 0, its square, and itself; at 0 others, for no root is taken of 0."""
    resting = trace.name("resting", trace.equal(point.x, 0))
    square = trace.name("square", trace.where(resting, 1 + point.x, point.x))
    return resting, square, trace.name("length", trace.sqrt(square))


def _rescaled(trace: Geometry, point: Point, square: Number, share: Number, slope: Number) -> tuple[Number, ...]:
    """Return a vector times a share of its length, whose slope by that length is given."""
    bend = trace.name("bend", (slope - share) * point.y / square)
    return *(share * point.re), *(share * point.du + bend * point.re)
