"""Statements, declarations and functions of C as closures over the frame of a call."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any, TypeAlias

from pycparser import c_ast

from .errors import CError, place, refuse
from .expressions import compiled, condition
from .memory import UNSET, Cells
from .scope import Function, Scope
from .types import Frame, Run, Type, Value, convert

Result: TypeAlias = "tuple[Any, ...] | None"
"""None where the next statement follows, or the returned value (nothing is returned as None)."""

Statement = Callable[[Frame], Result]


def define(node: c_ast.FuncDef, scope: Scope) -> None:
    """Add a function with its body, which may call what stands before it."""
    function = declare_function(node.decl, scope)
    if function.body is not None:
        raise refuse(node.decl, f"{function.name} is defined twice")
    inner = scope.inside(function)
    for parameter, type_ in zip(_parameters(node.decl.type), function.parameters, strict=True):
        inner.declare(parameter, type_)
    function.body = _block(node.body.block_items or [], inner)


def declare_function(node: c_ast.Decl, scope: Scope) -> Function:
    """Add a prototype."""
    parameters = tuple(_parameter_type(parameter, scope) for parameter in _parameters(node.type))
    function = Function(node.name, scope.type_of(node.type.type), parameters)
    return scope.functions.setdefault(node.name, function)


def _parameters(node: c_ast.FuncDecl) -> list[Any]:
    found = node.args.params if node.args else []
    names = [getattr(getattr(p.type, "type", None), "names", None) for p in found]
    return [] if names == [["void"]] else found


def _parameter_type(node: c_ast.Node, scope: Scope) -> Type:
    """The type of a parameter: an array is a pointer, which remembers how many elements are promised."""
    type_ = _declared(node.type, scope)
    if type_.kind == "array":
        return Type("pointer", type_.element, type_.cells)
    return type_


def _declared(node: c_ast.Node, scope: Scope) -> Type:
    if isinstance(node, c_ast.ArrayDecl):
        size = compiled(node.dim, scope) if node.dim else None
        if size is None or not size.constant:
            raise refuse(node, "the size of an array must be a constant")
        return Type("array", _declared(node.type, scope), size.run([]))
    return scope.type_of(node)


def declaration(node: c_ast.Decl, scope: Scope) -> Statement | None:
    """A variable, with its first value; one that is static, or of the file, gets it at once."""
    static = "static" in node.storage or scope.function is None
    if set(node.storage) - {"static"}:
        raise refuse(node, f"{' '.join(node.storage)} is not read here")
    type_ = _declared(node.type, scope)
    # the name is declared after its first value has been read
    values = None if node.init is None else list(_initial(node.init, type_, scope))
    _, start = scope.declare(node, type_, static)
    if static:
        try:
            _write(scope.statics, start, type_, values, [])
        except IndexError:
            raise refuse(node, f"{node.name} is static, and its first value no constant") from None
        return None

    def run(frame: Frame) -> None:
        _write(frame, start, type_, values, frame)

    return run


def _write(cells: Cells, start: int, type_: Type, values: list[Run] | None, frame: Frame) -> None:
    found = [UNSET] * type_.cells if values is None else [run(frame) for run in values]
    cells[start : start + type_.cells] = found


def _initial(node: c_ast.Node, type_: Type, scope: Scope) -> Iterator[Run]:
    """The first values of all cells; those a list leaves out are 0."""
    if type_.kind != "array":
        yield convert(node, compiled(node, scope), type_).run
        return
    if not isinstance(node, c_ast.InitList) or len(node.exprs) > type_.size:
        raise refuse(node, f"an {type_} takes a list of at most {type_.size} values")
    for expression in node.exprs:
        yield from _initial(expression, type_.element, scope)
    for _ in range((type_.size - len(node.exprs)) * type_.element.cells):
        yield lambda frame: Fraction(0)


def statement(node: c_ast.Node, scope: Scope) -> Statement | None:
    """A statement; None where nothing is to be done."""
    if isinstance(node, c_ast.Decl):
        return declaration(node, scope)
    if isinstance(node, c_ast.DeclList):
        return _sequence([(part, declaration(part, scope)) for part in node.decls])
    if isinstance(node, c_ast.Compound):
        return _scoped(node.block_items or [], scope)
    if isinstance(node, c_ast.If):
        return _if(node, scope)
    if isinstance(node, c_ast.For):
        return _for(node, scope)
    if isinstance(node, c_ast.Return):
        return _return(node, scope)
    if isinstance(node, c_ast.EmptyStatement | c_ast.Pragma):
        return None
    return _effect(compiled(node, scope).run)


def _effect(run: Run) -> Statement:
    def effect(frame: Frame) -> None:
        run(frame)

    return effect


def _block(nodes: Sequence[c_ast.Node], scope: Scope) -> Statement:
    return _sequence([(node, statement(node, scope)) for node in nodes])


def _scoped(nodes: Sequence[c_ast.Node], scope: Scope) -> Statement:
    scope.blocks.append({})
    try:
        return _block(nodes, scope)
    finally:
        scope.blocks.pop()


def _sequence(parts: Sequence[tuple[c_ast.Node, Statement | None]]) -> Statement:
    steps = [(node, run) for node, run in parts if run is not None]

    def sequence(frame: Frame) -> Result:
        for node, run in steps:
            try:
                result = run(frame)
            except (ArithmeticError, AttributeError, TypeError, ValueError) as error:
                raise CError(f"{place(node)}: {error}") from error
            if result is not None:
                return result
        return None

    return sequence


def _if(node: c_ast.If, scope: Scope) -> Statement:
    test = condition(node.cond, scope)
    first, second = (_scoped([part] if part else [], scope) for part in (node.iftrue, node.iffalse))
    return lambda frame: first(frame) if test(frame) else second(frame)


def _for(node: c_ast.For, scope: Scope) -> Statement:
    scope.blocks.append({})
    try:
        start = _block([node.init] if node.init else [], scope)
        test = compiled(node.cond, scope).run if node.cond else lambda frame: 1
        step = _block([node.next] if node.next else [], scope)
        body = _scoped([node.stmt], scope)
    finally:
        scope.blocks.pop()

    def loop(frame: Frame) -> Result:
        start(frame)
        while test(frame):
            result = body(frame)
            if result is not None:
                return result
            step(frame)
        return None

    return loop


def _return(node: c_ast.Return, scope: Scope) -> Statement:
    function = scope.function
    assert function is not None
    if node.expr is None:
        return lambda frame: (None,)
    value: Value = convert(node, compiled(node.expr, scope), function.result)
    run = value.run
    return lambda frame: (run(frame),)
