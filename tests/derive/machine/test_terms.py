"""Emitted text read back as terms of Coq."""

from pathlib import Path

import pytest

from derive.machine.c_text import CText
from derive.machine.definitions import GEOMETRY, OPAQUE, SCALARS, U, V
from derive.machine.goals import chart_file, geometry_file
from derive.machine.python_text import PythonText
from derive.machine.terms import Program, ReadError, number

NUMPY = Path(__file__).parents[3] / "generated" / "dualcay"

HEADER = """
static void toy_half(const double *v_at, unsigned long v_by, double side, double *w_at, unsigned long w_by)
{
    const double y = side * v_at[v_by];
    w_at[0] = y / 2;
    w_at[w_by] = -v_at[0];
}
static void toy_program(const double v[2], double w[2])
{
    toy_half(v, 1, -0.5, w, 1);
}
"""


def header(folder: Path, text: str) -> CText:
    path = folder / "toy.h"
    path.write_text(text)
    return CText(path, "toy_")


def module(folder: Path, body: str) -> PythonText:
    path = folder / "toy.py"
    path.write_text(f"def program(m, c, v):\n    {body}\n")
    return PythonText(path)


@pytest.mark.smoke
def test_python_and_c_give_one_term(tmp_path: Path) -> None:
    made = header(tmp_path, HEADER).program("program", [("a", "b")], {})
    assert made.steps == [(("y",), "((- ((1 / 2))) * b)")]
    assert made.results == ("(y / 2)", "(- (a))")
    read = module(tmp_path, "a, b = v; y = -(1 / 2) * b; return y / 2, -a").program("program", [("a", "b")], {})
    assert (read.steps, read.results) == (made.steps, made.results)


def test_names_of_inlined_programs_stay_apart(tmp_path: Path) -> None:
    inner = "def inner(v):\n    y = v * 2\n    return y, y\n"
    outer = "def program(m, v):\n    y = v + 1\n    a, b = inner(y)\n    return a, y\n"
    (tmp_path / "toy.py").write_text(inner + outer)
    made = PythonText(tmp_path / "toy.py").program("program", ["v"], {})
    assert made.results == ("y_2", "y")


def test_scalar_programs_stay_opaque(tmp_path: Path) -> None:
    made = module(tmp_path, "s, _ = c.scalars(m, v); return s,").program("program", ["v"], {"scalars": ("s", "w")})
    assert made.steps == [(("s", "w"), "scalars v")]


@pytest.mark.parametrize(
    "body", ["return v ** 2", "return q", "x = v", "if v: return v", "a, b = c.scalars(m, v); return a"]
)
def test_other_python_is_refused(tmp_path: Path, body: str) -> None:
    with pytest.raises(ReadError, match=r"toy.py"):
        module(tmp_path, body).program("program", ["v"], {"scalars": ("s",)})


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("w_at[w_by]", "w_at[0]"),
        ("v_at[v_by]", "v_at[5]"),
        ("y / 2", "1 / 2"),
        ("toy_half(v", "other(v"),
        ("y / 2", "z / 2"),
    ],
)
def test_other_c_is_refused(tmp_path: Path, old: str, new: str) -> None:
    with pytest.raises(ReadError, match=r"toy"):
        header(tmp_path, HEADER.replace(old, new)).program("program", [("a", "b")], {})


def test_missing_functions_and_files_are_named(tmp_path: Path) -> None:
    with pytest.raises(ReadError, match="no function other"):
        module(tmp_path, "return v").program("other", ["v"], {})
    with pytest.raises(ReadError, match=r"absent.py"):
        PythonText(tmp_path / "absent.py")
    with pytest.raises(ReadError, match=r"absent.h"):
        CText(tmp_path / "absent.h", "")


@pytest.mark.parametrize("value", [0, 1, 2, 7, -10, 160])
def test_numbers_are_sums_of_ones(value: int) -> None:
    assert eval(number(value)) == value


def test_goals_state_every_result() -> None:
    text = PythonText(NUMPY / "_geometry.py")
    for name in ("quaternion", "tensor", "pose", "tangent", "tangent_inv"):
        program = text.program(name, [V], OPAQUE)
        assert geometry_file(name, program).count("entry K") == len(program.results)
    scalars = SCALARS["tangent_scalars"]
    program = PythonText(NUMPY / "cayley3.py").program("_tangent_scalars", scalars.parameters, {})
    made = chart_file("numpy", "tangent_scalars", 3, program)
    assert made.count("entry K") == len(scalars.results)
    assert all(f"{name}_right" in made for name, goal in GEOMETRY.items() if goal.scalars == "tangent_scalars")


def test_tables_of_the_interface() -> None:
    interface = PythonText(NUMPY / "_interface.py")
    assert (interface.table("twist"), interface.table("body_rate")) == (("1",), ("-1", "-0.5"))


def test_definitions_are_nested_lets() -> None:
    program = Program(("a",), steps=[(("b",), "(a + 1)")], results=("b", "a"))
    assert program.definition("f") == "Definition f (a : K) : (K * K)%type :=\n  let b := (a + 1) in\n  (b, a)."
    assert len({*V, *U}) == 12
