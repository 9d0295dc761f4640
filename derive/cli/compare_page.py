"""The page of ``dualcay compare --format markdown``: docs/parameterizations.md."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import sympy

from ..maps.any_phi.stretch import POINTS, best, bound
from .compared import ANGLES, COUNTED, Compared, errors, number, times

PAGE = """# Parameterizations

Made by `dualcay compare --format markdown`; nothing here is typed by hand but these words.

A chart is v = φ(α) u. Along the axis Re T multiplies rates by 1/φ′, across it by 2 sin(α/2)/φ; their quotient is the
condition number of Re T. Where φ′ = 0 or sin(α/2) = 0 one of them is infinite or 0: these are the singular angles.

{shape}

![figures against the angle](parameterizations.png)

What is computed, in operations for one pose:

{cost}

Errors, measured by `make parameterizations` on seeded vectors at the angle, against 60 digits: in eps of the size and
the condition of a result; of `from_pose` below half a turn, where a pose has one vector.

{errors}

Times, measured with them, in nanoseconds for a pose of N, on one core; another machine has others, of like ratios.

{times}

* **n = 2 is conformal** (`cayley2`, `scaled2`, `wiener_milenkovic`): both singular values are equal at every angle, so
  the condition number is 1 up to the edge at 2π, and the inverse of T is a scaled transpose.
* **n ≥ 3 carries v beyond 2π, not kinematics**: T loses rank at 2π in every chart that gets there, so motion needs
  another branch before. So it does in the exponential. What is gained is that v stays finite and changes slowly at π.
* **Shadows lose digits** near the edge of a chart, where φ′ is 0 or infinite, and near 2π, where one pose has vectors
  in all directions: errors are those of the result times its condition, and the condition is what grows.
* **Which to take**: n = 2 for attitude and motion that may go over to its shadow (no trigonometry, no singular T below
  2π); the exponential where v has to be an angle; n = 3, 4 where v should stay finite and smooth well beyond π; n = 1
  where rotations stay well below π and composition has to be cheap; sine charts where |v| has to be bounded.

## Which φ keeps Re T nearest to a rotation?

The greatest of the singular values and of their inverses, over |α| ≤ A, is M. No φ has a smaller one than
√(A/2 / sin(A/2)): with 1/φ′ ≤ M it is φ(A) ≥ A/M, and with φ(A)/(2 sin(A/2)) ≤ M it is A/M ≤ 2 M sin(A/2). The angle
itself, divided by that M, reaches it; with φ′(0) = 1 it is approached by slopes that fall at once to 1/M, and reached
by none. Of the scaled charts 2n tan(α/2n) the limit n → ∞, the exponential, is best: its M is the square of that, and
tan θ > θ makes φ(A)/(2 sin(A/2)) larger in any other. Of c sin(α/c) that quotient falls as c gets less, while 1/φ′(A)
grows; they are the same at c = 4, whatever A is: Lambert's chart times 4, with the singular values 1/cos(α/4) and
cos(α/4), is the best of sines, M = 1/cos(A/4). Odd polynomials of degree 5 go below it. What is best of sines and
polynomials was found by golden sections, M by evaluation at {points} angles.

{best}
"""


def page(compared: Sequence[Compared]) -> str:
    """All of it."""
    return PAGE.format(
        shape="\n".join(_shape(compared)),
        cost=_table(["chart", *COUNTED], [[row.chart.name, *map(number, row.operations.values())] for row in compared]),
        errors=_table(*errors(compared)),
        times=_table(*times(compared)),
        points=POINTS,
        best="\n".join(_best()),
    )


def _shape(compared: Sequence[Compared]) -> Iterator[str]:
    of_angles = [f"{name} {what}" for name in ANGLES for what in ("1/φ′", "across", "cond")]
    rows = []
    for row in compared:
        cells = [row.chart.name, row.chart.parameter, number(row.edge / math.pi), number(row.range)]
        for found in row.stretches.values():
            cells += map(number, (found.along, found.across, found.condition) if found else [None] * 3)
        singular = (number(float((angle / sympy.pi).evalf(10))) for angle in row.chart.singular_angles)
        rows.append([*cells, ", ".join(singular)])
    yield _table(["chart", "φ", "edge/π", "|v| there", *of_angles, "singular angles/π"], rows)


def _table(headings: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [headings, ["---"] * len(headings), *rows]
    return "\n".join(f"| {' | '.join(cell.replace('|', '&#124;') for cell in line)} |" for line in lines)


def _best() -> Iterator[str]:
    rows = []
    for name, angle in ANGLES.items():
        rows.append([name, "any (bound)", "", f"{bound(angle):.5f}"])
        rows += [[name, found.kind, f"`{found.phi}`", f"{found.worst:.5f}"] for found in best(angle)]
    yield _table(["A", "among", "--phi", "M"], rows)


