"""Branches, shadows, principal v: every one gives the same pose, and shadows add up."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.algebra import Dual, Quaternion, Tensor, Vector, ZeroDivisorError
from derive.maps import closed_forms
from derive.maps.inverse import (
    axis,
    principal,
    shadow,
    vector_from_quaternion,
    vector_from_screw,
    vector_from_tensor,
)
from derive.maps.pose import Pose, natural_invariants, tensor_from_pose, tensor_from_screw

pytestmark = pytest.mark.smoke

ORDERS = [1, 2, 3, 4, 5, 8]
S = sympy.Rational


def tensor(n: int, v: Vector) -> Tensor:
    return closed_forms.tensor(n, v.dot(v)).tensor(v)


@pytest.mark.parametrize("n", ORDERS)
def test_every_branch_gives_the_same_pose(n: int, draw, gap) -> None:
    v = draw()
    R, q = tensor(n, v), closed_forms.quaternion_from_vector(n, v)
    branches = [vector_from_quaternion(n, q, k) for k in range(n)]
    for k, v_k in enumerate(branches):
        assert gap(tensor(n, v_k), R) < 1e-40
        assert gap(vector_from_tensor(n, R, k), v_k) < 1e-40
        assert gap(vector_from_screw(n, natural_invariants(R), k), v_k) < 1e-40
        assert gap(shadow(n, branches[0], k), v_k) < 1e-40
        assert gap(vector_from_quaternion(n, -q, k - n), v_k) < 1e-40
        assert gap(principal(n, v_k), branches[0]) < 1e-40
    sizes = [v_k.magnitude().re for v_k in branches]
    assert sizes[0] == min(sizes)
    assert mpmath.atan(sizes[0]) * 2 * n < mpmath.pi
    assert min(gap(v, v_k) for v_k in branches) < 1e-40


@pytest.mark.parametrize("n", ORDERS)
def test_shadows_add_up(n: int, draw, gap) -> None:
    v = draw()
    for j in range(n):
        for k in range(-1, n):
            assert gap(shadow(n, shadow(n, v, j), k), shadow(n, v, j + k)) < 1e-38


def test_shadow_of_even_order_changes_the_sign_of_the_quaternion_by_branch(draw, gap) -> None:
    v = principal(4, draw())
    q = closed_forms.quaternion_from_vector(4, v)
    for k in range(4):
        assert gap(closed_forms.quaternion_from_vector(4, shadow(4, v, k)), q * (-1) ** k) < 1e-40


@pytest.mark.parametrize("n", ORDERS)
def test_pure_translation_is_no_special_case_on_the_principal_branch(n: int) -> None:
    v = Vector.dual((S(0),) * 3, (S(1), S(-2), S(2)))
    R = tensor(n, v)
    assert tensor_from_pose(Pose(Tensor.identity(), v.du * (2 * n))) == R
    assert vector_from_tensor(n, R) == vector_from_quaternion(n, closed_forms.quaternion_from_vector(n, v)) == v


def test_translation_on_other_branches_takes_its_direction_as_axis() -> None:
    v = Vector.dual((S(0),) * 3, (S(1, 3), S(-2, 3), S(2, 3)))
    u = Vector(S(1, 3), S(-2, 3), S(2, 3))
    q = closed_forms.quaternion_from_vector(4, v)
    # tan(π/4 + ε) = 1 + 2ε, tan(3π/4 + ε) = −1 + 2ε
    assert shadow(4, v, 1) == vector_from_quaternion(4, q, 1) == Vector.dual(u, u * 2)
    assert shadow(4, v, 3) == vector_from_quaternion(4, q, 3) == Vector.dual(-u, u * 2)
    # from a shadow, where Re q_n = 0, the sign of the dual part of q_n still knows the direction
    for k in (1, 3):
        assert axis(4, shadow(4, v, k))[0] == Vector.dual(u, u * 0)
        assert shadow(4, shadow(4, v, k), 4 - k) == v
    assert principal(4, shadow(4, v, 1)) == v


def test_half_turn_keeps_the_given_side() -> None:
    for sign in (S(1), S(-1)):
        v = Vector.dual((sign, S(0), S(0)), (S(1), S(2), S(3)))
        q = closed_forms.quaternion_from_vector(2, v)
        assert q.re == Quaternion(0, Vector(sign, 0, 0))
        assert vector_from_quaternion(2, q) == principal(2, v) == v
        assert vector_from_tensor(2, tensor(2, v)) == (v if sign == 1 else shadow(2, v))


def test_what_has_no_axis_or_no_finite_v_is_an_error() -> None:
    zero = Vector.dual((S(0),) * 3, (S(0),) * 3)
    one = Quaternion.dual((S(1), S(0), S(0), S(0)), (S(0),) * 4)
    assert shadow(3, zero, 3) == zero == vector_from_quaternion(3, one) == vector_from_tensor(3, tensor(3, zero))
    for call in (lambda: shadow(3, zero), lambda: vector_from_quaternion(3, one, 1)):
        with pytest.raises(ValueError, match="the identity has no axis"):
            call()
    half_turn = Quaternion.dual((S(0), S(0), S(1), S(0)), (S(0),) * 4)
    with pytest.raises(ZeroDivisorError, match="pole"):
        vector_from_quaternion(1, half_turn)
    with pytest.raises(ZeroDivisorError):
        shadow(2, Vector.dual((S(0),) * 3, (S(1), S(0), S(0))), 1)


@pytest.mark.parametrize("n", ORDERS)
def test_tangent_inverse_of_the_displacement_is_the_dual_part(n: int, draw, gap) -> None:
    """The dual part is the directional derivative of the real one: ``v° = dcay⁻¹ ρ``."""
    v = principal(n, draw())
    q = closed_forms.quaternion_from_vector(n, v)
    rho = (q.du * q.re.conjugate()).vector * 2
    re = v.re
    assert gap(closed_forms.tangent_inv(n, re.dot(re)).apply(re, rho), v.du) < 1e-42


def test_screw_of_a_vector(draw, gap) -> None:
    v = principal(5, draw())
    u, r = axis(5, v)
    found = natural_invariants(tensor(5, v))
    assert gap(found.axis, u) < 1e-42
    assert gap(u * r, v) < 1e-45
    assert gap(tensor_from_screw(found), tensor(5, v)) < 1e-42
    assert isinstance(r, Dual)
    assert r.re > 0
