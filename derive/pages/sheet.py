"""Formula sheet: lines of proved theorems, in pages and blocks.

A line is an equation that a theorem claims, a definition among its premises, or a formula of a chart that a proof
compares with the theorems. :func:`sheet` raises `ProofFailed` if a theorem of any line is not proved.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain, groupby
from typing import NamedTuple

import sympy

from ..algebra.arithmetic import PLAIN
from ..maps import Cayley
from ..maps.exponential import Exponential
from ..maps.formula import Formula
from ..maps.polynomials import x
from ..proof.identity import Equation, Proof
from ..proof.methods import Theorem, decided
from ..proof.notation import beta, latex, n, prime, r_k, text
from ..proof.phi_premises import phi, phi_1, phi_2, psi, psi_1, rho
from ..proof.proved import CLAIMS, proofs, require

ORDERS = (1, 2, 3)
"""Orders whose explicit formulas the sheet shows."""

MAPS = ("quaternion", "tensor", "tangent", "tangent_inv")
SLOPES = ("fy", "gy", "hy", "fiy", "hiy")
Wanted = tuple[str, *tuple[int | str, ...]]
"""Name of a theorem, then places in its claim, or left sides of its definitions as plain text."""


class Line(NamedTuple):
    """Formulas in LaTeX, title of their theorem, and equation numbers in CP23; `given` marks definitions."""

    formulas: tuple[str, ...]
    theorem: str
    numbers: tuple[int, ...] = ()
    given: bool = False


class Block(NamedTuple):
    """Lines under a heading."""

    heading: str
    lines: tuple[Line, ...]


class Page(NamedTuple):
    """Blocks of one printed page, with the meaning of its letters."""

    heading: str
    blocks: tuple[Block, ...]
    letters: str


MAPS_OF_ORDER: Mapping[str, tuple[Wanted, ...]] = {
    "Polynomials p and q": (
        ("powers of 1 + v", 0), ("binomial sums", 0, 1), ("norm", 0), ("addition", 0, 1), ("doubling", 0, 1),
        ("multiples of an angle", 0, 1), ("slopes", 0, 1), ("values at x = 0", 0, 1),
    ),
    "Vector to unit dual quaternion": (("quaternion", "v.v", "qhat", 0, 1, 2),),
    "Vector to dual tensor": (("tensor", 0), ("orthogonality", 0, 1)),
    "Screw, and the inverse map": (("screw", 0, 1, "v"),),
    "Pose and lines": (("pose", "V", "Q", "rho", 0), ("line", 0)),
    "Composition": (("composition", 0, 1),),
    "Tangent operator": (("tangent", 0), ("axis", 0), ("determinant", 0)),
    "Inverse tangent operator": (("tangent_inv", 0), ("inverse", 0)),
    "Space twist, body twist and rates": (
        ("twist", "omega", 0, 1), ("body twist", "omega_B", 0, 1, 2), ("quaternion rate", 0, 1), ("rates of v", 0, 1),
    ),
    "Growing order: towards the exponential, ε = 1/(2n)²": (
        ("growing order: angle", 0), ("growing order: maps", "dexp", 0, 1, 2),
    ),
}  # fmt: skip
"""First page, by headings."""

MOTION_OF_ORDER: Mapping[str, tuple[Wanted, ...]] = {
    "Coefficients of the tangent operators": (
        ("slopes of the tangent operators", "f", "g", "h", "f_i", "h_i", "c_n", "d_n"), ("brackets", 0, 1),
    ),
    "Their slopes": (
        ("slopes of the tangent operators", "f_y", "g_y", "h_y", "f_iy", "h_iy", 0, 1, 2, 3, 4),
    ),
    "Rates of the tangent operators": (("rate of the tangent operator", 0), ("rate of the inverse operator", 0)),
    "Jacobian of the twist": (("Jacobian of the twist", "J(a)", "J_B(a)", 0, 1),),
    "Jacobian of the rate": (("Jacobian of the rate", "K(a)", "K_B(a)", 0, 1),),
    "Structure equations": (("structure equation", 0), ("structure equation in the body", 0)),
    "Twist of a product": (("twist of a product", 0),),
    "Transition, space twist a given": (("transition, space twist given", "velocity", "delta", 0, 1, 2),),
    "Transition, body twist a given": (("transition, body twist given", "velocity", "delta", 0, 1, 2),),
    "Switching v = r u to branch k": (
        ("Moebius step", "r_k"), ("slope of a Moebius step", "r'", 1),
        ("shadow, even branch", "sin(beta*n)", "cos(beta*n)", 0), ("shadow, odd branch", "cos(beta*n)", 0),
        ("transport, even branch", "S_k", 0), ("transport, odd branch", 0),
    ),
}  # fmt: skip
"""Second page, by headings."""

CLOSED: Mapping[int, tuple[Wanted, ...]] = {
    1: (("inverse map at n = 1", "b", 0), ("composition at n = 1", 0)),
    2: (("inverse map at n = 2", "sigma", 0), ("composition at n = 2", 0)),
}
"""Closed forms of the inverse map and of composition, by order."""

EVERY_PHI: Mapping[str, tuple[Wanted, ...]] = {
    "Scalars": (("any phi: slopes", "s", "w", "rho", "f", "g", "h", "fi", "hi"),),
    "Maps": (
        ("any phi: quaternion", "qhat", "R"), ("any phi: orthogonality", 0), ("any phi: inverse", "T", "T^-1", 0),
        ("any phi: axis", 0, 1),
    ),
    "Twists and rates": (("any phi: twist", 0), ("any phi: body twist", 0, 1, 2)),
    "Slopes": (("any phi: slopes", 3, 4, 5, 6, 7, 8, 10),),
    "Jacobian of the rate, transition": (
        ("any phi: Jacobian of the rate", "K(a)", "K_B(a)", 0, 1),
        ("any phi: transition, space twist given", 0, 1, 2),
        ("any phi: transition, body twist given", 0, 1, 2),
    ),
    "Switching to another chart or branch": (("any phi: change of chart or branch", "w", "C", 0, 1, 2),),
}  # fmt: skip
"""Fourth page after the exponential, by headings."""

LETTERS = (
    "v = φ(α) u is the vector of a chart, x its square, q̂ a unit dual quaternion, R an orthogonal dual tensor, α the "
    "dual angle, u the axis, ρ the translation, ω the space twist; a tilde marks the skew tensor of a vector, a dot "
    "the derivative by time.",
    "a and b are constant dual vectors. J(a) and K(a) are the derivatives by v of the tangent operator and of its "
    "inverse, applied to a; an index B marks the body frame, an index y twice the derivative by x. δ is a small change "
    "of v along the motion. In switching, r u becomes r_k u with β = kπ/n, and a dot is the derivative by r.",
    "x is the square of v. r_k leads from v = r u to branch k, as on page 2.",
    "φ is any function of α, and x = φ². In switching, ψ belongs to the other chart or branch, whose vector is w; "
    "k counts whole turns.",
)
"""Meaning of letters, by page."""

IS_ANGLE = {phi: Exponential().phi, phi_1: 1, phi_2: 0, rho: 1, prime(rho): 0}
k = sympy.Symbol("k", integer=True)
NEXT_ANGLE = {psi: Exponential().phi + 2 * sympy.pi * k, psi_1: 1}


def sheet(claimed: Iterable[Theorem] | None = None) -> tuple[Page, ...]:
    """Return the four pages, with all claimed theorems decided; raise `ProofFailed` if one of a line is not proved."""
    known = {proof.name: proof for proof in decided(CLAIMS if claimed is None else claimed)}

    def blocks(table: Mapping[str, tuple[Wanted, ...]]) -> tuple[Block, ...]:
        return tuple(Block(heading, tuple(lines(wanted, known))) for heading, wanted in table.items())

    of_orders = (block for order in ORDERS for block in _of_order(Cayley(order), known))
    contents = {
        "Order n: maps and twists": blocks(MAPS_OF_ORDER),
        "Order n: Jacobians, transition, switching": blocks(MOTION_OF_ORDER),
        "Orders 1, 2, 3": tuple(of_orders),
        "Exponential, and every v = φ(α) u": (*_of_exponential(known), *blocks(EVERY_PHI)),
    }
    return tuple(Page(*named, letters) for named, letters in zip(contents.items(), LETTERS, strict=True))


def proved(proof: Proof) -> Proof:
    require((proof,))
    return proof


def lines(
    table: Iterable[Wanted], known: Mapping[str, Proof], changes: Mapping[sympy.Expr, sympy.Expr] | None = None
) -> Iterator[Line]:
    """Yield the wanted equations of theorems, with symbols replaced by `changes`.

    Neighbours of one theorem with the same equation numbers share a line.
    """
    for name, *places in table:
        proof = proved(known[name])
        defined = {text(premise.equation.left): premise.equation for premise in proof.premises if not premise.theorem}
        wanted = ((p, proof.claim[p]) if isinstance(p, int) else (p, defined[p]) for p in places)
        for (given, numbers), found in groupby(wanted, lambda pair: (isinstance(pair[0], str), pair[1].numbers)):
            formulas = tuple(_changed(equation, changes).latex for _, equation in found)
            yield Line(formulas, proof.title, numbers, given)


def _changed(equation: Equation, changes: Mapping[sympy.Expr, sympy.Expr] | None) -> Equation:
    if not changes:
        return equation
    return Equation(equation.left.xreplace(changes), sympy.together(equation.right.xreplace(changes)))


def _of_order(cayley: Cayley, known: Mapping[str, Proof]) -> Iterator[Block]:
    """Yield the blocks of one order; closed forms have one where they are proved."""
    order, at = cayley.order, cayley.scalars(x, PLAIN)
    found = {proof.name: proof for proof in proofs(cayley)}
    polynomials = ", ".join(f"Cayley({order}).{name}" for name in "pqcd")
    angles = f"polynomials.singular_angles({order}), polynomials.poles({order})"
    turns = sympy.FiniteSet(*cayley.singular_angles)
    slopes = {f"{name[0]}_{{{name[1:]}}}": getattr(at, name) for name in SLOPES}
    yield Block(
        f"n = {order}: maps",
        (
            _values({f"{name}_{order}": getattr(cayley, name) for name in "pqcd"}, found[polynomials]),
            *(_map(getattr(cayley, name), found[f"Cayley({order}).{name}"]) for name in MAPS),
            *lines((("screw", "v"),), known, {n: sympy.Integer(order)}),
            Line((rf"\mathrm{{Re}}(\alpha) \in {sympy.latex(turns)}",), proved(found[angles]).title),
        ),
    )
    yield Block(f"n = {order}: slopes, for J and K", (_values(slopes, found["slopes"]),))
    if closed := CLOSED.get(order):
        yield Block(f"n = {order}: inverse map and composition", tuple(lines(closed, known)))
    steps = zip(*(tuple(_step(order, branch, known)) for branch in range(1, order)), strict=True)
    joined = tuple(lines[0]._replace(formulas=tuple(chain(*(line.formulas for line in lines)))) for lines in steps)
    if joined:
        yield Block(f"n = {order}: switching", joined)


def _step(order: int, branch: int, known: Mapping[str, Proof]) -> Iterator[Line]:
    """Yield the step to a branch; its angle β must fulfil the premises of the theorem on shadows."""
    at_branch = {n: sympy.Integer(order), beta: branch * sympy.pi / order}
    shadow = proved(known[f"shadow, {'odd' if branch % 2 else 'even'} branch"])
    stated = [premise.equation for premise in shadow.premises]
    for turn in (sympy.cos(n * beta), sympy.sin(n * beta)):
        if Equation(turn, turn.xreplace(at_branch)) not in stated:
            raise ValueError(f"branch {branch} of order {order} is not a case of the theorem {shadow.name!r}")
    step = ("Moebius step", "r_k"), ("slope of a Moebius step", 1)
    yield from lines(step, known, at_branch | {r_k: sympy.Symbol(f"r_{branch}")})


def _of_exponential(known: Mapping[str, Proof]) -> Iterator[Block]:
    chart = Exponential()
    found = {proof.name: proof for proof in proofs(chart)}
    maps = (_map(getattr(chart, name), found["coefficients in alpha"]) for name in MAPS)
    powers = ("exponential", 0), ("exponential of a quaternion", 0)
    slopes = (("any phi: slopes", 3, 4, 5, 6, 7, 8),)
    switch = (("any phi: change of chart or branch", "w", "C"),)
    yield Block("Exponential: maps", (*lines(powers, known), *maps))
    yield Block("Exponential: slopes", tuple(lines(slopes, known, IS_ANGLE)))
    yield Block("Exponential: switching", tuple(lines(switch, known, IS_ANGLE | NEXT_ANGLE)))


def _map(formula: Formula, proof: Proof) -> Line:
    return Line((f"{formula.symbol} = {formula.explicit}",), proved(proof).title, formula.equations)


def _values(values: Mapping[str, sympy.Expr], proof: Proof) -> Line:
    shown = (f"{name} = {latex(sympy.factor(value))}" for name, value in values.items())
    return Line(tuple(shown), proved(proof).title)
