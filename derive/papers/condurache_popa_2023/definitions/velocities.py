"""What the symbols of section 8 stand for: twists and tangent operators, differentiated from first principles.

Symbols here may change in time: `Env.now` is their value alone, `Env.rate` their rate.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from derive.algebra import Dual, Tensor, Vector, real_part
from derive.maps import first_principles
from derive.maps.exponential import tensor_exponential
from derive.maps.lines import line_through
from derive.maps.pose import pose_from_tensor

from ...language import values
from ...language.evaluation import Env
from ...language.terms import Symbol
from ...numbers.draw import Draw
from ...numbers.fields import innermost
from . import orders
from .motions import AXES, screw_tensor


def at_rest(env: Env, a: Any) -> Any:
    """The same at a rate of 0."""

    def still(c: Any) -> Any:
        if not isinstance(c, Dual):
            return c
        return Dual(Dual(c.re.re, 0), Dual(c.du.re, 0)) if env.dual else Dual(c.re, 0)

    return a.map(still)


def twist(env: Env, R: Tensor) -> Vector:
    """``vect(Ṙ Rᵀ)``."""
    return first_principles.twist(R, env.rate(R))


def body_twist(env: Env, R: Tensor) -> Vector:
    """``vect(Rᵀ Ṙ)``."""
    return first_principles.body_twist(R, env.rate(R))


def spin(env: Env, R: Tensor) -> Tensor:
    """``Ṙ Rᵀ``."""
    Phi: Tensor = env.rate(R) @ R.transpose
    return Phi


def skew_twist(env: Env, R: Tensor) -> Tensor:
    """``skew(ω)``."""
    return Tensor.skew(twist(env, R))


def skew_body_twist(env: Env, R: Tensor) -> Tensor:
    """``skew(ω_B)``."""
    return Tensor.skew(body_twist(env, R))


def rates_of_lines(env: Env, R: Tensor, operator: Callable[[Vector], Vector]) -> bool:
    """Whether an operator gives the rates of three lines that the body carries along."""
    lines = [R @ axis for axis in AXES]
    return all(values.equal(env.field, env.now(operator(line)), env.now(env.rate(line))) for line in lines)


def velocity_operator(env: Env, R: Tensor) -> values.Solution:
    """Every tensor Φ with ``l̇ = Φ l`` for all lines of the body."""
    return values.Solution(lambda T: rates_of_lines(env, R, lambda line: T @ line))


def angular_velocity(env: Env, R: Tensor) -> values.Solution:
    """Every ω with ``l̇ = ω × l`` for all lines of the body."""
    return values.Solution(lambda w: rates_of_lines(env, R, lambda line: w.cross(line)))


def carried(env: Env, R: Tensor, line: Vector) -> Vector:
    """``R l₀``."""
    return R @ line


def moved_line(env: Env, R: Tensor, point: Vector, along: Vector) -> Vector:
    """The line through a point, moved as the pose of R moves points."""
    pose = pose_from_tensor(R)
    return line_through(pose.apply(point), pose.rotation @ along)


def first_line(env: Env, point: Vector, along: Vector) -> Vector:
    """The line through a point before the motion."""
    return line_through(point, along)


def _real(a: Any) -> Any:
    """Real parts as dual numbers, so that they keep their rates."""
    return a.map(lambda c: Dual(c.re, 0 * c.re))


def rotation_part(env: Env, R: Tensor) -> Tensor:
    """Q of ``R = (I + ε ρ̃) Q``."""
    Q: Tensor = _real(R)
    return Q


def displacement_part(env: Env, R: Tensor) -> Vector:
    """ρ of ``R = (I + ε ρ̃) Q``."""
    du = R.map(lambda c: Dual(c.du, 0 * c.du))
    rho: Vector = (du @ _real(R).transpose).vect()
    return rho


def rotation_rate(env: Env, Q: Tensor) -> Vector:
    """The angular velocity ``vect(Q̇ Qᵀ)``."""
    return twist(env, Q)


def velocity_at_origin(env: Env, Q: Tensor, rho: Vector) -> Vector:
    """The velocity of the body point that is at the origin: it is ``−Qᵀρ`` in the body."""
    body_point = at_rest(env, -(Q.transpose @ rho))
    velocity: Vector = env.rate(Q @ body_point + rho)
    return velocity


def zero_tensor(env: Env) -> Tensor:
    """The tensor 0."""
    return Tensor.identity() * 0


def product_at_start(env: Env, R_0: Tensor) -> Tensor:
    """``R₀ R₀ᵀ``."""
    return R_0 @ R_0.transpose


def flow(draw: Draw) -> dict[str, Any]:
    """A tensor with ``Ṫ = skew(ω) T`` that is not orthogonal, and its ω."""
    T = Tensor.from_entries(draw.number(draw.signed()).re.re for _ in range(9))
    omega = Vector(draw.signed(), draw.signed(), draw.signed())
    slope = Tensor.skew(omega) @ T

    def moving(value: Any, rate: Any) -> Dual:
        return Dual(Dual(value, rate), Dual(0 * value, 0 * value))

    return {
        "R": Tensor.from_entries(moving(a, b) for a, b in zip(T, slope, strict=True)),
        "ω": omega.map(lambda c: moving(c, 0 * c)),
    }


def not_orthogonal(R: Symbol, omega: Symbol) -> Callable[[Draw], dict[str, dict[Symbol, Any]]]:
    """A solution of Ṙ = skew(ω) R that starts elsewhere."""

    def point(draw: Draw) -> dict[str, dict[Symbol, Any]]:
        parts = flow(draw)
        return {"R not orthogonal": {R: parts["R"], omega: parts["ω"]}}

    return point


def axis_operator(env: Env, alpha: Any, u: Vector) -> Tensor:
    """Θ, the operator that takes the twist to u̇."""
    return first_principles.axis_rates(lambda a, w: screw_tensor(env, a, w), env.now(alpha), env.now(u))


def half_sine(env: Env, alpha: Any) -> Any:
    """``sin(α/2)`` at the moment."""
    return env.field.sin(values.divide(env.now(alpha), 2))


def sinc(env: Env) -> Callable[[Any], Any]:
    """``sin α/α``, continued by 1; its slope at 0 is 0."""
    return lambda a: 1 + 0 * a if innermost(a) == 0 else values.divide(env.field.sin(a), a)


def sinc_by_series(env: Env) -> Callable[[Any], Any]:
    """The same by its power series, to 60 digits for arguments up to 20."""

    def series(a: Any) -> Any:
        total, term = 1 + 0 * a, 1 + 0 * a
        for k in range(1, 80):
            term = -term * (a * a) / (2 * k * (2 * k + 1))
            total = total + term
        return total

    return series


def dexp(env: Env, a: Vector) -> Tensor:
    """The operator ω = dexp ȧ, with ω = vect(Ṙ Rᵀ) differentiated along ``R = exp(skew(a))``."""
    return first_principles.tangent(lambda w: tensor_exponential(w, env.field), env.now(a))


def dexp_inv(env: Env, a: Vector) -> Tensor:
    """Its inverse."""
    return dexp(env, a).inverse()


def dexp_inv_transpose(env: Env, a: Vector) -> Tensor:
    """The transpose of its inverse."""
    return dexp_inv(env, a).transpose


def dexp_transpose(env: Env, a: Vector) -> Tensor:
    """Its transpose."""
    return dexp(env, a).transpose


def dcay(env: Env, n: Any, v: Vector) -> Tensor:
    """The operator ω = dcay_n v̇ at the moment."""
    return orders.tangent(env, n, env.now(v))


def dcay_inv(env: Env, n: Any, v: Vector) -> Tensor:
    """Its inverse."""
    return dcay(env, n, v).inverse()


def dcay_inv_transpose(env: Env, n: Any, v: Vector) -> Tensor:
    """The transpose of its inverse."""
    return dcay_inv(env, n, v).transpose


def q_now(env: Env, n: Any, v: Vector) -> Any:
    """``q_n(|v|)`` at the moment."""
    return orders.q(env, n)(env.now(v))


def is_invertible(env: Env, T: Tensor) -> bool:
    """Whether a tensor has an inverse."""
    return not env.field.same(innermost(real_part(T.det())), 0)


def half_sinc(env: Env, alpha: Any) -> Any:
    """``sinc(α/2)`` at the moment; it is even, so that of |α|."""
    return sinc(env)(values.divide(env.now(alpha), 2))
