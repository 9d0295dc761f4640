"""Karakılıç, The dual Rodrigues parameters (2010): every equation and claim, section by section.

The LaTeX of its text is legible but for arrows over letters and a few stars. `symbols.shown` gives the characters that
are compared.

===========  ================================================================================
symbols      symbols used throughout the paper, and the characters its text extraction lost
operators    operators of its own
definitions  definitions of symbols, which the printed formulas are checked against
sections     entries in printed order; a section uses symbols of those before it
inventory    further lines of the text: the entries that decide them, or why they claim nothing
===========  ================================================================================
"""

from __future__ import annotations

from ..paper import Paper
from .symbols import LOST

PAPER = Paper(
    slug="karakilic-2010",
    short="K10",
    citation="İ. Karakılıç: The Dual Rodrigues Parameters. International Journal of Engineering and Applied Sciences "
    "2(2), 23-32, 2010",
    lost=LOST,
    package=__name__,
    sections=(
        "s1a_dual_numbers", "s1b_dual_vectors", "s2_cayley_formula", "s3a_rodrigues", "s3b_components", "s3c_steps",
        "s4_conclusion",
    ),
)
