"""Expressions of C as closures over the frame of a call."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from pycparser import c_ast

from .errors import refuse
from .memory import Pointer
from .scope import Scope
from .types import INT, REAL, SIZE, Frame, Run, Type, Value, at_address, common, convert, in_range

Operation = Callable[[Any, Any], Any]


def _remainder(a: int, b: int) -> int:
    """Of a division that truncates, as in C."""
    return abs(a) % abs(b) * (-1 if a < 0 else 1)


ARITHMETIC: Mapping[str, Operation] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv,
}  # fmt: skip
INTEGER: Mapping[str, Operation] = {"%": _remainder, "&": operator.and_, "|": operator.or_}
COMPARISON: Mapping[str, Operation] = {
    "<": operator.lt,
    ">": operator.gt,
    "<=": lambda a, b: a < b or a == b,
    ">=": lambda a, b: a > b or a == b,
    "==": operator.eq,
    "!=": operator.ne,
}
"""By what number types have: they order by < and >, and know equality."""


def compiled(node: c_ast.Node, scope: Scope) -> Value:
    """An expression, its types checked."""
    name = type(node).__name__
    if name not in _COMPILERS:
        raise refuse(node, f"{name} is not read here")
    return _COMPILERS[name](node, scope)


def condition(node: c_ast.Node, scope: Scope) -> Run:
    """An expression as a truth value."""
    value = compiled(node, scope)
    if not value.type.is_number:
        raise refuse(node, f"a number is expected as condition, not {value.type}")
    compared = isinstance(node, c_ast.BinaryOp) and node.op in COMPARISON
    return value.run if compared else scope.decided(node, value.run)


def assigned(node: c_ast.Node, target: Value, value: Value) -> Value:
    """An assignment."""
    address, run = target.address, convert(node, value, target.type).run
    if address is None or target.type.const:
        raise refuse(node, f"{target.type} cannot be assigned")

    def store(frame: Frame) -> Any:
        result = run(frame)
        address(frame).store(result)
        return result

    return Value(replace(target.type, const=False), store)


def binary(node: c_ast.Node, symbol: str, left: Value, right: Value, scope: Scope) -> Value:
    """Two values and an operator between."""
    if left.type.kind == "pointer" and symbol in "+-":
        return _moved(node, symbol, left, right)
    type_, (first, second) = common(node, left, right)
    f, g = first.run, second.run
    if symbol in COMPARISON:
        compare = COMPARISON[symbol]
        return Value(INT, scope.decided(node, lambda frame: compare(f(frame), g(frame))))
    if symbol in INTEGER and type_.is_integer:
        operation = INTEGER[symbol]
    elif symbol in ARITHMETIC:
        operation = ARITHMETIC[symbol]
    else:
        raise refuse(node, f"{left.type} {symbol} {right.type} is not read here")
    if symbol == "/" and type_.is_integer:
        raise refuse(node, "an integer division: one of the operands must be a real number")

    def run(frame: Frame) -> Any:
        return operation(f(frame), g(frame))

    return Value(type_, in_range(node, type_, run) if type_.is_integer else run)


def _moved(node: c_ast.Node, symbol: str, pointer: Value, steps: Value) -> Value:
    """A pointer plus or minus an integer."""
    if pointer.type.kind != "pointer" or not steps.type.is_integer:
        raise refuse(node, f"{pointer.type} {symbol} {steps.type} is not read here")
    at, by, size = pointer.run, steps.run, pointer.type.element.cells * (-1 if symbol == "-" else 1)

    def run(frame: Frame) -> Pointer:
        start: Pointer = at(frame)
        return start.moved(size * by(frame))

    return Value(pointer.type, run)


def _constant(node: c_ast.Constant, scope: Scope) -> Value:
    if node.type not in ("int", "double") or "x" in node.value.lower():
        raise refuse(node, f"a constant of type {node.type}, {node.value}, is not read here")
    number = int(node.value) if node.type == "int" else Fraction(node.value)
    return Value(INT if node.type == "int" else REAL, lambda frame: number, constant=True)


def _name(node: c_ast.ID, scope: Scope) -> Value:
    return scope.lookup(node)


def _element(node: c_ast.ArrayRef, scope: Scope) -> Value:
    return _pointed(node, _moved(node, "+", compiled(node.name, scope), compiled(node.subscript, scope)))


def _pointed(node: c_ast.Node, pointer: Value) -> Value:
    if pointer.type.kind != "pointer":
        raise refuse(node, f"a pointer is expected, not {pointer.type}")
    return at_address(pointer.type.element, pointer.run)


def _unary(node: c_ast.UnaryOp, scope: Scope) -> Value:
    value = compiled(node.expr, scope)
    run = value.run
    if node.op == "*":
        return _pointed(node, value)
    if node.op == "&" and value.address is not None:
        return Value(Type("pointer", value.type), value.address)
    if node.op in ("++", "--", "p++", "p--"):
        one = Value(INT, lambda frame: 1, constant=True)
        changed = assigned(node, value, binary(node, node.op[-1], value, one, scope))
        return Value(changed.type, _before(run, changed.run)) if node.op[0] == "p" else changed
    if not value.type.is_number:
        raise refuse(node, f"{node.op} of {value.type} is not read here")
    type_ = replace(value.type, const=False)
    if node.op == "!":
        return Value(INT, lambda frame: int(not run(frame)))
    if node.op == "-" and type_ != SIZE:
        return Value(type_, lambda frame: -run(frame), constant=value.constant)
    raise refuse(node, f"{node.op} of {value.type} is not read here")


def _before(read: Run, change: Run) -> Run:
    def run(frame: Frame) -> Any:
        value = read(frame)
        change(frame)
        return value

    return run


def _binary(node: c_ast.BinaryOp, scope: Scope) -> Value:
    if node.op in ("&&", "||"):
        first, second = condition(node.left, scope), condition(node.right, scope)
        if node.op == "&&":
            return Value(INT, lambda frame: first(frame) and second(frame))
        return Value(INT, lambda frame: first(frame) or second(frame))
    return binary(node, node.op, compiled(node.left, scope), compiled(node.right, scope), scope)


def _assignment(node: c_ast.Assignment, scope: Scope) -> Value:
    target, value = compiled(node.lvalue, scope), compiled(node.rvalue, scope)
    return assigned(node, target, binary(node, node.op[:-1], target, value, scope) if node.op != "=" else value)


def _choice(node: c_ast.TernaryOp, scope: Scope) -> Value:
    test = condition(node.cond, scope)
    type_, values = common(node, compiled(node.iftrue, scope), compiled(node.iffalse, scope))
    first, second = (value.run for value in values)
    return Value(type_, lambda frame: first(frame) if test(frame) else second(frame))


def _cast(node: c_ast.Cast, scope: Scope) -> Value:
    value, to = compiled(node.expr, scope), scope.type_of(node.to_type)
    if to.kind == "void":  # the value is not used; so compilers are told that a parameter is not
        return Value(to, value.run)
    if not value.type.is_number:
        raise refuse(node, f"{value.type} is not cast here")
    return convert(node, value, to)


def _call(node: c_ast.FuncCall, scope: Scope) -> Value:
    function = scope.called(node)
    given = node.args.exprs if node.args else []
    if len(given) != len(function.parameters):
        raise refuse(node, f"{function.name} takes {len(function.parameters)} arguments, not {len(given)}")
    runs = [convert(a, compiled(a, scope), to).run for a, to in zip(given, function.parameters, strict=True)]
    return Value(function.result, lambda frame: function.run([run(frame) for run in runs]))


def _list(node: c_ast.ExprList, scope: Scope) -> Value:
    *others, last = (compiled(expression, scope) for expression in node.exprs)

    def run(frame: Frame) -> Any:
        for other in others:
            other.run(frame)
        return last.run(frame)

    return Value(last.type, run)


_COMPILERS: Mapping[str, Callable[[Any, Scope], Value]] = {
    "ArrayRef": _element,
    "Assignment": _assignment,
    "BinaryOp": _binary,
    "Cast": _cast,
    "Constant": _constant,
    "ExprList": _list,
    "FuncCall": _call,
    "ID": _name,
    "TernaryOp": _choice,
    "UnaryOp": _unary,
}
"""What compiles a node, by its kind."""
