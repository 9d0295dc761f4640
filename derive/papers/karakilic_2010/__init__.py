"""Karakılıç, The dual Rodrigues parameters (2010): every equation and claim, section by section.

The LaTeX of its text is legible but for arrows over letters and a few stars: `alphabet.marks` says what is compared.
"""

from __future__ import annotations

from ..paper import Paper
from .alphabet import LOST

PAPER = Paper(
    slug="karakilic-2010",
    short="K10",
    citation="İ. Karakılıç: The Dual Rodrigues Parameters. International Journal of Engineering and Applied Sciences "
    "2(2), 23-32, 2010",
    lost=LOST,
    package=__name__,
    sections=("dual_numbers", "dual_vectors", "cayley_formula", "rodrigues", "components", "steps", "conclusion"),
)
