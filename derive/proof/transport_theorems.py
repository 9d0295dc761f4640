r"""Theorems for every n that the papers lack: rates at a change of branch, twists of products.

A step between branches keeps the twist. With ``v = r u`` and ``v_k = r_k u``, rates transform by ``v_k' = S_k v'``,
where ``S_k = (r_k/r) (I − u⊗u) + (dr_k/dr) u⊗u``. Momenta transform by the inverse transpose. The twist of a product
of displacements gives the Jacobians of composition.
"""

from __future__ import annotations

import sympy

from .displacement_theorems import MOEBIUS, TURNED, TURNED_ROOT, UNIT, branch_step, pythagoras
from .formulas import defined, tangent
from .methods import identity
from .notation import *
from .setting import Symbols
from .statement import Equation, Premise, definition
from .theorem import Theorem

STEP = identity(
    "slope of a Moebius step",
    Symbols((sympy.sin(beta), sympy.cos(beta), r), free=(r, sympy.sin(beta), sympy.cos(beta))),
    (Equation(1 + r_k**2, (1 + r**2) / TURNED_ROOT**2), Equation(rate(r_k), 1 / TURNED_ROOT**2)),
    MOEBIUS, definition(rate(r), 1), pythagoras(beta),
)  # fmt: skip
_SIDES = tuple(side(angle) for angle in (beta, gamma) for side in (sympy.sin, sympy.cos))
BOTH, FURTHER = beta + gamma, sympy.cos(gamma) - r_k * sympy.sin(gamma)
BOTH_ROOT = sympy.cos(BOTH) - r * sympy.sin(BOTH)


def _transported(there: sympy.Expr, here: sympy.Expr, root: sympy.Expr) -> sympy.Expr:
    """Return the tensor S of a step from ``here u`` to ``there u``; `root` is the divisor of the step."""
    return there / here * (I - dyad(u, u)) + dyad(u, u) / root**2


def _transport(sign: int) -> Theorem:
    """Return the theorem that a step S_k between branches keeps the twist; S_kᵀ transforms momenta."""
    cosine, sine = sympy.cos(beta), sympy.sin(beta)
    return identity(
        f"transport, {'even' if sign == 1 else 'odd'} branch",
        Symbols((p, q, r_k, sine, cosine, r, n), (u,), (r, r_k, sine, cosine)),
        (Equation(dcay_k * transport, dcay),),
        definition(transport, _transported(r_k, r, TURNED_ROOT)),
        defined(dcay, tangent, (n, r**2, p, q), r * u), defined(dcay_k, tangent, (n, r_k**2, p_k, q_k), r_k * u),
        *TURNED.given(), STEP.premise(0), UNIT, *branch_step(sign),
    )  # fmt: skip


TWICE = identity(
    "transport, step by step", Symbols((r, *_SIDES), (u,), (r, *_SIDES)),
    (
        Equation(r_jk, (r * sympy.cos(BOTH) + sympy.sin(BOTH)) / BOTH_ROOT),
        Equation(
            _transported(r_jk, r, BOTH_ROOT), _transported(r_jk, r_k, FURTHER) * _transported(r_k, r, TURNED_ROOT)
        ),
    ),
    MOEBIUS,
    definition(r_jk, (r_k * sympy.cos(gamma) + sympy.sin(gamma)) / FURTHER),
    definition(sympy.cos(BOTH), sympy.cos(beta) * sympy.cos(gamma) - sympy.sin(beta) * sympy.sin(gamma)),
    definition(sympy.sin(BOTH), sympy.sin(beta) * sympy.cos(gamma) + sympy.cos(beta) * sympy.sin(gamma)),
    UNIT,
)  # fmt: skip
_TWO, _ONE = scalar_2 + second, scalar_1 + first


def _moving(scalar: sympy.Expr, vector: sympy.Expr, twist: sympy.Expr) -> tuple[Premise, ...]:
    """Return the premises ``q' = ω q/2``, CP23 (75), for scalar and vector part."""
    return (
        definition(rate(scalar), -dot(twist, vector) / 2),
        definition(rate(vector), (scalar * twist + cross(twist, vector)) / 2),
    )


PRODUCT = identity(
    "twist of a product", Symbols((scalar_2, scalar_1), (second, first, omega_1, omega_2)),
    (Equation(rate(_TWO * _ONE), (omega_2 + sandwich(_TWO) * omega_1) * _TWO * _ONE / 2),),
    *_moving(scalar_1, first, omega_1), *_moving(scalar_2, second, omega_2),
    definition(scalar_2**2 + dot(second, second), 1),
)  # fmt: skip
"""Theorem that implies ``T(v) v' = T(v2) v2' + R(v2) T(v1) v1'`` for ``R(v) = R(v2) R(v1)``."""

TRANSPORT_THEOREMS = (STEP, TWICE, _transport(1), _transport(-1), PRODUCT)
