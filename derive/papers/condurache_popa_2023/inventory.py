"""Every display and claiming sentence of the text by line: the entries that decide it, or why it claims nothing.

Blank lines, the journal's own lines and the reference list are left out.
"""

from __future__ import annotations

from .inventory_of_maps import CONCLUSION, NAMES, NEXT, NUMBERED, PROSE, SECTION_7, SECTION_8, TITLE

FRONT: dict[int, tuple[str, ...] | str] = {
    20: TITLE, 28: TITLE, 31: PROSE, 33: TITLE, 35: ("isomorphism", "isomorphism-onto", "16"), 36: PROSE,
    37: ("47", "49", "50", "57", "59", "60", "88", "89"), 38: PROSE, 40: TITLE, 42: PROSE, 44: TITLE,
}  # fmt: skip

DUAL_ALGEBRA: dict[int, tuple[str, ...] | str] = {
    46: NEXT, 47: ("1",),
    48: ("zero-divisors", "magnitude-square", "magnitude", "inverse-exists", "inverse", "commutative-ring",
         "invertible-or-zero-divisor"),
    49: ("2",), 50: ("2",), 51: ("cosine", "sine"), 52: ("sine", "power", "tangent", "arc-tangent"),
    54: TITLE, 56: NEXT, 57: ("3",), 58: ("triple-product", "vector-module"), 59: ("vector-magnitude",), 60: ("4",),
    61: NAMES, 62: NUMBERED, 63: ("5",), 64: ("5",), 65: ("polar-magnitude",), 66: ("6",), 67: ("polar-unique",),
    68: ("line", "line-free"),
    70: TITLE, 72: ("7",), 73: ("7",), 74: ("tensor-module", "tensor-parts"), 75: ("8",), 76: ("9",), 77: ("9",),
    78: NEXT, 79: ("10",),
    80: ("skew-symmetric", "axial-vector", "axial-vector-is-vect", "axial-vector-unique", "skew-module"),
    81: ("vect",), 82: ("11",), 83: ("11",), 84: NEXT, 85: ("12",),
    86: ("dyad-product", "components", "dyad-matrix", "skew-matrix"),
}  # fmt: skip

MOTION: dict[int, tuple[str, ...] | str] = {
    88: TITLE, 90: NEXT, 91: ("13",), 92: NAMES, 93: NUMBERED, 94: ("structure-unique",), 95: ("14",),
    96: ("structure-parts",), 97: ("orthogonal-group",), 98: NUMBERED, 99: ("isomorphism", "isomorphism-onto"),
    100: ("15",), 101: NAMES, 102: NEXT, 103: ("16",), 104: ("structural-invariants",), 105: ("isomorphism-onto",),
    106: NUMBERED, 107: ("representation",), 108: ("17",), 109: NEXT,
    110: ("18", "18-axis", "18-translation", "18-moment"),
    111: ("mozzi-chasles", "natural-rotation", "natural-translation"), 112: NUMBERED, 113: ("19",), 114: ("19",),
    115: NUMBERED, 116: ("19", "14", "17"),
}  # fmt: skip

QUATERNIONS: dict[int, tuple[str, ...] | str] = {
    118: TITLE, 120: NEXT, 121: ("20",), 122: ("quaternion-module",), 123: NEXT, 124: ("21",),
    125: ("quaternion-algebra", "non-commutative", "conjugate", "quaternion-norm", "quaternion-submodules",
          "scalar-plus-vector", "quaternion-parts"),
    126: NAMES, 127: NUMBERED, 128: ("22",), 129: ("22",), 130: ("22", "22-parts"), 131: NUMBERED,
    132: ("22-product", "22-expanded", "22-parts", "22-vector", "22-displacement"), 133: ("23",), 134: ("23",),
    135: NUMBERED,
    136: ("exponential-unit", "exponential-onto"), 137: ("exponential-onto",), 138: NEXT, 139: NUMBERED,
    140: ("homomorphism", "homomorphism-onto"), 141: ("24",), 142: NUMBERED,
    143: ("24-exponential", "homomorphism-well-defined", "homomorphism"), 144: ("homomorphism-onto", "representation"),
    145: ("not-injective", "double-cover"),
}  # fmt: skip

CAYLEY_TENSORS: dict[int, tuple[str, ...] | str] = {
    147: TITLE, 149: ("lie-algebra", "lie-bracket"), 150: NUMBERED, 151: NEXT, 152: ("25",),
    153: ("tensor-exponential-well-defined", "tensor-exponential-onto"), 154: NAMES, 155: ("26",), 156: ("26",),
    157: ("euler-vector", "euler-vector-logarithm", "general-screw", "pure-translation", "pure-rotation",
          "euler-vector-unique"),
    158: ("cayley-well-defined",), 159: NUMBERED, 160: NEXT, 161: ("27",), 162: ("cayley-well-defined", "cayley-onto"),
    163: NUMBERED, 164: ("cayley-domain",), 165: ("28",), 166: NEXT, 167: ("29",), 168: ("cayley-well-defined",),
    169: NEXT, 170: ("30",), 171: NEXT, 172: ("31",), 173: NEXT, 174: ("32",), 175: NEXT, 176: ("33",),
    177: ("33-angle", "cayley-onto"), 178: NEXT, 179: NUMBERED,
    180: ("corollary-1-rotation", "corollary-1-translation", "corollary-1-general"),
    181: ("rodrigues-vector", "rodrigues-domain"),
}  # fmt: skip

CAYLEY_QUATERNIONS: dict[int, tuple[str, ...] | str] = {
    183: TITLE, 185: PROSE, 186: NUMBERED, 187: NEXT, 188: ("34",),
    189: ("cayley-quaternion-well-defined", "cayley-quaternion-onto"), 190: NUMBERED, 191: NEXT, 192: ("35",),
    193: NEXT, 194: ("36",),
    195: ("cayley-quaternion-well-defined", "norm-of-1-plus-v", "cayley-quaternion-inverse", "cayley-quaternion-onto"),
    196: NUMBERED, 197: ("corollary-2-rotation", "corollary-2-translation", "corollary-2-general"), 198: ("37",),
    199: ("37",), 200: ("38-domain",), 201: ("38",), 202: NAMES, 203: ("38", "39"), 204: ("39",), 205: ("39",),
    206: ("40",), 207: ("40",), 208: ("41",), 209: ("41",), 210: NEXT, 211: NUMBERED, 212: NEXT, 213: ("42",),
    214: ("cayley-half-well-defined", "cayley-half-onto"), 215: NUMBERED, 216: ("43",), 217: ("43",),
    218: ("cayley-half-well-defined",), 219: ("44",), 220: ("44",), 221: ("44-screw", "44-domain", "cayley-half-onto"),
    222: ("44", "44-screw"), 223: NUMBERED,
    224: ("corollary-3-rotation", "corollary-3-translation", "corollary-3-general"), 225: ("45",), 226: ("45",),
    227: PROSE,
}  # fmt: skip


def _each(first: int, last: int, number: int) -> dict[int, tuple[str, ...] | str]:
    """Lines that hold one numbered equation each."""
    return {line: (str(number + line - first),) for line in range(first, last + 1)}


APPLICATION: dict[int, tuple[str, ...] | str] = {
    414: TITLE, 416: NEXT, 417: TITLE, **_each(418, 424, 92), 425: TITLE, **_each(426, 432, 99), 433: TITLE,
    **_each(434, 440, 106), 441: TITLE, **_each(442, 448, 113), 449: TITLE, **_each(450, 451, 120), 452: ("121",),
    **_each(453, 456, 122), 457: tuple(str(number) for number in range(92, 126)),
    458: ("126", "127", "128", "129", "130", "131"), **_each(459, 464, 126),
    465: ("six-equations", "nature-of-95-to-98"),
    471: TITLE, 473: PROSE, 495: TITLE, 497: NAMES, 498: NAMES, 499: NAMES,
    500: NAMES, 501: NAMES, 502: NAMES, 503: ("10",), 504: NAMES, 505: NAMES, 506: NAMES,
}  # fmt: skip

LINES: dict[int, tuple[str, ...] | str] = {
    **FRONT, **DUAL_ALGEBRA, **MOTION, **QUATERNIONS, **CAYLEY_TENSORS, **CAYLEY_QUATERNIONS, **SECTION_7,
    **SECTION_8, **APPLICATION, **CONCLUSION,
}  # fmt: skip
