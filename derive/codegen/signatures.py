"""The table of kernel functions: a row each, from which exports, prototypes, recipes and validation derive.

A new function is a row here, a recipe in ``lowering``, an expectation in ``cases`` and a docstring in the templates of
the interface; without one of them nothing is generated.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from ..maps.chart import Chart
from .lowering import calculus, coordinates, forward, groups, inverse, kinematics, motion, retraction
from .lowering.point import Geometry
from .programs.program import Program

Recipe = Callable[[Geometry], Program]


@dataclass(frozen=True, slots=True)
class Array:
    """A named array of components; ``part_of`` says which part (real, dual and so on) each belongs to."""

    name: str
    shape: tuple[int, ...]
    part_of: tuple[int, ...]

    def __post_init__(self) -> None:
        if len(self.part_of) != math.prod(self.shape):
            raise ValueError(f"the parts {self.part_of} of {self.name} do not make its shape {self.shape}")

    @property
    def size(self) -> int:
        """How many components."""
        return len(self.part_of)

    @property
    def parts(self) -> tuple[int, ...]:
        """The size of each part."""
        return tuple(self.part_of.count(part) for part in range(max(self.part_of) + 1))

    def called(self, name: str) -> Array:
        """The same under another name."""
        return replace(self, name=name)


@dataclass(frozen=True, slots=True)
class Function:
    """A function of a kernel module.

    Parameters
    ----------
    name : str
    arguments, results : tuple of Array
    recipe : callable, optional
        Traces its program; None for a function that shares the program of another, `kernel`.
    exact : bool
        Whether its expectation is exact, on elements of a ring, or at 50 digits.
    constants : tuple of str
        Components of the argument ``table`` of its program, where they are the same for all charts.
    branch : bool
        Whether a branch is chosen.
    real : bool
        Whether it selects branches or angles, and so takes no complex numbers.
    public : bool
        Whether users call it.
    at_rest : str
        The function whose program it runs for a turn by no branch, where it runs its own for others; empty where the
        argument stands.
    aliases : tuple of str
        Further names in the modules of Cayley maps.
    keywords : tuple of str
        Keyword parameters besides those of every function, in languages that have them: they choose what is done to
        arguments and results, and change no program.
    remainder : float
        What its own series leave off, however many digits numbers have.
    """

    name: str
    arguments: tuple[Array, ...]
    results: tuple[Array, ...]
    recipe: Recipe | None
    exact: bool = True
    constants: tuple[str, ...] = ()
    branch: bool = False
    real: bool = False
    public: bool = True
    at_rest: str = ""
    aliases: tuple[str, ...] = ()
    keywords: tuple[str, ...] = ()
    shares: str = ""
    remainder: float = 0.0

    @property
    def shape(self) -> tuple[int, ...]:
        """Of what its program returns: several results stand side by side."""
        return self.results[0].shape if len(self.results) == 1 else (sum(array.size for array in self.results),)

    def traced(self, chart: Chart | None = None) -> Program:
        """Its program for all charts, or for one.

        Raises
        ------
        ValueError
            If it has no recipe.
        """
        if self.recipe is None:
            raise ValueError(f"{self.name} has no recipe: it shares the program of {self.shares!r}")
        return self.recipe(Geometry(chart))

    @property
    def kernel(self) -> str:
        """The function whose program it runs."""
        return self.shares or self.name


def _array(name: str, shape: tuple[int, ...], *parts: int) -> Array:
    """An array whose parts, of these sizes, follow each other."""
    return Array(name, shape, tuple(part for part, size in enumerate(parts) for _ in range(size)))


def _dual(name: str) -> Array:
    return _array(name, (6,), 3, 3)


def _tensor(name: str) -> Array:
    return _array(name, (2, 3, 3), 9, 9)


def _jacobian(name: str) -> Array:
    """A dual tensor as a real matrix: its real part beside zeros, then its dual part beside the real one."""
    return Array(name, (6, 6), (0,) * 18 + (1, 1, 1, 0, 0, 0) * 3)


V, OMEGA, V_DOT, LINE, SHADOW, MOVED, BACK = map(_dual, ("v", "omega", "v_dot", "line", "v_k", "moved", "v_back"))
OMEGA_DOT, V_DDOT, WRENCH, MOMENTUM = map(_dual, ("omega_dot", "v_ddot", "z", "tau"))
DELTA, MOVED_V, LOGARITHM = map(_dual, ("delta", "v_moved", "w"))
JACOBIAN, BY_V, BY_LINE = map(_jacobian, ("jacobian", "by_v", "by_line"))
TWO, BY_TWO = (V.called("v2"), V.called("v1")), (_jacobian("by_v2"), _jacobian("by_v1"))
BY_STEP = BY_V, _jacobian("by_delta")
BY_V_OF_POINT, BY_POINT = Array("by_v", (3, 6), (0, 0, 0, 1, 1, 1) * 3), _array("by_r", (3, 3), 9)
QUATERNION = _array("q", (8,), 4, 4)
POSE = _array("pose", (4, 4), 3, 1, 3, 1, 3, 1, 4)
POINT = _array("r", (3,), 3)
SHARE = _array("t", (), 1)
ANGLE = _array("angle", (2,), 1, 1)

SPACE, BODY = ("1",), ("-1",)
"""The side of T: itself, which gives the twist in space, or its transpose, in the body; of T⁻¹ also half the side."""
SPACE_INV, BODY_INV = ("1", "0.5"), ("-1", "-0.5")

CHECK, SCALAR_FIRST = "check", "scalar_first"
"""Keywords: whether arguments are checked for what they have to be, and where in a quaternion the scalar stands."""


def _way_back(name: str, given: Array, recipe: Recipe, *keywords: str) -> Function:
    """From what represents a pose to its v on a branch."""
    keywords = (CHECK, *keywords)
    return Function(name, (given,), (V,), recipe, exact=False, branch=True, real=True, keywords=keywords)


def _both_frames(name: str, arguments: tuple[Array, ...], result: Array, recipe: Recipe) -> tuple[Function, Function]:
    """A function of space and, by the other side of T, that of the body."""
    return (
        Function(name, arguments, (result,), recipe, constants=SPACE),
        Function(f"body_{name}", arguments, (result,), None, constants=BODY, shares=name),
    )


def _by_exponential(name: str, arguments: tuple[Array, ...], recipe: Recipe, *results: Array) -> Function:
    """A function which the exponential's series enter."""
    remainder = retraction.EXPONENTIAL.remainder
    return Function(name, arguments, results, recipe, exact=False, real=True, remainder=remainder)


_ROWS = (
    Function("quaternion", (V,), (QUATERNION,), forward.quaternion, keywords=(SCALAR_FIRST,)),
    Function("tensor", (V,), (_tensor("tensor"),), forward.tensor),
    Function("pose", (V,), (POSE,), forward.pose),
    Function("transform_point", (V, POINT), (POINT.called("moved"),), forward.transform_point),
    Function("transform_line", (V, LINE), (MOVED,), forward.transform_line),
    Function("inverse", (V,), (BACK,), forward.inverse),
    Function("tangent", (V,), (_tensor("tangent"),), kinematics.tangent, aliases=("dcay",)),
    Function("tangent_inv", (V,), (_tensor("tangent"),), kinematics.tangent_inv, aliases=("dcay_inv",)),
    Function("body_tangent", (V,), (_tensor("tangent"),), kinematics.body_tangent),
    Function("body_tangent_inv", (V,), (_tensor("tangent"),), kinematics.body_tangent_inv),
    Function("twist", (V, V_DOT), (OMEGA,), kinematics.twist, constants=SPACE),
    Function("rate", (V, OMEGA), (V_DOT,), kinematics.rate, constants=SPACE_INV),
    Function("body_twist", (V, V_DOT), (OMEGA,), None, constants=BODY, shares="twist"),
    Function("body_rate", (V, OMEGA), (V_DOT,), None, constants=BODY_INV, shares="rate"),
    *_both_frames("tangent_dot", (V, V_DOT), _tensor("tangent_dot"), calculus.tangent_dot),
    *_both_frames("twist_dot", (V, V_DOT, V_DDOT), OMEGA_DOT, calculus.twist_dot),
    *_both_frames("rate_dot", (V, OMEGA, OMEGA_DOT), V_DDOT, calculus.rate_dot),
    *_both_frames("twist_jacobian", (V, V_DOT), JACOBIAN, calculus.twist_jacobian),
    *_both_frames("rate_jacobian", (V, OMEGA), JACOBIAN, calculus.rate_jacobian),
    Function("cotangent", (V, WRENCH), (MOMENTUM,), None, constants=BODY, shares="twist"),
    Function("body_cotangent", (V, WRENCH), (MOMENTUM,), None, constants=SPACE, shares="twist"),
    Function("cotangent_jacobian", (V, WRENCH), (JACOBIAN,), None, constants=BODY, shares="twist_jacobian"),
    Function("body_cotangent_jacobian", (V, WRENCH), (JACOBIAN,), None, constants=SPACE, shares="twist_jacobian"),
    _way_back("from_quaternion", QUATERNION, inverse.from_quaternion, SCALAR_FIRST),
    _way_back("from_tensor", _tensor("R"), inverse.from_tensor),
    _way_back("from_pose", POSE.called("T"), inverse.from_pose),
    Function("from_screw", (ANGLE, LINE), (V,), inverse.from_screw, exact=False, real=True, keywords=(CHECK,)),
    Function("to_screw", (V,), (ANGLE, LINE), inverse.to_screw, exact=False, real=True),
    Function("angle", (V,), (ANGLE,), inverse.angle, exact=False, real=True),
    Function("to_exponential", (V,), (LOGARITHM,), coordinates.to_exponential, exact=False, real=True),
    Function("from_exponential", (LOGARITHM,), (V,), coordinates.from_exponential, exact=False, real=True),
    Function("turn", (V,), (SHADOW,), inverse.turn, exact=False, real=True, public=False),
    Function("shadow", (V,), (SHADOW,), inverse.shadow, exact=False, branch=True, real=True),
    Function("identity_jacobian", (V,), (JACOBIAN,), inverse.identity_jacobian, exact=False, real=True, public=False),
    Function(
        "shadow_jacobian",
        (V,),
        (JACOBIAN,),
        inverse.shadow_jacobian,
        exact=False,
        branch=True,
        real=True,
        at_rest="identity_jacobian",
    ),
    Function("principal", (V,), (SHADOW,), inverse.principal, exact=False, real=True),
    Function("compose", TWO, (V,), inverse.compose, exact=False, real=True),
    Function("between", TWO, (V,), groups.between, exact=False, real=True),
    Function("compose_jacobians", TWO, BY_TWO, groups.compose_jacobians, exact=False, real=True),
    Function("between_jacobians", TWO, BY_TWO, groups.between_jacobians, exact=False, real=True),
    _by_exponential("retract", (V, DELTA), retraction.retract, MOVED_V),
    _by_exponential("body_retract", (V, DELTA), retraction.body_retract, MOVED_V),
    _by_exponential("retract_jacobians", (V, DELTA), retraction.retract_jacobians, *BY_STEP),
    _by_exponential("body_retract_jacobians", (V, DELTA), retraction.body_retract_jacobians, *BY_STEP),
    _by_exponential("local", TWO, retraction.local, DELTA),
    _by_exponential("body_local", TWO, retraction.body_local, DELTA),
    _by_exponential("interpolate", (*reversed(TWO), SHARE), motion.interpolate, V),
    Function("adjoint", (V,), (_jacobian("adjoint"),), groups.adjoint),
    Function("transform_point_jacobians", (V, POINT), (BY_V_OF_POINT, BY_POINT), groups.transform_point_jacobians),
    Function("transform_line_jacobians", (V, LINE), (BY_V, BY_LINE), groups.transform_line_jacobians),
)

FUNCTIONS: Mapping[str, Function] = {row.name: row for row in _ROWS}
"""Every function of a kernel module that takes arrays."""

KERNELS: Mapping[str, Function] = {row.name: row for row in _ROWS if row.recipe}
"""Those with a program of their own."""

PUBLIC: Mapping[str, Function] = {row.name: row for row in _ROWS if row.public}
"""Those that users call."""


def aliases(chart: Chart) -> dict[str, str]:
    """Further names in the module of a chart, and the functions they are names of."""
    return {alias: name for name, row in PUBLIC.items() for alias in row.aliases} if chart.cayley else {}
