"""Control of the kernel tests: some law fails after a flipped sign in a program of order 3."""

from __future__ import annotations

import ast
import copy
import dataclasses
import inspect
import math
import pickle
import sys
from collections.abc import Callable
from types import CodeType, FunctionType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from dualcay import _geometry, _numbers, _runtime, cayley3
from tests.generated import test_kernel_signs as rules
from tests.support import sampling, thorough
from tests.support.trial import FUNCTIONS, Trial

ORDER = 3
REGIMES = ("uniform", "shadow", "pure translation", "below pi", "coordinate axes")
"""Regimes with arguments on both sides of each selection, so that every operation matters."""


SELECTING = ("either", "zero", "one", "every", "whole", "xmade", "beside1", "beside2")
"""Names of numbers that only select a side, or NaN."""


def programs(module: Any) -> dict[str, ast.FunctionDef]:
    """Return the programs of a module by name: geometry programs, or the scalar programs of a chart."""
    found = (node for node in ast.parse(inspect.getsource(module)).body if isinstance(node, ast.FunctionDef))
    return {node.name: node for node in found if not node.name.startswith("__")}


PROGRAMS = programs(_geometry) | programs(cayley3)


def signs(program: ast.FunctionDef) -> list[int]:
    """Return the places of + and −, counted in a walk through the syntax tree of a program.

    Excluded are signs that only select a side or NaN, and signs of constants 0 and 1, which order 3 does not use.
    """
    selecting: list[ast.AST] = [
        node
        for node in ast.walk(program)
        if (isinstance(node, ast.Call) and ast.unparse(node.func) == "m.where")
        or (isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) in SELECTING)
    ]
    apart = {id(node) for call in selecting for node in ast.walk(call)}
    return [
        place
        for place, node in enumerate(ast.walk(program))
        if id(node) not in apart
        and isinstance(getattr(node, "op", None), ast.Add | ast.Sub | ast.USub)
        and not (isinstance(node, ast.BinOp) and (nothing(node) or nothing(node.right)))
    ]


def nothing(node: ast.expr) -> bool:
    """Tell whether a node is ``(a − a)``, which is 0 or NaN."""
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Sub) and ast.dump(node.left) == ast.dump(node.right)


def flipped(program: ast.FunctionDef, place: int) -> ast.FunctionDef:
    """Return the program with the sign at a place flipped."""
    changed: ast.FunctionDef = pickle.loads(pickle.dumps(program))  # faster than `copy.deepcopy`
    node = list(ast.walk(changed))[place]
    if isinstance(node, ast.BinOp):
        node.op = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
    elif isinstance(node, ast.UnaryOp):
        node.op = ast.UAdd()
    return changed


def kernels_with(program: ast.FunctionDef | None) -> Any:
    """Return the kernels of order 3 with one program replaced, also in calls from other programs."""
    spaces = {module: dict(vars(module)) for module in (_geometry, cayley3)}
    for space in spaces.values():
        for name in PROGRAMS.keys() & space.keys():
            space[name] = FunctionType(space[name].__code__, space, name, space[name].__defaults__)
    if program is not None:
        space = spaces[cayley3 if program.name in vars(cayley3) and program.name.startswith("_") else _geometry]
        tree = ast.fix_missing_locations(ast.Module(body=[program], type_ignores=[]))
        exec(compile(tree, "a flipped program", "exec"), space)
    chart: Any = copy.copy(cayley3.CHART)
    chart.functions = {name: spaces[cayley3][f.__name__] for name, f in chart.functions.items()}
    chart.plain, chart._recorded = SimpleNamespace(**chart.functions), {}
    chart.kernels = {
        name: dataclasses.replace(kernel, plain=spaces[_geometry][kernel.plain.__name__])
        for name, kernel in chart.kernels.items()
    }
    made = type(cayley3.KERNELS)(chart)
    public = {name: getattr(made, name) for name in cayley3.__all__ if hasattr(made, name)}
    return SimpleNamespace(**public, CHART=chart, __name__=cayley3.__name__)


def names_read(code: CodeType, seen: frozenset[str] = frozenset()) -> frozenset[str]:
    """Return the names of all programs that a program runs, directly or through others."""
    scalars = {f"_{name}" for name in code.co_names} | set(code.co_names)
    new = (scalars & PROGRAMS.keys()) - seen
    seen |= new
    for name in new:
        seen = names_read(getattr(cayley3 if name.startswith("_") else _geometry, name).__code__, seen)
    return seen


READ = {name: names_read(k.plain.__code__) | {k.plain.__name__} for name, k in cayley3.CHART.kernels.items()}


def users(program: str) -> list[str]:
    """Return the interface functions that run a program; a function with the program's name comes first."""
    kernels = sorted((name for name, read in READ.items() if program in read), key=lambda name: name != program)
    shown = ("from_quaternion" if name == "turn" else name for name in kernels)  # `turn` tells branches apart
    return [name for name in dict.fromkeys(shown) if name in FUNCTIONS]


@pytest.fixture(autouse=True)
def single_poses(monkeypatch: pytest.MonkeyPatch) -> None:
    """Run kernels pose by pose on every batch; roots of negative numbers are NaN."""
    monkeypatch.setattr(_numbers.Floats, "sqrt", staticmethod(lambda x: math.sqrt(x) if x >= 0 else math.nan))
    monkeypatch.setattr(_runtime, "POINTWISE_MAX", sys.maxsize)
    monkeypatch.setattr(sampling, "CROWD", 1)


def fails(check: Callable[..., None], *arguments: object) -> bool:
    try:
        check(*arguments)
    except AssertionError:
        return True
    return False


def seen_by_oracle(kernels: Any, names: list[str]) -> bool:
    return any(fails(Trial(kernels, ORDER, regime).check, name) for name in names for regime in REGIMES)


def seen_at_full_turns(kernels: Any) -> bool:
    """Return whether a wrong side is chosen at a multiple of 2π; no other law shows this error."""
    law = rules.test_full_turns_are_translations_along_the_axis
    duals = [1.0, 2.0, -0.5], [-1.0, -2.0, 0.5], [0.3, -0.4, 0.2]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(rules, "load", lambda _: kernels)
        cases = [(order, real, dual) for order, real in rules.AT_FULL_TURNS for dual in duals if order == ORDER]
        return any(fails(law, *case) for case in cases)


def seen_on_cones(kernels: Any) -> bool:
    """Return whether a zero axis is seen where there is none: at axes whose square is 0 with one sign changed."""
    axes = np.array([[1, 1, 0], [0, 1, 1], [3, 4, 5], [3, 5, 4], [5, 3, 4]])
    return not np.isfinite(kernels.from_screw(np.array([1.0, 2.0]), np.hstack([axes, 0.0 * axes]))).all()


def test_unchanged_kernels_pass() -> None:
    kernels = kernels_with(None)
    assert not seen_by_oracle(kernels, list(FUNCTIONS))
    assert not seen_at_full_turns(kernels)
    assert not seen_on_cones(kernels)


@pytest.mark.parametrize("name", sorted(name for name in PROGRAMS if users(name)))
@thorough.shares(3, 7)
def test_oracle_detects_every_flipped_sign(name: str, share: int) -> None:
    unseen = []
    for place in signs(PROGRAMS[name])[len(name) % share :: share]:
        kernels = kernels_with(flipped(PROGRAMS[name], place))
        if not (seen_by_oracle(kernels, users(name)) or seen_at_full_turns(kernels) or seen_on_cones(kernels)):
            unseen.append(ast.unparse(list(ast.walk(PROGRAMS[name]))[place]))
    assert not unseen
