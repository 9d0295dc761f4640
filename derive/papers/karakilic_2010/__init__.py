"""Karakılıç, The dual Rodrigues parameters (2010): every equation and claim, section by section.

The LaTeX of its text is legible but for arrows over symbols and a few stars: `symbols.shown` says what is compared.

=========  ==================================================================================
symbols   the symbols of the paper, and what its extraction keeps of a formula
operators  operators of its own
definitions  definitions of symbols, which the printed formulas are checked against
sections   the entries, in printed order; a section uses symbols of those before it
inventory  by line of the text: the entries that decide it, or why it claims nothing
=========  ==================================================================================
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
