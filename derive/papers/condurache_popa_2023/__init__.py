"""Condurache and Popa, Symmetry 15(11) 2011 (2023): every equation and claim, section by section."""

from __future__ import annotations

from ..equation import Paper
from .cp23_notation import LOST

CLAIMS: dict[int, str] = {
    35: "isomorphism isomorphism-onto 16", 37: "47 49 50 57 59 60 88 89", 49: "2", 52: "sine", 63: "5", 72: "7",
    76: "9", 83: "11", 105: "isomorphism-onto", 113: "19", 116: "19 14 17", 128: "22", 130: "22 22-parts", 133: "23",
    137: "exponential-onto", 140: "homomorphism homomorphism-onto", 144: "representation", 156: "26",
    158: "cayley-well-defined", 168: "cayley-well-defined", 177: "cayley-onto",
    195: "cayley-quaternion-well-defined cayley-quaternion-onto", 198: "37", 203: "38 39", 204: "39", 206: "40",
    208: "41", 214: "cayley-half-well-defined", 216: "43", 219: "44", 221: "cayley-half-onto", 222: "44 44-screw",
    225: "45", 235: "theorem-11-well-defined", 243: "46 47", 294: "theorem-15-unit", 315: "vector-w", 320: "normal-w",
    355: "69", 361: "theorem-19-unique", 368: "73", 408: "90 91", 452: "121", 457: " ".join(map(str, range(92, 126))),
    458: "126 127 128 129 130 131", 469: "six-real-equations", 503: "10",
}
"""Entries, listed at other lines, that decide each further line of the text."""

REASONS: dict[str, str] = {
    "title":
        "20 28 33 40 44 54 70 88 118 147 183 229 236 242 259 295 303 342 360 414 417 425 433 441 449 467 471 495",
    "prose without a claim": "31 36 38 42 185 227 288 473",
    "leads to the next display":
        "46 56 78 84 90 102 109 120 123 138 151 160 166 169 171 173 175 178 187 191 193 210 212 233 238 246 248 "
        "255 262 264 268 270 278 280 286 300 306 321 345 348 350 356 362 364 375 381 385 389 391 394 398 401 404 "
        "416",
    "names or defines, claims nothing":
        "61 92 101 126 154 202 258 289 291 292 311 344 379 388 411 497 498 499 500 501 502 504 505 506",
    "theorem number":
        "62 93 98 106 112 115 127 131 135 139 142 150 159 163 179 186 190 196 211 215 223 232 239 244 252 267 277 "
        "290 299 305 312 347 357 370 374 400",
    "compares with other works only": "231",
    "end of a proof": "266",
    "announces the five families that follow": "316",
    "number of a family": "317 324 328 332 336",
    "summarizes the theorem": "369",
    "joins two displays": "377",
    "names earlier equations only": "407",
}
"""Further lines that claim nothing, by reason. Blank lines, lines of the journal and references are omitted."""

PAPER = Paper(
    slug="condurache-popa-2023", short="CP23",
    citation="D. Condurache, I. Popa: A Minimal Parameterization of Rigid Body Displacement and Motion Using a "
    "Higher-Order Cayley Map by Dual Quaternions. Symmetry 15(11) 2011, 2023",
    doi="10.3390/sym15112011",
    lost=LOST, package=__name__, claims=CLAIMS, reasons=REASONS,
    sections=(
        "s02_1_dual_numbers", "s02_2_dual_vectors", "s02_3_dual_tensors", "s03_rigid_motion", "s04_dual_quaternions",
        "s05_cayley_tensors", "s06_cayley_quaternions", "s07a_fractional_transform", "s07b_order_lists",
        "s07c_parameterizations", "s07d_families", "s07e_references", "s08a_kinematics", "s08b_tangent_operators",
        "s09a_explicit_orders", "s09b_components", "s10_conclusions",
    ),
)  # fmt: skip
