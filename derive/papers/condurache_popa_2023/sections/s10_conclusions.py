"""Section 10, the only claim of the conclusions without a display: line 469."""

from . import *
from . import s07a_fractional_transform, s07c_parameterizations, s07d_families, s08b_tangent_operators

DIRECT = ("50", "57", "88", "89", "62", "65")
"""Numbers of the equations for the maps from v to displacements and twists."""

direct = proposition("maps from v", "no transcendental function in the maps from v: (50), (57), (62), (65), (88), (89)")
every = proposition("all maps", "no transcendental function in any display of sections 7 and 8 about maps")
MAPS: tuple[Equation, ...] = (
    *s07a_fractional_transform.ENTRIES, *s07c_parameterizations.ENTRIES, *s07d_families.ENTRIES,
    *s08b_tangent_operators.ENTRIES,
)


def _direct(env: Env) -> bool:
    return is_algebraic(*(e.readings[0].statement for e in MAPS if e.number in DIRECT))


def _every(env: Env) -> bool:
    return is_algebraic(*(e.readings[0].statement for e in MAPS))


ENTRIES = (
    equation("no-transcendental-functions", "the expressions have no transcendental functions", 469,
             (Reading(direct, "the maps from v to displacements and twists"),
              Reading(every, "all expressions, the inverse maps and the exponential among them")),
             where=(let(direct, _direct), let(every, _every)),
             remark="(49), (60), (61) and the families need tan, cot or sin of the angle; (82) and (84) sinc and cot."),
)
