r"""Theorems for every n that the papers lack: derivatives of the tangent operator, and limits for growing order.

Notation: ``T = f I + g skew(v) + h v⊗v``, ``T⁻¹ = (f_i I − skew(v) + h_i v⊗v)/2``, and slopes ``f_y = 2 df/dx``.
Then ``df/dt = f_y (v · v')``. The theorems concern:

* slopes and second slopes in closed form, without division by x;
* the derivatives by v in both frames: J(a) of the twist ``T a``, and K(a) of the rate ``T⁻¹ a``;
* the structure equation ``(∂_a T) b − (∂_b T) a = T a × T b`` in space, with a minus sign in the body frame;
* derivative of v(t) by v(0): for a given body twist a and a constant b, ``δ = T⁻¹ b`` solves the variational equation
  ``δ' = K_B(a) δ``. Hence ``∂v/∂v0 = T(v)⁻¹ T(v0)``, and the space perturbation ``T δ`` of the pose is constant.
  For a given space twist all operators are transposed;
* growing order: let ``v`` be 2n times the vector of the map, and ``ε = 1/(2n)²``. Then ``v = φ(α) u`` with

.. math::
    \varphi(\alpha) = \frac{\tan(\sqrt\varepsilon\,\alpha)}{\sqrt\varepsilon} \qquad
    \varphi' = 1 + \varepsilon\,\varphi^2

Hence α solves ``dα/dr = 1/(1 + ε r²)``, ``r = |v|``, with α = 0 at r = 0. The right side is analytic in ε and r where
``|ε| r² < 1``: for α < nπ/2, half the edge of the chart. The solution and all maps are analytic there too. The theorems
state these maps and their derivatives by ε, both at ε = 0, as dual numbers with ``ε² = 0``. Quaternion, tensor and T
therefore differ from the values of the exponential map by ``1/(4 n²)`` times the coefficient of ε, plus terms of order
``1/n⁴``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import sympy

from .displacement_theorems import DOUBLE_ANGLE, EXPONENTIAL, UNIT, VERSOR_EXPONENTIAL, circular, pythagoras, solution
from .evaluation import tangent, tangent_inv
from .identity import Equation, Premise, definition
from .map_theorems import INVERSE, MOTION, MOVING, ORIGIN_P, ORIGIN_Q, SLOPES, SQUARE, TANGENT, TENSOR
from .methods import Theorem, determined, identity
from .notation import *
from .setting import Symbols

NORM = p**2 + x * q**2
GROWTH = 2 * n / (1 + x)
"""Logarithmic slope ``2 N'/N`` of the norm N."""

BRACKETS = (definition(c, 2 * (p * prime(q) - q * prime(p))), definition(d, q - 2 * prime(q) - 2 * prime(p)))
SLOPES_OF = tuple(
    definition(slope, 2 * prime(symbol)) for slope, symbol in zip((f_y, g_y, h_y, f_iy, h_iy), (f, g, h, f_i, h_i))
)
OF_X = Symbols((p, q, x, n), free=(x,))
SPEED = dot(v, v_dot)

FIRST = (
    Equation(f_y, h - GROWTH * g),
    Equation(g_y, 8 * q * prime(q) / NORM - GROWTH * g),
    Equation(h_y, 4 * prime(c) / NORM - GROWTH * h),
    Equation(f_iy, -c / q**2),
    Equation(h_iy, 2 * (prime(d) - d * prime(q) / q) / (n * q)),
)
"""Slopes of f, g, h, f_i, h_i."""

_Q_X, _FALLING = prime(q), GROWTH**2 / n
SECOND = (
    Equation(2 * prime(f_y), h_y - GROWTH * g_y + _FALLING * g),
    Equation(
        2 * prime(g_y),
        16 * (q * prime(_Q_X) + _Q_X**2) / NORM - GROWTH * (g_y + 8 * q * _Q_X / NORM) + _FALLING * g,
    ),
    Equation(2 * prime(h_y), 8 * prime(prime(c)) / NORM - GROWTH * (h_y + 4 * prime(c) / NORM) + _FALLING * h),
    Equation(2 * prime(f_iy), (4 * c * _Q_X / q - 2 * prime(c)) / q**2),
    Equation(2 * prime(h_iy), 4 * (prime(prime(d)) - d * prime(_Q_X) / q) / (n * q) - 4 * _Q_X / q * h_iy),
)
"""Second slopes of f, g, h, f_i, h_i, valid at x = 0 too."""


def transition(
    frame: str, operator: sympy.Expr, inverse: sympy.Expr
) -> tuple[tuple[Equation, ...], tuple[Premise, ...]]:
    """Return claim and premises on a perturbation δ of v in a motion whose twist a in a frame is given.

    δ solves the variational equation. The perturbation of the pose is the constant b in the other frame.
    """
    body = frame == "body"

    def given(tensor: sympy.Expr) -> sympy.Expr:
        return transpose(tensor) if body else tensor

    def other(tensor: sympy.Expr) -> sympy.Expr:
        return tensor if body else transpose(tensor)

    jacobian, hand = (body_rate_jacobian, -1) if body else (rate_jacobian, 1)
    claim = (
        Equation(rate(delta), jacobian * delta),
        Equation(other(operator) * delta, b),
        Equation(given(operator) * delta, given(R) * b),
    )
    premises = (
        definition(v_dot, given(inverse) * a),
        definition(rate(v), v_dot),
        definition(delta, other(inverse) * b),
        definition(jacobian, rate_jacobian_of(a, hand), wrong=rate_jacobian_of(a, -hand)),
    )
    return claim, premises


def _jacobian(of: sympy.Expr, hand: int = 1) -> sympy.Expr:
    """Return the derivative of ``T a`` by v for a = `of`; with hand −1, the derivative of ``Tᵀ a``."""
    image = f_y * of + hand * g_y * cross(v, of) + h_y * dot(v, of) * v
    return dyad(image, v) - hand * g * skew(of) + h * (dyad(v, of) + dot(v, of) * I)


def rate_jacobian_of(of: sympy.Expr, hand: int = 1) -> sympy.Expr:
    """Return the derivative of ``T⁻¹ a`` by v for a = `of`; with hand −1, the derivative of ``T⁻ᵀ a``."""
    return (dyad(f_iy * of + h_iy * dot(v, of) * v, v) + hand * skew(of) + h_i * (dyad(v, of) + dot(v, of) * I)) / 2


def _image(
    name: str, operator: sympy.Expr, derivative: Callable[..., sympy.Expr], frames: Sequence[sympy.Expr],
    *premises: Premise,
) -> Theorem:
    """Return the theorem on the derivative by v of the image of a fixed vector, in space and body frame."""
    space, body = frames
    return identity(
        name, Symbols((p, q, x, n), (v, v_dot, a), (x,)),
        (Equation(rate(operator) * a, space * v_dot), Equation(transpose(rate(operator)) * a, body * v_dot)),
        definition(space, derivative(a), wrong=derivative(a, -1)),
        definition(body, derivative(a, -1), wrong=derivative(a)),
        *premises,
    )  # fmt: skip


_FI, _, _HI = tangent_inv(n, x, p, q)
_VALUES = (*tangent(n, x, p, q), 2 * _FI, 2 * _HI)
COEFFICIENTS = {a: definition(a, value) for a, value in zip((f, g, h, f_i, h_i), _VALUES, strict=True)}
GIVEN = (*COEFFICIENTS.values(), *SLOPES_OF, *BRACKETS, *SLOPES.given(), ORIGIN_P, ORIGIN_Q)
OF_SLOPES = identity("slopes of the tangent operators", OF_X, FIRST, *GIVEN)
KNOWN = COEFFICIENTS | {premise.equation.left: premise for premise in OF_SLOPES.given()}


def known(*symbols: sympy.Expr) -> Iterator[Premise]:
    """Yield the premises that define coefficients and slopes."""
    return (KNOWN[symbol] for symbol in symbols)


TURNING = dyad(v, v_dot) + dyad(v_dot, v)
RATE = SPEED * (f_y * I + g_y * skew(v) + h_y * dyad(v, v)) + g * skew(v_dot) + h * TURNING
RATE_OF_INVERSE = (SPEED * (f_iy * I + h_iy * dyad(v, v)) - skew(v_dot) + h_i * TURNING) / 2
FORWARD, BACKWARD = (*known(g, h, f_y, g_y, h_y), BRACKETS[0], TANGENT), (*known(h_i, f_iy, h_iy), *BRACKETS)
ALONG_MOTIONS = (
    identity("rate of the tangent operator", MOVING, (Equation(rate(dcay), RATE),), *FORWARD, *MOTION),
    identity(
        "rate of the inverse operator", MOVING,
        (Equation(rate(dcay_inv), RATE_OF_INVERSE), Equation(dcay * rate(dcay_inv), -rate(dcay) * dcay_inv)),
        *BACKWARD, TANGENT, INVERSE, *MOTION, ORIGIN_Q,
    ),
    _image("Jacobian of the twist", dcay, _jacobian, (twist_jacobian, body_jacobian), *FORWARD, *MOTION),
    _image(
        "Jacobian of the rate", dcay_inv, rate_jacobian_of, (rate_jacobian, body_rate_jacobian), *BACKWARD, INVERSE,
        *MOTION[:-1], ORIGIN_Q,
    ),
)  # fmt: skip
"""Theorems on the rates of T and T⁻¹, and on the derivatives by v of ``T a`` and ``T⁻¹ a``."""
_BODY_OF_B, _OF_A = body_jacobian.func("J_B(b)", commutative=False), definition(twist_jacobian, _jacobian(a))
_COMMON = SQUARE, SLOPES.premise(1), ORIGIN_P
STRUCTURE = (
    identity(
        "structure equation", Symbols((p, q, x, n, h, h_y), (v, a, b), (x,)),
        (Equation(twist_jacobian_b * a - twist_jacobian * b, cross(dcay * a, dcay * b)),),
        _OF_A, definition(twist_jacobian_b, _jacobian(b)), *known(g, f_y, g_y), TANGENT, *_COMMON,
    ),
    identity(
        "structure equation in the body", Symbols((p, q, x, n, h_y), (v, a, b), (x,)),
        (
            Equation(_BODY_OF_B * a - body_jacobian * b, -cross(transpose(dcay) * a, transpose(dcay) * b)),
            Equation(_BODY_OF_B * a, transpose(R) * twist_jacobian * b),
        ),
        _OF_A, definition(body_jacobian, _jacobian(a, -1)), definition(_BODY_OF_B, _jacobian(b, -1)),
        *known(g, h, f_y, g_y), TANGENT, TENSOR, *_COMMON,
    ),
)  # fmt: skip
"""Theorems on the Maurer-Cartan equation in space and body; in the body, J_B(b) a = Rᵀ J(a) b."""


def _transition(frame: str) -> Theorem:
    claim, motion = transition(frame, dcay, dcay_inv)
    return identity(
        f"transition, {frame} twist given", Symbols((p, q, x, n), (v, a, b), (x,)), claim,
        *BACKWARD, TANGENT, INVERSE, TENSOR, *motion, *MOTION[1:-1], ORIGIN_P, ORIGIN_Q,
    )  # fmt: skip


CALCULUS_THEOREMS = (
    OF_SLOPES, identity("second slopes of the tangent operators", OF_X, SECOND, *GIVEN), *ALONG_MOTIONS, *STRUCTURE,
    _transition("space"), _transition("body"),
)  # fmt: skip


SCOPE = "1/(2n)^2 = epsilon, to first order"

HALF = sympy.cos(alpha / 2), sympy.sin(alpha / 2)
OF_LENGTH = sympy.cos(r / 2), sympy.sin(r / 2)
GROWTH = 1 / (1 + epsilon * r**2)
"""Derivative dα/dr, equal to the factor of T along the axis."""

SYMBOLS = (OF_LENGTH[1], OF_LENGTH[0], r)


ANGLE = determined(
    "growing order: angle", Symbols(SYMBOLS), Equation(r, 0),
    (
        Equation(alpha, r - epsilon * r**3 / 3),
        Equation(HALF[0], OF_LENGTH[0] + epsilon * r**3 / 6 * OF_LENGTH[1]),
        Equation(HALF[1], OF_LENGTH[1] - epsilon * r**3 / 6 * OF_LENGTH[0]),
    ),
    *solution(alpha, 0, GROWTH, r),
    *solution(HALF[0], 1, -HALF[1] * GROWTH / 2, r),
    *solution(HALF[1], 0, HALF[0] * GROWTH / 2, r),
    *(Premise(premise.equation.replaced({alpha: r})) for premise in circular(alpha / 2)),
    definition(rate(r), 1),
    scope=SCOPE,
)  # fmt: skip

T, dexp = structure("T"), structure("dexp")
AT_LENGTH = alpha, r
LENGTH = sympy.sin(r), sympy.cos(r)
ROTATION = exponential(r * skew(u))
ALONG = dyad(u, u)

MAPS = identity(
    "growing order: maps", Symbols(SYMBOLS, (u,), (r,)),
    (
        Equation(q_hat, exponential(r / 2 * u) * (1 - epsilon * r**3 / 6 * u)),
        Equation(R, ROTATION * (I - epsilon * r**3 / 3 * skew(u))),
        Equation(T, dexp - epsilon * r**2 / 3 * (ROTATION + 2 * ALONG)),
    ),
    definition(v, r * u),
    definition(f, 2 * HALF[1] * HALF[0] / r),
    definition(g, 2 * HALF[1] ** 2 / r**2),
    definition(h, (GROWTH - f) / r**2),
    definition(q_hat, HALF[0] + HALF[1] / r * v),
    definition(R, I + f * skew(v) + g * skew(v) ** 2),
    definition(T, f * I + g * skew(v) + h * dyad(v, v)),
    definition(dexp, (LENGTH[0] * I + (1 - LENGTH[1]) * skew(u) + (r - LENGTH[0]) * ALONG) / r),
    ANGLE.premise(1), ANGLE.premise(2), EXPONENTIAL.premise(0, AT_LENGTH), VERSOR_EXPONENTIAL.premise(0, AT_LENGTH),
    *(DOUBLE_ANGLE.premise(place, AT_LENGTH) for place in (0, 1)), pythagoras(r / 2), UNIT,
    scope=SCOPE,
)  # fmt: skip

GROWING_ORDER = (ANGLE, MAPS)
