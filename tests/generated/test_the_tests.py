"""A test of the tests: one sign flipped anywhere in either form of a kernel's copy, and the laws fail for the copy."""

from __future__ import annotations

import ast
import dataclasses
import math
import pickle
import sys
import types
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from dualcay import _geometry, _runtime
from tests.generated import test_kernel_groups as groups
from tests.generated import test_kernel_roundtrips as roundtrips
from tests.generated import test_kernel_signs as rules
from tests.generated import test_kernel_tangents as tangents
from tests.support.accuracy import FUNCTIONS, Trial
from tests.support.kernels import load

ORDER = 3
SOURCE = Path(load(ORDER).__file__ or "")
CODE = compile(SOURCE.read_text(encoding="utf-8"), "copy of " + SOURCE.name, "exec")


def cores(path: Path) -> dict[str, ast.FunctionDef]:
    """Programs in both forms, by name: geometry's, or the scalars of a chart."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    functions = (node for node in tree.body if isinstance(node, ast.FunctionDef))
    return {node.name: node for node in functions if not node.name.startswith("__")}


CORES = cores(Path(_geometry.__file__)) | cores(SOURCE)
# Regimes in which a core's every operation counts: where sides are chosen, inputs from both sides.
REGIMES = ("uniform", "shadow", "pure translation", "below pi", "coordinate axes")


OPPOSITE = {"add": "sub", "sub": "add", "neg": "positive"}
"""What the in-place form calls."""


def signs(core: ast.FunctionDef) -> list[int]:
    """Places of + and − in the core, as indices into its walk; not those that only choose, a side or NaN.

    ``where`` chooses a side, and ``either`` holds numbers of which one may have overflowed.
    """
    choices: list[ast.AST] = [
        node
        for node in ast.walk(core)
        if (isinstance(node, ast.Call) and ast.unparse(node.func) == "m.where")
        or (isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "either")
    ]
    apart = {id(node) for call in choices for node in ast.walk(call)}
    return [
        i
        for i, node in enumerate(ast.walk(core))
        if id(node) not in apart
        and (
            (isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub))
            or (isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub))
            or (isinstance(node, ast.Call) and ast.unparse(node.func) in OPPOSITE)
        )
    ]


def flipped(core: ast.FunctionDef, place: int) -> ast.FunctionDef:
    """The core with one sign the other way."""
    changed: ast.FunctionDef = pickle.loads(pickle.dumps(core))  # a deep copy, faster
    node = list(ast.walk(changed))[place]
    if isinstance(node, ast.BinOp):
        node.op = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
    elif isinstance(node, ast.UnaryOp):
        node.op = ast.UAdd()
    elif isinstance(node, ast.Call):
        node.func = ast.parse(OPPOSITE[ast.unparse(node.func)], mode="eval").body
    return changed


def module_copy(replacement: ast.FunctionDef | None = None) -> types.ModuleType:
    """A fresh copy of the kernel module, with one core replaced: of the geometry it uses, or of its scalars."""
    module = types.ModuleType("dualcay.copy")
    module.__package__ = "dualcay"
    sys.modules[module.__name__] = module  # annotations are looked up there
    exec(CODE, module.__dict__)
    if replacement is not None:
        tree = ast.Module(body=[replacement], type_ignores=[])
        changed: dict[str, object] = {"positive": np.positive}
        space = vars(_geometry) | module.__dict__ | changed
        exec(compile(ast.fix_missing_locations(tree), "a flipped core", "exec"), space, changed)
        replace_core(module.CHART, replacement.name, changed[replacement.name])
    return module


def replace_core(chart: Any, core: str, function: object) -> None:
    form = {"blocks" if core.endswith("_blocks") else "plain": function}
    name = core.removesuffix("_blocks")
    if name.startswith("_"):
        scalar = name.removeprefix("_")
        chart.functions = chart.functions | {scalar: dataclasses.replace(chart.functions[scalar], **form)}
        vars(chart.plain)[scalar] = chart.functions[scalar].plain
    else:
        chart.kernels = chart.kernels | {name: dataclasses.replace(chart.kernels[name], **form)}


@pytest.fixture
def only_form(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """Run batches of every size in the form of the named core; the root of a flipped sum must not change the form."""
    name: str = request.param
    root = staticmethod(lambda x: math.sqrt(x) if x >= 0 else math.nan)
    monkeypatch.setattr(_runtime.Floats, "sqrt", root)
    monkeypatch.setattr(_runtime, "POINTWISE_MAX", -1 if name.endswith("_blocks") else sys.maxsize)
    return name


def fails(check: Callable[..., None], *arguments: object) -> bool:
    try:
        check(*arguments)
    except AssertionError:
        return True
    return False


def caught_by_the_oracle(module: types.ModuleType, name: str) -> bool:
    return any(fails(Trial(module, ORDER, regime).check, name) for regime in REGIMES)


def caught_at_full_turns(module: types.ModuleType) -> bool:
    """The side taken at a multiple of 2π shows nowhere else."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(rules, "load", lambda _: module)
        cases = [(order, real) for order, real in rules.AT_FULL_TURNS if order == ORDER]
        return any(
            fails(rules.test_full_turns_are_translations_along_the_axis, order, real, dual)
            for order, real in cases
            for dual in ([1.0, 2.0, -0.5], [-1.0, -2.0, 0.5], [0.3, -0.4, 0.2])
        )


FORWARD = ("quaternion", "tensor", "pose", "tangent", "tangent_inv", "twist", "rate")
INVERSE = ("from_quaternion", "from_tensor", "from_pose", "compose", "shadow")
SEEN_THROUGH = {"turn": "from_quaternion"}  # the step from branch to branch


def seen_through(core: str) -> Iterator[str]:
    """The functions of users that a core serves."""
    name = core.removesuffix("_blocks")
    kernels = [name]
    if name.startswith("_"):
        lent = {kernel: {function for function, *_ in k.lent} for kernel, k in _geometry.KERNELS.items()}
        kernels = [kernel for kernel, functions in lent.items() if name.removeprefix("_") in functions]
    yield from (found for kernel in kernels if (found := SEEN_THROUGH.get(kernel, kernel)) in FUNCTIONS)


def laws() -> Iterator[tuple[Callable[..., None], tuple[object, ...]]]:
    """Laws that know nothing of the oracle: derivatives, inverses, round trips, products."""
    yield roundtrips.test_shadows_form_a_cyclic_group, ("uniform",)
    yield roundtrips.test_shadows_give_the_same_pose_and_the_quaternion_up_to_sign, ("pure translation",)
    for regime in ("uniform", "shadow", "below pi", "coordinate axes"):
        yield tangents.test_complex_steps_of_the_quaternion, (regime,)
        yield tangents.test_complex_steps_of_the_tensor, (regime,)
        yield tangents.test_complex_steps_of_the_pose, (regime,)
        yield tangents.test_twist_and_rate_are_the_operators_applied_and_undo_each_other, (regime,)
        yield tangents.test_body_twists_are_space_twists_turned_back, (regime,)
        for route in roundtrips.ROUTES:
            yield roundtrips.test_every_branch_gives_the_pose_back, (route, regime)
        yield roundtrips.test_shadows_give_the_same_pose_and_the_quaternion_up_to_sign, (regime,)
        yield groups.test_composition_is_the_product_of_tensors_v1_first, (regime,)


def caught_by_the_laws(module: types.ModuleType) -> bool:
    return any(fails(law, module, ORDER, *arguments) for law, arguments in laws()) or caught_at_full_turns(module)


def test_an_unchanged_copy_passes() -> None:
    module = module_copy()
    assert not any(caught_by_the_oracle(module, name) for name in FUNCTIONS)
    assert not caught_by_the_laws(module)


@pytest.mark.parametrize("only_form", sorted(core for core in CORES if any(seen_through(core))), indirect=True)
def test_every_flipped_sign_is_seen_by_the_oracle(only_form: str) -> None:
    name = only_form
    unseen = []
    for place in signs(CORES[name]):
        module = module_copy(flipped(CORES[name], place))
        caught = any(caught_by_the_oracle(module, function) for function in seen_through(name))
        if not (caught or caught_at_full_turns(module)):
            unseen.append(place)
    assert not unseen, [ast.unparse(list(ast.walk(CORES[name]))[p]) for p in unseen]


def test_most_cores_have_signs() -> None:
    assert len(CORES) > 60
    without = {name.strip("_").removesuffix("_blocks") for name, core in CORES.items() if not signs(core)}
    assert without <= {"beyond", "unfolded"}


@pytest.mark.parametrize(
    "only_form", [f"{name}{form}" for name in FORWARD + INVERSE for form in ("", "_blocks")], indirect=True
)
def test_flipped_signs_are_seen_by_the_laws(only_form: str) -> None:
    name = only_form
    places = signs(CORES[name])
    for place in places[:: max(1, len(places) // 4)]:
        assert caught_by_the_laws(module_copy(flipped(CORES[name], place))), ast.unparse(
            list(ast.walk(CORES[name]))[place]
        )


@pytest.mark.parametrize("only_form", ["pose", "pose_blocks", "_pose", "_tangent_blocks"], indirect=True)
def test_a_core_replaced_by_itself_passes(only_form: str) -> None:
    module = module_copy(CORES[only_form])
    assert not any(caught_by_the_oracle(module, function) for function in seen_through(only_form))
