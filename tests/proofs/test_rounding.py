"""Rounding errors of emitted programs: scripts, premises and results of Gappa, and bounds that it refuses."""

import re
from dataclasses import asdict
from fractions import Fraction
from itertools import product
from json import dumps
from pathlib import Path

import numpy as np
import pytest
import sympy

from derive.maps import Cayley
from derive.maps.polynomials import x
from proofs import gappa
from proofs.emitted import CHeader, printed
from proofs.rounding import FUNCTIONS, ORDERS, Bound, certify, control, found, load, main, measured, read
from proofs.statements import MachineError
from proofs.transcript import Transcript

RECORDED = Path(__file__).parents[2] / "benchmarks" / "certified.json"

HEADER = """
static void dualcay_toy_scalars(double x, double *s_at)
{
    const double s = 2 / (1 + x);
    *s_at = s;
}
static void dualcay_toy_program(const double v[6], double w[2])
{
    const double x = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    double s;
    dualcay_toy_scalars(x, &s);
    w[0] = -v[3] * s;
    w[1] = 1;
}
"""


def program(folder: Path, text: str = HEADER) -> Transcript:
    (folder / "toy.h").write_text(text)
    return CHeader(folder / "toy.h").program("program", [gappa.V], [2])


@pytest.fixture(scope="module")
def headers(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return printed(tmp_path_factory.mktemp("c"), ORDERS)


def test_script_holds_the_program_rounded_and_exact(tmp_path: Path) -> None:
    lines = gappa.script(program(tmp_path), 2, {0: "in ?"}).splitlines()
    assert "t7 rnd= (2) / t6;" in lines
    assert "t7_exact = (2) / t6_exact;" in lines
    assert "t9 rnd= t8 * t7;" in lines
    assert "t9_exact = t8_exact * t7_exact;" in lines
    assert "/\\ t5_exact - (square) in [0, 0]" in lines
    assert "t9 - t9_exact in ? }" in lines
    assert gappa.outputs(program(tmp_path)) == (0,)


def test_altered_header_changes_script_and_premises(tmp_path: Path) -> None:
    text = gappa.script(program(tmp_path, HEADER.replace("+ v[2]", "- v[2]")), 2, {0: "in ?"})
    assert "t5 rnd= t3 - t4;" in text
    assert "(square)" not in text


@pytest.mark.parametrize("number", ["0.5", "9007199254740993", "(double)2"])
def test_constants_that_may_be_rounded_are_refused(tmp_path: Path, number: str) -> None:
    with pytest.raises(MachineError, match="is refused: only integers of C"):
        gappa.script(program(tmp_path, HEADER.replace("2 / (1", f"{number} / (1")), 2, {})


@pytest.mark.thorough
def test_ratio_of_equal_names_is_one(headers: Path) -> None:
    text = gappa.script(read(headers, "quaternion", 3), 3, {0: "in ?"})
    (root,) = re.findall(r"(t\d+) / \1 -> 1 {\1 <> 0}", text)
    (power,) = re.findall(rf"{root} rnd= sqrt \((t\d+)\);", text)
    assert f"/\\ {power}_exact - ((1 + square) * (1 + square) * (1 + square)) in [0, 0]" in text
    assert "_exact - (length * reach * cosine) in [0, 0]" in text


def test_results_are_read_exactly() -> None:
    printed = """Results:
  t10 - t10_exact in [-3b-2 {-0.75, -2^(-0.41)}, 1b-2 {0.25, 2^(-2)}]
  t11 - t11_exact in [0, 0]
Error: some properties were not satisfied:
  BND(t2 - t2_exact)"""
    assert gappa.bounds_of(printed) == {"t10": Fraction(3, 4), "t11": 0}
    assert gappa.claim(2.0625) == "in [-33b-56, 33b-56]"
    up = gappa.rounded_up(gappa.EPS)
    assert (up, gappa.claim(up)) == (1.0625, "in [-17b-56, 17b-56]")


@pytest.mark.parametrize("order", ORDERS)
def test_reach_is_the_largest_stretch_of_the_inverse_tangent(order: int) -> None:
    """Compare the term with singular values of T⁻¹, along v decided for all |v| ≤ 1."""
    q = Cayley(order).q
    shorter = sympy.Poly(order**2 * (1 + x) ** (order - 2) - q**2, x)
    assert shorter.is_zero or (shorter.count_roots(sympy.Rational(1, 10**6), 1) == 0 and shorter.eval(1) > 0)
    assert shorter.is_zero or (shorter.eval(0) == 0 and shorter.diff().eval(0) > 0)
    assert sympy.Poly(q, x).count_roots(0, 1) == 0
    for length in (0.0, 0.3, 0.7, 1.0):
        inverse = np.array(Cayley(order).tangent_inv.matrix((length, 0, 0, 0, 0, 0))[0], dtype=float)
        expected = gappa.reach(order, length * length)
        assert np.linalg.norm(inverse, 2) == pytest.approx(expected, rel=1e-14)


@pytest.mark.thorough
def test_measured_errors_stay_below_recorded_bounds(headers: Path) -> None:
    bounds = load(RECORDED)
    assert {(each.function, each.order) for each in bounds} == set(product(FUNCTIONS, ORDERS))
    for function, order in {(each.function, each.order) for each in bounds}:
        own = {each.output: each for each in bounds if (each.function, each.order) == (function, order)}
        errors = measured(read(headers, function, order), order, 60)
        assert errors.keys() == own.keys()
        for i, error in errors.items():
            assert 0.2 * own[i].measured < error < (own[i].bound or 0)
            assert own[i].measured < (own[i].bound or 0)


@pytest.mark.thorough
def test_missing_gappa_and_wrong_files_are_named(
    headers: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "bounds.json").write_text("[{}]")
    assert main(["--c", str(headers), "--check", str(tmp_path / "bounds.json")]) == 1
    assert "no file of bounds" in capsys.readouterr().err
    high = Bound("quaternion", 2, 0, 1.0, 2.0)
    with pytest.raises(MachineError, match="other outputs"):
        certify(headers, [high])
    with pytest.raises(MachineError, match=r"above the bound 1\.0"):
        certify(headers, [Bound("quaternion", 2, i, 1.0, 2.0) for i in range(8)])
    monkeypatch.setenv("PATH", str(tmp_path))
    assert main(["--c", str(headers), "-o", str(tmp_path / "made.json")]) == 3
    assert "apt-get install gappa" in capsys.readouterr().err
    assert not (tmp_path / "made.json").exists()


@pytest.mark.coq
def test_bound_is_certified_and_a_false_one_is_refused(headers: Path, tmp_path: Path) -> None:
    bounds = found(headers, "quaternion", 2)
    certify(headers, bounds)
    control(headers, bounds[0])
    (tmp_path / "bounds.json").write_text(dumps([asdict(each) for each in bounds]))
    assert load(tmp_path / "bounds.json") == bounds
    header = headers / "cayley2.h"
    text = header.read_text()
    header.write_text(text.replace("s = p * r;", "s = p * r + 1 - 1;"))
    with pytest.raises(MachineError, match=r"Gappa refuses bounds of quaternion of order 2: q\[0\]"):
        certify(headers, bounds)
    header.write_text(text)
