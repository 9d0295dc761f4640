"""Theorems on rotation and motion for every order: tensor, quaternion, tangent operators.

Everything is decided by components over the differential field Q(n, x)(p, q), for a generic vector v: a rate v' is any
combination of the three basis directions, in which all statements are linear.
Both sides of an equation carry the same factor, a non-zero element that clears the denominators.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ..algebra import Coefficient, Quaternion, Tensor, Vector
from .differential_field import Formulas, Setting
from .identity import Check, Claim, Proof, decide

FIELD = "residues of all components in the differential field Q(n, x)(p, q)"
BASIS = (Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1))
Checks = Callable[[Formulas], Iterator[Check]]


def _orthogonal(formulas: Formulas) -> Iterator[Check]:
    at = Setting()
    power = at.power
    rotation = at.isotropic(formulas.tensor(*at.symbols), power)
    yield from at.entries("R R^T - I", rotation @ rotation.transpose - Tensor.identity() * power**2)
    yield "det R - 1", at.residue(rotation.det() - power**3)


def _unit_quaternion(formulas: Formulas) -> Iterator[Check]:
    at = Setting()
    z = Quaternion(at.p, at.v * at.q)  # q̂ (1+x)^(n/2); the root drops out of every statement
    product = z * z.conjugate()
    yield "z z* - (1+x)^n, scalar part", at.residue(product.scalar - at.power)
    yield from at.entries("z z*, vector part", product.vector)
    rotation = at.isotropic(formulas.tensor(*at.symbols), at.power)
    for j, basis in enumerate(BASIS):
        yield from at.entries(f"z e{j + 1} z* - (1+x)^n R e{j + 1}", z.sandwich(basis) - rotation @ basis)


def _exponential(formulas: Formulas) -> Iterator[Check]:
    at = Setting(square="1")  # v = X u with a fixed unit vector u; X = tan(alpha/2n), dX/dalpha = (1+X^2)/2n
    n, x, p, q = at.symbols
    X, u = at.variable, at.v
    rate = (1 + x) / (2 * n)
    a, b, c = formulas.tensor(n, x, p, q)
    coefficients = a, X * b, x * c
    slopes = tuple(rate * at.slope(coefficient) for coefficient in coefficients)
    factor = at.power**2
    difference = at.isotropic(slopes, factor) - Tensor.skew(u) @ at.isotropic(coefficients, factor)
    yield from at.entries("dR/dalpha - skew(u) R", difference)
    start = formulas.tensor(n, at.zero, at.one, n)
    yield "R = I at alpha = 0", at.residue(start[0] - 1)  # b and c come with the factors X and x = 0
    # q̂ = cos(alpha/2) + u sin(alpha/2), with (1+x)^(n/2) divided out: its logarithmic derivative is n X/(1+x)
    cosine, sine = p, X * q
    growth = n * X / (1 + x)
    yield "d cos(alpha/2)/dalpha", at.residue(rate * (at.slope(cosine) - growth * cosine) + sine / 2)
    yield "d sin(alpha/2)/dalpha", at.residue(rate * (at.slope(sine) - growth * sine) - cosine / 2)


def _twist(formulas: Formulas) -> Iterator[Check]:
    at = Setting()
    # the rate of the factor that makes R polynomial goes with R R^T, which is symmetric: it drops out of vect
    rotation = at.isotropic(formulas.tensor(*at.symbols), at.power)
    slopes = 2 * at.x * (1 + at.x)  # clears the denominators of p' and q'
    tangent = at.isotropic(formulas.tangent(*at.symbols), slopes * at.power**2)
    for j, (basis, rate) in enumerate(zip(BASIS, at.rates(rotation, slopes), strict=True)):
        yield from at.entries(f"vect(R' R^T) - dcay e{j + 1}", (rate @ rotation.transpose).vect() - tangent @ basis)


def _quaternion_rate(formulas: Formulas) -> Iterator[Check]:
    at = Setting()
    z = Quaternion(at.p, at.v * at.q)
    slopes = 2 * at.x * (1 + at.x)
    tangent = at.isotropic(formulas.tangent(*at.symbols), slopes * at.power)
    for j, (basis, rate) in enumerate(zip(BASIS, at.rates(z, slopes), strict=True)):
        growth = at.n * at.components[j] / (1 + at.x)  # logarithmic derivative of (1+x)^(n/2)
        twist = (rate - z * (growth * slopes)) * z.conjugate() * 2
        yield f"2 q' q*, scalar part, v' = e{j + 1}", at.residue(twist.scalar)
        yield from at.entries(f"2 q' q* - dcay e{j + 1}", twist.vector - tangent @ basis)


def _body(formulas: Formulas) -> Iterator[Check]:
    at = Setting()
    rotation = at.isotropic(formulas.tensor(*at.symbols), at.power)
    tangent = at.isotropic(formulas.tangent(*at.symbols), _tangent_factor(at))
    difference = tangent.transpose * at.power - rotation.transpose @ tangent
    yield from at.entries("dcay^T - R^T dcay", difference)


def _inverse(formulas: Formulas) -> Iterator[Check]:
    at = Setting()
    factors = _tangent_factor(at), 2 * at.n * at.x * at.q
    tangent = at.isotropic(formulas.tangent(*at.symbols), factors[0])
    inverse = at.isotropic(formulas.tangent_inv(*at.symbols), factors[1])
    unit = Tensor.identity() * (factors[0] * factors[1])
    yield from at.entries("dcay dcay^-1 - I", tangent @ inverse - unit)
    yield from at.entries("dcay^-1 dcay - I", inverse @ tangent - unit)


def _axis(formulas: Formulas) -> Iterator[Check]:
    at = Setting()
    factor = _tangent_factor(at)
    tangent = at.isotropic(formulas.tangent(*at.symbols), factor)
    rate = at.v * (factor * 2 * at.n / (1 + at.x))
    yield from at.entries("dcay v - 2n/(1+x) v", tangent @ at.v - rate)
    yield from at.entries("dcay^T v - 2n/(1+x) v", tangent.transpose @ at.v - rate)


def _determinant(formulas: Formulas) -> Iterator[Check]:
    at = Setting()
    factor = _tangent_factor(at)
    tangent = at.isotropic(formulas.tangent(*at.symbols), factor)
    expected = 8 * at.n * at.q**2 / (at.power * (1 + at.x))
    yield "det dcay - 8n q^2/(1+x)^(n+1)", at.residue(tangent.det() - factor**3 * expected)


def _tangent_factor(at: Setting) -> Coefficient:
    """What clears the denominators of dcay."""
    return at.x * (1 + at.x) * at.power


MOTION: tuple[tuple[Claim, Checks], ...] = (
    (Claim("R R^T = I, det R = 1", r"R R^T = I,\; \det R = 1", FIELD, (13, 57, 73)), _orthogonal),
    (
        Claim(
            "q = (p_n + q_n v)/(1+x)^(n/2) has norm 1, and q r q* = R r",
            r"\hat q \hat q^* = 1,\; \hat q\, r\, \hat q^* = R r",
            FIELD,
            (24, 50, 55, 57),
        ),
        _unit_quaternion,
    ),
    (
        Claim(
            "R = exp(alpha skew(u)) and q = cos(alpha/2) + u sin(alpha/2) for v = tan(alpha/2n) u",
            r"R = e^{\alpha \tilde u},\; \hat q = \cos\tfrac\alpha2 + u \sin\tfrac\alpha2,"
            r"\; v = u \tan\tfrac{\alpha}{2n}",
            "linear differential equation in alpha and value at alpha = 0, residues in Q(n, X)(p, q)",
            (17, 23, 25, 48, 49),
        ),
        _exponential,
    ),
    (
        Claim(
            "omega = vect(R' R^T) = dcay v'",
            r"\omega = \mathrm{vect}(\dot R R^T) = \mathrm{dcay}\, \dot v",
            FIELD,
            (68, 70, 86, 88),
        ),
        _twist,
    ),
    (
        Claim("q' = omega q/2 with omega = dcay v'", r"\dot{\hat q} = \tfrac12 \omega \hat q", FIELD, (75, 86, 88)),
        _quaternion_rate,
    ),
    (
        Claim(
            "dcay^T = R^T dcay, so omega_B = dcay^T v'",
            r"\mathrm{dcay}^T = R^T \mathrm{dcay},\; \omega_B = \mathrm{dcay}^T \dot v",
            FIELD,
            (74, 86, 91),
        ),
        _body,
    ),
    (Claim("dcay dcay^-1 = I", r"\mathrm{dcay}\, \mathrm{dcay}^{-1} = I", FIELD, (87, 88, 89, 90)), _inverse),
    (
        Claim("dcay v = dcay^T v = 2n/(1+x) v", r"\mathrm{dcay}\, v = \tfrac{2n}{1+x} v", FIELD, (77,)),
        _axis,
    ),
    (
        Claim("det dcay = 8n q_n^2/(1+x)^(n+1)", r"\det \mathrm{dcay} = \frac{8 n q_n^2}{(1+x)^{n+1}}", FIELD),
        _determinant,
    ),
)


def motion_theorems(formulas: Formulas) -> tuple[Proof, ...]:
    """Decide, for every n, what is claimed of the given formulas."""

    def bound(checks: Checks) -> Callable[[], Iterator[Check]]:
        return lambda: checks(formulas)

    return tuple(decide(claim, bound(checks)) for claim, checks in MOTION)
