r"""Theorems on every parameterization v = φ(α) u, in φ, its derivatives, and sine and cosine of α/2.

.. math::
    \hat q = \cos\tfrac\alpha2 + \frac{\sin\frac\alpha2}{\varphi}\,v \qquad
    T = \frac{\sin\alpha}{\varphi} I + \frac{1 - \cos\alpha}{\varphi^2} \tilde v
        + \frac{1/\varphi' - \sin\alpha/\varphi}{\varphi^2}\,v \otimes v

Their premises stand in :mod:`~derive.proof.phi_premises`.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

import sympy

from .calculus_theorems import rate_jacobian_of, transition
from .identity import Equation, Proof, definition
from .methods import Theorem, decided, identity
from .notation import *
from .phi_premises import *
from .setting import Symbols


def _of_maps() -> tuple[Theorem, ...]:
    return (
        identity(
            "any phi: orthogonality", Symbols(SYMBOLS, (v,), (phi,)),
            (Equation(R * transpose(R), I), Equation(det(R), 1)),
            TENSOR, *SCALARS[3:5], *SQUARES, scope=SCOPE,
        ),
        identity(
            "any phi: quaternion", Symbols(SYMBOLS, (v, point), (phi,)),
            (Equation(q_hat * conjugate(q_hat), 1), Equation(q_hat * point * conjugate(q_hat), R * point)),
            QUATERNION, TENSOR, *SCALARS[:2], *SCALARS[3:5], *SQUARES, scope=SCOPE,
        ),
        identity(
            "any phi: axis", Symbols(SYMBOLS, (v,), (phi, phi_1)),
            (Equation(T * v, v / phi_1), Equation(det(T), 2 * (1 - COS) / (phi_1 * phi**2))),
            TANGENT, *SCALARS[3:6], *SQUARES, scope=SCOPE,
        ),
        identity(
            "any phi: inverse", IN_V,
            (Equation(T * T_inv, I), Equation(T_inv * T, I)),
            TANGENT, INVERSE, *SCALARS[3:], *SQUARES, scope=SCOPE,
        ),
        _of_volume(),
    )  # fmt: skip


def _of_volume() -> Theorem:
    """Return the theorem on the homochoric vector: φ³ is a multiple of ``α − sin α``, given by its derivative."""
    at = {phi_1: share * (1 - COS) / phi**2}
    rates = Equation(prime(alpha), 1 / TURN), *(premise.equation for premise in OF_ANGLE)
    slopes = definition(prime(share), 0), *(definition(e.left, e.right.xreplace(at)) for e in rates)
    return identity(
        "any phi: constant volume element", Symbols((alpha, share, cosine, sine, x, phi), (v,), (sine, phi, share)),
        (Equation(prime(phi**3), prime(3 * share * (alpha - SIN))), Equation(det(T), 2 / share)),
        TANGENT, *SCALARS[3:5], definition(h, SCALARS[5].equation.right.xreplace(at)), *slopes, *SQUARES, scope=SCOPE,
    )  # fmt: skip


def _of_motion() -> tuple[Theorem, ...]:
    given = *MOTION, *OF_ANGLE, *SQUARES
    twist = identity(
        "any phi: twist", Symbols(SYMBOLS, (v, v_dot), (phi, phi_1)),
        (Equation(omega, T * rate(v)), Equation(rate(R), skew(omega) * R)),
        TENSOR, TANGENT, *SCALARS[3:6], definition(omega, vect(rate(R) * transpose(R))), *given, scope=SCOPE,
    )  # fmt: skip
    body = identity(
        "any phi: body twist", MOVING,
        (
            Equation(transpose(T), transpose(R) * T),
            Equation(omega_body, transpose(T) * rate(v)),
            Equation(rate(v), transpose(T_inv) * omega_body),
        ),
        TENSOR, TANGENT, INVERSE, *SCALARS[3:], twist.premise(0), definition(omega_body, transpose(R) * omega), *given,
        scope=SCOPE,
    )  # fmt: skip
    return twist, body


def _of_transition() -> Iterator[Theorem]:
    """Yield the theorems on the derivatives of the rate by v, and of v(t) by v(0) for a twist given in either frame.

    The derivative of the rate has one form for any functions f_i and h_i of x.
    """
    along = tuple(definition(rate(c), slope * dot(v, v_dot)) for c, slope in ((f_i, f_iy), (h_i, h_iy)))
    jacobians = definition(rate_jacobian, rate_jacobian_of(a)), definition(body_rate_jacobian, rate_jacobian_of(a, -1))
    yield identity(
        "any phi: Jacobian of the rate", Symbols((f_i, h_i, f_iy, h_iy), (v, v_dot, a)),
        (
            Equation(rate(T_inv) * a, rate_jacobian * v_dot),
            Equation(transpose(rate(T_inv)) * a, body_rate_jacobian * v_dot),
        ),
        definition(T_inv, (f_i * I - skew(v) + h_i * dyad(v, v)) / 2), *jacobians, MOTION[0], *along, scope=SCOPE,
    )  # fmt: skip
    slopes = definition(h_i, hi), definition(f_iy, 2 * prime(fi)), definition(h_iy, 2 * prime(hi))
    given = TENSOR, TANGENT, INVERSE, *SCALARS[3:], *slopes, *OF_ANGLE, OF_PHI[0], *SQUARES
    slope = Equation(h_iy, (2 * phi_2 / (phi * phi_1) - f_iy - 2 * h_i) / phi**2)
    for frame in ("space", "body"):
        claim, motion = transition(frame, T, T_inv)
        yield identity(
            f"any phi: transition, {frame} twist given", Symbols(SYMBOLS, (v, a, b), (sine, phi, phi_1)),
            (*claim, slope), *given, *motion, MOTION[1], scope=SCOPE,
        )  # fmt: skip


def _of_change() -> Theorem:
    """Return the theorem on another vector ``w = ψ/φ v`` of a pose, in another chart or with ``ψ = φ(α + 2kπ)``."""
    symbols = Symbols((*SYMBOLS, psi, psi_1), (v, v_dot), (phi, phi_1, psi, psi_1))
    stretch = (1 / psi_1 - SIN / psi) / psi**2
    there = (
        definition(other_v, psi / phi * v),
        definition(change, psi / phi * I + (psi_1 / phi_1 - psi / phi) / x * dyad(v, v)),
        definition(other_T, SIN / psi * I + (1 - COS) / psi**2 * skew(other_v) + stretch * dyad(other_v, other_v)),
        definition(prime(psi), psi_1 / TURN),
    )
    return identity(
        "any phi: change of chart or branch", symbols,
        (
            Equation(rate(other_v), change * v_dot),
            Equation(other_T * change, T),
            Equation(transpose(other_T) * change, transpose(T)),
        ),
        TANGENT, *SCALARS[3:6], *there, *MOTION, *OF_ANGLE, *SQUARES, scope=SCOPE,
    )  # fmt: skip


def y(value: sympy.Expr) -> sympy.Expr:
    """Return a slope, twice the derivative by x."""
    return 2 * prime(value)


def _of_slopes() -> tuple[Theorem, ...]:
    gy, fiy = f * h - g**2, -h / g
    first = (
        Equation(rho, f + x * h),
        Equation(fi, s / w),
        Equation(hi, (g - fi * h) / rho),
        Equation(y(s), -rho * w / 2),
        Equation(y(w), s * h / 2 - w**3),
        Equation(y(f), h - rho * g),
        Equation(y(g), gy),
        Equation(y(h), (y(rho) - 3 * h + rho * g) / x),
        Equation(y(fi), fiy),
        Equation(y(hi), (gy - fiy * h - fi * y(h) - hi * y(rho)) / rho),
        Equation(y(rho), RATE_SLOPE),
        Equation(y(rho), y(f) + 2 * h + x * y(h)),
    )
    second = (
        Equation(y(y(f)), y(h) - y(rho) * g - rho * gy),
        Equation(y(y(g)), y(f) * h + f * y(h) - 2 * g * gy),
        Equation(y(y(h)), (y(y(rho)) - 5 * y(h) + y(rho) * g + rho * gy) / x),
        Equation(y(y(s)), -(y(rho) * w + rho * y(w)) / 2),
        Equation(y(y(w)), (y(s) * h + s * y(h)) / 2 - 3 * w**2 * y(w)),
        Equation(y(y(fi)), (y(y(f)) - 2 * y(fi) * y(g) - fi * y(y(g))) / g),
        Equation(
            y(y(hi)),
            (
                y(y(g)) - y(y(fi)) * h - 2 * y(fi) * y(h) - fi * y(y(h)) - 2 * y(hi) * y(rho) - hi * y(y(rho))
            ) / rho,
        ),
        Equation(y(y(rho)), (3 * phi_2**2 / phi_1 - phi_3 + phi_2 * phi_1 / phi) / (phi**2 * phi_1**4)),
        Equation(y(y(rho)), y(y(f)) + 4 * y(h) + x * y(y(h))),
    )
    third = (
        *(equation for equation in (*first, *second) if equation.right.has(phi_2)),
        Equation(y(y(y(f))), y(y(h)) - y(y(g)) * rho - 2 * y(g) * y(rho) - g * y(y(rho))),
        Equation(y(y(y(g))), y(y(f)) * h + 2 * y(f) * y(h) + f * y(y(h)) - 2 * (y(g) ** 2 + g * y(y(g)))),
    )
    at_constant_rate = Equation(y(y(y(h))), -(y(y(y(f))) + 6 * y(y(h))) / x)
    symbols, given, squares = Symbols(SYMBOLS, (), (sine, phi, phi_1)), (*SCALARS, *OF_ANGLE), SQUARES[::2]
    return (
        identity("any phi: slopes", symbols, first, *given, OF_PHI[0], *squares, scope=SCOPE),
        identity("any phi: second slopes", symbols, second, *given, *OF_PHI, *squares, scope=SCOPE),
        identity(
            "any phi: third slopes", Symbols(SYMBOLS, (), (phi, phi_1)), third, *SCALARS[2:6], *OF_ANGLE,
            *OF_PHI, *squares, scope=SCOPE,
        ),
        identity(
            "any phi: third slope at a constant rate", Symbols(SYMBOLS[:-2], (), (phi, phi_1)), (at_constant_rate,),
            SCALARS[3], SCALARS[5], *OF_ANGLE, definition(prime(phi_1), 0), *squares, scope=SCOPE,
        ),
    )  # fmt: skip


def _of_shares() -> Iterator[Theorem]:
    """Yield the theorems on the slopes of ``α/φ`` by ``x`` and of ``φ/α`` by ``α²``."""
    of_exp = (
        definition(prime(alpha), 1 / TURN),
        definition(g_exp, (1 - COS) / alpha**2),
        definition(h_exp, (1 - SIN / alpha) / alpha**2),
        definition(hy_exp, (g_exp - 3 * h_exp) / alpha**2),
    )
    symbols = Symbols((alpha, *SYMBOLS), (), (phi, phi_1, alpha))
    given = SCALARS[5], *OF_ANGLE, OF_PHI[0], *SQUARES[::2]
    rate_slope = Equation(y(rho), RATE_SLOPE)
    bend = y(h) - 3 * share**2 * y(share) * h_exp - share**4 * rho * hy_exp
    yield identity(
        "any phi: share of the angle", symbols,
        (rate_slope, Equation(y(share), h - share**3 * h_exp), Equation(y(y(share)), bend)),
        definition(share, alpha / phi), SCALARS[2], *given, *of_exp, scope=SCOPE,
    )  # fmt: skip

    def by_square(value: sympy.Expr) -> sympy.Expr:
        return y(value) * share * phi_1

    rest, bend = h_exp - share**3 * h, by_square(phi_1)
    change = hy_exp - 3 * share**2 * by_square(share) * h - share**4 * phi_1 * y(h)
    yield identity(
        "any phi: share of the vector", symbols,
        (
            rate_slope,
            Equation(by_square(share), phi_1 * rest),
            Equation(by_square(share), (phi_1 - share) / alpha**2),
            Equation(bend, -(phi_1**3) * share * y(rho)),
            Equation(by_square(by_square(share)), bend * rest + phi_1 * change),
            Equation(by_square(by_square(share)), (bend - 3 * by_square(share)) / alpha**2),
        ),
        definition(share, phi / alpha), SCALARS[2], *given, *of_exp, scope=SCOPE,
    )  # fmt: skip


def _of_gain() -> Theorem:
    """Return the theorem on the rate of the gain in ``v = gain vec(e)``, for a multiple e of a unit quaternion."""
    motion = (
        definition(rate(cosine), -sine * turning / 2),
        definition(rate(sine), cosine * turning / 2),
        definition(rate(phi), phi_1 * turning),
        definition(rate(size), growing),
    )
    given = (
        definition(gain, phi / (size * sine)),
        definition(scalar_part, size * cosine),
        definition(vector_part, size**2 * sine**2),
    )
    rate_of_scalar = growing * cosine - size * sine * turning / 2
    half_rate = size * sine * (growing * sine + size * cosine * turning / 2)
    along = gain * scalar_part * hi - 1
    change = along * rate(vector_part) / 2 - (scalar_part + gain * vector_part * hi) * rate(scalar_part)
    return identity(
        "any phi: rate of the gain", Symbols((cosine, sine, phi, phi_1, size, turning, growing), (), (sine, phi, size)),
        (
            Equation(rate(scalar_part), rate_of_scalar),
            Equation(rate(vector_part) / 2, half_rate),
            Equation(rate(gain), gain * change / (scalar_part**2 + vector_part)),
        ),
        SCALARS[-1], *given, *motion, SQUARES[0], scope=SCOPE,
    )  # fmt: skip


ANY_PHI = (
    *_of_maps(), *_of_motion(), *_of_slopes(), *_of_shares(), _of_gain(), *_of_transition(), _of_change(),
)  # fmt: skip


@cache
def any_phi() -> tuple[Proof, ...]:
    """Return the proofs of the theorems on every φ, decided once per process."""
    return decided(ANY_PHI)
