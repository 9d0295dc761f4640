r"""The kinematic equations of rigid motion, each as a function: rates from the twist, and the operators in them.

``ω = vect(Ṙ Rᵀ)`` is the space twist, ``ω_B = Rᵀ ω`` the body twist (dual vectors: angular velocity + ε velocity of the
body point at the origin). With ``q̂ = cos α/2 + u sin α/2``, ``a = α u`` and ``v = tan(α/2n) u``:

.. math::
    \dot R = \tilde\omega R = R\,\tilde\omega_B, \qquad
    \dot{\hat q} = \tfrac12 \omega \hat q = \tfrac12 \hat q\,\omega_B, \qquad
    \dot a = \mathrm{dexp}_a^{-1} \omega, \qquad \dot v = \mathrm{dcay}_n^{-1} \omega

CP23 (70), (74), (75), (76), (83), (90). All functions take any number type; `library` has its ``sin``, ``cos``,
``sqrt``.
"""

from __future__ import annotations

from typing import Any

from ..algebra import Coefficient, Isotropic, Quaternion, Tensor, Vector, functions, real_part
from . import closed_forms
from .sign_tests import is_zero


def tensor_rate(R: Tensor, omega: Vector) -> Tensor:
    """Return ``Ṙ = skew(ω) R`` from the space twist, CP23 (70): 18 real equations."""
    return Tensor.skew(omega) @ R


def tensor_rate_body(R: Tensor, omega_body: Vector) -> Tensor:
    """Return ``Ṙ = R skew(ω_B)`` from the body twist, CP23 (74)."""
    return R @ Tensor.skew(omega_body)


def quaternion_rate(q: Quaternion, omega: Vector) -> Quaternion:
    """Return ``½ ω q̂`` from the space twist, CP23 (75): eight real equations."""
    return Quaternion(0, omega) * q / 2


def quaternion_rate_body(q: Quaternion, omega_body: Vector) -> Quaternion:
    """Return ``½ q̂ ω_B`` from the body twist, CP23 (76)."""
    return q * Quaternion(0, omega_body) / 2


def axis_operator(alpha: Coefficient, u: Vector, library: Any = functions) -> Tensor:
    r"""Return Θ with ``u̇ = Θ ω = Θᵀ ω_B``, CP23 (78).

    .. math:: \Theta = -\tfrac12 \left[\tilde u + \cot\frac{\alpha}{2}\,\tilde u^2\right]

    Raises
    ------
    ZeroDivisionError
        At Re α = 2πk, where the axis can turn at any rate.
    """
    skew, half = Tensor.skew(u), alpha / 2
    sine = library.sin(half)
    if is_zero(real_part(sine)):
        raise ZeroDivisionError(f"no rate of the axis at the angle {alpha!r}")
    operator: Tensor = (skew + skew @ skew * (library.cos(half) / sine)) / -2
    return operator


def screw_rates(
    alpha: Coefficient, u: Vector, omega: Vector, library: Any = functions
) -> tuple[Coefficient, Vector]:
    """Return ``(α̇, u̇) = (ω·u, Θ ω)`` of the natural invariants from the space twist, CP23 (77), (78)."""
    return omega.dot(u), axis_operator(alpha, u, library) @ omega


def twist_from_screw(
    alpha: Coefficient, u: Vector, alpha_dot: Coefficient, u_dot: Vector, library: Any = functions
) -> Vector:
    """Return the space twist ``α̇ u + sin α u̇ + (1 − cos α) u × u̇``, CP23 (79); the body's has the minus, (80)."""
    omega: Vector = u * alpha_dot + u_dot * library.sin(alpha) + u.cross(u_dot) * (1 - library.cos(alpha))
    return omega


def dexp(a: Vector, library: Any = functions) -> Tensor:
    r"""Return dexp_a with ``ω = dexp_a ȧ`` for ``R = exp(skew(a))``, CP23 (81), (82).

    .. math::
        \mathrm{dexp}_a = I + \frac{1 - \cos|a|}{|a|^2}\,\tilde a + \frac{|a| - \sin|a|}{|a|^3}\,\tilde a^2

    Defined everywhere, ``I + skew(a)/2 + skew(a)²/6`` where Re a = 0; loses rank at Re|a| = 2πk, k ≥ 1.
    """
    skew, square = Tensor.skew(a), a.dot(a)
    if is_zero(real_part(square)):
        series: Tensor = Tensor.identity() + skew / 2 + skew @ skew / 6
        return series
    angle = library.sqrt(square)
    operator: Tensor = Tensor.identity() + skew * ((1 - library.cos(angle)) / square)
    operator += skew @ skew * ((1 - library.sin(angle) / angle) / square)
    return operator


def dexp_inv(a: Vector, library: Any = functions) -> Tensor:
    r"""Return the inverse operator, ``ȧ = dexp_a⁻¹ ω``, CP23 (83), (84).

    .. math::
        \mathrm{dexp}_a^{-1} = I - \tfrac12\,\tilde a
            + \left(1 - \frac{|a|}{2} \cot\frac{|a|}{2}\right) \frac{\tilde a^2}{|a|^2}

    ``I − skew(a)/2 + skew(a)²/12`` where Re a = 0.

    Raises
    ------
    ZeroDivisionError
        At Re|a| = 2πk, k ≥ 1.
    """
    skew, square = Tensor.skew(a), a.dot(a)
    if is_zero(real_part(square)):
        series: Tensor = Tensor.identity() - skew / 2 + skew @ skew / 12
        return series
    half = library.sqrt(square) / 2
    sine = library.sin(half)
    if is_zero(real_part(sine)):
        raise ZeroDivisionError(f"dexp is singular at the angle {2 * half!r}")
    operator: Tensor = Tensor.identity() - skew / 2
    operator += skew @ skew * ((1 - half * library.cos(half) / sine) / square)
    return operator


def euler_rate(a: Vector, omega: Vector, library: Any = functions) -> Vector:
    """Return ``ȧ = dexp_a⁻¹ ω`` from the space twist, CP23 (83); six real equations, as the next."""
    return dexp_inv(a, library) @ omega


def euler_rate_body(a: Vector, omega_body: Vector, library: Any = functions) -> Vector:
    """Return ``ȧ = dexp_a⁻ᵀ ω_B`` from the body twist, CP23 (85)."""
    return dexp_inv(a, library).transpose @ omega_body


def rodrigues_rate(n: int, v: Vector, omega: Vector) -> Vector:
    """Return ``v̇ = dcay_n⁻¹ ω`` from the space twist, CP23 (87), (90).

    Raises
    ------
    ZeroDivisionError
        Where Re q_n = 0, ``Re|v| = tan(kπ/n)``.
    """
    return _inverse(n, v).tensor(v) @ omega


def rodrigues_rate_body(n: int, v: Vector, omega_body: Vector) -> Vector:
    """Return ``v̇ = dcay_n⁻ᵀ ω_B`` from the body twist, CP23 (87), (91)."""
    return _inverse(n, v).tensor(v).transpose @ omega_body


def _inverse(n: int, v: Vector) -> Isotropic:
    return closed_forms.tangent_inv(n, v.dot(v))
