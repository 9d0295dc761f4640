r"""Theorems for every n on derivatives of the tangent operator, absent from the papers.

Notation: ``T = f I + g skew(v) + h v⊗v``, ``T⁻¹ = (f_i I − skew(v) + h_i v⊗v)/2``, and slopes ``f_y = 2 df/dx``.
Then ``df/dt = f_y (v · v')``. The theorems concern:

* slopes and second slopes in closed form, without division by x;
* the derivatives by v in both frames: J(a) of the twist ``T a``, and K(a) of the rate ``T⁻¹ a``;
* the structure equation ``(∂_a T) b − (∂_b T) a = T a × T b`` in space, with a minus sign in the body frame.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy

from .formulas import Formulas
from .map_theorems import MOTION, MOVING, ORIGIN_P, ORIGIN_Q, SQUARE
from .methods import Identity
from .notation import *
from .polynomial_theorems import SLOPES
from .setting import Symbols
from .statement import Equation, Premise, definition
from .theorem import Theorem

NORM = p**2 + x * q**2
GROWTH = 2 * n / (1 + x)
"""Logarithmic slope ``2 N'/N`` of the norm N."""

BRACKETS = (definition(c, 2 * (p * prime(q) - q * prime(p))), definition(d, q - 2 * prime(q) - 2 * prime(p)))
SLOPES_OF = {
    slope: definition(slope, 2 * prime(symbol))
    for slope, symbol in zip((f_y, g_y, h_y, f_iy, h_iy), (f, g, h, f_i, h_i), strict=True)
}
OF_X = Symbols((p, q, x, n), free=(x,))
SPEED = dot(v, v_dot)
FORWARD, BACKWARD = (g, h, f_y, g_y, h_y), (h_i, f_iy, h_iy)


def calculus_theorems(formulas: Formulas) -> tuple[Theorem, ...]:
    """Return the theorems on derivatives of the given formulas."""
    operator = formulas.defined(dcay, "tangent"), formulas.defined(dcay_inv, "tangent_inv", numbers=(89,))
    tensor = formulas.defined(R, "tensor")
    coefficients = dict(_coefficients(formulas))
    slopes = _slopes(coefficients)
    known = coefficients | {premise.equation.left: premise for premise in slopes.given()}
    return (
        slopes,
        _second_slopes(coefficients),
        *_of_operators(known, *operator),
        *_of_images(known, *operator),
        _structure(known, operator[0]),
        _body(known, operator[0], tensor),
    )


def _coefficients(formulas: Formulas) -> Iterator[tuple[sympy.Expr, Premise]]:
    """Yield the definitions of f, g, h, f_i, h_i."""
    inverse, _, dyadic = formulas.tangent_inv(n, x, p, q)
    values = (*formulas.tangent(n, x, p, q), 2 * inverse, 2 * dyadic)
    for symbol, value in zip((f, g, h, f_i, h_i), values, strict=True):
        yield symbol, definition(symbol, value)


def _slopes(coefficients: dict[sympy.Expr, Premise]) -> Theorem:
    return Theorem(
        "slopes of the tangent operators",
        (
            Equation(f_y, h - GROWTH * g),
            Equation(g_y, 8 * q * prime(q) / NORM - GROWTH * g),
            Equation(h_y, 4 * prime(c) / NORM - GROWTH * h),
            Equation(f_iy, -c / q**2),
            Equation(h_iy, 2 * (prime(d) - d * prime(q) / q) / (n * q)),
        ),
        (*coefficients.values(), *SLOPES_OF.values(), *BRACKETS, *SLOPES.given(), ORIGIN_P, ORIGIN_Q),
        Identity(OF_X),
    )


def _second_slopes(coefficients: dict[sympy.Expr, Premise]) -> Theorem:
    """Return the theorem on second slopes, valid at x = 0 too."""
    q_x, falling = prime(q), GROWTH**2 / n
    return Theorem(
        "second slopes of the tangent operators",
        (
            Equation(2 * prime(f_y), h_y - GROWTH * g_y + falling * g),
            Equation(
                2 * prime(g_y),
                16 * (q * prime(q_x) + q_x**2) / NORM - GROWTH * (g_y + 8 * q * q_x / NORM) + falling * g,
            ),
            Equation(2 * prime(h_y), 8 * prime(prime(c)) / NORM - GROWTH * (h_y + 4 * prime(c) / NORM) + falling * h),
            Equation(2 * prime(f_iy), (4 * c * q_x / q - 2 * prime(c)) / q**2),
            Equation(2 * prime(h_iy), 4 * (prime(prime(d)) - d * prime(q_x) / q) / (n * q) - 4 * q_x / q * h_iy),
        ),
        (*coefficients.values(), *SLOPES_OF.values(), *BRACKETS, *SLOPES.given(), ORIGIN_P, ORIGIN_Q),
        Identity(OF_X),
    )


def _of_operators(known: dict[sympy.Expr, Premise], tangent: Premise, inverse: Premise) -> Iterator[Theorem]:
    """Yield the theorems on derivatives along a motion."""
    turned = dyad(v, v_dot) + dyad(v_dot, v)
    yield Theorem(
        "rate of the tangent operator",
        (
            Equation(
                rate(dcay),
                SPEED * (f_y * I + g_y * skew(v) + h_y * dyad(v, v)) + g * skew(v_dot) + h * turned,
            ),
        ),
        (*(known[symbol] for symbol in FORWARD), BRACKETS[0], tangent, *MOTION),
        Identity(MOVING),
    )
    yield Theorem(
        "rate of the inverse operator",
        (
            Equation(
                rate(dcay_inv), (SPEED * (f_iy * I + h_iy * dyad(v, v)) - skew(v_dot) + h_i * turned) / 2
            ),
            Equation(dcay * rate(dcay_inv), -rate(dcay) * dcay_inv),
        ),
        (*(known[symbol] for symbol in BACKWARD), *BRACKETS, tangent, inverse, *MOTION, ORIGIN_Q),
        Identity(MOVING),
    )


def _jacobian(of: sympy.Expr, hand: int = 1) -> sympy.Expr:
    """Return the derivative of ``T a`` by v for a = `of`; with hand −1, the derivative of ``Tᵀ a``."""
    image = f_y * of + hand * g_y * cross(v, of) + h_y * dot(v, of) * v
    return dyad(image, v) - hand * g * skew(of) + h * (dyad(v, of) + dot(v, of) * I)


def _rate_jacobian(of: sympy.Expr, hand: int = 1) -> sympy.Expr:
    """Return the derivative of ``T⁻¹ a`` by v for a = `of`; with hand −1, the derivative of ``T⁻ᵀ a``."""
    return (dyad(f_iy * of + h_iy * dot(v, of) * v, v) + hand * skew(of) + h_i * (dyad(v, of) + dot(v, of) * I)) / 2


def _of_images(known: dict[sympy.Expr, Premise], tangent: Premise, inverse: Premise) -> Iterator[Theorem]:
    """Yield the theorems on the derivatives by v of the twist ``T a`` and the rate ``T⁻¹ a`` for a fixed a."""
    symbols = Symbols((p, q, x, n), (v, v_dot, a), (x,))
    yield Theorem(
        "Jacobian of the twist",
        (
            Equation(rate(dcay) * a, twist_jacobian * v_dot),
            Equation(transpose(rate(dcay)) * a, body_jacobian * v_dot),
        ),
        (
            definition(twist_jacobian, _jacobian(a), wrong=_jacobian(a, -1)),
            definition(body_jacobian, _jacobian(a, -1), wrong=_jacobian(a)),
            *(known[symbol] for symbol in FORWARD), BRACKETS[0], tangent, *MOTION,
        ),
        Identity(symbols),
    )  # fmt: skip
    yield Theorem(
        "Jacobian of the rate",
        (
            Equation(rate(dcay_inv) * a, rate_jacobian * v_dot),
            Equation(transpose(rate(dcay_inv)) * a, body_rate_jacobian * v_dot),
        ),
        (
            definition(rate_jacobian, _rate_jacobian(a), wrong=_rate_jacobian(a, -1)),
            definition(body_rate_jacobian, _rate_jacobian(a, -1), wrong=_rate_jacobian(a)),
            *(known[symbol] for symbol in BACKWARD), *BRACKETS, inverse, *MOTION[:-1], ORIGIN_Q,
        ),
        Identity(symbols),
    )  # fmt: skip


def _structure(known: dict[sympy.Expr, Premise], tangent: Premise) -> Theorem:
    """Return the theorem on the Maurer-Cartan equation."""
    images = cross(dcay * a, dcay * b)
    return Theorem(
        "structure equation",
        (Equation(twist_jacobian_b * a - twist_jacobian * b, images),),
        (
            definition(twist_jacobian, _jacobian(a)),
            definition(twist_jacobian_b, _jacobian(b)),
            *(known[symbol] for symbol in (g, f_y, g_y)), tangent, SQUARE, SLOPES.premise(1), ORIGIN_P,
        ),
        Identity(Symbols((p, q, x, n, h, h_y), (v, a, b), (x,))),
    )  # fmt: skip


def _body(known: dict[sympy.Expr, Premise], tangent: Premise, tensor: Premise) -> Theorem:
    """Return the theorem in the body frame: a structure equation with a minus sign, and J_B(b) a = Rᵀ J(a) b."""
    of_b = body_jacobian.func("J_B(b)", commutative=False)
    images = cross(transpose(dcay) * a, transpose(dcay) * b)
    return Theorem(
        "structure equation in the body",
        (
            Equation(of_b * a - body_jacobian * b, -images),
            Equation(of_b * a, transpose(R) * twist_jacobian * b),
        ),
        (
            definition(twist_jacobian, _jacobian(a)),
            definition(body_jacobian, _jacobian(a, -1)),
            definition(of_b, _jacobian(b, -1)),
            *(known[symbol] for symbol in (g, h, f_y, g_y)), tangent, tensor, SQUARE, SLOPES.premise(1), ORIGIN_P,
        ),
        Identity(Symbols((p, q, x, n, h_y), (v, a, b), (x,))),
    )  # fmt: skip
