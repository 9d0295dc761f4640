r"""SymPy expression of φ, built from a text with checked grammar; its parity, and the test for a known φ.

A known φ is a multiple of ``α``, ``tan(α/2n)`` or ``sin(α/2n)``, written in any form. Let u be the greatest common
divisor of the factors of α. Sines, cosines and tangents of multiples of uα are rational functions of
``E = exp(i u α)``. In lowest terms each has one form:

.. math:: \tan\frac{j u \alpha}{2} = \frac{1}{i} \frac{E^j - 1}{E^j + 1} \qquad
    \sin j u \alpha = \frac{1}{2 i} \frac{E^{2j} - 1}{E^j}
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

import sympy
from sympy.functions.elementary.trigonometric import TrigonometricFunction
from sympy.polys.polyerrors import CoercionFailed

from ...algebra.arithmetic import require_order
from ...claims.language.grammar import source
from .. import grammar
from ..elementary import Quotient, alpha, mirror
from ..grammar import PhiError

ODD = (sympy.sin, sympy.tan, sympy.asin, sympy.atan, sympy.sinh, sympy.tanh, sympy.asinh, sympy.atanh)
EVEN = (sympy.cos, sympy.cosh)
OPERATIONS: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: lambda a, b: a + b,
    ast.Sub: lambda a, b: a - b,
    ast.Mult: lambda a, b: a * b,
    ast.Div: lambda a, b: a / b,
}

EXPONENT_MAX = 16
NUMBER_BITS_MAX = 2000
HARMONICS_MAX = 64
"""Limit of k in multiples kuα, which bounds the degree of polynomials in E."""

I, E = sympy.I, sympy.Symbol("E")
BY_EXPONENTIAL: Mapping[Any, Callable[[int], sympy.Expr]] = {
    sympy.sin: lambda k: (E**k - E**-k) / (2 * I),
    sympy.cos: lambda k: (E**k + E**-k) / 2,
    sympy.tan: lambda k: (E ** (2 * k) - 1) / (E ** (2 * k) + 1) / I,
    sympy.cot: lambda k: (E ** (2 * k) + 1) / (E ** (2 * k) - 1) * I,
}

QUOTIENTS = {
    sympy.sec: lambda u: 1 / sympy.cos(u), sympy.csc: lambda u: 1 / sympy.sin(u),
    sympy.cot: lambda u: sympy.cos(u) / sympy.sin(u),
}  # fmt: skip
"""Functions that are replaced by quotients."""

KNOWN = {getattr(sympy, name) for name in grammar.FUNCTIONS}

Form = tuple[Fraction, Any, int]
"""Form (K, function, n) of ``K function(α/2n)``; (K, None, 1) for ``K α``."""


def expression_of(phi: Any, order: int | None) -> sympy.Expr:
    """Return a text or an expression as an elementary expression in `elementary.alpha`; `PhiError` gives the reason."""
    if isinstance(phi, str):
        return parsed(phi, order)
    if not isinstance(phi, sympy.Expr):
        raise PhiError(f"phi is a text or a SymPy expression in derive.alpha, given {phi!r}")
    if other := sorted(map(str, phi.free_symbols - {alpha})):
        same = f"{alpha} with other assumptions" if str(alpha) in other else ", ".join(other)
        raise PhiError(f"phi = {phi} holds the symbol {same}: its only symbol is derive.alpha")
    if other := sorted({f.func.__name__ for f in phi.atoms(sympy.Function) if f.func not in KNOWN}):
        raise PhiError(f"phi = {phi} holds {', '.join(other)}; known functions are {', '.join(grammar.FUNCTIONS)}")
    return _real(phi)


def _real(phi: sympy.Expr) -> sympy.Expr:
    """Return an expression in quotients; refuse one with a constant that is no real number."""
    constants = (part for part in sympy.preorder_traversal(phi) if not part.free_symbols)
    if (wrong := next((part for part in constants if not (part.is_comparable and part.is_finite)), None)) is not None:
        raise PhiError(f"phi = {phi} holds {wrong}, which is no real number")
    return _in_quotients(phi)


def _in_quotients(phi: sympy.Expr) -> sympy.Expr:
    """Replace `QUOTIENTS`, and products of tangent and cosine, which SymPy keeps, by sines."""
    for function, quotient in QUOTIENTS.items():
        phi = phi.replace(function, quotient)
    return phi.replace(lambda e: e.is_Mul, _without_common_cosines)


def _without_common_cosines(product: sympy.Expr) -> sympy.Expr:
    cosines = {factor.as_base_exp()[0].args[0] for factor in product.args if factor.as_base_exp()[0].func == sympy.cos}
    return product.xreplace({sympy.tan(u): sympy.sin(u) / sympy.cos(u) for u in cosines})


def parsed(text: str, order: int | None = None) -> sympy.Expr:
    """Return a text as an expression in `elementary.alpha`, with `order` for n; `PhiError` names a refused part."""
    found = _built(text, order)[0]
    if found.has(sympy.zoo, sympy.nan, sympy.oo, -sympy.oo):
        raise PhiError(f"phi divides by zero: {text!r}")
    return _real(found)


def left_out(text: str, order: int | None = None) -> list[sympy.Expr]:
    """Return the functions and terms that a text holds and its expression lacks, such as ``log(alpha)`` times 0."""
    found, parts = _built(text, order)
    without_factor = dict.fromkeys(part.as_coeff_Mul()[1] for part in parts)
    return [_in_quotients(part) for part in without_factor if part.has(alpha) and not found.has(part)]


def _built(text: str, order: int | None) -> tuple[sympy.Expr, list[sympy.Expr]]:
    """Return the expression of a text, with its functions, and the operands of sums and products without α."""
    text, order = grammar.spelled(text), order if order is None else require_order(order)
    tree, builder = grammar.PHI.tree(text), _Builder(text, order)
    try:
        return builder.build(tree), builder.parts
    except ZeroDivisionError:
        raise PhiError(f"phi divides by zero: {text!r}") from None


class _Builder:
    def __init__(self, text: str, order: int | None) -> None:
        self.text = text
        self.order = order
        self.parts = list[sympy.Expr]()

    def build(self, node: ast.expr) -> sympy.Expr:
        """Return the expression of a node that `grammar` allows."""
        match node:
            case ast.Constant():
                digits, exponent = grammar.PHI.decimal(node, self.text)
                return sympy.Integer(digits) * sympy.Integer(10) ** exponent
            case ast.Name():
                return self._name(node.id)
            case ast.UnaryOp():
                value = self.build(node.operand)
                return -value if isinstance(node.op, ast.USub) else value
            case ast.BinOp(op=ast.Pow()):
                return self._power(node)
            case ast.BinOp():
                left, right = self.build(node.left), self.build(node.right)
                if isinstance(node.op, ast.Div) and right.is_zero:
                    raise ZeroDivisionError
                found = OPERATIONS[type(node.op)](left, right)
                if not found.has(alpha):
                    self.parts += [left, right if left or not isinstance(node.op, ast.Div) else 1 / right]
                return found
            case ast.Call(func=ast.Name(id=name)):
                found = getattr(sympy, name)(self.build(node.args[0]))
                self.parts.append(found)
                return found
        raise TypeError(f"the grammar of phi does not allow {node!r}")

    def _name(self, name: str) -> sympy.Expr:
        if name == "n" and self.order is None:
            raise PhiError("phi holds n: give its value, by -n or as order=")
        return {"alpha": alpha, "pi": sympy.pi, "n": sympy.Integer(self.order or 0)}[name]

    def _power(self, node: ast.BinOp) -> sympy.Expr:
        base, exponent = self.build(node.left), self._exponent(node.right)
        if base.is_Rational and max(abs(base.p), base.q).bit_length() * abs(exponent) > NUMBER_BITS_MAX:
            raise PhiError(f"a number in phi is too large: {source(node, self.text)[:60]}")
        if base == 0 and exponent < 0:
            raise ZeroDivisionError
        return base**exponent

    def _exponent(self, node: ast.expr) -> sympy.Rational:
        value = self.build(node)
        if not (value.is_Rational and abs(value) <= EXPONENT_MAX and value.q <= EXPONENT_MAX):
            raise PhiError(f"powers in phi are numbers up to {EXPONENT_MAX}, given {source(node, self.text)}")
        return value


def parity(expression: sympy.Expr) -> int | None:
    """Return −1 if the structure of an expression shows that it is odd in α, 1 if even, None if undecided."""
    if expression == alpha:
        return -1
    if alpha not in expression.free_symbols:
        return 1
    if isinstance(expression, Quotient):
        return mirror(expression.above) * (-1) ** expression.power or None
    parts = [parity(argument) for argument in expression.args]
    if expression.is_Add:
        return parts[0] if len(set(parts)) == 1 else None
    if expression.is_Mul:
        return None if None in parts else int(sympy.prod(parts))
    if expression.is_Pow:
        exponent = expression.exp
        if alpha not in exponent.free_symbols and exponent.is_Integer and parts[0] is not None:
            return int(parts[0] ** (int(exponent) % 2))
    elif expression.func in ODD and parts[0] == -1:
        return -1
    elif expression.func in EVEN and parts[0] is not None:
        return 1
    return 1 if all(part == 1 for part in parts) else None


def multiple_of_known(phi: sympy.Expr) -> Form | None:
    """Return the `Form` of a known φ; None for any other φ."""
    if phi.is_rational_function(alpha):
        factor = sympy.cancel(phi / alpha)
        return (_fraction(factor), None, 1) if _is_positive_rational(factor) else None
    atoms = phi.atoms(TrigonometricFunction)
    shares = {atom: atom.args[0] / alpha for atom in atoms}
    if not atoms or not all(atom.func in BY_EXPONENTIAL and shares[atom].is_Rational for atom in atoms):
        return None
    unit = abs(reduce(sympy.Rational.gcd, shares.values()))
    counts = {atom: int(share / unit) for atom, share in shares.items()}
    if max(map(abs, counts.values())) > HARMONICS_MAX:
        return None
    rational = phi.xreplace({atom: BY_EXPONENTIAL[atom.func](counts[atom]) for atom in atoms})
    if not rational.is_rational_function(E) or rational.free_symbols != {E}:
        return None
    return _form(rational, _fraction(unit))


def _form(rational: sympy.Expr, unit: Fraction) -> Form | None:
    """Return the form of a rational function of E, by comparison with tangent and sine in lowest terms."""
    try:
        above, below = (sympy.Poly(part, E, domain="QQ_I") for part in sympy.fraction(sympy.together(rational)))
    except CoercionFailed:  # an irrational coefficient
        return None
    above, below = above.cancel(below, include=True)
    degree, leading = above.degree(), above.LC()
    if above.all_coeffs() != [leading, *[0] * (degree - 1), -leading]:
        return None
    ratio = leading / below.LC()
    if below == sympy.Poly(E**degree + 1, E, domain="QQ_I") * below.LC():
        return _with_order(I * ratio, sympy.tan, degree * unit)
    if degree % 2 == 0 and below == sympy.Poly(E ** (degree // 2), E, domain="QQ_I") * below.LC():
        return _with_order(2 * I * ratio, sympy.sin, degree * unit)
    return None


def _with_order(factor: sympy.Expr, function: Any, share: Fraction) -> Form | None:
    """Return the form of ``factor · function(share α/2)``, whose order is 1/share."""
    factor = sympy.expand(factor)
    known = share.numerator == 1 and _is_positive_rational(factor)
    return (_fraction(factor), function, share.denominator) if known else None


def _is_positive_rational(value: sympy.Expr) -> bool:
    return bool(value.is_Rational and value > 0)


def _fraction(value: sympy.Rational) -> Fraction:
    return Fraction(int(value.p), int(value.q))
