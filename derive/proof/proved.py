r"""Proofs of a chart, and `Proved`, a chart with its proofs, which only `prove` makes; texts that people read.

Formulas in docstrings, comments and output are compared with the proved ones. A text is read into equations between
symbols of the theorems, and these are decided. Plain text and LaTeX are known: integers, ``+ - / ^``, fractions,
brackets, products by juxtaposition, and the names below. Texts on one order are decided at that order, with the values
of the theorems for every n. All other texts are decided for every φ.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import InitVar, dataclass
from functools import cache
from itertools import chain
from typing import Any

import sympy

from ..algebra import Quaternion, Tensor, Vector
from ..algebra.arithmetic import PLAIN
from ..maps import Cayley
from ..maps.any_phi.expressions import OPERATIONS
from ..maps.chart import Chart
from ..maps.chart_formulas import DEFINITIONS, IDENTITIES
from ..maps.formula import Formula
from . import notation as m
from . import phi_theorems as every
from .at_order import at_order, computations, instances
from .calculus_theorems import CALCULUS_THEOREMS, GROWING_ORDER
from .components import Components
from .displacement_theorems import CLOSED_AT, DISPLACEMENT_THEOREMS, TRANSPORT_THEOREMS
from .evaluation import Evaluation
from .identity import Checks, Equation, Proof, decide, definition
from .map_theorems import MAP_THEOREMS, POLYNOMIAL_THEOREMS
from .methods import decided
from .phi_theorems import ANY_PHI
from .scalars import ScalarProofs, instance
from .setting import Setting, Symbols
from .spline_theorems import SPLINES

Names = Mapping[str, sympy.Expr]
"""Symbols and terms of theorems, by their spelling."""

METHOD = "text read into equations, residues in an exact ring"

MARKED = re.compile("`(.+?)`")
"""Formula in a text."""

SIZE, GAIN, LENGTH, A, B = sympy.symbols("size gain r a b")
VECTOR_PART = m.structure("vec(q)")

BASIS: Names = {
    "I": m.I, "v": m.v, "x": m.x, "R": m.R, "R^T": m.transpose(m.R), "det R": m.det(m.R), "|q|^2": m.norm2(m.q_hat),
    **dict.fromkeys(("skew(v)", r"\tilde v", r"\tilde{v}"), m.skew(m.v)),
    **dict.fromkeys(("v(x)v", r"v \otimes v"), m.dyad(m.v, m.v)),
    **dict.fromkeys((r"\hat q", r"\hat{q}"), m.q_hat), r"\tfrac12": sympy.Rational(1, 2),
}  # fmt: skip
SCALARS: Names = {"s": every.s, "w": every.w, "f": m.f, "g": m.g, "h": m.h, "fi": every.fi, "hi": every.hi}
SLOPES: Names = {f"{name}y": sympy.Symbol(f"{name}y") for name in SCALARS}
BENDS: Names = {f"{name}y": sympy.Symbol(f"{name}y") for name in SLOPES}
OF_X: Names = {"rate": every.rho, "a": A, "b": B, **SCALARS}
EVERY_PHI: Names = {
    **BASIS, **OF_X, **SLOPES, **BENDS, "f_i": every.fi, "h_i": every.hi, "q": m.q_hat, "vec q": VECTOR_PART,
    "T": every.T, "T^T": m.transpose(every.T), **dict.fromkeys(("T^-1", "T^{-1}"), every.T_inv),
    **dict.fromkeys(("phi", "phi(alpha)"), every.phi), "phi'": every.phi_1, "sin(alpha/2)": every.sine,
    "u": m.v / every.phi, "r": LENGTH, "gain": GAIN, "size": SIZE,
    **{f"d{name}/dx": m.prime(value) for name, value in {**SCALARS, **SLOPES}.items()},
}  # fmt: skip
"""Names in texts on every chart."""


def of_order(n: int) -> Names:
    operator, polynomials = rf"\mathrm{{dcay}}_{{{n}}}", {"p": m.p, "q": m.q, "c": m.c, "d": m.d}
    return {
        **BASIS, **OF_X, **polynomials, **{f"{letter}_{{{n}}}": term for letter, term in polynomials.items()},
        "n": sympy.Integer(n), **dict.fromkeys(("dcay", operator), m.dcay), "det dcay": m.det(m.dcay),
        "dcay^T": m.transpose(m.dcay), **dict.fromkeys(("dcay^-1", f"{operator}^{{-1}}"), m.dcay_inv),
    }  # fmt: skip


def equations(text: str, names: Names) -> tuple[Equation, ...]:
    r"""Read equations with two or more sides, separated by ``\quad``; raise ValueError for any other text."""
    found: list[Equation] = []
    for part in re.split(r"\\q?quad", text):
        first, *others = (_read(side, names) for side in part.split("="))
        if not others:
            raise ValueError(f"no equation: {text!r}")
        found += [Equation(first, other) for other in others]
    return tuple(found)


def _read(side: str, names: Names) -> sympy.Expr:
    """Return one side of an equation, after rewriting it in Python's syntax with one word for each name."""
    spelled = sorted(names, key=len, reverse=True)
    words = {f"N{place}": names[name] for place, name in enumerate(spelled)}
    pattern = rf"(?<![\\a-zA-Z])(?:{'|'.join(map(re.escape, spelled))})"
    text = re.sub(pattern, lambda found: f" N{spelled.index(found[0])} ", side)
    for old, new in ((r"\,", " "), (r"\frac{", "("), ("}{", ")/("), ("^", "**")):
        text = text.replace(old, new)
    text = re.sub(r"(?<=[\w)])\s+(?=[\w(])", "*", text.translate(str.maketrans("[]{}", "()()")).strip())
    try:
        return _built(ast.parse(text, mode="eval").body, words)
    except (SyntaxError, LookupError) as error:
        raise ValueError(f"not understood in a formula: {side.strip()!r}") from error


def _built(node: ast.expr, words: Names) -> sympy.Expr:
    match node:
        case ast.Constant(value=int(value)):
            return sympy.Integer(value)
        case ast.Name(id=name):
            return words[name]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_built(operand, words)
        case ast.BinOp(left=left, op=ast.Pow(), right=right):
            return _built(left, words) ** _built(right, words)
        case ast.BinOp(left=left, op=op, right=right):
            return OPERATIONS[type(op)](_built(left, words), _built(right, words))
    raise LookupError(ast.dump(node))


# ---- deciding ----------------------------------------------------------------------------------------------------


@cache
def _every_phi() -> Setting:
    slopes = zip((*SLOPES.values(), *BENDS.values()), (*SCALARS.values(), *SLOPES.values()), strict=True)
    given = (
        every.QUATERNION, every.TENSOR, every.TANGENT, every.INVERSE, *every.SCALARS, *every.OF_ANGLE, *every.OF_PHI,
        *every.SQUARES, *(definition(slope, 2 * m.prime(value)) for slope, value in slopes),
        definition(VECTOR_PART, every.w * m.v), definition(GAIN, 1 / every.w), definition(LENGTH, every.phi),
        definition(A, SIZE * every.s), definition(B, SIZE * every.w),
    )  # fmt: skip
    return Setting(Symbols((*every.SYMBOLS, SIZE), (m.v,), (every.sine, every.phi, every.phi_1)), given)


class _OfOrder(Evaluation):
    """Values of the names in texts on a Cayley map, in Q(√(1 + x)) with the components of v."""

    def __init__(self, cayley: Cayley) -> None:
        at = at_order(cayley.order)
        v = Vector(*at.ring.v)
        (s, w), (f, g, h), (fi, _, hi) = (at.values[symbol] for symbol in (m.q_hat, m.dcay, m.dcay_inv))
        a, b, _ = cayley.scalars(at.x, PLAIN).ray
        values = dict(zip(OF_X.values(), (f + at.x * h, a, b, s, w, f, g, h, 2 * fi, 2 * hi), strict=True))
        values |= {symbol: at.values[symbol][0] for symbol in (m.p, m.q, m.c, m.d)}
        for symbol in (m.R, m.dcay, m.dcay_inv):
            along, turned, dyad = at.values[symbol]
            values[symbol] = Tensor.identity() * along + Tensor.skew(v) * turned + Tensor.dyad(v, v) * dyad
        super().__init__({**values, m.x: at.x, m.v: v, m.q_hat: Quaternion(s, v * w)})

    def power(self, base: sympy.Expr, exponent: sympy.Expr) -> Any:
        return self.value(base).sqrt() ** int(2 * exponent)


@cache
def compared(text: str, cayley: Cayley | None = None) -> Proof:
    """Decide the equations of a text on a Cayley map if given, otherwise for every φ."""
    claim = equations(text, of_order(cayley.order) if cayley else EVERY_PHI)

    def checks() -> Checks:
        at = _OfOrder(cayley) if cayley else _every_phi()
        for equation in claim:
            for place, (left, right) in enumerate(at.sides(equation), 1):
                yield f"{equation.text}, component {place}", left - right

    return decide(text, claim, METHOD, checks, f"n = {cayley.order}" if cayley else every.SCOPE)


def shown_with(chart: Chart) -> Iterator[Proof]:
    """Decide the maps and identities as a chart states them, and as every chart does."""
    for name, identities in IDENTITIES.items():
        yield from map(compared, (DEFINITIONS[name], *identities))
        formula: Formula = getattr(chart, name)
        for text in (f"{formula.symbol} = {formula.definition}", *formula.identities):
            yield compared(text, chart.cayley)


_MADE_HERE = object()


STATED = (*POLYNOMIAL_THEOREMS, *MAP_THEOREMS, *DISPLACEMENT_THEOREMS, *CALCULUS_THEOREMS, *TRANSPORT_THEOREMS)
"""Theorems for every n, each after the theorems it uses."""

CLAIMS = (*STATED, *chain(*CLOSED_AT.values()), *ANY_PHI, *GROWING_ORDER, *SPLINES)
"""Theorems that are proved once instead of at each order."""


def citing(numbers: Container[int]) -> tuple[Proof, ...]:
    """Prove the theorems that claim the given equations of CP23, after all theorems they use."""
    wanted = {t.name for t in STATED if any(n in numbers for equation in t.claim for n in equation.numbers)}
    needed = set(wanted)
    for theorem in reversed(STATED):
        if theorem.name in needed:
            needed |= {premise.theorem for premise in theorem.premises}
    return tuple(proof for proof in decided(t for t in STATED if t.name in needed) if proof.name in wanted)


@cache
def theorems() -> tuple[Proof, ...]:
    """Return the proofs of scope "all n", decided once per process."""
    return decided(STATED)


class ProofFailed(Exception):
    """Error for statements about a formula that are not proved; each of the `failed` proofs lists its ``failures``."""

    def __init__(self, failed: tuple[Proof, ...]) -> None:
        self.failed = failed
        lines = (f"{proof.statement} [{proof.scope}]: {_first_failure(proof)}" for proof in failed)
        super().__init__("not proved: " + "; ".join(lines))


def require(decided: Iterable[Proof]) -> None:
    """Raise `ProofFailed` if any statement is not proved."""
    if failed := tuple(proof for proof in decided if not proof.proved):
        raise ProofFailed(failed)


def shown(text: str, cayley: Cayley | None = None) -> str:
    """Return a text without the marks of its formulas; raise `ProofFailed` if one of them is not proved.

    Formulas hold for a Cayley map if given, otherwise for every chart. One without marks raises ValueError.
    """
    if re.search(r"(?<![<>])=", MARKED.sub("", text)):
        raise ValueError(f"a formula without marks is compared with nothing: {text!r}")
    require(compared(formula, cayley) for formula in MARKED.findall(text))
    return text.replace("`", "")


@dataclass(frozen=True)
class Proved:
    """Chart with the proofs of its formulas, made only by :func:`prove`.

    A Cayley map has theorems for all n, their instances at its order, and proofs by components. An algebraic chart has
    proofs that its scalars agree with its formulas and its φ. For any other chart, proofs show that its formulas in α
    are instances of the theorems on every φ.
    """

    formulas: Chart
    proofs: tuple[Proof, ...]
    token: InitVar[object] = None

    def __post_init__(self, token: object) -> None:
        if token is not _MADE_HERE:
            raise TypeError("only derive.proof.prove makes a Proved")

    def __repr__(self) -> str:
        return f"<Proved {self.formulas.name}: {len(self.proofs)} proofs>"


def proofs(chart: Chart) -> tuple[Proof, ...]:
    """Decide every statement about a chart and return all proofs, including failed ones."""
    decided = tuple(_proofs_of_order(chart.cayley)) if chart.cayley else ()
    return (*decided, *(ScalarProofs(chart).proofs() if chart.algebraic else instance(chart)))


def prove(chart: Chart) -> Proved:
    """Prove a chart and the formulas shown with it; raise `ProofFailed` if any statement fails."""
    decided = proofs(chart)
    require(decided)
    require(shown_with(chart))
    return Proved(chart, decided, _MADE_HERE)


def _proofs_of_order(cayley: Cayley) -> Iterator[Proof]:
    yield from theorems()
    yield from instances(cayley)
    yield from computations(cayley.order)
    yield from decided(CLOSED_AT.get(cayley.order, ()))
    yield from Components(cayley).proofs()


def _first_failure(proof: Proof) -> str:
    if not proof.failures:
        return "nothing was checked"
    first = proof.failures[0]
    text = str(first.value)
    return f"{first.label}, residue {text if len(text) <= 200 else f'{text[:200]} ...'}"
