"""Karakılıç, The dual Rodrigues parameters (2010): every equation and claim, section by section.

The LaTeX of its text is legible, except for arrows over letters and a few stars. `symbols.shown` returns the characters
to compare.

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
    slug="karakilic-2010",
    short="K10",
    citation="İ. Karakılıç: The Dual Rodrigues Parameters. International Journal of Engineering and Applied Sciences "
    "2(2), 23-32, 2010",
    lost=LOST,
    package=__name__,
    sections=(
        "s1a_dual_numbers", "s1b_dual_vectors", "s2_cayley_formula", "s3a_rodrigues", "s3b_components", "s4_conclusion",
    ),
)
