"""Kinds of the values in claims, and their names: letters, and definitions of a file, filled in or kept as calls.

A kind is "integer", "number", "quaternion", "truth" or, for a matrix, its numbers of rows and columns. A vector is
(3, 1), a twist (6, 1), a tensor (3, 3), a pose (4, 4).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice
from typing import Any

from . import operator_table
from .printed import ATOM, LIST, Apply, Number, Symbol, Term, Trait, macro, takes_apart, walk, with_trait
from .substitution import substituted

Kind = str | tuple[int, int]
VECTOR, TWIST, TENSOR, POSE = (3, 1), (6, 1), (3, 3), (4, 4)
NUMBERS = ("integer", "number")
NAMES: dict[Kind, str] = {VECTOR: "vector", TENSOR: "tensor (3x3)", TWIST: "column of 6", POSE: "4x4 matrix",
                          "truth": "relation", "infinity": "infinity"}


class KindError(ValueError):
    """Error for arguments of the wrong kind: what was expected and what was given, and the place of the argument."""

    def __init__(self, message: str, place: int | None = None) -> None:
        super().__init__(message)
        self.place = place


def name(kind: Kind) -> str:
    """Return a kind in words, with an article."""
    return article(NAMES.get(kind, kind if isinstance(kind, str) else f"{kind[0]}x{kind[1]} matrix"))


def article(words: str) -> str:
    return words if words == "infinity" else f"{'an' if words[0] in 'aeiou8' else 'a'} {words}"


def is_number(kind: Kind) -> bool:
    return kind in NUMBERS


TESTS: dict[str, Callable[[Kind], bool]] = {
    "integer": lambda kind: kind == "integer",
    "number": is_number,
    "vector": lambda kind: kind == VECTOR,
    "quaternion": lambda kind: kind in ("quaternion", VECTOR) or is_number(kind),
    "tensor": lambda kind: kind == TENSOR,
    "pose": lambda kind: kind == POSE,
    "twist": lambda kind: kind == TWIST,
    "column": lambda kind: is_number(kind) or (isinstance(kind, tuple) and kind[1] == 1),
    "matrix": lambda kind: isinstance(kind, tuple),
    "square matrix": lambda kind: isinstance(kind, tuple) and kind[0] == kind[1],
    "relation": lambda kind: kind == "truth",
    "infinity": lambda kind: kind == "infinity",
    "value": lambda kind: kind not in ("truth", "infinity"),
}
"""Words for what an operation takes."""


def sum_kind(a: Kind, b: Kind, sign: str) -> Kind:
    """Return the kind of a sum; a number plus a vector is a quaternion."""
    if a == b:
        return a
    if is_number(a) and is_number(b):
        return "number"
    if TESTS["quaternion"](a) and TESTS["quaternion"](b):
        return "quaternion"
    raise KindError(f"{name(a)} {sign} {name(b)} has no meaning")


def product_kind(a: Kind, b: Kind) -> Kind:
    if is_number(a) or is_number(b):
        return (b if is_number(a) else a) if a == b or not (is_number(a) and is_number(b)) else "number"
    if "quaternion" in (a, b) and TESTS["quaternion"](a) and TESTS["quaternion"](b):
        return "quaternion"
    if isinstance(a, tuple) and isinstance(b, tuple) and a[1] == b[0]:
        return "number" if (a[0], b[1]) == (1, 1) else (a[0], b[1])
    hint = ": write dot, cross, dyad or quaternions" if a == b == VECTOR else ""
    raise KindError(f"{name(a)} * {name(b)} has no meaning{hint}")


def quotient_kind(a: Kind, b: Kind) -> Kind:
    if is_number(b):
        return "number" if is_number(a) else a
    if b == "quaternion" and TESTS["quaternion"](a):
        return "quaternion"
    raise KindError(f"{name(a)} / {name(b)} has no meaning: write inverse")


def power_kind(a: Kind, b: Kind) -> Kind:
    if is_number(a) and is_number(b):
        return "number"
    if b == "integer" and (a == "quaternion" or TESTS["square matrix"](a)):
        return a
    if a == "quaternion" and is_number(b):
        return a
    if a == VECTOR and b == "integer":
        raise KindError("a vector ** an integer has no meaning: write norm(v)**2 or dot(v, v), of a quaternion q*q")
    raise KindError(f"{name(a)} ** {name(b)} has no meaning")


def require_comparable(a: Kind, b: Kind, zero: bool, ordered: bool) -> None:
    """Raise KindError unless two sides of a relation can be compared; 0 is the zero of every kind."""
    if "truth" in (a, b):
        raise KindError("a side of a relation is a value, got a relation")
    numbers = is_number(a) and is_number(b)
    if ordered and not numbers:
        raise KindError(f"an inequality takes numbers, got {name(a)} and {name(b)}")
    quaternions = "quaternion" in (a, b) and TESTS["quaternion"](a) and TESTS["quaternion"](b)
    if not (a == b or numbers or quaternions or zero):
        raise KindError(f"{name(a)} is compared with {name(b)}")


ZERO = Number(0)


PARTS_MAX = 6000
"""Largest number of parts of a claim with its definitions filled in."""


class ClaimError(ValueError):
    """Error for a text that is no claim, with its column, counted from 1; 0 for no place in a text.

    `at` is the file and line of a text that stands in a document.
    """

    def __init__(self, message: str, column: int = 0, at: tuple[str, int] | None = None) -> None:
        super().__init__(message)
        self.message, self.column, self.at = message, column, at

    def __str__(self) -> str:
        return f"column {self.column}: {self.message}" if self.column else self.message

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.message, self.column, self.at)


@dataclass
class Abbreviation:
    """Definition of a file: a name with parameters and a text, whose kind follows from those of its arguments."""

    name: str
    parameters: tuple[str, ...]
    text: str
    latex: str = ""  # as printed; by its name if it is empty
    known: dict[tuple[Kind, ...], tuple[Term, Kind]] = field(default_factory=dict)

    @property
    def head(self) -> str:
        """Name with its parameters, as in the file."""
        return f"{self.name}({', '.join(self.parameters)})" if self.parameters else self.name

    def symbol(self, kinds: tuple[Kind, ...]) -> Symbol:
        """Return the symbol of the name, another one for arguments of each further list of kinds."""
        quantity = "function of parts" if takes_apart(self.known[kinds][0]) else "function"
        others = list(self.known).index(kinds)
        name = f"{self.name} {others + 1}" if others else self.name
        return Symbol(name, quantity, self.latex or latex_of(self.name), self.name)

    def symbols(self) -> tuple[Symbol, ...]:
        return tuple(Symbol(f"{p} of {self.name}", "index", latex_of(p), p) for p in self.parameters)


@dataclass(frozen=True)
class Scope:
    """Names that a claim may use: letters with symbols and kinds, and abbreviations.

    `local` letters, such as the index of a sum or the parameter of an abbreviation, stand before declared `letters`.
    Another abbreviation does not know them.
    """

    letters: Mapping[str, tuple[Symbol, Kind]]
    abbreviations: Mapping[str, Abbreviation] = field(default_factory=dict)
    open: tuple[str, ...] = ()  # abbreviations that are being read
    local: Mapping[str, tuple[Symbol, Kind]] = field(default_factory=dict)

    def with_letter(self, name: str, symbol: Symbol, kind: Kind) -> Scope:
        return replace(self, local={**self.local, name: (symbol, kind)})

    def of(self, called: Abbreviation, kinds: Sequence[Kind]) -> Scope:
        """Return the scope of the text of an abbreviation, whose parameters have these kinds."""
        given = dict(zip(called.parameters, zip(called.symbols(), kinds, strict=True), strict=True))
        return replace(self, open=(*self.open, called.name), local=given)

    @property
    def known(self) -> Mapping[str, tuple[Symbol, Kind]]:
        return {**self.letters, **self.local}


def expanded(term: Term, abbreviations: Mapping[str, Abbreviation]) -> Term:
    """Return a term with the abbreviations filled in; raise ClaimError if it becomes too long."""
    result = _expanded(term, abbreviations, {})
    if sum(1 for _ in islice(walk(result), PARTS_MAX + 1)) > PARTS_MAX:
        raise ClaimError(f"with its definitions the claim has more than {PARTS_MAX} parts")
    return result


def _expanded(term: Term, abbreviations: Mapping[str, Abbreviation], known: dict[Term, Term]) -> Term:
    """Return a term with the abbreviations filled in; equal parts become one part."""
    if not isinstance(term, Apply):
        return term
    if term not in known:
        arguments = [_expanded(a, abbreviations, known) for a in term.arguments]
        found: Term = Apply(term.operator.name, *arguments)
        if term.operator.name.startswith(CALL):
            function = term.arguments[0]
            assert isinstance(function, Symbol)
            called, kinds = abbreviations[str(function.args[3])], CALLS[term.operator.name]
            body = _expanded(called.known[kinds][0], abbreviations, known)
            found = substituted(body, dict(zip(called.symbols(), arguments[1:], strict=True)))
        known[term] = known.setdefault(found, found)
    return known[term]


def contracted(term: Term, names: Mapping[Term, Term]) -> Term:
    """Return a term in which parts stand by their names, the largest first."""
    if term in names:
        return names[term]
    if not isinstance(term, Apply):
        return term
    return Apply(term.operator.name, *(contracted(a, names) for a in term.arguments))


CALL = "call "
CALLS: dict[str, tuple[Kind, ...]] = {}
"""Kinds of the arguments of an abbreviation, by the operator that calls it."""


def call(abbreviation: Abbreviation, arguments: Sequence[Term], kinds: tuple[Kind, ...]) -> Term:
    """Return the term of a call: one operator for each list of kinds, since the meaning follows from them."""
    printed = abbreviation.latex if "#" in abbreviation.latex else ""
    delicate = bool(with_trait(Trait.DELICATE, abbreviation.known[kinds][0]))
    name = f"{CALL}{'; '.join(map(str, kinds))}{' delicate' * delicate}{printed}"
    if name not in CALLS:
        places = ", ".join(f"{{{i}}}" for i in range(1, len(kinds) + 1))
        shown = (rf"{{0}}\left({places}\right)", f"{{0}}({places})") if kinds else ("{0}", "{0}")
        if printed:
            shown = macro(printed, 1), shown[1]
        traits = Trait.DELICATE if delicate else Trait.NONE
        operator_table.define(name, *shown, ATOM, (LIST,), _unfilled, traits=traits)
        CALLS[name] = kinds
    return Apply(name, abbreviation.symbol(kinds), *arguments)


def _unfilled(env: Any, *parts: Any) -> Any:
    raise NotImplementedError("a claim is evaluated with its definitions filled in")


GREEK = re.findall(
    r"\w+",
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi rho sigma tau upsilon phi chi psi omega "
    "Gamma Delta Theta Lambda Xi Sigma Phi Psi Omega",
)


def latex_of(name: str) -> str:
    """Return the LaTeX of a name: Greek letters by their names, digits and what follows an underscore below."""
    stem, _, rest = name.partition("_")
    if found := re.fullmatch(r"([A-Za-z]+)(\d+)", stem):
        stem, rest = found[1], found[2] + ("," + rest if rest else "")
    stem = rf"\{stem}" if stem in GREEK else stem if len(stem) == 1 else rf"\mathrm{{{stem}}}"
    below = "".join(rf"\{part}" if part in GREEK else part for part in re.split(r"_", rest))
    return f"{stem}_{{{below}}}" if below else stem
