"""Rules of differentiation of kernels whose results are vectors, by kinematics: each is a combination of kernels.

The twist of R(v) along a direction dv is ``T(v) dv``. Rules have derivatives of any order, because kernels have them.
They keep compiled programs small: the differentiated text of a few calls in a row would take minutes to compile.
Components are last.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

from ._chart import Array, Call, Chart, Components
from ._interface import SPACE, SPACE_INV
from ._libraries import functions_of
from ._runtime import call, components, computed
from ._slopes import STEPS, share_of_angle, share_of_square


class Motions:
    """Kernels of one chart that the rules combine; components are last."""

    def __init__(self, chart: Chart) -> None:
        self.chart = chart
        # dual vectors move as lines do, and the rotation vectors of rotations alone move as points do
        self.move = "transform_line" if "transform_line" in chart.kernels else "transform_point"

    def twist(self, v: Array, rate: Array) -> Array:
        return call(self.chart, "twist", -1, v, rate, table=SPACE)

    def rate(self, v: Array, twist: Array) -> Array:
        return call(self.chart, "rate", -1, v, twist, table=SPACE_INV)

    def moved(self, v: Array, twist: Array) -> Array:
        return call(self.chart, self.move, -1, v, twist)

    @property
    def steps(self) -> Motions:
        """Kernels of exp(δ)."""
        return Motions(_steps(self.chart))


@cache
def _steps(chart: Chart) -> Chart:
    """Return the exponential with the kernels of a chart: those of poses or those of rotations."""
    return replace(STEPS, kernels=chart.kernels)


# --- rules: derivative of a result along the rates of its arguments ------------------------------------------------

Values = Sequence[Array]
Rule = Callable[["Motions", tuple[str, ...], Array, Values, Values], Array]


def _compose(at: Motions, table: tuple[str, ...], v: Array, values: Values, rates: Values) -> Array:
    """Return ``T(v)⁻¹ (T(v2) dv2 + R(v2) T(v1) dv1)``."""
    (v2, v1), (rate2, rate1) = values, rates
    return at.rate(v, at.twist(v2, rate2) + at.moved(v2, at.twist(v1, rate1)))


def _between(at: Motions, table: tuple[str, ...], v: Array, values: Values, rates: Values) -> Array:
    """Return ``T(v)⁻¹ R(v1)⁻¹ (T(v2) dv2 − T(v1) dv1)``."""
    return at.rate(v, _relative_twist(at, values, rates))


def _relative_twist(at: Motions, values: Values, rates: Values) -> Array:
    (v2, v1), (rate2, rate1) = values, rates
    return at.moved(-v1, at.twist(v2, rate2) - at.twist(v1, rate1))


def _retract(at: Motions, table: tuple[str, ...], w: Array, values: Values, rates: Values) -> Array:
    """Return ``T(w)⁻¹ (dexp(δ) dδ + exp(δ) T(v) dv)``."""
    (v, delta), (rate, change) = values, rates
    return at.rate(w, at.steps.twist(delta, change) + at.steps.moved(delta, at.twist(v, rate)))


def _body_retract(at: Motions, table: tuple[str, ...], w: Array, values: Values, rates: Values) -> Array:
    """Return ``T(w)⁻¹ (T(v) dv + R(v) dexp(δ) dδ)``."""
    (v, delta), (rate, change) = values, rates
    return at.rate(w, at.twist(v, rate) + at.moved(v, at.steps.twist(delta, change)))


def _local(at: Motions, table: tuple[str, ...], delta: Array, values: Values, rates: Values) -> Array:
    """Return ``dexp(δ)⁻¹ (T(v2) dv2 − exp(δ) T(v1) dv1)``."""
    (v2, v1), (rate2, rate1) = values, rates
    return at.steps.rate(delta, at.twist(v2, rate2) - at.steps.moved(delta, at.twist(v1, rate1)))


def _body_local(at: Motions, table: tuple[str, ...], delta: Array, values: Values, rates: Values) -> Array:
    """Return ``dexp(δ)⁻¹ R(v1)⁻¹ (T(v2) dv2 − T(v1) dv1)``."""
    return at.steps.rate(delta, _relative_twist(at, values, rates))


def _twist(at: Motions, side: tuple[str, ...], twist: Array, values: Values, rates: Values) -> Array:
    """Return ``T dv̇ + dT v̇``."""
    (v, v_dot), (rate, change) = values, rates
    return call(at.chart, "twist", -1, v, change, table=side) + _turned(at, side, v, rate, v_dot)


def _rate(at: Motions, sides: tuple[str, ...], v_dot: Array, values: Values, rates: Values) -> Array:
    """Return ``T⁻¹ (dω − dT v̇)``."""
    (v, _), (rate, change) = values, rates
    return call(at.chart, "rate", -1, v, change - _turned(at, sides[:1], v, rate, v_dot), table=sides)


def _turned(at: Motions, side: tuple[str, ...], v: Array, rate: Array, v_dot: Array) -> Array:
    """Return ``dT v̇``, with dT the change of T along the rate."""
    change = call(at.chart, "tangent_dot", -1, v, rate, table=side)
    if v.shape[-1] == 3:
        return _product(change, v_dot)
    real, dual = change[..., 0, :, :], change[..., 1, :, :]
    re, du = v_dot[..., :3], v_dot[..., 3:]
    m = functions_of("v", v)
    return m.xp.concatenate([_product(real, re), _product(real, du) + _product(dual, re)], axis=-1)


def _product(matrix: Array, vector: Array) -> Array:
    # libraries may compute products of matrices with fewer digits
    return functions_of("matrix", matrix).xp.sum(matrix * vector[..., None, :], axis=-1)


def _shadow(at: Motions, turn: tuple[str, ...], w: Array, values: Values, rates: Values) -> Array:
    """Return ``∂w/∂v dv``; a principal v has the axis of its own angle, so that a turn is a shadow."""
    return _product(call(at.chart, "shadow_jacobian", -1, *values, table=turn), *rates)


def _principal(at: Motions, returns: tuple[str, ...], w: Array, values: Values, rates: Values) -> Array:
    """Return ``T(w)⁻¹ T(v) dv``, because w has the pose of v."""
    return at.rate(w, at.twist(*values, *rates))


def _interpolate(at: Motions, table: tuple[str, ...], w: Array, values: Values, rates: Values) -> Array:
    """Return ``T(w)⁻¹ (dexp(t δ) (t dδ + δ dt) + exp(t δ) T(v1) dv1)``, with δ from v1 to v2."""
    (v1, v2, t), (rate1, rate2, change) = values, rates
    delta, t = call(at.chart, "local", -1, v2, v1), t[..., None]
    turned = t * _local(at, table, delta, (v2, v1), (rate2, rate1)) + change[..., None] * delta
    step = t * delta
    return at.rate(w, at.steps.twist(step, turned) + at.steps.moved(step, at.twist(v1, rate1)))


def _to_exponential(at: Motions, table: tuple[str, ...], w: Array, values: Values, rates: Values) -> Array:
    return _rescaled(share_of_square, at, *values, *rates)


def _from_exponential(at: Motions, table: tuple[str, ...], v: Array, values: Values, rates: Values) -> Array:
    return _rescaled(share_of_angle, at, *values, *rates)


def _rescaled(function: Callable[..., Any], at: Motions, v: Array, rate: Array) -> Array:
    """Return the derivative of ``share(x) v`` along a rate, from the share with its slopes at ``x = v·v``."""
    m = functions_of("v", v)
    n = v.shape[-1]
    rows, changes = (components(m, array, (n,), -1) for array in (v, rate))
    (re, du), (dre, ddu) = ((part[:3], part[3:]) for part in (rows, changes))
    share, slope, bend, *_ = function(m, m.scalars(at.chart), m.scalars(at.steps.chart), _dot(re, re))
    along = _dot(re, dre)
    found = [share * d + slope * along * r for r, d in zip(re, dre, strict=True)]
    if du:
        y = _dot(re, du)
        turned = slope * (_dot(re, ddu) + _dot(du, dre)) + bend * y * along
        parts = zip(re, du, dre, ddu, strict=True)
        found += [share * dd + slope * (y * d + along * o) + turned * r for r, o, d, dd in parts]
    return m.stack(found, -1)


def _dot(a: Components, b: Components) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


RULES: Mapping[str, Rule] = {
    "compose": _compose,
    "between": _between,
    "retract": _retract,
    "body_retract": _body_retract,
    "local": _local,
    "body_local": _body_local,
    "twist": _twist,
    "rate": _rate,
    "turn": _shadow,
    "shadow": _shadow,
    "principal": _principal,
    "interpolate": _interpolate,
    "to_exponential": _to_exponential,
    "from_exponential": _from_exponential,
}
"""Rules by kernel."""

JACOBIANS: Mapping[str, str] = {
    "compose_jacobians": "compose",
    "between_jacobians": "between",
    "retract_jacobians": "retract",
    "body_retract_jacobians": "body_retract",
}
"""Kernels of which two derivatives of another kernel are the result."""


def columns(at: Motions, name: str, values: Values) -> Array:
    """Return the derivatives of a kernel by both arguments, side by side as its Jacobians, by its rule."""
    m, n = functions_of(name, values[0]), values[0].shape[-1]
    result = call(at.chart, name, -1, *values)
    eye = m.taken([[float(i == j) for j in range(n)] for i in range(n)])
    wide = [array[..., None, :] for array in (result, *values)]
    one, none = eye + 0 * wide[0], 0 * eye + 0 * wide[0]
    found = [RULES[name](at, (), wide[0], wide[1:], rates) for rates in ((one, none), (none, one))]
    flat = [m.xp.swapaxes(jacobian, -1, -2) for jacobian in found]
    return m.xp.concatenate([m.reshape(jacobian, (*jacobian.shape[:-2], n * n)) for jacobian in flat], axis=-1)


def run(m: Any, kernel_call: Call, axis: int, arrays: Values) -> Array:
    """Run a kernel on checked arrays, by its rule if it has one."""
    if kernel_call.name in m.by_text or kernel_call.name not in {*RULES, *JACOBIANS}:
        found: Array = m.unruled(kernel_call, axis)(*arrays)
        return found
    parts = [part for _, part in kernel_call.arguments]
    last = [m.moved(a, 0, -1) if axis == 0 and part else a for a, part in zip(arrays, parts, strict=True)]
    found = m.ruled(kernel_call)(*last)
    return m.moved(found, -1, 0) if axis == 0 else found


def value_of(kernel_call: Call, *given: Array) -> Array:
    """Return the result of a kernel on arrays whose components are last."""
    return functions_of(kernel_call.name, given[0]).once(text_of(kernel_call, -1, *given))


def text_of(kernel_call: Call, axis: int, *given: Array) -> Array:
    """Return the result of a kernel by its text."""
    return computed(functions_of(kernel_call.name, given[0]), kernel_call, axis, given)


def slope_of(kernel_call: Call, result: Array, values: Values, rates: Values) -> Array:
    """Return the derivative of a kernel along the rates of its arguments."""
    at, name = Motions(kernel_call.chart), kernel_call.name
    if name in JACOBIANS:
        m: Any = functions_of(name, values[0])
        return m.derivative(lambda *given: columns(at, JACOBIANS[name], given), values, rates)
    return RULES[name](at, kernel_call.table, result, values, rates)
