"""Emitted programs executed on numbers that write terms, and altered texts."""

import shutil
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from derive.codegen.validation.loading import loaded
from proofs.coq_definitions import GEOMETRY, SCALARS
from proofs.emitted import CHeader, PythonModule
from proofs.goals import chart_file, geometry_file
from proofs.statements import MachineError
from proofs.transcript import Transcript, constant

NUMPY = Path(__file__).parents[2] / "generated" / "dualcay"

HEADER = """
static void dualcay_toy_half(const double *v_at, unsigned long v_by, double side, double *w_at, unsigned long w_by)
{
    const double y = side * v_at[v_by];
    w_at[0] = y / 2;
    w_at[w_by] = -v_at[0];
}
static void dualcay_toy_program(const double v[2], double w[2])
{
    dualcay_toy_half(v, 1, -0.5, w, 1);
}
"""


def in_c(folder: Path, text: str) -> Transcript:
    (folder / "toy.h").write_text(text)
    return CHeader(folder / "toy.h").program("program", [("a", "b")], [2])


@pytest.fixture
def kernels(tmp_path: Path) -> Path:
    return shutil.copytree(NUMPY, tmp_path / "numpy")


def alter(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def geometry(kernels: Path, name: str) -> Transcript:
    with loaded(kernels) as package:
        return PythonModule(kernels, package, "cayley1").geometry(name)


@pytest.mark.smoke
def test_python_and_c_give_one_term(tmp_path: Path) -> None:
    made = in_c(tmp_path, HEADER)
    read = Transcript(lambda v: (Fraction(-1, 2) * v[1] / 2, -v[0]), [("a", "b")])
    assert (made.steps, made.results) == (read.steps, read.results)
    assert made.place == "toy.h:8"
    head = "Definition f (a b : K) : (K * K)%type :="
    assert made.definition("f").splitlines() == [head, "  ((((- ((1 / 2))) * b) / 2), (- (a)))."]


def test_what_is_used_twice_is_a_let_and_what_is_unused_is_left_out() -> None:
    def program(a: Any) -> list[Any]:
        s, w = a.transcript.enter("scalars", [a + 1], 2)
        product, _ = s * 3, w * w
        return [product * product, w]

    head = "Definition f (a : K) : (K * K)%type :="
    lets = ["  let '(t2, t3) := scalars ((a + 1)) in", "  let t4 := t2 * (1 + 2 * 1) in"]
    assert Transcript(program, ["a"]).definition("f").splitlines() == [head, *lets, "  ((t4 * t4), t3)."]


@pytest.mark.parametrize(
    "program",
    [
        lambda v: [v**2], lambda v: [0.5 * v], lambda v: [abs(v)], lambda v: [v == v], lambda v: [v != v],
        lambda v: [v < 0], lambda v: [v if v else 1], lambda v: ["v"], lambda v: [1 / 3], lambda v: None,
    ],
)  # fmt: skip
def test_only_straight_lines_on_exact_numbers_are_written(program: Callable[[Any], Any]) -> None:
    with pytest.raises(TypeError):
        Transcript(program, ["v"])


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("w_at[w_by]", "w_at[0]"),
        ("v_at[v_by]", "v_at[5]"),
        ("toy_half(v", "other(v"),
        ("y / 2", "z / 2"),
        ("y / 2", "y < 2"),
    ],
)
def test_other_c_is_refused(tmp_path: Path, old: str, new: str) -> None:
    with pytest.raises(MachineError, match=r"toy"):
        in_c(tmp_path, HEADER.replace(old, new))


def test_other_python_is_refused_with_its_line(kernels: Path) -> None:
    alter(kernels / "_geometry.py", "gvv1 - fv3", "gvv1 ** fv3")
    with pytest.raises(MachineError, match=r"^pose: _geometry\.py:\d+: unsupported operand"):
        geometry(kernels, "pose")
    alter(kernels / "_geometry.py", "s, w, sy, wy = c.quaternion_scalars", "s, w, sy = c.quaternion_scalars")
    with pytest.raises(MachineError, match=r"^quaternion: _geometry\.py:\d+: too many values"):
        geometry(kernels, "quaternion")


def test_programs_of_one_chart_are_no_part_of_geometry(tmp_path: Path, kernels: Path) -> None:
    alter(kernels / "_geometry.py", "c.quaternion_scalars(m, x)", "(*c.rate_scalars(m, x), 1, 1, 1)")
    with pytest.raises(MachineError, match=r"^quaternion: _geometry\.py:\d+: .* no attribute 'rate_scalars'"):
        geometry(kernels, "quaternion")
    own = "\nstatic double dualcay_toy_own(double x) { return 2 * x; }\n"
    shared = "static void dualcay_toy_quaternion(const double v[6], double q[8])"
    shared += "{ for (int i = 0; i < 8; ++i) { q[i] = dualcay_toy_own(v[0]); } }"
    (tmp_path / "toy.h").write_text(f'{own}#include "geometry.h"\n')
    (tmp_path / "geometry.h").write_text(shared)
    assert len(CHeader(tmp_path / "toy.h").geometry("quaternion").steps) == 8
    with pytest.raises(MachineError, match=r"^quaternion: toy\.h:2: dualcay_toy_own is a program of one chart"):
        CHeader(tmp_path / "toy.h", opaque=True).geometry("quaternion")


def test_missing_functions_and_files_are_named(tmp_path: Path, kernels: Path) -> None:
    with pytest.raises(MachineError, match="no function dualcay_toy_program"):
        in_c(tmp_path, "double a(double b) { return b; }")
    with pytest.raises(MachineError, match=r"absent.h"):
        CHeader(tmp_path / "absent.h")
    alter(kernels / "_interface.py", "def pose(", "def posed(")
    with pytest.raises(MachineError, match="pose"):
        geometry(kernels, "pose")
    (kernels / "cayley1.py").unlink()
    with pytest.raises(MachineError, match=r"cayley1\.py"):
        geometry(kernels, "pose")


@pytest.mark.parametrize("value", [0, 1, 2, 7, -10, 160])
def test_numbers_are_sums_of_ones(value: int) -> None:
    assert eval(constant(value)) == value


def test_goals_state_every_result() -> None:
    with loaded(NUMPY) as package:
        module = PythonModule(NUMPY, package, "cayley3")
        for name in GEOMETRY:
            program = module.geometry(name)
            assert geometry_file(name, program).count("entry K") == len(program.results)
            assert [step.symbol for step in program.steps if len(step.names) > 1] == [GEOMETRY[name].scalars]
        made = chart_file("numpy", "tangent_scalars", 3, module.scalars("tangent_scalars"))
    assert made.count("entry K") == len(SCALARS["tangent_scalars"].results)
    assert all(f"{name}_right" in made for name, goal in GEOMETRY.items() if goal.scalars == "tangent_scalars")


def test_frame_and_program_of_the_interface_are_read(kernels: Path) -> None:
    before = {name: geometry(kernels, name).steps for name in ("rate", "body_rate")}
    assert before["rate"] != before["body_rate"]
    alter(kernels / "_interface.py", '("-1", "-0.5")', '("1", "0.5")')
    assert geometry(kernels, "body_rate").steps == before["rate"] == geometry(kernels, "rate").steps
