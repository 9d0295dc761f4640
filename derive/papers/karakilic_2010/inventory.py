"""Every display and claiming sentence of the text by line: the entries that decide it, or why nothing is to decide.

Lines of the reference list and blank lines are left out.
"""

from __future__ import annotations

TITLE, NAMES, PROSE, NUMBER = "title", "names or defines, claims nothing", "prose without a claim", "equation number"

LINES: dict[int, tuple[str, ...] | str] = {
    1: TITLE, 3: TITLE, 5: TITLE, 7: TITLE, 9: TITLE,
    11: ("real-parameters",),
    13: ("20", "21", "22", "study-distance"),
    15: TITLE, 17: TITLE,
    19: PROSE,
    21: ("length", "orthogonal", "cayley-formula"),
    23: ("dual-number", "study", "study-product", "study-angle", "study-distance"),
    25: ("addition",), 26: ("multiplication",),
    28: ("zero-divisors", "ring", "no-field"),
    30: ("extension",), 32: ("extension",), 34: ("extension",), 35: ("extension",),
    37: "leads to the next display",
    39: ("sine",), 40: ("cosine",), 41: ("exponential",),
    43: ("dual-vector", "module"), 45: ("dimension", "degenerate", "norm"), 47: ("norm",), 49: ("unit", "unit-vector"),
    51: TITLE, 53: ("length",), 55: ("length",), 57: "leads to the next display", 59: ("orthogonal-diagonals",),
    61: ("sum-and-difference",), 63: ("sum-and-difference",), 64: ("sum-and-difference",),
    66: "leads to the next display", 68: ("difference-from-sum",),
    70: ("b-orthogonal", "quadratic-form"), 72: ("quadratic-form", "quadratic-expansion"),
    74: ("quadratic-form", "skew-entries", "skew"), 76: ("not-singular",),
    78: ("b-matrix",), 79: ("b-times",), 80: ("b-plus-identity",), 81: ("a-from-b",), 83: ("cayley-formula",),
    85: ("cayley-formula",), 87: ("transposed",), 89: ("transposed",), 90: ("transposed",), 91: ("transposed",),
    93: "leads to the next display", 95: ("orthogonal",), 97: ("orthogonal",), 99: NAMES, 101: ("matrix",),
    103: ("product", "vector"), 105: ("product",),
    107: TITLE, 109: ("every-orthogonal", "rodrigues-matrix"), 111: ("rodrigues-matrix",), 113: ("rodrigues-vector",),
    115: ("rodrigues-vector",), 117: ("rhombus", "vertex-angle"), 121: ("rhombus",), 123: ("projected", "diagonals"),
    125: ("ratio",), 127: "leads to the next display", 129: ("half-angle",), 131: "leads to the next display",
    133: ("1",), 134: NUMBER, 136: ("2",), 138: ("2",), 139: NUMBER, 141: "leads to the next display", 143: ("3",),
    144: NUMBER, 146: ("4",), 148: ("4",), 149: NUMBER, 151: ("real-norm", "5"), 153: ("unit-rodrigues", "6"),
    155: ("6",), 157: ("7",), 159: "leads to the next display", 161: ("7",), 162: NUMBER, 164: NAMES,
    166: ("8",), 167: NUMBER, 169: ("9",), 170: NUMBER, 172: "page number", 174: ("10",), 175: NUMBER,
    177: ("11", "12", "13"), 179: ("11",), 180: NUMBER, 182: ("12",), 183: NUMBER, 185: ("13",), 186: NUMBER,
    188: ("real-parameters",), 190: ("real-parameters",), 192: ("real-parameters",), 194: ("real-parameters",),
    196: ("with-tangents",), 198: ("with-tangents",), 200: ("14",), 202: ("14",), 203: NUMBER,
    205: ("15", "16"), 207: ("15",), 208: NUMBER, 210: ("16",), 212: ("unit-norm",), 214: ("17",), 216: ("17",),
    217: NUMBER, 219: ("zero-components", "denominators"), 221: ("6-expanded",), 223: ("6-expanded",), 225: ("18",),
    227: ("18",), 228: NUMBER, 230: ("step-19",), 232: ("19",), 233: NUMBER, 235: ("step-20",), 237: ("20",),
    238: NUMBER, 240: ("step-21",), 242: ("21",), 243: NUMBER, 245: ("step-22",), 247: ("22",), 248: NUMBER,
    250: "page number", 252: TITLE, 254: ("conclusion-22", "conclusion-20", "conclusion-21"),
    256: ("conclusion-22",), 257: NUMBER, 259: ("conclusion-20",), 260: NUMBER, 262: ("conclusion-21",), 263: NUMBER,
    265: ("real-parameters", "conclusion-20", "conclusion-21", "conclusion-22", "positions"), 269: ("positions",),
}  # fmt: skip
