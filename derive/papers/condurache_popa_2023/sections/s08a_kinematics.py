"""Section 8, motion by tensors, quaternions and natural invariants: lines 342-387."""

from functools import partial
from typing import Any

from ....algebra import Dual, Tensor, Vector, first_principles
from ....algebra.pose import line_through
from ..definitions import motions
from . import *

R_t = Symbol("R(t)", "orthogonal tensor", r"\underline{\mathbf{R}}(t)", "Rt")
R_0, other = Symbol("R_0", "orthogonal tensor", r"\underline{\mathbf{R}}_0", "R0"), tensor("S")
T = tensor("T")
omega = vector("omega", r"\omega", "ω")
omega_B = Symbol("omega_B", "dual vector", r"\underline{\boldsymbol{\omega}}_B", "ωB")
skew_B = Symbol("skew omega_B", "tensor", r"\tilde{\underline{\boldsymbol{\omega}}}_B", "ω~B")
Phi = Symbol("Phi", "tensor", r"\underline{\Phi}", "Φ")
line, line_0 = vector("l", r"l"), vector("l_0", "l_0", "l0")
line_t = Symbol("l(t)", "line", r"\underline{\mathbf{l}}(t)", "lt")
free_line = vector("line")
point, along = (Symbol(name, "real vector", rf"\mathbf{{{name}}}", name) for name in ("point", "direction"))
w_real = Symbol("w", "real vector", r"\boldsymbol{\omega}", "ω")
v_real = Symbol("v of the origin", "real vector", r"\mathbf{v}", "v")
zero_tensor = Symbol("0 tensor", "tensor", r"\underline{\mathbf{0}}", "0")
at_start = Symbol("R R^T at t0", "tensor", r"(\underline{\mathbf{R}}\,\underline{\mathbf{R}}^T)(t_0)", "RRTt0")
Theta = Symbol("Theta", "tensor", r"\underline{\boldsymbol{\Theta}}", "Θ")
half_sine = Symbol("sin α/2", "number", r"\sin\frac{\underline{\alpha}}{2}", "sin α/2")

ZERO = let(zero_tensor, lambda env: Tensor.identity() * 0)
MOTION = (
    let(R, screw_tensor, alpha, u), let(q_hat, screw_quaternion, alpha, u), let(omega, motions.twist, R),
    let(omega_B, motions.body_twist, R), let(skew_B, skew_of, omega_B),
    let(line_0, motions.at_rest, free_line), let(line, image, R, line_0),
    ZERO, let(Theta, lambda env, alpha, u: first_principles.axis_rates(
        partial(screw_tensor, env), env.now(alpha), env.now(u)), alpha, u),
    let(half_sine, motions.half_sine, alpha),
)
PARTS = (
    let(R, screw_tensor, alpha, u), let(omega, motions.twist, R), let(Q, motions.rotation_part, R),
    let(rho, lambda env, R, Q: (R.map(lambda c: Dual(c.du, 0 * c.du)) @ Q.transpose).vect(), R, Q),
    let(w_real, motions.twist, Q), let(v_real, motions.velocity_at_origin, Q, rho),
)


def not_orthogonal() -> dict[Symbol, Any]:
    """Return values with ``Ṙ = skew(ω) R`` although R is not orthogonal."""

    def moving(value: Any, rate: Any) -> Dual:
        return Dual(Dual(value, rate), Dual(0, 0))

    T, w = Tensor.from_entries((1, 2, 0, -1, 3, 1, 2, 0, 1)), Vector(2, -1, 3)
    start = Tensor.from_entries(moving(a, b) for a, b in zip(T, Tensor.skew(w) @ T, strict=True))
    return {R: start, omega: w.map(lambda c: moving(c, 0))}


Theta_read = -(half * (skew(u) + cot(half * alpha) * skew(u)**2))

ENTRIES = (
    equation("66", equal(line_t, R_t * line_0),
             where=(let(line_t, motions.moved_line, R_t, point, along),
                    let(line_0, plain(line_through), point, along))),
    equation("67", equal(rate(line), Phi * line), where=(*MOTION, let(Phi, skew_of, omega))),
    equation("68", equal(Phi, rate(R) * transpose(R)), where=(*MOTION, let(Phi, motions.velocity_tensor, R))),
    equation("velocity-tensor-sum", equal(rate(R) * transpose(R) + R * transpose(rate(R)), zero_tensor), where=MOTION),
    equation("velocity-tensor-skew", equal(Phi, -transpose(Phi)),
             where=(*MOTION, let(Phi, lambda env, R: env.rate(R) @ R.transpose, R)), moving=True),
    equation("dual-angular-velocity", equal(omega, vect(rate(R) * transpose(R))),
             where=(let(R, screw_tensor, alpha, u), let(omega, motions.angular_velocity, R))),
    equation("69", equal(omega, w_real + epsilon * v_real), where=PARTS, moving=True),
    equation("velocity-at-origin", equal(v_real, rate(rho) - cross(w_real, rho)), where=PARTS),
    equation("70", equal(rate(R), skew(omega) * R), where=MOTION),
    equation("theorem-19-unique",
             equal(transpose(skew(omega) * other) * T + transpose(other) * (skew(omega) * T), zero_tensor),
             where=(ZERO,)),
    equation("71",
             equal(ddt(R * transpose(R)), rate(R) * transpose(R) + R * transpose(rate(R)),
                   skew(omega) * R * transpose(R) - R * transpose(R) * skew(omega), zero_tensor),
             where=MOTION, condition=equal(R * transpose(R), identity), also={"R not orthogonal": not_orthogonal()}),
    equation("72", equal(R * transpose(R), at_start, identity),
             where=(let(at_start, plain(lambda R: R @ R.transpose), R_0), ZERO),
             because=equal(skew(omega) * identity - identity * skew(omega), zero_tensor)),
    equation("determinant", equal(det(T * transpose(T)), det(T)**2)),
    equation("73", both(equal(R * transpose(R), identity), equal(det(R), 1)),
             because=equal(det(T * transpose(T)), det(T)**2)),
    equation("body-twist", equal(omega_B, transpose(R) * omega), where=MOTION),
    equation("74", equal(rate(R), R * skew_B), where=MOTION),
    equation("eighteen-equations", equal(equations_in(R), 18)),
    equation("75", equal(rate(q_hat), half * omega * q_hat), where=MOTION),
    equation("76", equal(rate(q_hat), half * q_hat * omega_B), where=MOTION),
    equation("eight-equations", equal(equations_in(q_hat), 8), where=MOTION),
    equation("77", equal(rate(alpha), dot(omega, u), dot(omega_B, u)), where=MOTION),
    equation("78", equal(rate(u), Theta * omega, transpose(Theta) * omega_B), where=MOTION,
             condition=nonzero(Re(half_sine)), because=equal(rate(u), Theta_read * omega)),
    equation("theta",
             (Reading(equal(Theta, Theta_read), "with a minus in front"),
              Reading(equal(Theta, half * (skew(u) + cot(half * alpha) * skew(u)**2)), "without")),
             where=MOTION, condition=nonzero(Re(sin(half * alpha)))),
    equation("79", equal(omega, rate(alpha) * u + sin(alpha) * rate(u) + (1 - cos(alpha)) * cross(u, rate(u))),
             where=MOTION),
    equation("80", equal(omega_B, rate(alpha) * u + sin(alpha) * rate(u) - (1 - cos(alpha)) * cross(u, rate(u))),
             where=MOTION),
)
