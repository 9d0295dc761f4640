"""Table of the theorems that Coq proves too, by name, for docs/theorems.md; and why others are not covered.

Statements in Coq are about an arbitrary commutative ring, for every n. Inverses are premises there, nothing is divided.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from derive.proof.identity import ALL_ORDERS, Proof


class InCoq(NamedTuple):
    """Coq theorems that state a theorem of the toolkit, and the part that they leave out."""

    theorems: tuple[str, ...] = ()
    left_out: str = ""


def _whole(names: str, left_out: str = "") -> InCoq:
    return InCoq(tuple(names.split()), left_out)


_SECOND = "second and third derivatives of the scalars are not stated in Coq"
_SHARES = "ratios of a vector to its angle or quaternion are not stated in Coq"
_VARIATION = "the variational equation; Coq takes the pose multiplied by a constant"
_INVERSE = "closed forms of the inverse map are not stated in Coq"
_SPLINES = "splines are not stated in Coq"
_SHADOW = _whole("shadow change_of_chart", "the matrix S_k itself; that v_k moves so that the pose is kept")

BY_COQ: Mapping[str, InCoq] = {
    "powers of 1 + iX": _whole("powers"),
    "powers of 1 + v": _whole("quaternion_powers"),
    "norm": _whole("norm"),
    "addition": _whole("addition"),
    "doubling": _whole("doubling"),
    "slopes": _whole("p_slope_equation q_slope_equation slopes_are_dual_parts dual_part_is_derivative"),
    "values at x = 0": _whole("values_at_zero"),
    "brackets at x = 0": _whole("brackets_at_zero"),
    "brackets": _whole("bracket_c bracket_d brackets_related"),
    "binomial sums": _whole("binomial_sums"),
    "binomial theorem": _whole("binomial_theorem"),
    "binomial sums of the brackets": _whole("binomial_sum_of_c binomial_sum_of_d"),
    "multiples of an angle": _whole("multiples_of_an_angle"),
    "tensor": _whole("cayley_tensor_isotropic"),
    "orthogonality": _whole("cayley_orthogonal"),
    "quaternion": _whole("cayley_quaternion_power cayley_quaternion_unit cayley_sandwich"),
    "tangent": _whole("dcay_brackets"),
    "tangent_inv": _whole("dcay_inv_brackets"),
    "inverse": _whole("cayley_inverse"),
    "axis": _whole("cayley_axis"),
    "determinant": _whole("cayley_determinant"),
    "twist": _whole("cayley_twist cayley_twist_is_vect"),
    "body twist": _whole("cayley_body_tangent cayley_body_twist"),
    "quaternion rate": _whole("cayley_quaternion_rate cayley_body_quaternion_rate"),
    "rates of v": _whole("rates"),
    "double angle": _whole("double_angle", "angles that are no multiples n θ"),
    "exponential": _whole("exponential_of_skew", "convergence: the power series agree term by term"),
    "exponential of a quaternion": _whole("exponential_of_vector", "convergence: the power series agree term by term"),
    "screw": _whole("screw_quaternion screw_tensor"),
    "pose": _whole("pose cayley_twist"),
    "line": _whole("line"),
    "Moebius step": _whole("moebius_step"),
    "shadow, even branch": _whole("shadow"),
    "shadow, odd branch": _whole("shadow"),
    "composition": _whole("composition_of_tensors"),
    "slopes of the tangent operators": _whole("tangent_slopes inverse_slopes"),
    "second slopes of the tangent operators": InCoq(left_out=_SECOND),
    "rate of the tangent operator": _whole("rate_of_operator tangent_slopes"),
    "rate of the inverse operator": _whole("rate_of_operator rate_of_inverse inverse_slopes"),
    "Jacobian of the twist": _whole("jacobian_of_operator jacobian_of_transpose"),
    "transition, space twist given": _whole("transition", _VARIATION),
    "transition, body twist given": _whole("body_transition cayley_transition", _VARIATION),
    "Jacobian of the rate": _whole("jacobian_of_operator jacobian_of_transpose"),
    "structure equation": _whole("structure_equation cayley_slopes"),
    "structure equation in the body": _whole("body_structure_equation cayley_slopes", "J_B(b) a = R^T J(a) b"),
    "slope of a Moebius step": _whole("moebius_slope"),
    "transport, step by step": _whole("change_of_chart", "the closed form of the matrix"),
    "transport, even branch": _SHADOW,
    "transport, odd branch": _SHADOW,
    "twist of a product": _whole("twist_of_a_product", "the statement is about tensors, not quaternions"),
    "inverse map at n = 1": InCoq(left_out=_INVERSE),
    "inverse map at n = 2": InCoq(left_out=_INVERSE),
    "composition at n = 1": _whole("composition_first_order"),
    "composition at n = 2": _whole("composition_second_order"),
    "any phi: orthogonality": _whole("phi_orthogonal"),
    "any phi: quaternion": _whole("phi_quaternion"),
    "any phi: axis": _whole("phi_axis phi_determinant"),
    "any phi: constant volume element": _whole("phi_determinant", "the derivative of the cube of φ"),
    "any phi: inverse": _whole("phi_inverse_tangent"),
    "any phi: twist": _whole("phi_twist"),
    "any phi: body twist": _whole("phi_body_tangent body_twist phi_inverse_tangent"),
    "any phi: slopes": _whole("twist phi_twist", "slopes of the inverse operator and of 1/φ'"),
    "any phi: Jacobian of the rate": InCoq(left_out="the slopes of f_i and h_i for any φ"),
    "any phi: transition, space twist given": _whole("transition", _VARIATION),
    "any phi: transition, body twist given": _whole("body_transition", _VARIATION),
    "any phi: change of chart or branch": _whole("change_of_chart"),
    "any phi: second slopes": InCoq(left_out=_SECOND),
    "any phi: third slopes": InCoq(left_out=_SECOND),
    "any phi: third slope at a constant rate": InCoq(left_out=_SECOND),
    "any phi: share of the angle": InCoq(left_out=_SHARES),
    "any phi: share of the vector": InCoq(left_out=_SHARES),
    "any phi: rate of the gain": InCoq(left_out=_SHARES),
    "growing order: angle": InCoq(left_out="a limit, to first order in 1/(2n)²"),
    "growing order: maps": InCoq(left_out="a limit, to first order in 1/(2n)²"),
    "spline: parts are C2": InCoq(left_out=_SPLINES),
    "spline: twist of a factor": InCoq(left_out=_SPLINES),
    "quaternion at n": _whole("cayley_sandwich"),
    "tensor at n": _whole("cayley_sandwich"),
    "orthogonality at n": _whole("cayley_orthogonal"),
    "twist at n": _whole("cayley_twist_is_vect"),
    "inverse at n": _whole("cayley_inverse"),
}
"""Coq theorems by name of the toolkit's theorem."""

AT_ORDER = InCoq(left_out="it compares objects of the toolkit, which Coq does not know")
"""Entry of the other statements at one order."""


def in_coq(proof: Proof) -> InCoq:
    """Return the entry of a proof."""
    return BY_COQ[proof.name] if proof.scope == ALL_ORDERS else BY_COQ.get(proof.name, AT_ORDER)
