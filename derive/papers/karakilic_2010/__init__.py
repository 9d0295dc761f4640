"""Karakılıç, The dual Rodrigues parameters (2010): every equation and claim, section by section.

The LaTeX of its text is legible, except for arrows over letters and a few stars.
"""

from __future__ import annotations

from ..equation import Paper
from .k10_notation import LOST

CLAIMS: dict[int, str] = {
    11: "real-parameters", 13: "20 21 22 study-distance", 21: "length orthogonal cayley-formula", 30: "extension",
    34: "extension", 35: "extension", 45: "norm", 53: "length", 61: "sum-and-difference", 64: "sum-and-difference",
    70: "quadratic-form", 74: "quadratic-form", 83: "cayley-formula", 87: "transposed", 90: "transposed",
    91: "transposed", 97: "orthogonal", 103: "product", 109: "rodrigues-matrix", 113: "rodrigues-vector",
    121: "rhombus", 136: "2", 146: "4", 153: "6", 157: "7", 177: "11 12 13", 188: "real-parameters",
    192: "real-parameters", 194: "real-parameters", 196: "with-tangents", 200: "14", 205: "15 16", 216: "17",
    221: "6-expanded", 225: "18", 254: "conclusion-22 conclusion-20 conclusion-21",
    265: "real-parameters conclusion-20 conclusion-21 conclusion-22", 269: "positions",
}
"""Entries, listed at other lines, that decide each further line of the text."""

REASONS: dict[str, str] = {
    "title": "1 3 5 7 9 15 17 51 107 252",
    "prose without a claim": "19",
    "leads to the next display": "37 57 66 93 127 131 141 159",
    "names or defines, claims nothing": "99 164",
    "equation number": "134 139 144 149 162 167 170 175 180 183 186 203 208 217 228 233 238 243 248 257 260 263",
    "page number": "172 250",
}
"""Further lines that claim nothing, by reason. Blank lines, lines of the journal and references are omitted."""

PAPER = Paper(
    slug="karakilic-2010", short="K10",
    citation="İ. Karakılıç: The Dual Rodrigues Parameters. International Journal of Engineering and Applied Sciences "
    "2(2), 23-32, 2010",
    lost=LOST, package=__name__, claims=CLAIMS, reasons=REASONS,
    sections=(
        "s1a_dual_numbers", "s1b_dual_vectors", "s2_cayley_formula", "s3a_rodrigues", "s3b_components", "s4_conclusion",
    ),
)  # fmt: skip
