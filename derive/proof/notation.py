r"""Symbols and operators of statements, as SymPy expressions, and their printers.

Symbols of vectors, tensors and quaternions do not commute, so a product keeps its order. Operators are applied to
symbols: ``transpose(R)``, ``rate(R)`` (derivative along a motion), ``prime(p)`` (d/dx). Their values are defined in
:mod:`~derive.proof.evaluation`.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any, ClassVar

import sympy
from sympy.printing.latex import LatexPrinter
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter

from ..maps.polynomials import x as x

n, m = sympy.symbols("n m", integer=True, positive=True)
j = sympy.Symbol("j", integer=True)
X, r, alpha, theta, beta, gamma, i, epsilon = sympy.symbols("X r alpha theta beta gamma i epsilon")
p, q, p_m, q_m, p_k, q_k, c, d = sympy.symbols("p_n q_n p_m q_m p_k q_k c_n d_n")
p_sum, q_sum, p_double, q_double = sympy.symbols("p_{m+n} q_{m+n} p_{2n} q_{2n}")

TERMS = {
    p: ("p", n), q: ("q", n), c: ("c", n), d: ("d", n), p_m: ("p", m), q_m: ("q", m), p_sum: ("p", m + n),
    q_sum: ("q", m + n), p_double: ("p", 2 * n), q_double: ("q", 2 * n),
}  # fmt: skip
"""Sequence name and index of each term."""

INDICES = frozenset((n, m))


def structure(name: str) -> sympy.Symbol:
    """Return a noncommutative symbol for a vector, tensor or quaternion."""
    return sympy.Symbol(name, commutative=False)


I, v, v_dot, u, z, point, along = map(structure, ("I", "v", "velocity", "u", "z", "point", "along"))
R, R_k, Q, dcay, dcay_inv, q_hat = map(structure, ("R", "R(v_k)", "Q", "dcay_n", "dcay_n^-1", "qhat"))
omega, omega_body, omega_1, omega_2 = map(structure, ("omega", "omega_B", "omega_1", "omega_2"))
rho, vector, first, second, a = map(structure, ("rho", "vector", "vector_1", "vector_2", "a"))
b, b_1, b_2, sigma, sigma_1, sigma_2 = map(structure, ("b", "b_1", "b_2", "sigma", "sigma_1", "sigma_2"))
v_dual, V, R_dual = map(structure, ("v°", "V", "R(V)"))
twist_jacobian, twist_jacobian_b, body_jacobian = map(structure, ("J(a)", "J(b)", "J_B(a)"))
rate_jacobian, body_rate_jacobian, dcay_k, transport = map(structure, ("K(a)", "K_B(a)", "dcay_n(v_k)", "S_k"))
delta = structure("delta")
f, g, h, f_i, h_i, f_y, g_y, h_y, f_iy, h_iy = sympy.symbols("f g h f_i h_i f_y g_y h_y f_iy h_iy")
x_dual, p_dual, q_dual, r_k, r_jk = sympy.symbols("x(V) p_n(V) q_n(V) r_k r_{j+k}")
scalar, scalar_1, scalar_2 = sympy.symbols("scalar scalar_1 scalar_2")

TYPESET = {
    x: "x", q_hat: r"\hat q", dcay: r"\mathrm{dcay}_n", dcay_inv: r"\mathrm{dcay}_n^{-1}", omega_body: r"\omega_B",
    point: r"\mathbf r", along: r"\mathbf a", vector: r"\mathbf q", first: r"\mathbf q_1", second: r"\mathbf q_2",
    scalar: "q_0", scalar_1: "q_{0,1}", scalar_2: "q_{0,2}", R_k: "R(v_k)", R_dual: "R(V)", v_dual: r"v^\circ",
    x_dual: "x(V)", p_dual: "p_n(V)", q_dual: "q_n(V)", epsilon: r"\varepsilon", v_dot: r"\dot v",
    body_jacobian: "J_B(a)", structure("J_B(b)"): "J_B(b)", body_rate_jacobian: "K_B(a)",
    dcay_k: r"\mathrm{dcay}_n(v_k)", structure("dexp"): r"\mathrm{dexp}",
    **{sympy.Symbol(f"phi{mark}"): rf"{{\varphi{mark}}}" for mark in ("", "'", "''", "'''")},
    **{sympy.Symbol(f"{name}i"): f"{name}_i" for name in "fh"}, sympy.Symbol("psi'"): r"{\psi'}",
    **{sympy.Symbol(name): rf"\mathrm{{{name}}}" for name in ("share", "gain", "size")},
    sympy.Symbol("alpha_dot"): r"\dot\alpha", sympy.Symbol("size_dot"): r"\dot{\mathrm{size}}",
    sympy.Symbol("|vec(e)|^2"): r"|\mathrm{vec}(e)|^2",
}  # fmt: skip
"""LaTeX of symbols that SymPy cannot typeset from their names."""

FUNCTIONS = {sympy.Symbol(f"{name}(alpha/2)"): getattr(sympy, name)(alpha / 2) for name in ("sin", "cos")}
"""Functions for which symbols stand."""


class Operator(sympy.Function):  # type: ignore[misc]  # SymPy is untyped
    """Operator applied to symbols; subclasses define its formats as text and as LaTeX."""

    text: ClassVar[str]
    typeset: ClassVar[str]

    def _sympystr(self, printer: StrPrinter) -> str:
        return self._printed(printer, self.text)

    def _latex(self, printer: LatexPrinter, exp: str | None = None) -> str:
        body = self._printed(printer, self.typeset)
        if exp is None:
            return body
        return rf"\left({body}\right)^{{{exp}}}" if isinstance(self, prime) else f"{{{body}}}^{{{exp}}}"

    def _printed(self, printer: Any, template: str) -> str:
        return template.format(*(self._bracketed(printer, template, place) for place in range(len(self.args))))

    def _bracketed(self, printer: Any, template: str, place: int) -> str:
        """Return a printed argument, in brackets if it is a compound expression and the template has none."""
        argument, printed = self.args[place], str(printer._print(self.args[place]))
        bare = f"({{{place}}}" not in template and f"{{{place}}})" not in template
        composed = not argument.is_Symbol or "^" in argument.name
        return f"({printed})" if bare and composed else printed


def _operator(name: str, text: str, typeset: str, **attributes: Any) -> Any:
    return type(name, (Operator,), {"text": text, "typeset": typeset, "__module__": __name__, **attributes})


transpose = _operator("transpose", "{0}^T", "{{{0}}}^T")
conjugate = _operator("conjugate", "conj({0})", "{{{0}}}^*")
skew = _operator("skew", "skew({0})", r"\tilde{{{0}}}")
vect = _operator("vect", "vect({0})", r"\mathrm{{vect}}({0})")
rate = _operator("rate", "{0}'", r"\dot{{{0}}}")
cross = _operator("cross", "{0} x {1}", r"{0} \times {1}")
dyad = _operator("dyad", "{0}(x){1}", r"{0} \otimes {1}")
sandwich = _operator("sandwich", "Delta({0})", r"\Delta({0})")
first_order = _operator("first_order", "compose_1({0}, {1})", r"\mathrm{{compose}}_1({0}, {1})")
second_order = _operator("second_order", "compose_2({0}, {1})", r"\mathrm{{compose}}_2({0}, {1})")
real, dual = _operator("real", "Re({0})", r"\mathrm{{Re}}({0})"), _operator("dual", "Du({0})", r"\mathrm{{Du}}({0})")
exponential = _operator("exponential", "exp({0})", r"\exp({0})")
det = _operator("det", "det({0})", r"\det {0}", is_commutative=True)
norm2 = _operator("norm2", "|{0}|^2", r"|{0}|^2", is_commutative=True)
below = _operator("below", "denominator of {0}", r"\mathrm{{den}}({0})", is_commutative=True)
dot = _operator("dot", "{0}.{1}", r"{0} \cdot {1}", is_commutative=True)
prime = _operator("prime", "d/dx {0}", r"\frac{{d}}{{dx}} {0}", is_commutative=True)


class Shifted(sympy.Function):  # type: ignore[misc]
    """Term of a sequence at another index, or function at another value: ``Shifted(u, n, n + 1)``."""

    def _eval_is_commutative(self) -> bool:
        return bool(self.args[0].is_commutative)

    def _sympystr(self, printer: StrPrinter) -> str:
        return "[{}]({} -> {})".format(*map(printer._print, self.args))

    def _latex(self, printer: LatexPrinter) -> str:
        return r"\left[{}\right]_{{{} \to {}}}".format(*map(printer._print, self.args))


class _Text(StrPrinter):  # type: ignore[misc]
    """Plain text: ``^`` for powers, one fraction bar for all negative exponents, ascending powers."""

    def _print_Mul(self, expr: sympy.Expr) -> str:
        sign, expr = ("-", -expr) if expr.could_extract_minus_sign() else ("", expr)
        above, below = sympy.fraction(expr)
        if below == 1:
            printed = super()._print_Mul(expr) if expr.is_Mul else self.parenthesize(expr, PRECEDENCE["Mul"])
        else:
            over = self.parenthesize(above, PRECEDENCE["Mul"], strict=True)
            printed = f"{over}/{self.parenthesize(below, PRECEDENCE['Pow'], strict=True)}"
        return f"{sign}{printed}"

    def _print_Sum(self, expr: sympy.Expr) -> str:
        ((index, first, _),) = expr.limits
        return f"sum over {index} >= {first} of {self.parenthesize(expr.function, PRECEDENCE['Mul'], strict=True)}"

    def _print_binomial(self, expr: sympy.Expr) -> str:
        return "C({}, {})".format(*map(self._print, expr.args))

    def _print_Pow(self, expr: sympy.Expr, rational: bool = False) -> str:
        if expr.exp.is_negative:
            return f"1/{self.parenthesize(1 / expr, PRECEDENCE['Pow'], strict=True)}"
        base, exponent = (self.parenthesize(part, PRECEDENCE["Pow"]) for part in expr.args)
        return f"({base})^{exponent}" if isinstance(expr.base, prime) else f"{base}^{exponent}"


class _Typeset(LatexPrinter):  # type: ignore[misc]
    """LaTeX with one fraction bar for all negative exponents, the project's symbols, ascending powers."""

    def _print_Symbol(self, expr: sympy.Symbol, style: str = "plain") -> str:
        if "." in expr.name:  # a name in the code
            return rf"\mathtt{{{expr.name.replace('_', chr(92) + '_')}}}"
        return str(TYPESET.get(expr) or super()._print_Symbol(expr, style))

    def _needs_mul_brackets(self, expr: sympy.Expr, first: bool = False, last: bool = False) -> bool:
        """Put a product of vectors in brackets when it is a factor."""
        return isinstance(expr, (dot, cross)) or bool(super()._needs_mul_brackets(expr, first, last))

    def _print_Mul(self, expr: sympy.Expr) -> str:
        above, below = sympy.fraction(expr)
        if below == 1 or expr.is_Rational:
            return str(super()._print_Mul(expr))
        return rf"\frac{{{self._print(above)}}}{{{self._print(below)}}}"


@lru_cache(maxsize=4096)  # theorems print the same equation for each premise
def text(expression: sympy.Expr) -> str:
    return str(_Text({"order": "rev-lex"}).doprint(expression))


def latex(expression: sympy.Expr) -> str:
    """Return an expression as LaTeX, without delimiters."""
    return str(_Typeset({"order": "rev-lex"}).doprint(expression.xreplace(FUNCTIONS)))
