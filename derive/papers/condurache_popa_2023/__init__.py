"""Condurache and Popa, Symmetry 15(11) 2011 (2023): every equation and claim, section by section.

Its text is a lossy extraction: `alphabet.LOST` lists the marks that are gone.
"""

from __future__ import annotations

from ..paper import Paper
from .alphabet import LOST

PAPER = Paper(
    slug="condurache-popa-2023",
    short="CP23",
    citation="D. Condurache, I. Popa: A Minimal Parameterization of Rigid Body Displacement and Motion Using a "
    "Higher-Order Cayley Map by Dual Quaternions. Symmetry 15(11) 2011, 2023",
    lost=LOST,
    package=__name__,
    sections=(
        "dual_numbers", "dual_vectors", "dual_tensors", "rigid_motion", "quaternions", "cayley_tensors",
        "cayley_quaternions", "higher_order", "order_lists", "parameterizations", "families", "kinematics",
        "tangent_operators", "orders", "higher_orders", "components", "conclusions",
    ),
)  # fmt: skip
