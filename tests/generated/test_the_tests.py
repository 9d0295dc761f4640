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

import numpy as np
import pytest

from dualcay import _runtime
from tests.generated import test_kernel_groups as groups
from tests.generated import test_kernel_roundtrips as roundtrips
from tests.generated import test_kernel_signs as rules
from tests.generated import test_kernel_tangents as tangents
from tests.support.accuracy import FUNCTIONS, Trial
from tests.support.kernels import load

ORDER = 3
SOURCE = Path(load(ORDER).__file__ or "")
TREE = ast.parse(SOURCE.read_text(encoding="utf-8"))
CODE = compile(TREE, "copy of " + SOURCE.name, "exec")
CORES = {node.name: node for node in TREE.body if isinstance(node, ast.FunctionDef) and node.name.startswith("_")}
# Regimes in which a core's every operation counts: where sides are chosen, inputs from both sides.
REGIMES = ("uniform", "shadow", "pure translation", "below pi", "coordinate axes")


OPPOSITE = {"add": "sub", "sub": "add", "neg": "positive"}
"""What the in-place form calls."""


def signs(core: ast.FunctionDef) -> list[int]:
    """Places of + and − in the core, as indices into its walk; not those that only choose a side, in ``where``."""
    choices = [call for call in ast.walk(core) if isinstance(call, ast.Call) and ast.unparse(call.func) == "m.where"]
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
    """A fresh copy of the kernel module, with one core replaced."""
    module = types.ModuleType("dualcay.copy")
    module.__package__ = "dualcay"
    sys.modules[module.__name__] = module  # annotations are looked up there
    exec(CODE, module.__dict__)
    if replacement is not None:
        tree = ast.Module(body=[replacement], type_ignores=[])
        changed: dict[str, object] = {"positive": np.positive}
        exec(compile(ast.fix_missing_locations(tree), "a flipped core", "exec"), module.__dict__ | changed, changed)
        form = "blocks" if replacement.name.endswith("_blocks") else "plain"
        name = replacement.name.removesuffix("_blocks").upper()
        kernel = dataclasses.replace(getattr(module, name), **{form: changed[replacement.name]})
        setattr(module, name, kernel)
    return module


@pytest.fixture
def only_form(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """Run batches of every size in the form of the named core; the root of a flipped sum must not change the form."""
    name: str = request.param
    root = staticmethod(lambda x: math.sqrt(x) if x >= 0 else math.nan)
    monkeypatch.setattr(_runtime.Floats, "sqrt", root)
    monkeypatch.setattr(_runtime, "FEW", -1 if name.endswith("_blocks") else sys.maxsize)
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


SEEN_THROUGH = {"_turn": "from_quaternion"}  # the step from branch to branch
FORWARD = (
    "_quaternion",
    "_tensor",
    "_pose",
    "_tangent",
    "_tangent_inv",
    "_twist",
    "_rate",
    "_body_twist",
    "_body_rate",
)
INVERSE = ("_from_quaternion", "_from_tensor", "_from_pose", "_compose", "_shadow")


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


@pytest.mark.parametrize("only_form", sorted(CORES), indirect=True)
def test_every_flipped_sign_is_seen_by_the_oracle(only_form: str) -> None:
    name = only_form
    function = SEEN_THROUGH.get(name.removesuffix("_blocks"), name.removesuffix("_blocks").removeprefix("_"))
    places = signs(CORES[name])
    assert places
    unseen = []
    for place in places:
        module = module_copy(flipped(CORES[name], place))
        if not (caught_by_the_oracle(module, function) or caught_at_full_turns(module)):
            unseen.append(place)
    assert not unseen, [ast.unparse(list(ast.walk(CORES[name]))[p]) for p in unseen]


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
