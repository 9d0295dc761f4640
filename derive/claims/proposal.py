r"""Claims proposed from LaTeX: a formula is read only if each sign of it is known, and its claim prints the same signs.

Letters are known by their declarations, never by their look. Signs with several meanings are not read, such as ``\hat``
or a function of a product without brackets.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import cached_property
from itertools import zip_longest

from .language.claims import statement
from .language.names import GREEK, Abbreviation, ClaimError, Scope, is_number, latex_of
from .language.operations import CONSTANTS, OPERATIONS, written
from .language.printed import OPERATORS, latex

SIGN = re.compile(r"\\operatorname\s*\{[A-Za-z]+\}|\\[A-Za-z]+|\\.|\d+|\S", re.DOTALL)
LAYOUT = (r"\left", r"\right", r"\,", r"\;", r"\:", r"\!", r"\ ", "~", r"\displaystyle")
SAME = {
    r"\le": r"\leq", r"\ge": r"\geq", r"\ne": r"\neq", r"\tfrac": r"\frac", r"\dfrac": r"\frac", r"\lvert": "|",
    r"\rvert": "|", r"\|": "|", r"\lVert": "|", r"\rVert": "|", r"\top": "T", r"\widetilde": r"\tilde",
    r"\tr": r"\operatorname{trace}", r"\operatorname{tr}": r"\operatorname{trace}", r"\lbrack": "[", r"\rbrack": "]",
}  # fmt: skip
"""Signs that say the same as another one."""
RELATIONS = {"=": "==", r"\neq": "!=", "<": "<", ">": ">", r"\leq": "<=", r"\geq": ">="}
PRODUCTS = {r"\cdot": "dot", r"\times": "cross", r"\otimes": "dyad"}
ACCENTS = {r"\tilde": "skew", r"\dot": "rate"}
CHARACTERS_MAX = 4000
"""Largest number of characters in a formula that is read."""
CLOSING = {"(": ")", "[": "]", "{": "}", "|": "|"}
FONTS = ("", r"\mathbf", r"\boldsymbol", r"\bm", r"\vec", r"\mathrm", r"\mathsf")
PREFIX = re.compile(r"(\\\w+(?:\{\w+\})?) \{0\}")
FUNCTIONS = {
    found[1]: name for name, row in OPERATIONS.items() if len(row.takes) == 1
    and (found := PREFIX.fullmatch(OPERATORS[row.operator].latex.replace("{{", "{").replace("}}", "}")))
}  # fmt: skip
"""Calls by the sign that the printer puts before their argument."""


REACH = "brackets show how far a sign reaches"


class NotReadError(ValueError):
    """Error for a formula that is not read: the first sign that is not understood, and why."""


def signs(formula: str) -> list[str]:
    """Return the signs of a formula without layout; a group of one sign has no braces."""
    found: list[str] = []
    for sign in SIGN.findall(formula):
        sign = re.sub(r"(?<=\w)\s", "", sign)
        sign = SAME.get(sign, sign)
        while sign.isdigit() and _is_argument(found):
            found.append(sign[0])  # an argument without braces is one digit
            sign = sign[1:]
        if sign.isdigit() and found and found[-1].isdigit() and not _is_argument(found[:-1]):
            sign = found.pop() + sign  # spaces between digits are not printed
        if sign and sign not in LAYOUT:
            found.append(sign)
        if found[-3:-2] == ["{"] and found[-1] == "}" and found[-2] not in "{}":
            found[-3:] = [found[-2]]
    while found and found[-1] in ".,;:":
        found.pop()
    ends = [r"\\", *found, "", ""]
    return [sign for sign, *near in zip(found, ends, ends[2:], ends[3:], strict=False) if not _only_aligns(sign, *near)]


def _is_argument(found: list[str]) -> bool:
    """Return whether the sign after these, without braces, is an argument of the last command."""
    at, depth = len(found) - 1, 0
    while at > 0 and (depth := depth + (found[at] == "}") - (found[at] == "{")) > 0:
        at -= 1
    is_second = found[-1:] != ["{"] and found[max(at - 1, 0) : at] == [r"\frac"]
    return is_second or found[-1:] in (["^"], ["_"], [r"\frac"], [r"\sqrt"])


def _only_aligns(sign: str, before: str, after: str, later: str) -> bool:
    """Return whether a sign aligns the rows of one formula, where another one may separate two formulas."""
    if sign == "&":
        return before in (r"\\", *RELATIONS) or after in RELATIONS
    return sign == r"\\" and (later if after == "&" else after) in (*RELATIONS, "+", "-")


class Spellings(dict[tuple[str, ...], tuple[str, str]]):
    """Names with their LaTeX, by the signs that print them."""

    left_out: Spellings  # names that are printed in several ways

    def only(self, used: Mapping[str, set[tuple[str, ...]]]) -> Spellings:
        """Return the names that are printed in one way, with that one."""
        found = Spellings({way: row for way, row in self.items() if used.get(row[0]) == {way}})
        found.left_out = Spellings({way: row for way, row in self.items() if len(used.get(row[0], ())) > 1})
        return found

    @cached_property
    def sizes(self) -> dict[str, list[int]]:
        """Numbers of signs of the names that begin with a sign, the largest first."""
        found: dict[str, set[int]] = {}
        for way in self:
            found.setdefault(way[0], set()).add(len(way))
        return {sign: sorted(sizes, reverse=True) for sign, sizes in found.items()}

    def at(self, given: list[str], place: int) -> tuple[str, ...]:
        """Return the signs of the name that stands at a place of a formula; none if there is no name."""
        for size in self.sizes.get(given[place], ()):
            way = tuple(given[place : place + size])
            if way in self and given[place + size : place + size + 1] != ["_"]:
                return way
        return ()


PLAIN = (*FUNCTIONS, *ACCENTS, *PRODUCTS, *RELATIONS, r"\frac", r"\sqrt")
"""Commands that leave the letter after them what it is."""


def spellings(scope: Scope) -> Spellings:
    """Return the letters, constants and definitions of a scope by the signs that may print them."""
    constants = {name: CONSTANTS[name] for name in ("I", "pi")}
    printed = {name: str(symbol.args[2]) for name, (symbol, _) in {**constants, **scope.letters}.items()}
    found = Spellings({tuple(signs(shown)): (name, shown) for name, shown in printed.items()})
    for name in filter(str.isidentifier, (*scope.letters, *scope.abbreviations)):
        stem, below, rest = latex_of(name).partition("_")
        for font in FONTS:
            shown = f"{font}{{{stem}}}{below}{rest}" if font else latex_of(name)
            found.setdefault(tuple(signs(shown)), (name, shown))
    return found


def ways(formulas: Iterable[str], known: Spellings) -> dict[str, set[tuple[str, ...]]]:
    """Return how each name is printed in formulas."""
    found: dict[str, set[tuple[str, ...]]] = {}
    for given in (signs(formula) for formula in formulas if len(formula) <= CHARACTERS_MAX):
        at, before = 0, ""
        while at < len(given):
            way = known.at(given, at)
            if way and not (before.startswith("\\") and before not in PLAIN):
                found.setdefault(known[way][0], set()).add(way)
            at += len(way) or 1
            before = "" if way else given[at - 1]  # a letter changes no letter after it
    return found


def proposed(formula: str, scope: Scope, known: Spellings) -> str:
    """Return the claim of a formula, or raise NotReadError."""
    if len(formula) > CHARACTERS_MAX:
        raise NotReadError(f"a formula of {len(formula)} characters, and {CHARACTERS_MAX} are the most")
    given = signs(formula)
    try:
        text = _Reader(given, scope, known).relation()
        claim = statement(text, scope)
    except RecursionError:
        raise NotReadError("too many brackets in each other") from None
    except ClaimError as error:
        raise NotReadError(f"read as {text}, which is no claim: {error.message}") from None
    a, b = ([sign for sign in side if sign not in "{}()[]"] for side in (given, signs(latex(claim))))
    for sign, other in zip_longest(a, b, fillvalue="the end"):
        if sign != other:
            raise NotReadError(f"{sign}: the claim {text} is printed with {other} there")
    return written(claim)


class _Reader:
    """Reader of the signs of a formula, which writes a claim."""

    def __init__(self, given: list[str], scope: Scope, known: Spellings) -> None:
        self.given, self.scope, self.known = [*given, "the end"], scope, known
        self.at = 0

    @property
    def next(self) -> str:
        return self.given[self.at]

    def taken(self, among: Collection[str]) -> str:
        """Return the next sign and step over it, if it is one of these; else nothing."""
        if self.next not in among or self.next == "the end":
            return ""
        self.at += 1
        return self.given[self.at - 1]

    def fail(self, why: str = "") -> NotReadError:
        return NotReadError(f"{self.next}{': ' * bool(why)}{why}")

    def relation(self) -> str:
        parts = [self.sum()]
        while sign := self.taken(RELATIONS):
            parts += [RELATIONS[sign], self.sum()]
        if self.next != "the end" or len(parts) == 1:
            raise self.fail()
        return " ".join(parts)

    def sum(self, inside: str = "") -> str:
        """Read a sum up to a sign that ends it, such as the bracket that closes the group around it."""
        text = f"-{self.product(inside)}" if self.taken("-") else self.product(inside)
        while sign := self.taken("+-"):
            text += f" {sign} {self.product(inside)}"
        return text

    def product(self, inside: str) -> str:
        factors, ends = [self.factor()], (*RELATIONS, *"+-)]},", inside, "the end")
        while self.next not in ends:
            sign = self.taken(PRODUCTS)
            if not sign:
                factors.append(self.factor())
                continue
            if not all(map(self.is_number, factors[:-1])):
                raise self.fail(REACH)
            factors[-1] = f"{PRODUCTS[sign]}({factors[-1]}, {self.factor()})"
            if self.next not in ends:
                raise self.fail(REACH)
        return factors[0] if len(factors) == 1 else f"({'*'.join(factors)})"

    def is_number(self, text: str) -> bool:
        try:
            statement(f"{text} <= 0", self.scope)
        except ClaimError:
            return False
        return True

    def factor(self) -> str:
        if sign := self.taken(FUNCTIONS):
            return self.function(sign)
        text = self.base()
        return self.raised(text) if self.taken("^") else text

    def raised(self, text: str) -> str:
        if ("T",) not in self.known and self.taken("T"):
            return f"transpose({text})"
        if self.taken("*"):
            return f"conjugate({text})"
        return f"{text}**({self.argument()})"

    def function(self, sign: str) -> str:
        """Read the argument of a function: a group, or one factor after which it is clear that it ends."""
        call = FUNCTIONS[sign]
        if self.next in "([":
            text, unclear = f"{call}({self.base()})", self.next == "^"
        elif self.next in FUNCTIONS or self.next == "^":
            raise self.fail(REACH)
        else:
            text = f"{call}({self.factor()})"
            ends = self.next in (*RELATIONS, *PRODUCTS, *"+-)]}|,", *FUNCTIONS, "the end")
            unclear = not ends and (OPERATIONS[call].takes != ("number",) or not self.is_matrix())
        if unclear:
            raise self.fail(REACH)
        return text

    def is_matrix(self) -> bool:
        """Return whether the next factor is surely no part of a number."""
        name, _ = self.known.get(self.known.at(self.given, self.at), ("", ""))
        letters = {**CONSTANTS, **self.scope.letters}
        return self.next == r"\tilde" or (name in letters and not is_number(letters[name][1]))

    def argument(self) -> str:
        """Read an argument of a command: a group in braces, or one sign."""
        if self.next == "{":
            return self.group()
        if self.next == "-":
            raise self.fail()
        return self.base()

    def group(self) -> str:
        closing = CLOSING[self.taken(CLOSING)]
        text = self.sum(closing)
        if not self.taken(closing):
            raise self.fail()
        return text

    def base(self) -> str:
        if self.next.isdigit():
            return self.taken((self.next,))
        if name := self.name():
            return name
        if self.taken((r"\frac",)):
            return f"(({self.argument()})/({self.argument()}))"
        if self.next == r"\sqrt" and self.given[self.at + 1] != "[":
            self.at += 1
            return f"sqrt({self.argument()})"
        if sign := self.taken(ACCENTS):
            return f"{ACCENTS[sign]}({self.argument()})"
        if self.next in CLOSING and self.next != "{":  # braces are not seen, so they group nothing
            return f"norm({self.group()})" if self.next == "|" else f"({self.group()})"
        if way := self.known.left_out.at(self.given, self.at):
            raise self.fail(f"the letter {self.known.left_out[way][0]} is printed in several ways: print it in one")
        is_letter = self.next.lstrip("\\") in GREEK or (len(self.next) == 1 and self.next.isalpha())
        raise self.fail("no declared letter" if is_letter else "")

    def name(self) -> str:
        """Read a letter, a constant or a call of a definition; nothing if no such name stands here."""
        way = self.known.at(self.given, self.at)
        if not way:
            return ""
        self.at += len(way)
        name, _ = self.known[way]
        called = None if name in self.scope.letters else self.scope.abbreviations.get(name)
        return f"{name}({', '.join(self.parts(called))})" if called and called.parameters else name

    def parts(self, called: Abbreviation) -> Iterator[str]:
        if not self.taken("("):
            raise self.fail(f"{called.head} needs its arguments in brackets")
        yield self.sum()
        while self.taken(","):
            yield self.sum()
        if not self.taken(")"):
            raise self.fail()

