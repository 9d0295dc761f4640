"""Explanation of one kernel function of a chart: formula, theorems, programs with operations, places of the text.

Theorems prove the formula. Validation (:mod:`derive.codegen.validation`) executes the kernel's text on disk and
compares it with the formula, exactly on symbols or to 50 digits at seeded random screws.
"""

from __future__ import annotations

import importlib.util
import inspect
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal, NamedTuple

from ..codegen.rows import Function
from ..codegen.signatures import PUBLIC, geometry, lower_chart
from ..codegen.targets.python import formulas_of
from ..maps.chart import Chart
from ..proof import Proof, theorems
from ..proof.phi_theorems import any_phi


class Coverage(NamedTuple):
    """Validation of one kernel function, names of the theorems behind its formula, and the part without a theorem.

    Validation compares the emitted function with its formula. "text" means constants, for functions without arguments.
    """

    validation: Literal["exact", "50 digits", "text"]
    theorems: tuple[str, ...]
    only_validated: str = ""


_SLOPES = ("slopes of the tangent operators", "second slopes of the tangent operators")
_PRODUCT = ("twist of a product", "twist", "rates of v")
_SMALL = ("exponential of a quaternion", "composition", "quaternion")
_BRANCHES = "the choice of axis, of sign and of the branch among the angles of one screw; half turns and translations"

_BRANCH = "the branch nearest v"
_PRINCIPAL = "the principal v of the product quaternion"
_SHADOW = ("shadow, even branch", "shadow, odd branch")

_NAMED: Mapping[str, Coverage] = {
    "quaternion": Coverage("exact", ("quaternion", "screw")),
    "tensor": Coverage("exact", ("tensor", "orthogonality", "screw", "exponential")),
    "pose": Coverage("exact", ("pose", "orthogonality")),
    "transform_point transform_line": Coverage("exact", ("pose", "line")),
    "inverse": Coverage("exact", ("orthogonality", "quaternion")),
    "tangent dcay": Coverage("exact", ("tangent", "twist", "axis", "determinant")),
    "tangent_inv dcay_inv": Coverage("exact", ("tangent_inv", "inverse", "rates of v")),
    "body_tangent": Coverage("exact", ("body twist", "axis", "determinant")),
    "body_tangent_inv": Coverage("exact", ("rates of v", "inverse")),
    "twist": Coverage("exact", ("twist", "quaternion rate")),
    "body_twist": Coverage("exact", ("body twist", "quaternion rate")),
    "rate": Coverage("exact", ("rates of v", "inverse")),
    "body_rate": Coverage("exact", ("rates of v", "body twist")),
    "tangent_dot body_tangent_dot twist_dot body_twist_dot": Coverage(
        "exact", (*_SLOPES, "rate of the tangent operator", "structure equation")
    ),
    "rate_dot body_rate_dot": Coverage("exact", (*_SLOPES, "rate of the inverse operator")),
    "twist_jacobian body_twist_jacobian cotangent_jacobian body_cotangent_jacobian": Coverage(
        "exact", (*_SLOPES, "Jacobian of the twist", "structure equation", "structure equation in the body")
    ),
    "rate_jacobian body_rate_jacobian": Coverage("exact", (*_SLOPES, "Jacobian of the rate")),
    "transition": Coverage("exact", ("transition, space twist given", "Jacobian of the rate", "inverse")),
    "body_transition": Coverage("exact", ("transition, body twist given", "Jacobian of the rate", "inverse")),
    "cotangent body_cotangent": Coverage("exact", ("tangent", "body twist")),
    "from_quaternion from_tensor": Coverage("50 digits", ("screw", "multiples of an angle"), _BRANCHES),
    "from_pose": Coverage("50 digits", ("screw", "multiples of an angle", "pose"), _BRANCHES),
    "from_screw": Coverage("50 digits", ("screw",), "tan of a dual angle"),
    "to_screw": Coverage("50 digits", ("screw", "pose"), _BRANCHES),
    "angle to_exponential": Coverage("50 digits", ("screw", "axis"), "the angle of a length"),
    "from_exponential": Coverage("50 digits", ("screw",), "tan of a dual angle, whole turns beyond the edge"),
    "shadow": Coverage("50 digits", ("Moebius step", *_SHADOW), "the axis and its sign"),
    "shadow_jacobian": Coverage("50 digits", (*_SHADOW, "axis", "rates of v"), "the axis and its sign"),
    "principal": Coverage("50 digits", _SHADOW, _BRANCHES),
    "adjoint": Coverage("exact", ("tensor", "pose", "line")),
    "transform_point_jacobians": Coverage("exact", ("pose", "line", "twist")),
    "transform_line_jacobians": Coverage("exact", ("line", "twist")),
    "between": Coverage("50 digits", ("composition", "quaternion"), _PRINCIPAL),
    "retract body_retract": Coverage("50 digits", _SMALL, _BRANCH),
    "retract_jacobians body_retract_jacobians": Coverage("50 digits", (*_SMALL, *_PRODUCT), _BRANCH),
    "local body_local": Coverage("50 digits", _SMALL, "the principal angle"),
    "local_jacobians body_local_jacobians": Coverage("50 digits", (*_SMALL, *_PRODUCT), "the principal angle"),
    "interpolate": Coverage("50 digits", _SMALL, "the shorter way, and the branch that is followed from v1"),
    "compose_jacobians between_jacobians": Coverage("50 digits", _PRODUCT, _PRINCIPAL),
    "compose": Coverage("50 digits", ("composition", "quaternion"), _PRINCIPAL),
    "singular_angles": Coverage("text", ("determinant", "multiples of an angle")),
}
"""Coverage by names of kernel functions."""

ROWS = {tuple(names.split()): covered for names, covered in _NAMED.items()}
"""Coverage by the functions that share it."""

COVERAGE = {name: covered for names, covered in ROWS.items() for name in names}
"""Coverage by kernel function."""


SLOPES = {"slopes of the tangent operators": "slopes", "second slopes of the tangent operators": "second slopes"}
"""Theorems on every φ by name of the theorem for every n, where the names differ by more than ``any phi:``."""


@dataclass(frozen=True)
class Explanation:
    """Explanation of a kernel function; its text has a line for each fact."""

    function: str
    chart: Chart
    formula: str  # contract of the geometry program, which all charts share
    scalars: Mapping[str, str] = field(hash=False)  # formulas of the scalar programs that it calls, by name
    theorems: tuple[Proof, ...]
    validation: str  # how the text on disk is compared with the formula
    operations: Mapping[str, Counter[str]] = field(hash=False)  # of the geometry and the scalar programs, by name
    total: int  # operations of a call; a scalar program counts as often as it is called
    places: tuple[str, ...]  # files and lines of the recipe and of the generated text

    def __repr__(self) -> str:
        return "\n".join(self._lines())

    def _lines(self) -> Iterator[str]:
        yield f"{self.function} of {self.chart.name}, v = {self.chart.parameter} u"
        yield f"formula      {self.formula}"
        yield from (f"  {name:<10} {text}" for name, text in self.scalars.items())
        yield from (f"theorem      {proof.name} [{proof.scope}]: {proof.statement}" for proof in self.theorems)
        yield f"validation   {self.validation}"
        for name, counted in self.operations.items():
            yield f"program      {name}: {', '.join(f'{n} {op}' for op, n in sorted(counted.items())) or 'calls only'}"
        yield f"in all       {self.total} operations"
        yield from (f"text         {place}" for place in self.places)


def explain(chart: Chart, function: str) -> Explanation:
    """Explain one kernel function of a chart: its formula, theorems, programs and where its text stands.

    Parameters
    ----------
    chart : Chart
        Chart such as ``derive.Cayley(7)``, with a number as its order.
    function : str
        Name of a function of the chart's module, such as ``"pose"`` or ``"dcay"``.

    Returns
    -------
    Explanation
        Its text shows one fact a line. Attributes: ``formula``, ``scalars``, ``theorems``, ``validation``,
        ``operations``, ``total``, ``places``.

    Raises
    ------
    ValueError
        If the module has no such function, or the chart has no kernels.

    Examples
    --------
    >>> import derive
    >>> found = derive.explain(derive.Cayley(3), "pose")
    >>> found.formula
    'Homogeneous matrix [[Q, ρ], [0, 1]] of R = Q + ε skew(ρ) Q, CP23 (16), (57).'
    >>> found.operations["pose_scalars"]["div"]
    1
    """
    row = next((row for row in PUBLIC.values() if function in (row.name, *row.aliases_in(chart))), None)
    if row is None:
        raise ValueError(f"a function is one of {', '.join(PUBLIC)}, got {function!r}")
    if not isinstance(chart.order, int):
        raise ValueError(f"kernels have a number as order n, got {chart.order}: put one in its place, by subs")
    chart.require_kernels()
    kernel, scalars, covered = geometry()[row.kernel], lower_chart(chart).scalars, COVERAGE[row.name]
    calls = [call.function for call in kernel.calls if call.function in scalars]  # n = 1 has no other branch to turn to
    called = list(dict.fromkeys(calls))
    return Explanation(
        row.name, chart, PUBLIC[row.kernel].traced().contract,
        scalars={name: "; ".join(formulas_of(name, chart)) for name in called},
        theorems=_rests_on(chart, row),
        validation="; validated only: ".join(filter(None, (covered.validation, covered.only_validated))),
        operations={row.kernel: kernel.operations, **{name: scalars[name].operations for name in called}},
        total=kernel.operations.total() + sum(scalars[name].operations.total() for name in calls),
        places=tuple(_places(chart, row, called)),
    )  # fmt: skip


def _rests_on(chart: Chart, row: Function) -> tuple[Proof, ...]:
    """Return the theorems for every n behind a function of a Cayley map, or those for every φ."""
    wanted = COVERAGE[row.name].theorems
    if not chart.cayley:
        wanted = tuple(f"any phi: {SLOPES.get(name, name)}" for name in wanted)
    return tuple(proof for proof in (theorems() if chart.cayley else any_phi()) if proof.name in wanted)


def _places(chart: Chart, row: Function, called: list[str]) -> Iterator[str]:
    """Yield file and line of the recipe, of the public function and of the programs that it runs."""
    recipe = PUBLIC[row.kernel].recipe
    assert recipe is not None
    file, line = recipe.__module__.replace(".", "/"), inspect.getsourcelines(recipe)[1]
    yield f"{file}.py:{line}  recipe {recipe.__name__}"
    package = importlib.util.find_spec("dualcay")
    folder = Path(package.origin).parent if package and package.origin else Path()
    module = (chart.base or chart).name  # a multiple runs the programs of its base chart
    for file, names in (("_interface", [row.name]), ("_geometry", [row.kernel]), (module, [f"_{c}" for c in called])):
        text = folder / f"{file}.py"
        lines = text.read_text(encoding="utf-8").splitlines() if text.exists() else []
        for name in names:
            place = next((i for i, line in enumerate(lines, 1) if line.strip().startswith(f"def {name}(")), None)
            written = f":{place}  {name}" if place else f"  {name}, by dualcay generate {' '.join(chart.selection)}"
            yield f"dualcay/{file}.py{written}"
