"""Certificates: an independent program accepts those of the toolkit and refuses altered ones."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.support.alterations import altered, seal
from tests.support.command import dualcay
from tools import check_certificates

CHECKER = Path(check_certificates.__file__)
EQUATIONS = ("verify", "--paper", "condurache-popa-2023", "--eq", "57,88,112")


def checked(file: Path) -> subprocess.CompletedProcess[str]:
    """Run the checker in a process without the packages of the project."""
    command = [sys.executable, "-I", "-S", str(CHECKER), str(file)]
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False)


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("certificates") / "certificates.json"
    assert dualcay(*EQUATIONS, "--certificates", str(file)).returncode == 0
    return file


@pytest.fixture(scope="module")
def found(written: Path) -> dict[str, Any]:
    content: dict[str, Any] = json.loads(written.read_text("utf-8"))
    return content


def test_the_checker_accepts_all(written: Path, found: dict[str, Any]) -> None:
    done = checked(written)
    assert done.returncode == 0, done.stdout
    assert done.stdout == f"{found['certified']} of {found['certified']} certificates are right\n"


def test_all_theorems_and_the_equations_have_certificates(found: dict[str, Any]) -> None:
    names = [certificate["name"] for certificate in found["certificates"]]
    assert {"twist", "slopes", "binomial sums of the brackets", "transport, even branch"} <= set(names)
    assert {"condurache-popa-2023 (57)", "condurache-popa-2023 (112), corrected"} <= set(names)
    assert not any(" [all n]" in entry["name"] for entry in found["listed"])
    assert all(entry["reason"] for entry in found["listed"])


def test_inductions_have_a_base_and_a_step_that_the_checker_moves(found: dict[str, Any]) -> None:
    (norm,) = (c for c in found["certificates"] if c["name"] == "norm")
    (part,) = norm["parts"]
    assert [{*equation} - {"label", "right"} for equation in part["equations"]] == [{"start"}, {"step"}]


def test_certificates_have_content(found: dict[str, Any]) -> None:
    for certificate in found["certificates"]:
        equations = [e for part in certificate.get("parts", ()) for e in part["equations"]]
        cites = any(premise["by"] != "definition" for premise in certificate["premises"])
        moved = any(e.get("left") != e["right"] for e in equations)
        assert moved or cites or "series" in certificate, certificate["name"]


def test_the_checker_is_short_and_needs_the_standard_library_only() -> None:
    assert len(CHECKER.read_text("utf-8").splitlines()) <= 170


@pytest.mark.parametrize("seed", range(50))
def test_altered_certificates_are_refused(seed: int, found: dict[str, Any]) -> None:
    """Check one certificate before and after, with the claims of those above it."""
    theorems = [c["name"] for c in found["certificates"] if "parts" in c]
    place = [c["name"] for c in found["certificates"]].index(theorems[seed * 7 % len(theorems)])
    right, claims = found["certificates"][place], {c["name"]: c["claims"] for c in found["certificates"][:place]}
    check_certificates.check(right, claims)
    with pytest.raises(check_certificates.MALFORMED):
        check_certificates.check(altered(right, seed), claims)


def test_start_and_law_have_one_term(found: dict[str, Any], tmp_path: Path) -> None:
    content = json.loads(json.dumps(found))
    (certificate,) = (c for c in content["certificates"] if c["name"] == "double angle")
    start = next(e["start"] for e in certificate["parts"][0]["equations"] if e["label"] == "start, sin(alpha)")
    start["term"][2] = [[5 * c, powers] for c, powers in start["term"][2]]  # 0 at the start all the same
    seal(certificate)
    (tmp_path / "terms.json").write_text(json.dumps(content), "utf-8")
    refusal = "certificate 'double angle' is refused: start and law differ"
    assert checked(tmp_path / "terms.json").stdout.splitlines()[0] == refusal


@pytest.mark.parametrize("name", ["binomial sums", "binomial theorem", "binomial sums of the brackets"])
def test_altered_sums_are_refused(name: str, found: dict[str, Any], tmp_path: Path) -> None:
    content = json.loads(json.dumps(found))
    (certificate,) = (c for c in content["certificates"] if c["name"] == name)
    next(iter(certificate["series"]["sums"].values()))["summands"][0][0] += 1
    seal(certificate)
    (tmp_path / "sums.json").write_text(json.dumps(content), "utf-8")
    (line, *_) = checked(tmp_path / "sums.json").stdout.splitlines()
    assert line.startswith(f"certificate {name!r} is refused: ")
    assert " is not an identity at n = " in line


X, ONE = [[1, [1, 0]]], [1, [], [[1, [0, 0]]]]
IDENTITY = {"label": "p", "left": ONE, "right": ONE}


def false(equation: dict[str, Any], **rest: Any) -> dict[str, Any]:
    """Return a certificate in the variables x and y with one equation, which claims what is false."""
    part = {"variables": ["x", "y"], "relations": [], "factors": [], "free": ["x", "y"], "origin": {}, **rest}
    parts = [{**part, "equations": rest.get("equations", [equation])}]
    certificate = {"name": "false", "status": "proved", "claims": ["p = 7"], "premises": [], "parts": parts}
    seal(certificate)
    return certificate


NONZERO = [{"factor": X, "point": {"x": "1"}}]
STEEP = [{"factor": [[1, [8192, 0]]], "point": {"x": "1"}}]
UNTIED = [{"factor": X, "base": [[1, [0, 0]]]}]
Y = [1, [], [[1, [0, 1]]]]
FALSE = {
    "an exponent that wraps": (
        false({"label": "p", "left": [1, [2**19], ONE[2]], "right": Y}, factors=STEEP), "malformed"),
    "a power beyond all time": (
        false({"label": "p", "left": [1, [10**9], X], "right": ONE}, factors=NONZERO), "a power"),
    "a negative power": (false({"label": "p", "left": [1, [-1], X], "right": ONE}, factors=NONZERO), "a power"),
    "labels of an induction": (
        false(IDENTITY, equations=[{**IDENTITY, "label": f"{stage}, p"} for stage in ("start", "law")]), "'start' by"),
    "a relation 1 = 0": (false({"label": "p", "left": ONE, "right": Y}, relations=[[[1, [0, 0]]]]), "the relations"),
    "two relations with one lead": (false(IDENTITY, relations=[X, [[1, [1, 0]], [-1, [0, 0]]]]), "the relations"),
    "a factor that is not its base": (
        false({"label": "p", "left": [1, [1], []], "right": Y}, relations=[X], factors=UNTIED, free=[]), "untied"),
}  # fmt: skip


@pytest.mark.parametrize("name", FALSE)
def test_false_certificates_are_refused_at_once(name: str) -> None:
    certificate, reason = FALSE[name]
    check_certificates.check(false(IDENTITY), {})
    with pytest.raises(ValueError, match=reason):
        check_certificates.check(certificate, {})


def test_a_list_that_is_a_number_is_no_file_of_certificates(found: dict[str, Any], tmp_path: Path) -> None:
    (tmp_path / "five.json").write_text(json.dumps({**found, "listed": 5}), "utf-8")
    assert checked(tmp_path / "five.json").returncode == 3


def test_files_that_hold_no_certificates_are_named(written: Path, tmp_path: Path) -> None:
    (tmp_path / "cut.json").write_text(written.read_text("utf-8")[:-100], "utf-8")
    (tmp_path / "list.json").write_text("[]", "utf-8")
    for name in ("cut.json", "list.json", "absent.json"):
        done = checked(tmp_path / name)
        assert done.returncode == 3
        assert done.stderr.startswith(f"{tmp_path / name}: no file of certificates: ")
        assert "Traceback" not in done.stderr


def test_a_wrong_count_is_refused(found: dict[str, Any], tmp_path: Path) -> None:
    (tmp_path / "fewer.json").write_text(json.dumps({**found, "certificates": found["certificates"][:-1]}), "utf-8")
    done = checked(tmp_path / "fewer.json")
    assert done.returncode == 1
    assert "not as stated" in done.stdout


def test_the_option_names_a_file_of_its_own(tmp_path: Path) -> None:
    same = str(tmp_path / "report.json")
    done = dualcay(*EQUATIONS, "-o", same, "--certificates", same)
    assert done.returncode == 2
    assert "name another file than -o" in done.stderr
    assert not (tmp_path / "report.json").exists()
