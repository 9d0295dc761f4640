"""Section 9, components of the Rodrigues dual vector, and claims about (92)-(98): lines 457-465."""

from . import *
from .general_order import *
from .s03_rigid_motion import angle, shift
from .s07b_order_lists import o1

b_ = Symbol("b", "dual vector", r"\underline{\mathbf{b}}", "b")
b_re, b_du = (Symbol(f"b real{i}", "real vector", rf"\mathbf{{b}}{i}", f"b{i}") for i in ("", "^0"))
u_re, u_du = (Symbol(f"u real{i}", "real vector", rf"\mathbf{{u}}{i}", f"u{i}") for i in ("", "^0"))

PARTS = (
    let(b_, lambda env, *screw: (q := screw_quaternion(env, *screw)).vector / q.scalar, alpha, u),
    let(angle, real_of, alpha), let(shift, dual_of, alpha),
    let(b_re, real_of, b_), let(b_du, dual_of, b_), let(u_re, real_of, u), let(u_du, dual_of, u),
)
"""Definitions of the symbols; b is undefined at a half turn."""


def _components(i: int) -> tuple[Entry, Entry]:
    """Return entries for component i of the real part, in (126) to (128), and of the dual part, in (129) to (131)."""
    b_i, b0_i = (Symbol(f"b{i}{o}", "real", f"b_{i}{o}", f"b{i}{o}") for o in ("", "^0"))
    u_i, u0_i = (Symbol(f"u{i}{o}", "real", f"u_{i}{o}", f"u{i}{o}") for o in ("", "^0"))
    whole = ((b_i, b_re), (b0_i, b_du), (u_i, u_re), (u0_i, u_du))
    where = (*PARTS, *(let(symbol, component_of(i), vector) for symbol, vector in whole))
    square = 1 + tan(angle / 2) ** 2
    return (
        equation(str(125 + i), equal(b_i, tan(angle / 2) * u_i), where=where, condition=finite(angle / 2),
                 components=True),
        equation(str(128 + i), equal(b0_i, shift * bracket(square) * u0_i), where=where, condition=finite(angle / 2),
                 components=True, corrected=equal(b0_i, half * shift * bracket(square) * u_i + tan(angle / 2) * u0_i)),
    )


pairs = tuple(_components(i) for i in (1, 2, 3))
square = 1 + tan(angle / 2) ** 2
ENTRIES = (
    *(real for real, _ in pairs),
    *(dual for _, dual in pairs),
    equation("six-equations", both(equal(b_re, tan(angle / 2) * u_re), equal(b_du, shift * bracket(square) * u_du)),
             where=PARTS, condition=finite(angle / 2),
             corrected=both(equal(b_re, tan(angle / 2) * u_re),
                            equal(b_du, half * shift * bracket(square) * u_re + tan(angle / 2) * u_du))),
    equation("nature-of-95-to-98", both(orthogonal(q_hat), unit_quaternion(R)), where=o1.where,
             corrected=both(unit_quaternion(q_hat), orthogonal(R))),
)
