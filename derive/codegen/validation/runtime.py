"""Execution of run-time parts that are written by hand, on a few cases with independent values.

A check yields cases: the function with its case, the result, and the expected value. Derivatives are compared with
differences of validated kernels. `motions` has the checks of the NumPy target. SciPy is a stand-in.
"""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace
from typing import Any, TypeAlias

import mpmath
import numpy as np
from numpy.typing import NDArray

from ...maps.chart import Chart
from ..lowering.scalar_programs import SCALARS
from ..rows import Table
from ..signatures import POSES, ROTATIONS, SIDES
from .batches import ValidationFailed
from .decimals import EXACT_DIGITS, Decimal
from .loading import loaded, module_of
from .stand_ins import standing_in

Array: TypeAlias = NDArray[Any]

STEP = 2.0**-16  # step of central differences; their error is about its square
TOLERANCE = 1e-6  # largest difference of a result from its expected value, relative to the largest component or 1
FAR, NEAR = (0.5, -0.6, 0.4, 0.3, 2.0, -1.0), (0.02, 0.05, -0.01, 0.3, -0.2, 0.1)
"""Two vectors; in charts of order 3 to 8 the first is beyond the principal branch, the second within it."""

RATES = (0.3, 0.1, -0.4, 1.0, 0.5, -0.2), (-0.2, 0.6, 0.3, 0.1, -0.7, 0.4)
OFF = 0.125  # change of a component of an argument that ``check`` must refuse
UNCHECKED = {"from_pose": (3, 7, 11)}  # components with any value, by function: the translation of a pose


@dataclass(frozen=True)
class Loaded:
    """Imported package and the chart whose modules are called; ``exact`` arguments have 50 digits."""

    package: str
    chart: Chart
    exact: bool

    def part(self, name: str) -> Any:
        return importlib.import_module(f"{self.package}.{name}")

    def module(self, table: Table = POSES) -> Any:
        return module_of(self.package, self.chart, table)

    def array(self, values: Any) -> Array:
        """Return an array of floats, or of the same numbers with 50 digits."""
        floats = np.asarray(values, float)
        return np.vectorize(lambda c: Decimal(Fraction(c)), otypes=[object])(floats) if self.exact else floats


Case = tuple[str, Any, Any]
Check = Callable[[Loaded], Iterator[Case]]


def check(folder: Path, chart: Chart, checks: Sequence[Check], exact: bool = False) -> int:
    """Run checks on a package; return the number of results that agree. `ValidationFailed` names function and case."""
    count = 0
    with loaded(folder) as name, standing_in(), mpmath.workdps(EXACT_DIGITS), np.errstate(all="ignore"):
        for each in checks:
            cases, case = each(Loaded(name, chart, exact)), f"first case of {each.__name__}"
            try:
                for case, found, expected in cases:
                    _compare(case, found, expected)
                    count += 1
            except (ArithmeticError, AttributeError, LookupError, NameError, TypeError, ValueError) as error:
                raise ValidationFailed(f"run-time parts, {each.__name__}, after {case}: {error!r}") from error
    return count


def _compare(case: str, found: Any, expected: Any) -> None:
    got, wanted = (np.asarray(value) for value in (found, expected))
    if got.shape != wanted.shape:
        raise ValidationFailed(f"run-time parts, {case}: shape {got.shape}, expected {wanted.shape}")
    got, wanted = (np.array([float(getattr(c, "value", c)) for c in value.flat]) for value in (got, wanted))
    bound = TOLERANCE * max(1, *abs(wanted[np.isfinite(wanted)]))
    off = np.flatnonzero(~((abs(got - wanted) <= bound) | np.isnan(got) & np.isnan(wanted)))
    if off.size:
        i = off[0]
        raise ValidationFailed(f"run-time parts, {case}, component {i}: {got[i]:.9g} is not {wanted[i]:.9g}")


def differences(function: Callable[[Array], Array], v: Array) -> Array:
    """Return the derivative of a function by v, one column for each component, by central differences."""
    step: Any = Fraction(STEP) if v.dtype == object else STEP
    steps = step * np.eye(v.shape[-1], dtype=v.dtype)
    return np.stack([(function(v + h) - function(v - h)) / (2 * step) for h in steps], axis=-1)


def times(matrix: Array, vector: Array) -> Array:
    """Return the products of matrices and vectors over batches."""
    product: Array = (matrix @ vector[..., None])[..., 0]
    return product


def tools(at: Loaded) -> Iterator[Case]:
    """Cases of ``switch``, ``convert``, ``convert_jacobian`` and ``matrix6``."""
    _tools = at.part("_tools")
    for table in (POSES, ROTATIONS):
        module, n = at.module(table), 6 if table is POSES else 3
        v, v_dot = (at.array([[row[:n] for row in rows]]) for rows in ((FAR, NEAR), RATES))
        spread = at.array(np.diag(np.arange(1.0, n + 1)) + np.ones((n, n)))
        J = differences(module.principal, v)
        expected = module.principal(v), times(J, v_dot), J @ spread @ J.swapaxes(-1, -2)
        given = v, v_dot, np.broadcast_to(spread, J.shape)
        found = module.switch(*given)
        columns = module.switch(*(_components_first(array, 2) for array in given), axis=0)
        for name, one, other, wanted in zip(("vector", "rate", "covariance"), found, columns, expected, strict=True):
            yield f"switch of {n} components: {name}", one, wanted
            yield f"switch of {n} components: {name}, axis 0", other, _components_first(wanted, 2)
        other, moved = _doubled_shadow(module), 2 * module.shadow(v)
        yield f"convert of {n} components", _tools.convert(v, module, other), moved
        J = differences(lambda v, module=module: 2 * module.shadow(v), v)  # type: ignore[misc]
        yield f"convert_jacobian of {n} components", _tools.convert_jacobian(v, module, other), J
        columns = _tools.convert_jacobian(_components_first(v, 2), module, other, axis=0)
        yield f"convert_jacobian of {n} components, axis 0", columns, _components_first(J, 2)
    module = at.module()
    v, v_dot = at.array(FAR), at.array(RATES[0])
    yield "matrix6 of the tangent operator", times(_tools.matrix6(module.tangent(v)), v_dot), module.twist(v, v_dot)


def _components_first(array: Array, leading: int) -> Array:
    return np.moveaxis(array, range(leading), range(-leading, 0))


def _doubled_shadow(module: Any) -> Any:
    """Return a chart module whose vector is twice the shadow of a module's vector."""

    def from_exponential(w: Any, axis: int = -1, **options: Any) -> Any:
        return 2 * module.shadow(module.from_exponential(w, axis=axis), axis=axis)

    return SimpleNamespace(
        from_exponential=from_exponential,
        from_quaternion=lambda q, axis=-1: 2 * module.shadow(module.from_quaternion(q, axis=axis), axis=axis),
        local=lambda w2, w1, axis=-1: module.local(w2 / 2, w1 / 2, axis=axis),
        retract=lambda w, delta, axis=-1, **_: 2 * module.retract(w / 2, delta, axis=axis),
        twist=lambda w, rate, axis=-1: module.twist(w / 2, rate / 2, axis=axis),
        rate=lambda w, omega, axis=-1: 2 * module.rate(w / 2, omega, axis=axis),
    )


def laws(at: Loaded) -> Iterator[Case]:
    """Cases of ``check``: valid arguments pass, and a change of any component is refused, unless it is allowed."""
    for table in (POSES, ROTATIONS):
        module, screw = at.module(table), "screw" if table is POSES else "angle_axis"
        v = at.array(NEAR[: 6 if table is POSES else 3])
        names = ["quaternion", "tensor", *(["pose"] if table is POSES else []), screw]
        for name in names:
            found = getattr(module, f"to_{screw}" if name == screw else name)(v)
            *first, given = found if name == screw else (found,)
            function, steps = getattr(module, f"from_{name}"), OFF * np.eye(given.size).reshape(-1, *given.shape)
            yield f"from_{name} with check", function(*first, given, check=True), v
            refused = [_refused(True, function, *first, given + at.array(step)) for step in steps]
            wanted = [place not in UNCHECKED.get(f"from_{name}", ()) for place in range(given.size)]
            yield f"from_{name} with check: refused components", refused, wanted
            limits = [_refused(limit, function, *first, given + at.array(steps[0])) for limit in (OFF / 50, 50 * OFF)]
            yield f"from_{name} with check: a number", limits, [True, False]


def _refused(check: bool | float, function: Callable[..., Any], *given: Any) -> bool:
    try:
        function(*given, check=check)
    except ValueError:
        return True
    return False


RULED = {
    **dict.fromkeys(
        ("compose", "between", "retract", "body_retract", "local", "body_local", "interpolate", "to_exponential",
         "from_exponential"), ((),),
    ),
    "twist": (SIDES["SPACE"], SIDES["BODY"]), "rate": (SIDES["SPACE_INV"], SIDES["BODY_INV"]),
}  # fmt: skip
"""Kernels with a rule of differentiation, and tables that they take; turns are those of a chart."""


def steps(at: Loaded) -> Iterator[Case]:
    """Cases of the scalars of exp(δ) beside the rules: values and slopes, errors times 10¹⁶."""
    programs, m = at.part("_slopes").STEPS.scalars, at.part("_libraries").Objects(np, np.empty(0, object))
    formulas: dict[str, Callable[[Any], Any]] = {
        "f": lambda x: mpmath.sinc(mpmath.sqrt(x)),
        "g": lambda x: mpmath.sinc(mpmath.sqrt(x) / 2) ** 2 / 2,
        "h": lambda x: (1 - mpmath.sinc(mpmath.sqrt(x))) / x,
        "rate": lambda x: mpmath.mpf(1),
        "fi": lambda x: mpmath.sqrt(x) * mpmath.cot(mpmath.sqrt(x) / 2),
        "hi": lambda x: (2 - mpmath.sqrt(x) * mpmath.cot(mpmath.sqrt(x) / 2)) / x,
    }
    for x in map(mpmath.mpf, (1, 5, 8, 20, 60)):
        for name, program in vars(programs).items():
            row = SCALARS[name]
            shares = [mpmath.mpf(share) for share in ((0.5, 0.375, 0.125) if len(row.arguments) == 3 else (1,))]
            found = program(m, *(Decimal(x * share) for share in shares))
            values = [2 ** (k := r.count("y")) * mpmath.diff(formulas[r.rstrip("y")], x, k) for r in row.results]
            errors = [(Decimal(1) * a - Decimal(b)) * 10**16 for a, b in zip(found, values, strict=True)]
            yield f"{name} of exp(δ) at x = {x}", errors, np.zeros(len(errors))


def rules(at: Loaded) -> Iterator[Case]:
    """Cases of the rules of differentiation: derivatives of a kernel along the rates of its arguments."""
    rules, call = at.part("_rules"), at.part("_chart").Call
    for table in (POSES, ROTATIONS):
        chart, n = at.module(table).CHART, 6 if table is POSES else 3
        for name, tables in {**RULED, "turn": chart.turns[-1:], "shadow": chart.turns[-1:]}.items():
            arguments = chart.kernels[name].arguments[: 1 if name in ("turn", "shadow") else None]
            values, rates = (
                [np.array(row[: math.prod(shape)]).reshape(shape) for row, (_, shape) in zip(rows, arguments)]
                for rows in ((NEAR, RATES[0], (0.375,)), (*RATES, (0.25,)))
            )
            for given in tables:
                asked = call(chart, name, arguments[: len(values)], given)
                slope = rules.slope_of(asked, rules.value_of(asked, *values), values, rates)
                steps = ([v + s * rate for v, rate in zip(values, rates)] for s in (STEP, -STEP))
                ahead, back = (rules.value_of(asked, *moved) for moved in steps)
                yield f"rule of {name} of {n} components", slope, (ahead - back) / (2 * STEP)
