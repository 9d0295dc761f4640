"""Every display and claiming sentence of the text by line: the entries that decide it, or why it claims nothing.

Blank lines, the journal's own lines and the reference list are left out.
"""

from __future__ import annotations

Lines = dict[int, tuple[str, ...] | str]

TITLE, NAMES, PROSE, NUMBERED = "title", "names or defines, claims nothing", "prose without a claim", "theorem number"
NEXT = "leads to the next display"
REFERENCE = "names earlier equations only"


def _each(first: int, last: int, number: int) -> Lines:
    """Lines that hold one numbered equation each."""
    return {line: (str(number + line - first),) for line in range(first, last + 1)}


def _order_lists(slug: str, first: int, *parts: str) -> Lines:
    """The lines of a list for the orders 1 … 5."""
    return {first + i: tuple(f"{slug}-{i + 1}{part}" for part in parts) for i in range(5)}


SECTION_1: Lines = {
    20: TITLE, 28: TITLE, 31: PROSE, 33: TITLE, 35: ("isomorphism", "isomorphism-onto", "16"), 36: PROSE,
    37: ("47", "49", "50", "57", "59", "60", "88", "89"), 38: PROSE, 40: TITLE, 42: PROSE, 44: TITLE,
}  # fmt: skip

SECTION_2: Lines = {
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

SECTION_3: Lines = {
    88: TITLE, 90: NEXT, 91: ("13",), 92: NAMES, 93: NUMBERED, 94: ("structure-unique",), 95: ("14",),
    96: ("structure-parts",), 97: ("orthogonal-group",), 98: NUMBERED, 99: ("isomorphism", "isomorphism-onto"),
    100: ("15",), 101: NAMES, 102: NEXT, 103: ("16",), 104: ("structural-invariants",), 105: ("isomorphism-onto",),
    106: NUMBERED, 107: ("representation",), 108: ("17",), 109: NEXT,
    110: ("18", "18-axis", "18-translation", "18-moment"),
    111: ("mozzi-chasles", "natural-rotation", "natural-translation"), 112: NUMBERED, 113: ("19",), 114: ("19",),
    115: NUMBERED, 116: ("19", "14", "17"),
}  # fmt: skip

SECTION_4: Lines = {
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

SECTION_5: Lines = {
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

SECTION_6: Lines = {
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

SECTION_7: Lines = {
    229: TITLE, 231: "compares with other works only", 232: NUMBERED, 233: NEXT,
    234: ("46",), 235: ("theorem-11-well-defined", "theorem-11-onto"), 236: TITLE, 237: ("theorem-11-well-defined",),
    238: NEXT, 239: NUMBERED, 240: ("theorem-12-branches", "theorem-12-preimages"), 241: ("47",), 242: TITLE,
    243: ("46", "47", "theorem-12-reference"), 244: NUMBERED,
    245: ("corollary-4-rotation", "corollary-4-translation", "corollary-4-otherwise"), 246: NEXT, 247: ("48",),
    248: NEXT, 249: ("49",), 250: ("principal-vector",),
    251: ("shadow-vectors", "shadow-formula", "shadow-at-infinity", "shadow-avoids-singularity"),
    252: NUMBERED, 253: ("theorem-13-reference",), 254: ("50",), 255: NEXT, 256: ("51",), 257: ("52",), 258: NAMES,
    259: TITLE,
    260: ("theorem-13-proof",), 261: ("53",), 262: NEXT, 263: ("54",), 264: NEXT, 265: ("55",),
    266: "end of a proof", 267: NUMBERED, 268: NEXT, 269: ("56",), 270: NEXT,
    **_order_lists("list", 271, "-polynomials", "-quaternion", "-vector"),
    276: ("list-shadows", "tensor-shadows"), 277: NUMBERED, 278: NEXT, 279: ("57",), 280: NEXT,
    **_order_lists("tensor", 281, "", "-vector"),
    286: NEXT, 287: ("58",), 288: PROSE, 289: NAMES, 290: NUMBERED, 291: NAMES, 292: NAMES, 293: ("59",),
    294: ("theorem-15-unit",), 295: TITLE, 296: ("theorem-15-unit", "theorem-15-value"), 297: ("theorem-15-branches",),
    298: ("60",), 299: NUMBERED, 300: NEXT, 301: ("61",), 302: ("theorem-16-factor",), 303: TITLE,
    304: ("theorem-16-step", "theorem-16-reference"), 305: NUMBERED, 306: NEXT, 307: ("62",),
    308: ("vector-w",), 309: ("63",), 310: ("64",),
    311: NAMES, 312: NUMBERED, 313: ("corollary-5-reference",), 314: ("65",), 315: ("vector-w",),
    316: "announces the five families that follow", 317: "number of a family", 318: ("normal-vector",),
    319: ("normal-quaternion", "normal-w"), 320: ("normal-tensor", "normal-w"),
    321: NEXT, 322: ("limit-quaternion",), 323: ("limit-tensor",),
    324: "number of a family", 325: ("orthographic-vector",), 326: ("orthographic-quaternion",),
    327: ("orthographic-tensor",), 328: "number of a family", 329: ("lambert-vector",), 330: ("lambert-quaternion",),
    331: ("lambert-tensor",), 332: "number of a family", 333: ("breusing-vector",), 334: ("breusing-quaternion",),
    335: ("breusing-tensor",), 336: "number of a family", 337: ("sine-vector",), 338: ("sine-quaternion",),
    339: ("sine-tensor",), 340: ("sine-P", "sine-Q"),
}  # fmt: skip

SECTION_8: Lines = {
    342: TITLE, 344: NAMES, 345: NEXT, 346: ("66",), 347: NUMBERED, 348: NEXT, 349: ("67",), 350: NEXT, 351: ("68",),
    352: ("velocity-tensor-sum", "velocity-tensor-skew"), 353: ("dual-angular-velocity",), 354: ("69",),
    355: ("69", "velocity-at-origin"), 356: NEXT, 357: NUMBERED, 358: ("theorem-19-unique",), 359: ("70",), 360: TITLE,
    361: ("theorem-19-unique",), 362: NEXT, 363: ("71",), 364: NEXT, 365: ("72",), 366: ("determinant",), 367: ("73",),
    368: ("73",), 369: "summarizes the theorem", 370: NUMBERED, 371: ("body-twist",), 372: ("74",),
    373: ("eighteen-equations",), 374: NUMBERED, 375: NEXT, 376: ("75",), 377: "joins two displays", 378: ("76",),
    379: NAMES, 380: ("eight-equations",), 381: NEXT, 382: ("77",), 383: ("78",), 384: ("theta",), 385: NEXT,
    386: ("79",), 387: ("80",), 388: NAMES, 389: NEXT, 390: ("81",), 391: NEXT, 392: ("82",), 393: ("sinc",),
    394: NEXT, 395: ("83",), 396: ("dexp-inverse-domain",), 397: ("84",), 398: NEXT, 399: ("85",),
    400: NUMBERED, 401: NEXT, 402: ("86",),
    403: ("87",), 404: NEXT, 405: ("88",), 406: ("89",), 407: REFERENCE, 408: ("90", "91"), 409: ("90",), 410: ("91",),
    411: NAMES, 412: ("six-real-equations",),
}  # fmt: skip

SECTION_9: Lines = {
    414: TITLE, 416: NEXT, 417: TITLE, **_each(418, 424, 92), 425: TITLE, **_each(426, 432, 99), 433: TITLE,
    **_each(434, 440, 106), 441: TITLE, **_each(442, 448, 113), 449: TITLE, **_each(450, 451, 120), 452: ("121",),
    **_each(453, 456, 122), 457: tuple(str(number) for number in range(92, 126)),
    458: ("126", "127", "128", "129", "130", "131"), **_each(459, 464, 126),
    465: ("six-equations", "nature-of-95-to-98"),
}  # fmt: skip

SECTION_10: Lines = {467: TITLE, 469: ("no-transcendental-functions", "six-real-equations")}

BACK: Lines = {
    471: TITLE, 473: PROSE, 495: TITLE, 497: NAMES, 498: NAMES, 499: NAMES,
    500: NAMES, 501: NAMES, 502: NAMES, 503: ("10",), 504: NAMES, 505: NAMES, 506: NAMES,
}  # fmt: skip
"""After the last section; one sentence there rests on an equation."""

LINES: Lines = {
    **SECTION_1, **SECTION_2, **SECTION_3, **SECTION_4, **SECTION_5, **SECTION_6, **SECTION_7, **SECTION_8, **SECTION_9,
    **SECTION_10, **BACK,
}  # fmt: skip
