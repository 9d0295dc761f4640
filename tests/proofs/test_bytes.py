"""Machine code compared with the text of C headers: functions that are equal, and altered code that is refused."""

import re
import shutil
import sys
from pathlib import Path

import pytest

from proofs.assembly import read
from proofs.bytes import DECLINED, DIFFERENT, EQUAL, FLAGS, Proof, Verdict, compiled, main
from proofs.emitted import printed
from proofs.functions import Source
from proofs.rounded import Number, Trees
from proofs.statements import MachineError

pytestmark = pytest.mark.compiler
CHART = "dualcay_cayley2_"


@pytest.fixture(scope="module")
def headers(tmp_path_factory: pytest.TempPathFactory) -> Path:
    sys.setrecursionlimit(100_000)
    folder = printed(tmp_path_factory.mktemp("c"), [2])
    (folder / "rotation" / "cayley2.h").unlink()  # poses alone take half the time
    return folder


@pytest.fixture(scope="module")
def source(headers: Path) -> Source:
    return Source(headers, "cayley2", Trees("double"))


@pytest.fixture(scope="module")
def text(headers: Path, source: Source, tmp_path_factory: pytest.TempPathFactory) -> str:
    return built(headers, source, f"gcc {FLAGS}", tmp_path_factory.mktemp("built"))


def built(headers: Path, source: Source, command: str, build: Path) -> str:
    return compiled(headers, source, "float" if source.trees.unit == 4 else "double", command.split(), build)


def verdict(source: Source, text: str, name: str) -> Verdict:
    (found,) = (each for each in Proof(source, read(text)).verdicts(name) if each.name == name)
    return found


def altered(text: str, name: str, pattern: str, instead: str) -> str:
    """Return disassembled text in which the first instruction of a function that fits a pattern is another one."""
    start = text.index(f"<{name}>:")
    end = text.index("\n\n", start)
    body, count = re.subn(pattern, instead, text[start:end], count=1)
    assert count == 1, pattern
    return text[:start] + body + text[end:]


@pytest.mark.parametrize("name", ["rate", "rate_rows", "pose_rows", "shadow", "from_tensor", "local", "to_screw"])
def test_machine_code_equals_the_text(source: Source, text: str, name: str) -> None:
    assert verdict(source, text, CHART + name) == Verdict(CHART + name, EQUAL)


@pytest.mark.parametrize(
    ("name", "pattern", "instead"),
    [
        ("rate", r"\baddsd\b", "subsd"),
        ("rate", r"subsd  (%xmm\d+),(%xmm\d+)", r"subsd  \2,\1"),
        ("rate", r"movs[sd]  %xmm\d+,(0x\w+)?\(%r[a-z]x\)|movups %xmm\d+,(0x\w+)?\(%r[a-z]x\)", "nop"),
        ("rate", r"unpcklpd %xmm\d+,(%xmm\d+)", r"shufpd \$0x1,\1,\1"),
    ],
    ids=["another operation", "swapped operands", "no store", "swapped lanes"],
)
def test_altered_machine_code_is_refused(source: Source, text: str, name: str, pattern: str, instead: str) -> None:
    assert verdict(source, altered(text, CHART + name, pattern, instead), CHART + name).verdict == DIFFERENT


def test_constant_one_ulp_off_is_refused(source: Source, text: str) -> None:
    listing, name = read(text), f"{CHART}rate"
    instructions = (listing.code[address] for address in sorted(listing.reached(listing.functions[name])))
    address = next(each.next + operand.memory.displacement for each in instructions for operand in each.operands
                   if operand.memory and operand.memory.base == "rip" and each.name.endswith("sd"))  # fmt: skip
    listing.data[address] ^= 1
    found = [each for each in Proof(source, listing).verdicts(name) if each.name == name]
    assert [each.verdict for each in found] == [DIFFERENT]


@pytest.mark.parametrize("flags", ["-O2 -ffast-math", "-O2 -ffp-contract=fast -mfma"])
def test_flags_that_change_bits_are_refused(headers: Path, source: Source, flags: str, tmp_path: Path) -> None:
    name = f"{CHART}rate"
    found = verdict(source, built(headers, source, f"gcc {flags}", tmp_path), name)
    assert found.verdict == DIFFERENT
    assert ("fused multiply-add" in found.reason) == ("fma" in flags)


def test_declined_function_has_a_reason(source: Source, text: str) -> None:
    name = f"{CHART}rate"
    found = verdict(source, altered(text, name, r"\baddsd\b", "haddsd"), name)
    assert found.verdict == DECLINED
    assert "no instruction that is known: haddsd" in found.reason


def test_command_reads_disassembled_text(
    headers: Path, text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "text"
    options = [str(headers), "--real", "double", "--function", f"{CHART}inverse", "--disassembly", str(file)]
    file.write_text(text, encoding="utf-8")
    assert main(options) == 0
    assert re.search(r"cayley2 +double +2 +0 +0", capsys.readouterr().out)
    file.write_text(altered(text, f"{CHART}inverse", r"\bxorp[sd]", "orps"), encoding="utf-8")
    assert main(options) == 1
    assert f"{CHART}inverse: different" in capsys.readouterr().out
    assert main([str(headers), "--cc", "no-such-compiler"]) == 3


@pytest.mark.parametrize("real", ["double", "float"])
def test_identities_hold_for_every_float(real: str) -> None:
    trees = Trees(real)
    a, b, zero = (Number(trees, trees.make("given", name)) for name in "abz")

    def same(one: Number, other: Number) -> bool:
        return trees.equal(one.tree, other.tree)

    quarter, third = (Number(trees, trees.constant(each)) for each in (0.25, 1 / 3))
    assert all(same(*pair) for pair in ((a - b, -b + a), (2 * a, a + a), (a / 4, a * quarter), (abs(-a), abs(a))))
    for pair in ((a - b, -(b - a)), (a + 0, a), (a / 3, a * third), ((a + b) + zero, a + (b + zero))):
        assert not same(*pair)


@pytest.mark.thorough
@pytest.mark.parametrize("real", ["double", "float"])
@pytest.mark.parametrize("level", ["-O0", "-O1", "-O2", "-O3"])
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_levels_of_optimisation(headers: Path, compiler: str, level: str, real: str, tmp_path: Path) -> None:
    if not shutil.which(compiler):
        pytest.skip(f"{compiler} is missing")
    source = Source(headers, "cayley2", Trees(real))
    text = built(headers, source, f"{compiler} -std=c99 {level} -ffp-contract=off", tmp_path)
    proof = Proof(source, read(text))
    found = [each for name in ("rate", "pose", "shadow") for each in proof.verdicts(f"{CHART}{name}")]
    wrong = [each for each in found if each.verdict != EQUAL]
    assert level == "-O0" or not wrong
    assert all("never executed" in each.reason for each in wrong), "code without optimisation has dead instructions"


def test_missing_header_is_refused(tmp_path: Path) -> None:
    with pytest.raises(MachineError, match="lambert"):
        Source(tmp_path, "lambert", Trees("double"))
