"""Kernels of rotations alone: the recipes of poses are traced with real vectors, then validated."""

from __future__ import annotations

from pathlib import Path

import pytest

from derive.codegen import ValidationFailed
from derive.codegen.build import print_package
from derive.codegen.lowering.point import narrowed
from derive.codegen.lowering.scalar_programs import SQUARES
from derive.codegen.programs.program import Call
from derive.codegen.signatures import POSES, ROTATIONS, geometry
from derive.codegen.targets import TARGETS
from derive.codegen.validation import validate
from derive.codegen.validation.replay import NUMPY, replay
from derive.maps import Cayley
from derive.output import files

ONLY_OF_POSES = {"pose", "from_pose", "transform_line", "transform_line_jacobians"}


def test_functions_of_rotations_and_their_shapes() -> None:
    assert POSES.functions.keys() - {row.source for row in ROTATIONS.functions.values()} == ONLY_OF_POSES
    assert {row.source: name for name, row in ROTATIONS.functions.items() if row.source != name} == {
        "from_screw": "from_angle_axis",
        "to_screw": "to_angle_axis",
    }
    assert all(row.recipe is row.pose.recipe for row in ROTATIONS.functions.values())
    shapes = {array.shape for row in ROTATIONS.functions.values() for array in (*row.arguments, *row.results)}
    assert shapes == {(), (3,), (4,), (3, 3)}
    with pytest.raises(ValueError, match="rotations alone have no array pose"):
        _ = POSES.functions["pose"].kept


def test_restriction_undoes_embedding() -> None:
    for name, row in ROTATIONS.functions.items():
        given = tuple(tuple(range(1, array.size + 1)) for array in row.arguments)
        embedded = row.embedded(given, 0)
        assert [len(flat) for flat in embedded] == [array.size for array in row.pose.arguments], name
        assert row.restricted(embedded) == given, name
        assert all(sum(flat) == sum(small) for flat, small in zip(embedded, given, strict=True)), name


def test_rotation_programs_drop_dual_parts() -> None:
    for name in ROTATIONS.kernels:
        program, pose = geometry(ROTATIONS)[name], geometry()[ROTATIONS.functions[name].source]
        assert program.operations.total() <= 0.8 * pose.operations.total(), name
        assert {step.name for step in program.steps} <= program.operands, name
        assert all(narrowed(call) == call for call in program.calls), name


def test_calls_ask_only_for_slopes_that_are_read() -> None:
    names = ("f", "g", "_", "_", "_", "_")
    found = narrowed(Call(names, "tangent_scalars", SQUARES))
    assert found == Call(("f", "g", "_"), "pose_scalars", SQUARES)
    kept = Call(("gain",), "gain", ("e0", "e1", "e2", "e3", "size"))
    assert narrowed(kept) == kept


@pytest.fixture(scope="module")
def texts() -> dict[str, str]:
    return print_package([Cayley(1)], TARGETS["numpy"]).texts


GEOMETRY, INTERFACE = "rotation/_geometry.py", "rotation/_interface.py"


@pytest.mark.parametrize(
    ("file", "function", "old", "new"),
    [
        (GEOMETRY, "tensor_at", "gvv1 - fv3", "gvv1 + fv3"),
        (INTERFACE, "body_tangent_inv", '"body_tangent_inv", axis', '"tangent_inv", axis'),
    ],
)
def test_wrong_text_of_rotations_fails_validation(texts, tmp_path: Path, file, function, old, new) -> None:
    head, rest = texts[file].split(f"def {function}(", 1)
    assert old in rest
    files.write(tmp_path, {**texts, file: f"{head}def {function}({rest.replace(old, new, 1)}"})
    with pytest.raises(ValidationFailed):
        validate(tmp_path, Cayley(1), geometry=True, tables=(ROTATIONS,))


def test_wrong_wiring_of_rotations_fails_replay(texts, tmp_path: Path) -> None:
    wrong = texts[INTERFACE].replace('"to_angle_axis", axis', '"to_angle_axis", -1', 1)
    assert wrong != texts[INTERFACE]
    files.write(tmp_path, {**texts, INTERFACE: wrong})
    with pytest.raises(ValidationFailed, match="to_angle_axis"):
        replay(tmp_path, Cayley(1), (NUMPY,), (ROTATIONS,), geometry=True)
