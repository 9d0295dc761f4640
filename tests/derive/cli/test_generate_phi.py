"""``dualcay generate --phi``: the module, the check against its header, and usage errors for refused φ."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support.command import dualcay


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (("--phi", "alpha/2"), "--phi and --name belong together"),
        (("--name", "mine"), "--phi and --name belong together"),
        (("--phi", "alpha + 1", "--name", "mine"), "not odd by its structure"),
        (("--phi", "__import__('os').system('true')", "--name", "mine"), "not understood in phi"),
        (("--phi", "n*alpha", "--name", "mine"), "give its value with -n"),
        (("--phi", "n*alpha", "--name", "mine", "-n", "2,3"), "n in phi has one value"),
        (("--phi", "alpha#c", "--name", "mine"), "not understood in phi: '#'"),
        (("--phi", "alpha\n", "--name", "mine"), "not understood in phi"),
        (("--phi", "alpha/2", "--name", "lambert"), "is the name of a committed module"),
        (("--phi", "alpha/2", "--name", "not a name"), "an identifier"),
        (("--phi", "alpha*tan(pi/2 - 1 - alpha**2)", "--name", "mine"), "kernels compute no cot"),
    ],
)
def test_refusals(tmp_path: Path, arguments: tuple[str, ...], reason: str):
    done = dualcay("generate", *arguments, "-o", str(tmp_path / "kernels"))
    assert done.returncode == 2
    assert reason in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "kernels").exists()


def test_a_phi_that_is_a_sine_is_written_and_checked(tmp_path: Path):
    folder = str(tmp_path / "kernels")
    arguments = ("--phi", "2*sin(alpha/(2*n))", "-n", "1", "--name", "mine", "-o", folder)
    done = dualcay("generate", *arguments)
    assert done.returncode == 0
    assert "phi = 2*sin(alpha/(2*n)) is the chart 2 sine1: its programs and proofs are used\n" in done.stderr
    text = (tmp_path / "kernels" / "mine.py").read_text(encoding="utf-8")
    assert text.startswith("# python -m derive generate --phi '2*sin(alpha/(2*n))' --name mine -n 1 --target numpy\n")
    assert dualcay("generate", *arguments, "--check").returncode == 0
    (tmp_path / "kernels" / "mine.py").write_text(f"{text}# more\n", encoding="utf-8")
    assert dualcay("generate", *arguments, "--check").returncode == 1


def test_a_long_phi_stays_on_the_first_line_where_the_check_reads_it(tmp_path: Path):
    folder = tmp_path / "kernels"
    arguments = ("--phi", " + ".join(["alpha/10"] * 20), "--name", "mine", "-o", str(folder))
    assert dualcay("generate", *arguments).returncode == 0
    assert dualcay("generate", "--family", "exponential", "-o", str(folder), "--check").returncode == 0
    (folder / "cut.py").write_text("# python -m derive generate --phi 'alpha/(1 +\n")
    done = dualcay("generate", *arguments, "--check")
    assert (done.returncode, done.stderr.count("Traceback")) == (1, 0)
    assert f"foreign: {folder / 'cut.py'} (not made by what its first line says" in done.stdout
