"""Condurache and Popa, Symmetry 15(11) 2011 (2023): every equation and claim, section by section.

===========  ================================================================================
symbols      symbols used throughout the paper, and characters lost by its text extraction
operators    operators of this paper only
definitions  definitions of symbols, against which printed formulas are checked
sections     entries in printed order; a section may use symbols of earlier sections
inventory    further lines of the text, with deciding entries or the reason for no claim
===========  ================================================================================
"""

from __future__ import annotations

from ..equation import Paper
from .symbols import LOST

PAPER = Paper(
    slug="condurache-popa-2023",
    short="CP23",
    citation="D. Condurache, I. Popa: A Minimal Parameterization of Rigid Body Displacement and Motion Using a "
    "Higher-Order Cayley Map by Dual Quaternions. Symmetry 15(11) 2011, 2023",
    doi="10.3390/sym15112011",
    lost=LOST,
    package=__name__,
    sections=(
        "s02_1_dual_numbers", "s02_2_dual_vectors", "s02_3_dual_tensors", "s03_rigid_motion", "s04_dual_quaternions",
        "s05_cayley_tensors", "s06_cayley_quaternions", "s07a_fractional_transform", "s07b_order_lists",
        "s07c_parameterizations", "s07d_families", "s07e_references", "s08a_kinematics", "s08b_tangent_operators",
        "s09a_explicit_orders", "s09b_components", "s10_conclusions",
    ),
)
