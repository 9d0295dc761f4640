"""Tables of kernel functions with one row each, the source of exports, prototypes, recipes and validation.

The programs of a proved chart follow: geometry programs that all charts share, and the chart's own scalar programs.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache, lru_cache, partial

from ..maps.chart import Chart
from ..proof import Proved
from .lowering import calculus, forward, inverse, retraction, shadows
from .lowering.point import Recipe
from .lowering.scalar_programs import scalar_programs
from .programs.program import Program
from .programs.trace import written_out
from .rows import BY_TEXT, RULE, Array, Function, Table


def _array(name: str, shape: tuple[int, ...], *parts: int, real: tuple[int, ...] | None = None) -> Array:
    """Return an array whose parts have these sizes and follow each other."""
    return Array(name, shape, tuple(part for part, size in enumerate(parts) for _ in range(size)), real)


def _dual(name: str) -> Array:
    return _array(name, (6,), 3, 3, real=(3,))


def _tensor(name: str) -> Array:
    return _array(name, (2, 3, 3), 9, 9, real=(3, 3))


def _jacobian(name: str) -> Array:
    """Return the array of a dual tensor as a real matrix, [[Re, 0], [Du, Re]]."""
    return Array(name, (6, 6), (0,) * 18 + (1, 1, 1, 0, 0, 0) * 3, real=(3, 3))


V = replace(_dual("v"), vector=True)
OMEGA, V_DOT, LINE, SHADOW, MOVED, BACK = map(_dual, ("omega", "v_dot", "line", "v_k", "moved", "v_back"))
AXIS = replace(LINE, real_name="u")
OMEGA_DOT, V_DDOT, WRENCH, MOMENTUM = map(_dual, ("omega_dot", "v_ddot", "z", "tau"))
DELTA, MOVED_V, LOGARITHM = map(_dual, ("delta", "v_moved", "w"))
COVARIANCE = Array("covariance", (6, 6), (0, 0, 0, 1, 1, 1) * 3 + (1, 1, 1, 2, 2, 2) * 3, real=(3, 3))
SWITCHED = V_DOT.called("v_dot_k"), COVARIANCE.called("covariance_k")
TENSOR = _tensor("tensor")
JACOBIAN, BY_V, BY_LINE = map(_jacobian, ("jacobian", "by_v", "by_line"))
TWO, BY_TWO = (V.called("v2"), V.called("v1")), (_jacobian("by_v2"), _jacobian("by_v1"))
BY_STEP = BY_V, _jacobian("by_delta")
BY_V_OF_POINT = Array("by_v", (3, 6), (0, 0, 0, 1, 1, 1) * 3, real=(3, 3))
BY_POINT = _array("by_r", (3, 3), 9, real=(3, 3))
QUATERNION = _array("q", (8,), 4, 4, real=(4,))
POSE = _array("pose", (4, 4), 3, 1, 3, 1, 3, 1, 4)
POINT = _array("r", (3,), 3, real=(3,))
SHARE = _array("t", (), 1, real=())
ANGLE = _array("angle", (2,), 1, 1, real=())

SPACE, BODY = ("1",), ("-1",)
"""Side of T: 1 selects T (space), −1 its transpose (body). The constants of T⁻¹ are the side and half the side."""
SPACE_INV, BODY_INV = ("1", "0.5"), ("-1", "-0.5")
SIDES = {"SPACE": SPACE, "BODY": BODY, "SPACE_INV": SPACE_INV, "BODY_INV": BODY_INV}
"""Sides by their names in the run-time parts."""

CHECK, SCALAR_FIRST = "check", "scalar_first"
"""Keywords: ``check`` asks for valid arguments, ``scalar_first`` places the scalar of a quaternion."""


SMOOTH = f"{BY_TEXT}each step is a sum, a product or a quotient, and scalar programs have slopes"
CHOICES = f"{BY_TEXT}both arms of each choice have finite slopes, and no root is of 0"
OF_AXIS = f"{BY_TEXT}the axis has no derivative at rest, and no root is of 0 elsewhere"
"""Reasons why JAX and PyTorch differentiate the text of a function."""

_smooth = partial(Function, derivatives=SMOOTH)
"""Row of a function whose text JAX and PyTorch differentiate without loss at any v."""


_selecting = partial(Function, exact=False, real=True)
"""Row of a function that selects branches or angles."""

_by_exponential = partial(_selecting, remainder=retraction.EXPONENTIAL.remainder)
"""Row of a function whose value depends on the exponential's series."""


def _way_back(name: str, given: Array, recipe: Recipe, *keywords: str) -> Function:
    """Return the row of an inverse map, from a representation of a pose to v on a branch."""
    keywords = (CHECK, *keywords)
    return _selecting(name, (given,), (V,), recipe, CHOICES, branch=True, keywords=keywords)


def _both_frames(name: str, arguments: tuple[Array, ...], result: Array, recipe: Recipe) -> tuple[Function, Function]:
    """Return the rows of a function in space and in the body, which differ in the side of T."""
    return (
        _smooth(name, arguments, (result,), recipe, constants=SPACE),
        Function(f"body_{name}", arguments, (result,), None, constants=BODY, shares=name),
    )


_ROWS = (
    _smooth("quaternion", (V,), (QUATERNION,), forward.quaternion, keywords=(SCALAR_FIRST,)),
    _smooth("tensor", (V,), (TENSOR,), forward.tensor),
    _smooth("pose", (V,), (POSE,), forward.pose, rotation=None),
    _smooth("transform_point", (V, POINT), (POINT.called("moved"),), forward.transform_point),
    _smooth("transform_line", (V, LINE), (MOVED,), forward.transform_line, rotation=None),
    _smooth("inverse", (V,), (BACK,), forward.inverse),
    _smooth("tangent", (V,), (_tensor("tangent"),), calculus.tangent, aliases=("dcay",)),
    _smooth("tangent_inv", (V,), (_tensor("tangent"),), calculus.tangent_inv, aliases=("dcay_inv",)),
    _smooth("body_tangent", (V,), (_tensor("tangent"),), calculus.body_tangent),
    _smooth("body_tangent_inv", (V,), (_tensor("tangent"),), calculus.body_tangent_inv),
    Function("twist", (V, V_DOT), (OMEGA,), calculus.twist, RULE, constants=SPACE),
    Function("rate", (V, OMEGA), (V_DOT,), calculus.rate, RULE, constants=SPACE_INV),
    Function("body_twist", (V, V_DOT), (OMEGA,), None, constants=BODY, shares="twist"),
    Function("body_rate", (V, OMEGA), (V_DOT,), None, constants=BODY_INV, shares="rate"),
    *_both_frames("tangent_dot", (V, V_DOT), _tensor("tangent_dot"), calculus.tangent_dot),
    *_both_frames("twist_dot", (V, V_DOT, V_DDOT), OMEGA_DOT, calculus.twist_dot),
    *_both_frames("rate_dot", (V, OMEGA, OMEGA_DOT), V_DDOT, calculus.rate_dot),
    *_both_frames("twist_jacobian", (V, V_DOT), JACOBIAN, calculus.twist_jacobian),
    *_both_frames("rate_jacobian", (V, OMEGA), JACOBIAN, calculus.rate_jacobian),
    _smooth("transition", (V, V.called("v0")), (JACOBIAN,), inverse.transition, constants=BODY),
    Function("body_transition", (V, V.called("v0")), (JACOBIAN,), None, constants=SPACE, shares="transition"),
    Function("cotangent", (V, WRENCH), (MOMENTUM,), None, constants=BODY, shares="twist"),
    Function("body_cotangent", (V, WRENCH), (MOMENTUM,), None, constants=SPACE, shares="twist"),
    Function("cotangent_jacobian", (V, WRENCH), (JACOBIAN,), None, constants=BODY, shares="twist_jacobian"),
    Function("body_cotangent_jacobian", (V, WRENCH), (JACOBIAN,), None, constants=SPACE, shares="twist_jacobian"),
    _way_back("from_quaternion", QUATERNION, inverse.from_quaternion, SCALAR_FIRST),
    _way_back("from_tensor", _tensor("R"), inverse.from_tensor),
    replace(_way_back("from_pose", POSE.called("T"), inverse.from_pose), rotation=None),
    replace(
        _selecting("from_screw", (ANGLE, AXIS), (V,), shadows.from_screw, CHOICES, keywords=(CHECK,)),
        rotation="from_angle_axis",
    ),
    _selecting("to_screw", (V,), (ANGLE, AXIS), shadows.to_screw, OF_AXIS, rotation="to_angle_axis"),
    _selecting("angle", (V,), (ANGLE,), shadows.angle, OF_AXIS),
    _selecting("to_exponential", (V,), (LOGARITHM,), shadows.to_exponential, RULE),
    _selecting("from_exponential", (LOGARITHM,), (V,), shadows.from_exponential, RULE),
    _selecting("turn", (V,), (SHADOW,), shadows.turn, RULE, public=False),
    _selecting("shadow", (V,), (SHADOW,), shadows.shadow, RULE, branch=True),
    _selecting("stay", (V,), (SHADOW,), shadows.stay, SMOOTH, public=False),
    _selecting("identity_jacobian", (V,), (JACOBIAN,), shadows.identity_jacobian, SMOOTH, public=False),
    replace(
        _selecting("shadow_jacobian", (V,), (JACOBIAN,), shadows.shadow_jacobian, OF_AXIS, branch=True),
        at_rest="identity_jacobian",
    ),
    replace(_selecting("principal", (V,), (SHADOW,), shadows.principal, RULE), at_rest="stay"),
    _selecting("compose", TWO, (V,), inverse.compose, RULE),
    _selecting("between", TWO, (V,), inverse.between, RULE),
    _selecting("compose_jacobians", TWO, BY_TWO, inverse.compose_jacobians, RULE),
    _selecting("between_jacobians", TWO, BY_TWO, inverse.between_jacobians, RULE),
    _by_exponential("retract", (V, DELTA), (MOVED_V,), retraction.retract, RULE),
    _by_exponential("body_retract", (V, DELTA), (MOVED_V,), retraction.body_retract, RULE),
    _by_exponential("retract_jacobians", (V, DELTA), BY_STEP, retraction.retract_jacobians, RULE),
    _by_exponential("body_retract_jacobians", (V, DELTA), BY_STEP, retraction.body_retract_jacobians, RULE),
    _by_exponential("local", TWO, (DELTA,), retraction.local, RULE),
    _by_exponential("body_local", TWO, (DELTA,), retraction.body_local, RULE),
    _by_exponential("interpolate", (*reversed(TWO), SHARE), (V,), retraction.interpolate, RULE),
    _smooth("adjoint", (V,), (_jacobian("adjoint"),), inverse.adjoint),
    _smooth("transform_point_jacobians", (V, POINT), (BY_V_OF_POINT, BY_POINT), inverse.transform_point_jacobians),
    _smooth("transform_line_jacobians", (V, LINE), (BY_V, BY_LINE), inverse.transform_line_jacobians, rotation=None),
    _by_exponential("step_jacobians", (DELTA, *TWO), BY_TWO, retraction.step_jacobians, CHOICES, public=False),
    _by_exponential("local_jacobians", TWO, BY_TWO, retraction.local_jacobians, CHOICES),
    _by_exponential("body_local_jacobians", TWO, BY_TWO, retraction.body_local_jacobians, CHOICES),
)

_COMPOSED = (_selecting("switch", (V, V_DOT, COVARIANCE), (SHADOW, *SWITCHED), inverse.switch, CHOICES),)

TABLE = "table"
"""Argument of programs for numbers that the chart, the side or the branch gives."""
POSES = Table.of("", _ROWS, _COMPOSED)
"""Functions of a kernel module for poses."""

_REAL = ([row.of_rotation for row in rows if row.rotation is not None] for rows in (_ROWS, _COMPOSED))
ROTATIONS = Table.of("rotation", *_REAL)
"""Functions of a module of rotations alone: the real parts of the functions of poses."""

FUNCTIONS: Mapping[str, Function] = POSES.functions
KERNELS: Mapping[str, Function] = POSES.kernels
PUBLIC: Mapping[str, Function] = POSES.public


@cache
def geometry(table: Table = POSES) -> Mapping[str, Program]:
    """Return the geometry programs of a table by name. Geometry programs that they call are written out."""
    return {name: written_out(row.traced()) for name, row in table.kernels.items()}


@cache
def printed_geometry(table: Table = POSES) -> Mapping[str, Program]:
    """Return the shared geometry programs by name, in print order: each follows the programs that it calls."""
    found: dict[str, Program] = {}

    def add(program: Program) -> None:
        for called in program.called:
            add(called)
        found.setdefault(program.name, program)

    for row in table.kernels.values():
        add(row.traced())
    return found


@dataclass(frozen=True, slots=True)
class Way:
    """Programs that a public function runs where it takes plain numbers, as in C."""

    program: str  # for branch 0, if the function takes a branch
    then: str = ""  # program that turns the result to another branch
    instead: str = ""  # program that gives the result on another branch


STAYED, RETURNED, TURN = "stayed", "returned", "turn"
"""The vector itself, or NaN beyond the end of a chart; the vector on the principal branch; the turn to another one."""


def way(row: Function, table: Table) -> Way:
    """Return the programs of a public function. One with ``instead`` takes cosine and sine of the turn."""
    program = {**table.kernels, **table.composed}[row.kernel].traced()
    if not row.branch:
        return Way(RETURNED if row.at_rest else row.kernel)
    if any(argument == TABLE for argument, _ in program.inputs):
        return Way(row.at_rest or STAYED, instead=row.kernel)
    return Way(row.kernel, then=TURN)


def shared_with_poses(table: Table) -> frozenset[str]:
    """Return the names of helper programs that are equal for a table and for poses; empty for poses."""
    found, poses = printed_geometry(table), printed_geometry(POSES)
    same = (name for name in found.keys() - table.kernels.keys() if found[name] == poses.get(name))
    return frozenset() if table is POSES else frozenset(same)


@dataclass(frozen=True, slots=True)
class ChartPrograms:
    """Scalar programs of one chart that the functions of a ``table`` call."""

    table: Table
    scalars: Mapping[str, Program]
    operations: Mapping[str, Counter[str]]  # operations of each function, its scalars included


@lru_cache(maxsize=8)
def lower_chart(chart: Chart, table: Table = POSES) -> ChartPrograms:
    """Return the scalar programs that a table's functions call, and the operation counts of the functions."""
    scalars, counted, called = scalar_programs(chart), {}, set()
    for name, program in geometry(table).items():
        functions = {call.function for call in program.calls}
        if functions <= scalars.keys():
            called |= functions
            counted[name] = sum((scalars[call.function].operations for call in program.calls), program.operations)
    return ChartPrograms(table, {name: program for name, program in scalars.items() if name in called}, counted)


@dataclass(frozen=True, slots=True)
class Lowered:
    """Proved chart with its programs for poses and for rotations alone."""

    proved: Proved
    poses: ChartPrograms
    rotations: ChartPrograms

    @property
    def chart(self) -> Chart:
        return self.proved.formulas

    @property
    def name(self) -> str:
        return self.chart.name


def lower(proved: Proved) -> Lowered:
    return Lowered(proved, lower_chart(proved.formulas, POSES), lower_chart(proved.formulas, ROTATIONS))
