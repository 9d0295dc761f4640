"""Toolkit as its users meet it: import, display at a prompt and in a notebook, copies of charts."""

from __future__ import annotations

import copy
import html
import inspect
import pickle
import re
import shutil
import subprocess
import sys
from fractions import Fraction
from functools import cache, cached_property
from pathlib import Path
from types import FunctionType
from typing import Any

import pytest
import sympy

import derive
from derive.algebra import Dual, Isotropic, Quaternion, Tensor, Vector
from derive.codegen import Package
from derive.maps.chart import Chart
from derive.output.shown import Listing
from derive.papers import PAPERS
from derive.proof import Proof, theorems
from derive.proof.proved import STATED
from tests.support import examples
from tests.support.imports import ROOT, sources

LONGEST = 120


@pytest.fixture
def package(without_validation: None) -> Package:
    """Return the package that the example in the docstring of `generate` writes."""
    names: dict[str, Package] = {}
    assert examples.failures(inspect.getdoc(derive.generate), "generate", names) == ""
    return names["package"]


@cache
def verified() -> Any:
    """Return an erratum and a claim that holds under a condition."""
    return derive.verify("karakilic-2010", ["14", "22"])


def test_results_are_short_at_a_prompt(package: Package) -> None:
    result, other = verified()
    assert repr(result) == "<Result karakilic-2010 (14): erratum>"
    assert repr(result.equation) == "<Equation (14): b1* from the others>"
    assert repr(other) == "<Result karakilic-2010 (22): holds-if>"
    assert repr(theorems()[2]) == "<Proof [all n] norm: proved>"
    module, = package.modules
    assert re.fullmatch(r"<Module cayley1.py: \d+ proofs, \d+ calls validated>", repr(module))
    assert repr(package) == f"<Package of cayley1.py: {len(package.texts)} files>"
    assert repr(module.proved) == f"<Proved cayley1: {len(module.proved.proofs)} proofs>"


def test_list_has_a_line_for_each_result() -> None:
    proofs = derive.Cayley(2).prove()
    lines = repr(proofs).splitlines()
    assert len(lines) == len(proofs)
    assert max(map(len, lines)) <= LONGEST
    assert repr(Listing[Proof]()) == "[]"


def test_proof_is_a_formula_in_a_notebook() -> None:
    norm = theorems()[2]
    assert norm._repr_latex_() == rf"$\displaystyle \text{{proved [all n]:}}\quad {norm.latex}$"


FOUND = (derive.Cayley(1).prove, derive.family("lambert").prove, verified)


@pytest.mark.parametrize("found", FOUND)
def test_list_is_a_table_in_a_notebook(found) -> None:
    items = found()
    table = items._repr_html_()
    assert table.count("<tr>") == len(items) + 1
    assert table.count("<td") == len(items) * table.count("<th")
    for item in items:
        for text in item.cells().values():
            formula = re.fullmatch(r"\$(.*)\$", text)
            shown = rf"\({formula[1]}\)" if formula else text
            assert f">{html.escape(shown)}<" in table
    assert Listing[Proof]()._repr_html_() == '<table class="mathjax_process">\n</table>'


@cache
def compared() -> Any:
    return derive.compare([2], ["lambert"])


def test_comparison_is_a_table_with_figures() -> None:
    rows = compared()
    cells = [row.cells() for row in rows]
    assert [(row["chart"], row["edge/π"]) for row in cells] == [("cayley2", "2"), ("lambert", "2")]
    assert cells[0]["condition of Re T at π"] == "1"  # n = 2 is conformal
    assert cells[0]["φ"] == r"$\tan{\left(\frac{\alpha}{4} \right)}$"
    assert rows._repr_html_().count("<tr>") == 3
    assert [row.chart.name for row in derive.compare(phi="alpha/(1 + alpha**2/40)")] == ["phi"]
    with pytest.raises(ValueError, match="nonsense"):
        derive.compare(families=["nonsense"])


def formulas() -> dict[str, Any]:
    """Return values by the beginning of their LaTeX text."""
    s, t = sympy.symbols("s t")
    return {
        r"\begin{bmatrix} \frac{1}{2} \\ t + s \\ 0 \end{bmatrix}": Vector(Fraction(1, 2), s + t, 0),
        r"\begin{bmatrix} s \\ t \\ 0 \end{bmatrix} + \varepsilon \begin{bmatrix} 1 \\ 2 \\ 3 \end{bmatrix}":
            Vector.dual((s, t, 0), (1, 2, 3)),
        r"\begin{bmatrix} 0 & - t & s \\ t & 0 & -1 \\ - s & 1 & 0 \end{bmatrix}": Tensor.skew(Vector(1, s, t)),
        r"\begin{bmatrix} s \\ 1 \\ 2 \\ 3 \end{bmatrix}": Quaternion(s, Vector(1, 2, 3)),
        r"s + \varepsilon \left(t + s\right)": Dual(s, s + t),
        r"\left(t + s\right) I - 2 \tilde{v}": Isotropic(s + t, -2, 0, s),
        r"\left(s + \varepsilon t\right) I + 1 v \otimes v": Isotropic(Dual(s, t), 0, 1, s),
        r"\text{(14)}\quad b_1^{*} = ": verified()[0].equation,
        r"\text{false:}\quad b_1^{*} = ": verified()[0].verdicts[0],
        theorems()[2].claim[0].latex: theorems()[2].claim[0],
        r"\dot{R} = \tilde{\omega}\,R": derive.motion_equation("70"),
        r"\dot{R} = R\,\tilde{\omega_B}": derive.motion_equation("74"),
        r"\dot{\hat{q}} = \tfrac12 \omega\,\hat{q}": derive.motion_equation("75"),
        r"\dot{\hat{q}} = \tfrac12 \hat{q}\,\omega_B": derive.motion_equation("76"),
        r"\dot{v} = \mathrm{dcay}_{2}^{-1} \omega \qquad \mathrm{dcay}_{2}^{-1} = ": derive.motion_equation("90", 2),
        r"\dot{v} = \left(T^{-1}\right)^T \omega_B \qquad T^{-1} = ": derive.motion_equation("85"),
    }  # fmt: skip


def test_values_are_formulas_in_a_notebook() -> None:
    for latex, value in formulas().items():
        shown = value._repr_latex_()
        assert shown.startswith(rf"$\displaystyle {latex}")
        assert shown.endswith("$")
        assert shown.count("{") == shown.count("}")


def test_less_than_sign_is_escaped() -> None:
    table = verified()._repr_html_()
    assert "0 &lt; f" in table
    assert set(re.findall(r"</?(\w+)", table)) == {"table", "tr", "th", "td"}


@cache
def charts() -> list[Any]:
    n = sympy.Symbol("n", integer=True, positive=True)
    return [
        derive.Cayley(3), derive.Cayley(n + 1), *map(derive.family, ("lambert", "breusing", "exponential", "scaled3")),
        *map(derive.Parameterization, ("alpha/(1 + alpha**2/40)", "3*sin(alpha/6)/2")),
    ]  # fmt: skip


@cache
def maps() -> list[Any]:
    return [getattr(chart, name) for chart in charts() for name in ("quaternion", "tensor", "tangent", "tangent_inv")]


@cache
def results() -> tuple[Any, ...]:
    """Return an object of each public type that is no chart and no map, among them failed proofs and errata."""
    failed = STATED[2].with_claim(0, STATED[2].claim[0].altered()).decide({})
    return (
        *theorems(), *derive.family("exponential").prove(), *derive.Cayley(2).prove()[-3:], failed, *verified(),
        *(result.equation for result in verified()), *(result.verdicts[0] for result in verified()),
        derive.explain(derive.Cayley(2), "pose"), derive.motion_equation("90", 2), derive.motion_equation("70"),
        *compared(), Package({"a": "b"}, ()),
    )  # fmt: skip


def test_public_objects_are_copied_pickled_and_hashed() -> None:
    for item in (*charts(), *maps(), *results()):
        shown = hash(item), repr(item), sympy.latex(item)
        for other in (copy.copy(item), copy.deepcopy(item), pickle.loads(pickle.dumps(item))):
            assert type(other) is type(item)
            assert other == item
            assert (hash(other), repr(other), sympy.latex(other)) == shown
    for chart in charts():
        other = pickle.loads(pickle.dumps(chart))
        assert other.tangent.coefficients == chart.tangent.coefficients
        assert callable(other.prove)


def test_failed_proof_keeps_its_failures_in_copies() -> None:
    failed = next(item for item in results() if isinstance(item, Proof) and not item.proved)
    assert [r.label for r in pickle.loads(pickle.dumps(failed)).failures] == [r.label for r in failed.failures] != []


def test_sympy_typesets_and_rebuilds_the_formulas() -> None:
    entries = [chart.tangent.matrix(sympy.symbols("v1:7"))[1][1] for chart in charts()]
    statements = [r.statement for paper in PAPERS for entry in paper.entries() for r in entry.readings]
    for e in (*entries, *(c for formula in maps() for c in formula.coefficients), *statements):
        for part in sympy.preorder_traversal(e):
            assert not part.args or part.func(*part.args) == part
    assert sympy.latex(maps()[0]) == maps()[0].latex()
    for item in results():
        if isinstance(item, Proof):
            assert isinstance(item.equation, sympy.Eq)
            sides = [[e.left for e in item.claim], [e.right for e in item.claim]]
            assert [[*side] if isinstance(side, sympy.Tuple) else [side] for side in item.equation.args] == sides


def test_members_of_charts_have_docstrings() -> None:
    kinds = {base for chart in charts() for base in type(chart).__mro__ if issubclass(base, Chart)}
    members = [(kind, name, member) for kind in kinds for name, member in vars(kind).items() if name[0] != "_"]
    described = (FunctionType, property, cached_property)
    assert [(k.__name__, name) for k, name, m in members if isinstance(m, described) and not m.__doc__] == []


def installed(folder: Path) -> Path:
    """Return an installed folder of the toolkit, with empty subpackages."""
    place = folder / "derive"
    for name in derive._OWN:
        if name.endswith(".py"):
            place.mkdir(exist_ok=True)
            shutil.copy(ROOT / "derive" / name, place)
        else:
            (place / name).mkdir(parents=True)
            (place / name / "__init__.py").touch()
    (place / "_templates").mkdir()
    (place / "left_by_an_editor~").touch()
    (place / "left_by_git" / "__pycache__").mkdir(parents=True)
    return place


def imported(folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", "import derive"], cwd=folder, capture_output=True, text=True)


def test_own_modules_are_listed() -> None:
    rooms = {name[0] for name, _ in sources("derive") if len(name) > 1}
    files = {f"{name[0] if name else '__init__'}.py" for name, _ in sources("derive") if len(name) <= 1}
    files -= {f"{room}.py" for room in rooms}
    assert {room for room in rooms if (ROOT / "derive" / room / "__init__.py").exists()} <= derive._OWN
    assert {name for name in files if (ROOT / "derive" / name).exists()} <= derive._OWN
    assert all((ROOT / "derive" / name).exists() for name in derive._OWN)


@pytest.mark.parametrize("foreign", ["config.py", "trace/__init__.py"])
def test_files_of_another_distribution_are_named(tmp_path: Path, foreign: str) -> None:
    place = installed(tmp_path)
    assert imported(tmp_path).returncode == 0, imported(tmp_path).stderr
    (place / foreign).parent.mkdir(exist_ok=True)
    (place / foreign).touch()
    done = imported(tmp_path)
    last = done.stderr.splitlines()[-1]
    assert last.startswith(f"ImportError: {place} holds files of another distribution ({foreign.partition('/')[0]})")
    assert "cannot be installed together" in last
    assert "pip uninstall derive" in last
