"""Read straight-line programs from the text of a language, as the lists of steps that `listings` runs."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from .batches import ValidationFailed

TOKEN = re.compile(
    r"\s*(?:(\d+(?:\.\d+)?(?:e[-+]?\d+)?)|([A-Za-z_]\w*(?:(?:::|\.)[A-Za-z_]\w*)*)"
    r"|(\.\*|\./|==|[-+*/<&|?:()\[\],]))"
)
"""Number, name with its path, or sign."""
LEVELS = (("|",), ("&",), ("<", "=="), ("+", "-"), ("*", "/", ".*", "./"))
"""Infix signs, those that bind weakly first. Brackets stand wherever languages differ."""
OPERATIONS = {
    "|": "or", "&": "and", "<": "less", "==": "equal", "+": "add", "-": "subtract", "*": "multiply", ".*": "multiply",
    "/": "divide", "./": "divide",
}  # fmt: skip
"""Operations in the names of listings, by sign."""


@dataclass(frozen=True)
class Grammar:
    """Statements of a language: patterns of a function's head and of statements, and names of functions.

    ``head`` has the groups ``name`` and ``given``, and ``made`` if it numbers the results; ``end`` is the line that
    closes a function. The kinds of statements and their groups: ``value`` and ``number`` (of the chart) with ``name``
    and ``value``; ``call`` with ``called`` and ``given``, and ``names`` unless ``read`` follows; ``unpacked`` with
    ``names`` and ``whole``; ``result`` with ``value``.
    """

    head: str
    end: str
    statements: Mapping[str, str]
    functions: Mapping[str, str]  # operations in the names of listings, by function
    program: Callable[[str], str] = str  # name of a program in listings, by its name in calls and heads
    made: str = ""  # pattern of a name of an argument's list with its length, if functions take lists
    continued: str = ""  # mark at the end of a line that the next one continues
    first: int = 0  # place of the first result, where results are stored one by one


@dataclass
class Body:
    """Steps of a program while it is read."""

    grammar: Grammar
    numbers: Mapping[str, float]
    lists: dict[str, list[str]] = field(default_factory=dict)
    steps: list[list[Any]] = field(default_factory=list)
    results: list[Any] = field(default_factory=list)

    def step(self, operation: str, *operands: Any) -> str:
        """Add an operation; return the name of its result."""
        name = f"%{len(self.steps)}"
        self.steps.append([name, operation, *operands])
        return name

    def statement(self, text: str) -> None:
        """Read a statement."""
        for kind, pattern in self.grammar.statements.items():
            if found := re.fullmatch(pattern, text, re.DOTALL):
                getattr(self, f"_{kind}")(**found.groupdict())
                return
        raise ValidationFailed(f"no statement of a program: {text}")

    def _number(self, name: str, value: str) -> None:
        if float(value) != self.numbers.get(name):
            raise ValidationFailed(f"the number {name} is {value}, not {self.numbers.get(name)}")

    def _value(self, name: str, value: str) -> None:
        if (found := self.expression(value)) == (self.steps or [[None]])[-1][0]:
            self.steps[-1][0] = name
        else:
            self.steps.append([name, "add", 0, found])

    def _result(self, value: str, place: str = "") -> None:
        if place and int(place) != self.grammar.first + len(self.results):
            raise ValidationFailed(f"result {place} follows {len(self.results)} results")
        self.results += self.listed(value[1:-1] if _is_enclosed(value) else value)

    def _call(self, called: str, given: str, names: str = "") -> None:
        made = re.findall(r"\w+|~", names)
        self.steps.append([made, self.grammar.program(called), *self.listed(given)])

    def _read(self, names: str) -> None:
        """Give the results of the last call their names, by place."""
        made = self.steps[-1][0]
        for name, place in re.findall(r"(\w+) = \w+\[(\d+)\]", names):
            made += [f"_{len(made) + i}" for i in range(int(place) + 1 - len(made))]
            made[int(place)] = name

    def _unpacked(self, names: str, whole: str) -> None:
        self.lists[whole] = re.findall(r"\w+", names)

    # --- expressions --------------------------------------------------------------------------------------------------

    def expression(self, text: str) -> Any:
        (value,) = self.listed(text)
        return value

    def listed(self, text: str) -> list[Any]:
        """Return the operands of a list of expressions; lists in brackets count one by one."""
        tokens = list(_tokens(text))
        found = self._items(tokens)
        if tokens:
            raise ValidationFailed(f"no expression: {text}")
        return found

    def _items(self, tokens: list[str], close: str = "") -> list[Any]:
        found: list[Any] = []
        while tokens and tokens[0] != close:
            if tokens[0] == "[":
                tokens.pop(0)
                found += self._items(tokens, "]")
                tokens.pop(0)
            else:
                value = self._selected(tokens)
                found += self.lists.get(value, [value]) if isinstance(value, str) else [value]
            if tokens and tokens[0] == ",":
                tokens.pop(0)
            elif tokens and tokens[0] != close:
                break
        return found

    def _selected(self, tokens: list[str]) -> Any:
        """Read ``condition ? one : other``, or an expression without."""
        condition = self._infix(tokens, 0)
        if not tokens or tokens[0] != "?":
            return condition
        tokens.pop(0)
        one = self._selected(tokens)
        tokens.pop(0)
        return self.step("select", condition, one, self._selected(tokens))

    def _infix(self, tokens: list[str], level: int) -> Any:
        if level == len(LEVELS):
            return self._signed(tokens)
        left = self._infix(tokens, level + 1)
        while tokens and tokens[0] in LEVELS[level]:
            sign = tokens.pop(0)
            left = self.step(OPERATIONS[sign], left, self._infix(tokens, level + 1))
        return left

    def _signed(self, tokens: list[str]) -> Any:
        token = tokens.pop(0)
        if token == "-":
            value = self._signed(tokens)
            return -value if isinstance(value, int) else self.step("negate", value)
        if token == "(":
            value = self._selected(tokens)
            tokens.pop(0)
            return value
        if token[0].isdigit():
            if not float(token).is_integer():
                raise ValidationFailed(f"{token} is no number of the chart")
            return int(float(token))
        if not tokens or tokens[0] != "(":
            return {"false": 0, "true": 1}.get(token, token)
        tokens.pop(0)
        given = self._items(tokens, ")")
        tokens.pop(0)
        operation = self.grammar.functions[token]
        return given[0] if operation == "number" else self.step(operation, *given)


def _is_enclosed(text: str) -> bool:
    """Return whether the bracket that opens a text closes at its end."""
    depths = list(itertools.accumulate((letter == "(") - (letter == ")") for letter in text))
    return text.startswith("(") and 0 not in depths[:-1]


def _tokens(text: str) -> Iterator[str]:
    place = 0
    text = text.rstrip()
    while place < len(text):
        found = TOKEN.match(text, place)
        if not found:
            raise ValidationFailed(f"no expression: {text[place:]}")
        yield found[1] or found[2] or found[3]
        place = found.end()


def read(text: str, grammar: Grammar, numbers: Mapping[str, float]) -> dict[str, dict[str, Any]]:
    """Return the programs in a text by name, each as a list of steps."""
    found: dict[str, dict[str, Any]] = {}
    text = text.replace(grammar.continued or "\0", "")
    for head in re.finditer(grammar.head, text, re.MULTILINE):
        end = re.compile(grammar.end, re.MULTILINE).search(text, head.end())
        if end is None:
            raise ValidationFailed(f"{head['name']} has no end")
        body = Body(grammar, numbers)
        for statement in map(str.strip, text[head.end() : end.start()].split(";")):
            if statement:
                body.statement(" ".join(statement.split()))
        made = re.findall(r"\d+", head.groupdict().get("made") or "")
        if made not in ([], [str(grammar.first + place) for place in range(len(body.results))]):
            raise ValidationFailed(f"the results of {head['name']} have places {', '.join(made)}")
        given = [name for argument in _parameters(head["given"]) for name in _components(argument, body, grammar)]
        name, program = grammar.program(head["name"]), {"given": given, "steps": body.steps, "results": body.results}
        if found.setdefault(name, program) != program:
            raise ValidationFailed(f"two texts of {name} differ")
    for names, called, *_ in (step for program in found.values() for step in program["steps"]):
        if isinstance(names, list) and "read" in grammar.statements:  # the last results of a call may be unread
            names += ["_"] * (len(found[called]["results"]) - len(names))
    return found


def _parameters(text: str) -> Sequence[str]:
    return [part.strip() for part in re.split(r",(?![^\[]*\])", text) if part.strip()]


def _components(parameter: str, body: Body, grammar: Grammar) -> list[str]:
    """Return the names of a parameter's numbers; unread ones get names that no step has."""
    length = re.fullmatch(grammar.made, parameter) if grammar.made else None
    name = re.match(r"\w+|~", parameter)
    assert name is not None
    names = [name[0]] if length is None else body.lists.get(name[0], ["_"] * int(length[1]))
    return [f"{parameter} {place}" if each in ("_", "~") else each for place, each in enumerate(names)]
