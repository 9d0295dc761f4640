"""Section 8, motion by tensors, quaternions and natural invariants: lines 342-387."""

from functools import partial
from typing import Any

from ....algebra import Dual, Tensor, Vector
from ....maps import first_principles
from ....maps.pose import line_through
from ..definitions import velocities
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
    let(R, screw_tensor, alpha, u), let(q_hat, screw_quaternion, alpha, u), let(omega, velocities.twist, R),
    let(omega_B, velocities.body_twist, R), let(skew_B, skew_of, omega_B),
    let(line_0, velocities.at_rest, free_line), let(line, image, R, line_0),
    ZERO, let(Theta, lambda env, alpha, u: first_principles.axis_rates(
        partial(screw_tensor, env), env.now(alpha), env.now(u)), alpha, u),
    let(half_sine, velocities.half_sine, alpha),
)
PARTS = (
    let(R, screw_tensor, alpha, u), let(omega, velocities.twist, R), let(Q, velocities.rotation_part, R),
    let(rho, lambda env, R, Q: (R.map(lambda c: Dual(c.du, 0 * c.du)) @ Q.transpose).vect(), R, Q),
    let(w_real, velocities.twist, Q), let(v_real, velocities.velocity_at_origin, Q, rho),
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
    equation("66", "a line of the body", 346, equal(line_t, R_t * line_0), extract="l _ t = R _ t l _ 0",
             where=(let(line_t, velocities.moved_line, R_t, point, along),
                    let(line_0, plain(line_through), point, along)),
             remark="l₀ is the line in the body axes, so at t₀ in space if R(t₀) = I."),
    equation("67", "velocity of a line", 349, equal(rate(line), Phi * line), extract="l ˙ _ = Φ _ l _",
             where=(*MOTION, let(Phi, skew_of, omega)), moving=True),
    equation("68", "velocity dual tensor", 351, equal(Phi, rate(R) * transpose(R)), extract="Φ _ = R ˙ _ R _ T",
             where=(*MOTION, let(Phi, velocities.velocity_tensor, R)), moving=True),
    equation("velocity-tensor-sum", "derivative of R Rᵀ = I", 352,
             equal(rate(R) * transpose(R) + R * transpose(rate(R)), zero_tensor),
             extract="R ˙ _ R _ T + R _ R ˙ _ T = 0 _", where=MOTION, moving=True),
    equation("velocity-tensor-skew", "Φ is skew-symmetric", 352, equal(Phi, -transpose(Phi)), extract="Φ _ = Φ _ T",
             where=(*MOTION, let(Phi, lambda env, R: env.rate(R) @ R.transpose, R)), moving=True,
             fixed_by="the same line: Ṙ Rᵀ + R Ṙᵀ = 0, to which it is said to be equivalent"),
    equation("dual-angular-velocity", "dual angular velocity", 353, equal(omega, vect(rate(R) * transpose(R))),
             extract="ω _ = v e c t R ˙ _ R _ T",
             where=(let(R, screw_tensor, alpha, u), let(omega, velocities.angular_velocity, R)), moving=True),
    equation("69", "dual and real parts of the spatial twist", 354, equal(omega, w_real + epsilon * v_real),
             extract="ω _ = ω + ε v", where=PARTS, moving=True),
    equation("velocity-at-origin", "velocity of the body point at the origin", 355,
             equal(v_real, rate(rho) - cross(w_real, rho)), extract="v = ρ ˙ ω × ρ", where=PARTS, moving=True),
    equation("70", "Poisson-Darboux problem, spatial twist", 359, equal(rate(R), skew(omega) * R),
             extract="R ˙ _ = ω ~ _ R _", where=MOTION, moving=True),
    equation("theorem-19-unique", "the solution is unique", 358,
             equal(transpose(skew(omega) * other) * T + transpose(other) * (skew(omega) * T), zero_tensor),
             where=(ZERO,),
             remark="SᵀT of two solutions is constant, so that S = T if S is orthogonal and both start alike; a linear "
             "equation with a continuous ω has a solution."),
    equation("71", "derivative of R Rᵀ in the proof", 363,
             equal(ddt(R * transpose(R)), rate(R) * transpose(R) + R * transpose(rate(R)),
                   skew(omega) * R * transpose(R) - R * transpose(R) * skew(omega), zero_tensor),
             extract="d d t R _ R _ T = R ˙ _ R _ T + R _ R ˙ _ T = ω ~ _ R _ R _ T R _ R _ T ω ~ _ = 0 _",
             where=MOTION, moving=True, condition=equal(R * transpose(R), identity),
             also={"R not orthogonal": not_orthogonal()},
             remark="The last step uses R Rᵀ = I, which it is to prove. A proof: Z = R Rᵀ and Z = I solve the same "
             "linear problem, with derivative ω̃Z − Zω̃ and Z(t₀) = I."),
    equation("72", "R Rᵀ is constant", 365, equal(R * transpose(R), at_start, identity),
             extract="R _ R _ T = R _ R _ T t 0 = I _",
             where=(let(at_start, plain(lambda R: R @ R.transpose), R_0), ZERO),
             because=equal(skew(omega) * identity - identity * skew(omega), zero_tensor),
             remark="By (71) Z = R Rᵀ solves Ż = ω̃Z − Zω̃ with Z(t₀) = I, and so does Z = I, the supporting identity; "
             "with a continuous ω a linear problem has one solution."),
    equation("determinant", "the determinant is 1 or −1", 366, equal(det(T * transpose(T)), det(T)**2)),
    equation("73", "R is orthogonal and proper", 367, both(equal(R * transpose(R), identity), equal(det(R), 1)),
             extract="R _ R _ T = I _ d e t R _ = 1", because=equal(det(T * transpose(T)), det(T)**2),
             remark="By (72) and the supporting identity the determinant is 1 or −1; it is continuous and "
             "begins with 1."),
    equation("body-twist", "dual angular velocity in the body frame", 371, equal(omega_B, transpose(R) * omega),
             extract="ω _ B = R _ T ω _", where=MOTION, moving=True),
    equation("74", "Poisson-Darboux problem, body twist", 372, equal(rate(R), R * skew_B),
             extract="R ˙ _ = R _ ω ~ _ B", where=MOTION, moving=True),
    equation("eighteen-equations", "the tensor problems are 18 real equations", 373, equal(equations_in(R), 18)),
    equation("75", "quaternion equation, spatial twist", 376, equal(rate(q_hat), half * omega * q_hat),
             extract="q ^ ˙ _ = 1 2 ω _ q ^ _", where=MOTION, moving=True),
    equation("76", "quaternion equation, body twist", 378, equal(rate(q_hat), half * q_hat * omega_B),
             extract="q ^ ˙ _ = 1 2 q ^ _ ω _ B", where=MOTION, moving=True),
    equation("eight-equations", "the quaternion problems are eight real equations", 380,
             equal(equations_in(q_hat), 8), where=MOTION),
    equation("77", "rate of the dual angle", 382, equal(rate(alpha), dot(omega, u), dot(omega_B, u)),
             extract="α _ ˙ = ω _ · u _ = ω _ B · u _", where=MOTION, moving=True),
    equation("78", "rate of the axis", 383, equal(rate(u), Theta * omega, transpose(Theta) * omega_B),
             extract="u _ ˙ = Θ _ ω _ = Θ _ T ω _ B", where=MOTION, moving=True, condition=nonzero(Re(half_sine)),
             because=equal(rate(u), Theta_read * omega),
             remark="The supporting identity has Θ as line 384 is read; at a full turn the twist does not determine "
             "the axis."),
    equation("theta", "the dual tensor Θ", 384,
             (Reading(equal(Theta, Theta_read), "with a minus in front"),
              Reading(equal(Theta, half * (skew(u) + cot(half * alpha) * skew(u)**2)), "without")),
             extract="Θ _ = 1 2 [ u ~ _ + c o t ( 1 2 α _ ) u ~ _ 2 ]", where=MOTION,
             fixed_by="(78), which is true of Θ with this sign", condition=nonzero(Re(sin(half * alpha)))),
    equation("79", "spatial twist by the natural invariants", 386,
             equal(omega, rate(alpha) * u + sin(alpha) * rate(u) + (1 - cos(alpha)) * cross(u, rate(u))),
             extract="ω _ = α _ ˙ u _ + s i n α _ u _ ˙ + 1 c o s α _ u _ × u _ ˙", where=MOTION, moving=True),
    equation("80", "body twist by the natural invariants", 387,
             equal(omega_B, rate(alpha) * u + sin(alpha) * rate(u) - (1 - cos(alpha)) * cross(u, rate(u))),
             extract="ω _ B = α _ ˙ u _ + s i n α _ u _ ˙ 1 c o s α _ u _ × u _ ˙", where=MOTION, moving=True),
)
