"""Kinematic equations against differentiated displacements, in nilpotent arithmetic."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.algebra import Dual, Quaternion, Tensor, Vector
from derive.maps import closed_forms, first_principles, kinematics
from derive.maps.exponential import tensor_exponential
from derive.maps.pose import Screw, tensor_from_screw

TINY = mpmath.mpf(10) ** -40
ANGLE = Dual(mpmath.mpf("1.1"), mpmath.mpf("0.4"))
AXIS = Vector.dual([mpmath.mpf(c) / 7 for c in (2, 3, 6)], [mpmath.mpf(c) / 4 for c in (3, -2, 0)])


def unit(a: Vector) -> Vector:
    return a / a.magnitude()


def moved(step: mpmath.mpf) -> tuple[Dual, Vector]:
    """A screw as a function of time."""
    angle = ANGLE + Dual(mpmath.mpf("0.7"), mpmath.mpf("-0.2")) * step
    return angle, unit(AXIS + Vector.dual((1, -1, mpmath.mpf("0.5")), (2, 0, 1)) * step)


def rate(f):
    """Central difference, error of the order 1e-24."""
    step = mpmath.mpf(10) ** -12
    return (f(step) - f(-step)) / (2 * step)


ROUGH = mpmath.mpf(10) ** -20


def twists() -> tuple[Tensor, Vector, Vector]:
    R = tensor_from_screw(Screw(*moved(mpmath.mpf(0))))
    R_dot = rate(lambda t: tensor_from_screw(Screw(*moved(t))))
    return R, first_principles.twist(R, R_dot), first_principles.body_twist(R, R_dot)


def test_tensor_and_quaternion_rates(gap) -> None:
    R, omega, omega_body = twists()
    R_dot = rate(lambda t: tensor_from_screw(Screw(*moved(t))))
    assert gap(kinematics.tensor_rate(R, omega), R_dot) < ROUGH
    assert gap(kinematics.tensor_rate_body(R, omega_body), R_dot) < ROUGH

    def quaternion(t: mpmath.mpf) -> Quaternion:
        angle, u = moved(t)
        half = angle / 2
        return Quaternion(half.apply(mpmath.cos, lambda a: -mpmath.sin(a)), u * half.apply(mpmath.sin, mpmath.cos))

    q = quaternion(mpmath.mpf(0))
    assert gap(kinematics.quaternion_rate(q, omega), rate(quaternion)) < ROUGH
    assert gap(kinematics.quaternion_rate_body(q, omega_body), rate(quaternion)) < ROUGH


def test_rates_of_the_natural_invariants(gap) -> None:
    _, omega, omega_body = twists()
    angle, u = moved(mpmath.mpf(0))
    angle_dot, u_dot = rate(lambda t: moved(t)[0]), rate(lambda t: moved(t)[1])
    got_angle, got_axis = kinematics.screw_rates(angle, u, omega)
    assert gap(got_angle, angle_dot) < ROUGH
    assert gap(got_axis, u_dot) < ROUGH
    assert gap(kinematics.axis_operator(angle, u).transpose @ omega_body, u_dot) < ROUGH
    assert gap(kinematics.twist_from_screw(angle, u, angle_dot, u_dot), omega) < ROUGH


def test_rates_of_the_euler_vector(gap) -> None:
    _, omega, omega_body = twists()

    def euler(t: mpmath.mpf) -> Vector:
        angle, u = moved(t)
        return u * angle

    a = euler(mpmath.mpf(0))
    assert gap(kinematics.euler_rate(a, omega), rate(euler)) < ROUGH
    assert gap(kinematics.euler_rate_body(a, omega_body), rate(euler)) < ROUGH


@pytest.mark.parametrize("real", [(1, -2, 3), (0, 0, 0)])
def test_dexp_is_the_differential(real: tuple[int, ...], gap) -> None:
    a = Vector.dual([mpmath.mpf(c) / 3 for c in real], [mpmath.mpf(c) for c in (2, 1, -1)])
    assert gap(kinematics.dexp(a) @ kinematics.dexp_inv(a), Tensor.identity()) < TINY
    step = mpmath.mpf(10) ** -12
    for axis in Tensor.identity().rows:
        along = Vector(*axis) * step
        after, before = (tensor_exponential(a + b) for b in (along, -along))
        column = first_principles.twist(tensor_exponential(a), (after - before) / (2 * step))
        assert gap(kinematics.dexp(a) @ Vector(*axis), column) < ROUGH


@pytest.mark.parametrize("n", [1, 2, 3, 6])
def test_rates_of_the_rodrigues_vector(n: int, draw, gap) -> None:
    v, v_dot = draw(), draw()
    omega = closed_forms.tangent(n, v.dot(v)).tensor(v) @ v_dot
    R = closed_forms.tensor(n, v.dot(v)).tensor(v)
    assert gap(kinematics.rodrigues_rate(n, v, omega), v_dot) < TINY
    assert gap(kinematics.rodrigues_rate_body(n, v, R.transpose @ omega), v_dot) < TINY


def test_full_turn_raises() -> None:
    u = Vector.dual((sympy.Integer(1), sympy.Integer(0), sympy.Integer(0)), [sympy.Integer(0)] * 3)
    with pytest.raises(ZeroDivisionError):
        kinematics.axis_operator(Dual(2 * sympy.pi, sympy.Integer(1)), u)
    with pytest.raises(ZeroDivisionError):
        kinematics.dexp_inv(u * (2 * sympy.pi))
