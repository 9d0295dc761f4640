"""The second half of the inventory: sections 7, 8 and 10, lines 228-412 and 467-469."""

from __future__ import annotations

TITLE, NAMES, PROSE, NUMBERED = "title", "names or defines, claims nothing", "prose without a claim", "theorem number"
NEXT = "leads to the next display"
REFERENCE = "names earlier equations only"


def order_lists(slug: str, first: int, *parts: str) -> dict[int, tuple[str, ...]]:
    """The lines of a list for the orders 1 … 5."""
    return {first + i: tuple(f"{slug}-{i + 1}{part}" for part in parts) for i in range(5)}


SECTION_7: dict[int, tuple[str, ...] | str] = {
    229: TITLE, 231: "compares with other works only", 232: NUMBERED, 233: NEXT,
    234: ("46",), 235: ("theorem-11-well-defined", "theorem-11-onto"), 236: TITLE, 237: ("theorem-11-well-defined",),
    238: NEXT, 239: NUMBERED, 240: ("theorem-12-branches", "theorem-12-preimages"), 241: ("47",), 242: TITLE,
    243: ("46", "47"), 244: NUMBERED,
    245: ("corollary-4-rotation", "corollary-4-translation", "corollary-4-otherwise"), 246: NEXT, 247: ("48",),
    248: NEXT, 249: ("49",), 250: ("principal-vector",),
    251: ("shadow-vectors", "shadow-formula", "shadow-at-infinity", "shadow-avoids-singularity"),
    252: NUMBERED, 253: NEXT, 254: ("50",), 255: NEXT, 256: ("51",), 257: ("52",), 258: NAMES, 259: TITLE,
    260: ("theorem-13-proof",), 261: ("53",), 262: NEXT, 263: ("54",), 264: NEXT, 265: ("55",),
    266: "end of a proof", 267: NUMBERED, 268: NEXT, 269: ("56",), 270: NEXT,
    **order_lists("list", 271, "-polynomials", "-quaternion", "-vector"),
    276: ("list-shadows", "tensor-shadows"), 277: NUMBERED, 278: NEXT, 279: ("57",), 280: NEXT,
    **order_lists("tensor", 281, "", "-vector"),
    286: NEXT, 287: ("58",), 288: PROSE, 289: NAMES, 290: NUMBERED, 291: NAMES, 292: NAMES, 293: ("59",),
    294: ("theorem-15-unit",), 295: TITLE, 296: ("theorem-15-unit", "theorem-15-value"), 297: ("theorem-15-branches",),
    298: ("60",), 299: NUMBERED, 300: NEXT, 301: ("61",), 302: ("theorem-16-factor",), 303: TITLE,
    304: ("theorem-16-step",), 305: NUMBERED, 306: NEXT, 307: ("62",), 308: ("vector-w",), 309: ("63",), 310: ("64",),
    311: NAMES, 312: NUMBERED, 313: NEXT, 314: ("65",), 315: ("vector-w",),
    316: "announces the five families that follow", 317: "number of a family", 318: ("normal-vector",),
    319: ("normal-quaternion", "normal-w"), 320: ("normal-tensor", "normal-w"),
    321: NEXT, 322: ("limit-quaternion",), 323: ("limit-tensor",),
    324: "number of a family", 325: ("orthographic-vector",), 326: ("orthographic-quaternion",),
    327: ("orthographic-tensor",), 328: "number of a family", 329: ("lambert-vector",), 330: ("lambert-quaternion",),
    331: ("lambert-tensor",), 332: "number of a family", 333: ("breusing-vector",), 334: ("breusing-quaternion",),
    335: ("breusing-tensor",), 336: "number of a family", 337: ("sine-vector",), 338: ("sine-quaternion",),
    339: ("sine-tensor",), 340: ("sine-P", "sine-Q"),
}  # fmt: skip

SECTION_8: dict[int, tuple[str, ...] | str] = {
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

CONCLUSION: dict[int, tuple[str, ...] | str] = {467: TITLE, 469: ("no-transcendental-functions", "six-real-equations")}
