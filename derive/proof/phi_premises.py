"""Premises of the theorems on every φ: letters, the derivatives of φ, sine and cosine, and the values of the scalars.

The only premises on φ are its derivatives: φ′ is the derivative of φ, φ″ the derivative of φ′, and so on. The premises
on sine and cosine are their derivatives and ``sin² + cos² = 1``. Hence every family is an instance.
"""

from __future__ import annotations

import sympy

from .identity import definition
from .notation import *
from .setting import Symbols

SCOPE = "every phi"

phi, phi_1, phi_2, phi_3 = PHI = sympy.symbols("phi phi' phi'' phi'''")
cosine, sine = sympy.symbols("cos(alpha/2) sin(alpha/2)")
psi, psi_1 = sympy.symbols("psi psi'")
T, T_inv, other_T, other_v, change = map(structure, ("T", "T^-1", "T(w)", "w", "C"))
s, w, f, g, h, fi, hi, rho = sympy.symbols("s w f g h fi hi rho")
g_exp, h_exp, hy_exp, share = sympy.symbols("g_exp h_exp hy_exp share")
gain, size, scalar_part, vector_part = sympy.symbols("gain size e_0 |vec(e)|^2")
turning, growing = sympy.symbols("alpha_dot size_dot")

SIN, COS = 2 * sine * cosine, 1 - 2 * sine**2
"""Sine and cosine of α."""

TURN = 2 * phi * phi_1
"""Derivative dx/dα."""

SQUARES = definition(cosine**2, 1 - sine**2), definition(dot(v, v), x, wrong=2 * x), definition(x, phi**2)
OF_ANGLE = (
    definition(prime(phi), phi_1 / TURN),
    definition(prime(sine), cosine / (2 * TURN)),
    definition(prime(cosine), -sine / (2 * TURN)),
)
"""Derivatives by x; the derivative of α is 1/(dx/dα)."""
OF_PHI = definition(prime(phi_1), phi_2 / TURN), definition(prime(phi_2), phi_3 / TURN)

RATE_SLOPE = -phi_2 / (phi * phi_1**3)
"""Slope of ``rate = 1/φ'``."""

MOTION = (definition(rate(v), v_dot), definition(rate(x), 2 * dot(v, v_dot)))
SCALARS = (
    definition(s, cosine),
    definition(w, sine / phi),
    definition(rho, 1 / phi_1),
    definition(f, SIN / phi),
    definition(g, (1 - COS) / phi**2),
    definition(h, (1 / phi_1 - SIN / phi) / phi**2),
    definition(fi, phi * cosine / sine),
    definition(hi, (2 * phi_1 - phi * cosine / sine) / phi**2),
)
QUATERNION = definition(q_hat, s + w * v, wrong=s + 2 * w * v)
TENSOR = definition(R, (1 - x * g) * I + f * skew(v) + g * dyad(v, v), wrong=2 * I)
_REST = g * skew(v) + h * dyad(v, v)
TANGENT = definition(T, f * I + _REST, wrong=2 * f * I + _REST)
_REST_INV = hi / 2 * dyad(v, v) - skew(v) / 2
INVERSE = definition(T_inv, fi / 2 * I + _REST_INV, wrong=fi * I + _REST_INV)

SYMBOLS = (cosine, sine, x, *PHI)
IN_V, MOVING = Symbols(SYMBOLS, (v,), (sine, phi, phi_1)), Symbols(SYMBOLS, (v, v_dot), (sine, phi, phi_1))
