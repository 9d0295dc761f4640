"""Section 10, the only claim of the conclusions without a display: line 469."""

from . import *
from . import s07a_fractional_transform, s07c_parameterizations, s07d_families, s08b_tangent_operators

DIRECT = ("50", "57", "88", "89", "62", "65")
"""Numbers of the equations for the maps from v to displacements and twists."""

direct = proposition("maps from v", "no transcendental function in the maps from v: (50), (57), (62), (65), (88), (89)")
every = proposition("all maps", "no transcendental function in any display of sections 7 and 8 about maps")
SECTIONS = (s07a_fractional_transform, s07c_parameterizations, s07d_families, s08b_tangent_operators)
MAPS = {entry.number: entry.readings[0].statement for section in SECTIONS for entry in section.ENTRIES}
"""Statements by equation number."""

ENTRIES = (
    equation("no-transcendental-functions",
             (Reading(direct, "the maps from v to displacements and twists"),
              Reading(every, "all expressions, the inverse maps and the exponential among them")),
             where=(let(direct, lambda env: is_algebraic(*(MAPS[number] for number in DIRECT))),
                    let(every, lambda env: is_algebraic(*MAPS.values())))),
)
