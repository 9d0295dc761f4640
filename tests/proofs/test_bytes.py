"""Machine code compared with the text of C headers: functions that are equal, and altered code that is refused."""

import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from proofs.bytes.__main__ import FLAGS, MARK, compiled, main
from proofs.bytes.equality import SCALES, Equality
from proofs.bytes.functions import Source
from proofs.bytes.numbers import Number
from proofs.bytes.program import Program
from proofs.bytes.proof import DECLINED, DIFFERENT, EQUAL, Proof, Verdict
from proofs.bytes.trees import RELATIONS, Tree, Trees
from proofs.emitted import printed
from proofs.statements import MachineError

pytestmark = [pytest.mark.compiler, pytest.mark.vex]
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
def built(headers: Path, source: Source, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return made(headers, source, f"gcc {FLAGS}", tmp_path_factory.mktemp("built"))


@pytest.fixture(scope="module")
def assembly(headers: Path, source: Source, tmp_path_factory: pytest.TempPathFactory) -> str:
    return made(headers, source, f"gcc {FLAGS} -S", tmp_path_factory.mktemp("text")).read_text(encoding="utf-8")


def made(headers: Path, source: Source, command: str, build: Path) -> Path:
    return compiled(headers, source, "float" if source.trees.unit == 4 else "double", command.split(), build)


def verdict(source: Source, file: Path, name: str) -> Verdict:
    (found,) = (each for each in Proof(source, Program(file)).verdicts(name) if each.name == name)
    return found


def altered(assembly: str, pattern: str, instead: str, build: Path) -> Path:
    """Return the object of a text in which the first instruction of ``rate`` that fits a pattern is another one."""
    start = assembly.index(f"\n{CHART}rate:")
    end = assembly.index(".size", start)
    body, count = re.subn(pattern, instead, assembly[start:end], count=1)
    assert count == 1, pattern
    (build / "altered.s").write_text(assembly[:start] + body + assembly[end:], encoding="utf-8")
    subprocess.run(["gcc", "-c", "-o", build / "altered.o", build / "altered.s"], check=True)
    return build / "altered.o"


@pytest.mark.parametrize("name", ["rate", "rate_rows", "pose_rows", "shadow", "from_tensor", "local", "to_screw"])
def test_machine_code_equals_the_text(source: Source, built: Path, name: str) -> None:
    assert verdict(source, built, CHART + name) == Verdict(CHART + name, EQUAL)


@pytest.mark.parametrize(
    ("pattern", "instead", "wanted"),
    [
        (r"\baddsd\b", "subsd", DIFFERENT),
        (r"subsd\t(%xmm\d+), (%xmm\d+)", r"subsd\t\2, \1", DIFFERENT),
        (r"\tmov[su]p?[sd]\t%xmm\d+, [x\w]*\(%r[a-z]x\)", "\tnop", DIFFERENT),
        (r"unpcklpd\t%xmm\d+, (%xmm\d+)", r"shufpd\t$1, \1, \1", DIFFERENT),
        (r"\tret", "\tpushq %rax\n\tret", DIFFERENT),
        (r"\baddsd\b", "roundsd $0,", DECLINED),
    ],
    ids=["another operation", "swapped operands", "no store", "swapped lanes", "lost return", "unknown instruction"],
)
def test_altered_machine_code_is_refused(
    source: Source, assembly: str, pattern: str, instead: str, wanted: str, tmp_path: Path
) -> None:
    found = verdict(source, altered(assembly, pattern, instead, tmp_path), f"{CHART}rate")
    assert (found.verdict, bool(found.reason)) == (wanted, True)


def test_constant_one_ulp_off_is_refused(source: Source, assembly: str, tmp_path: Path) -> None:
    text = assembly.replace("\t.long\t1071644672", "\t.long\t1071644671")
    (tmp_path / "altered.s").write_text(text, encoding="utf-8")
    subprocess.run(["gcc", "-c", "-o", tmp_path / "altered.o", tmp_path / "altered.s"], check=True)
    assert verdict(source, tmp_path / "altered.o", f"{CHART}rate").verdict == DIFFERENT


@pytest.mark.parametrize("command", ["gcc -O2 -ffast-math", "gcc -O2 -ffp-contract=fast -mfma",
                                     "aarch64-linux-gnu-gcc -O3 -ffp-contract=fast"])  # fmt: skip
def test_flags_that_change_bits_are_refused(headers: Path, source: Source, command: str, tmp_path: Path) -> None:
    if not shutil.which(command.split()[0]):
        pytest.skip(f"{command.split()[0]} is missing")
    found = verdict(source, made(headers, source, command, tmp_path), f"{CHART}rate")
    assert found.verdict == DIFFERENT
    assert ("fused multiply-add" in found.reason) == ("contract" in command)


def test_command_reads_an_object(
    headers: Path, built: Path, assembly: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = [str(headers), "--real", "double", "--function", f"{CHART}rate", "--disassembly"]
    page = tmp_path / "page.md"
    page.write_text(f"before\n{MARK}\nold\n{MARK}\nafter\n", encoding="utf-8")
    assert main([*options, str(built), "-o", str(page)]) == 0
    assert "| cayley2 | double | gcc | 6 | 6 | 0 | 0 |" in capsys.readouterr().out
    assert re.fullmatch(rf"before\n{MARK}\n\n(\|.*\|\n)+\n{MARK}\nafter\n", page.read_text(encoding="utf-8"))
    assert main([*options, str(altered(assembly, r"\baddsd\b", "subsd", tmp_path))]) == 1
    assert f"{CHART}rate: different" in capsys.readouterr().out
    assert main([*options, str(headers / "cayley2.h")]) == 2
    assert main([str(headers), "--cc", "no-such-compiler"]) == 3
    assert main([str(headers / "missing")]) == main([*options[:-2], "no_such", "--disassembly", str(built)]) == 2


@pytest.mark.parametrize("real", ["double", "float"])
def test_identities_hold_for_every_float(real: str) -> None:
    trees = Trees(real)
    a, b, zero = (Number(trees, trees.make("given", name, 0, 0)) for name in "abz")

    def same(one: Number, other: Number) -> bool:
        return Equality(trees).equal(one.tree, other.tree)

    quarter, third = (Number(trees, trees.constant(each)) for each in (0.25, 1 / 3))
    assert all(same(*pair) for pair in ((a - b, -b + a), (2 * a, a + a), (a / 4, a * quarter), (abs(-a), abs(a))))
    for pair in ((a - b, -(b - a)), (a + 0, a), (a / 3, a * third), ((a + b) + zero, a + (b + zero))):
        assert not same(*pair)


def test_choices_are_compared_in_each_case_that_can_occur() -> None:
    trees = Trees("double")
    a, b, c = (Number(trees, trees.make("given", name, 0, 0)) for name in "abc")

    def largest(*given: Number) -> Number:
        found = given[0]
        for each in given[1:]:
            found = (found < each).choose(each, found)
        return found

    equal: Callable[[Number, Number], bool] = lambda one, other: Equality(trees).equal(one.tree, other.tree)  # noqa: E731
    assert equal(largest(a, b) + c, (a < b).choose(b + c, a + c))
    assert equal(largest(largest(a, b), c), (a < b).choose(largest(b, c), largest(a, c)))
    assert not equal(largest(a, b) + c, (b < a).choose(a + c, b + c)), "the two differ where the numbers are unordered"


def test_what_holds_in_one_case_is_not_taken_for_all(monkeypatch: pytest.MonkeyPatch) -> None:
    trees = Trees("double")
    a, b, c, d, e, f, g, h = (Number(trees, trees.make("given", name, 0, 0)) for name in "abcdefgh")
    first, second = a < b, c < d
    one = first.choose(e, f) + (second.choose(1, g) * a < b).choose(h, c)
    other = first.choose(e, f) + second.choose(h, (g * a < b).choose(h, c))  # the same where a < b
    monkeypatch.setattr(Equality, "alike_at_samples", lambda *_: True)
    assert not Equality(trees).equal(one.tree, other.tree)


def relations(equality: Equality, pairs: list[Tree], place: int) -> list[tuple[Tree, int]]:
    """Return the relations in which numbers stand at a sample."""
    return [(pair, int(equality._relation(pair)[place])) for pair in pairs]


def test_relations_of_numbers_never_contradict_each_other() -> None:
    trees = Trees("double")
    equality, chance = Equality(trees), np.random.default_rng(1)
    numbers = [trees.constant(each) for each in (0, 1, -2)] + [trees.make("given", name, 0, 0) for name in "abcd"]
    for _ in range(60):
        kind = [trees.add, trees.sub, trees.mul, trees.div][chance.integers(4)]
        one, other = (numbers[chance.integers(len(numbers))] for _ in range(2))
        numbers += [kind(one, other), trees.sqrt(trees.absolute(one)), trees.mul(one, one)][: 1 + chance.integers(3)]
    drawn = ([numbers[each] for each in chance.integers(len(numbers), size=2)] for _ in range(300))
    compared = (trees.choose(one, other, {each: each for each in RELATIONS}) for one, other in drawn)
    pairs = [each.parts[0] for each in compared if isinstance(each, Tree)]
    for place in range(len(SCALES)):
        known = frozenset[tuple[Tree, int]]()
        for fact in relations(equality, pairs, place):
            assert equality.order.contradiction(known, fact) is None
            for each, _ in equality._consequences(known, fact):
                assert each in relations(equality, [each[0]] if each else [], place)
            known |= {fact}


def test_relations_that_no_numbers_have_are_found() -> None:
    trees = Trees("double")
    a, b, c = (trees.make("given", name, 0, 0) for name in "abc")
    square = trees.add(trees.mul(a, a), trees.mul(b, b))
    less, equal, greater, unordered = range(1, 5)
    pair: Callable[[Tree, Tree], Tree] = lambda x, y: trees.make("pair", x, y)  # noqa: E731
    for *known, new in (
        [(pair(a, b), less), (pair(b, c), less), (pair(a, c), greater)],
        [(pair(a, b), equal), (pair(a, trees.negated(c)), less), (pair(b, trees.negated(c)), greater)],
        [(pair(trees.constant(0), square), greater)],
        [(pair(trees.constant(1), a), less), (pair(a, trees.constant(1 / 2)), less)],
        [(pair(trees.constant(0), square), less), (pair(a, b), unordered)],
        [(pair(a, b), unordered), (pair(trees.constant(0), square), less)],
    ):
        order = Equality(trees).order
        assert order.contradiction(frozenset(known), new) is not None
        assert all(order.contradiction(frozenset({one}), other) is None for one, other in pairwise(known))


X86, ARM = "gcc", "aarch64-linux-gnu-gcc"
ONE = "(const double a[1], double b[1]) { b[0] = a[0]; }"
TWO = "(const double a[2], double b[2]) { b[0] = a[0]; b[1] = a[1]; }"
PRODUCT = "(const double a[2], double b[1]) { b[0] = a[0] * a[1]; }"
SUM = "(const double a[3], double b[1]) { b[0] = a[0] * a[1] + a[2]; }"
LEAST = "(const double a[4], double b[2]) { b[0] = a[0] < a[2] ? a[0] : a[2]; b[1] = a[1] < a[3] ? a[1] : a[3]; }"
ZERO, BRANCH = "(double b[1]) { b[0] = 0; }", "(int k, double b[1]) { b[0] = k == 0 ? 1 : 2; }"
ROWS = """(const double a[2], double b[1]) { b[0] = a[1]; }
void f_rows(size_t n, const double *a, size_t s, double *b, size_t t)
{ for (size_t j = 0; j < n; ++j) { b[j] = a[j + s]; } }"""
LOAD, STORE = "movsd (%rdi),%xmm0", "movsd %xmm0,(%rsi)"
LOOP = "test %rdi,%rdi; je 2f; 1: movsd -8(%rsi,%rdi,8),%xmm0; movsd %xmm0,-8(%rcx,%rdi,8); sub $1,%rdi; jne 1b; 2:"
NUMBER = "setne %al; add $1,%eax; cvtsi2sd %eax,%xmm0; movsd %xmm0,(%rsi)"
BY_HAND = [
    ("numbers copied", X86, TWO, "movupd (%rdi),%xmm0; movupd %xmm0,(%rsi)", EQUAL),
    ("blended with itself", X86, TWO,
     "movupd (%rdi),%xmm0; movapd %xmm0,%xmm1; blendpd $2,%xmm0,%xmm1; movupd %xmm1,(%rsi)", EQUAL),
    ("AVX", X86, TWO, "vmovupd (%rdi),%xmm0; vmovupd %xmm0,(%rsi)", DECLINED),
    ("aligned load", X86, TWO, "movapd (%rdi),%xmm0; movupd %xmm0,(%rsi)", DIFFERENT),
    ("aligned store", X86, TWO, "movupd (%rdi),%xmm0; movapd %xmm0,(%rsi)", DIFFERENT),
    ("read beyond the argument", X86, ONE, f"movupd (%rdi),%xmm0; {STORE}", DIFFERENT),
    ("constant that ends early", X86, "(double b[2]) { b[0] = 1; b[1] = 0; }",
     "movupd 9f(%rip),%xmm0; movupd %xmm0,(%rdi); .section .rodata; 9: .double 1; .text", DIFFERENT),
    ("half a result", X86, ONE, "mov (%rdi),%eax; mov %eax,(%rsi)", DECLINED),
    ("below the red zone", X86, ONE, f"{LOAD}; movsd %xmm0,-200(%rsp); movsd -200(%rsp),%xmm0; {STORE}", DIFFERENT),
    ("below the stack", ARM, ONE, "ldr d0,[x0]; str d0,[sp,-16]; ldr d0,[sp,-16]; str d0,[x1]", DIFFERENT),
    ("frame of the caller", ARM, ONE, "ldr d0,[x0]; str q0,[sp,-8]; str d0,[x1]", DIFFERENT),
    ("largest of a number and garbage", X86, ONE, f"{LOAD}; maxsd %xmm9,%xmm0; {STORE}", DIFFERENT),
    ("two registers of garbage", X86, ZERO, "xorpd %xmm14,%xmm13; movsd %xmm13,(%rdi)", DIFFERENT),
    ("least, not of NaN", ARM, LEAST, "ldp q0,q1,[x0]; fmin v0.2d,v0.2d,v1.2d; str q0,[x1]", DECLINED),
    ("0 times infinity is 2", ARM, PRODUCT, "ldp d0,d1,[x0]; fmulx d0,d0,d1; str d0,[x1]", DECLINED),
    ("fused, by element", ARM, SUM, "ldr q1,[x0]; ldp d2,d0,[x0,8]; fmla d0,d2,v1.d[0]; str d0,[x1]", DIFFERENT),
    ("tiny numbers are 0", ARM, PRODUCT,
     "ldp d0,d1,[x0]; mov x9,#1<<24; msr fpcr,x9; fmul d0,d0,d1; msr fpcr,xzr; str d0,[x1]", DECLINED),
    ("strings run down", X86, ONE, f"{LOAD}; {STORE}; std", DECLINED),
    ("80 bits", X86, SUM, "fldl (%rdi); fmull 8(%rdi); faddl 16(%rdi); fstpl (%rsi)", DECLINED),
    ("branch", X86, BRANCH, f"xor %eax,%eax; test %edi,%edi; {NUMBER}", EQUAL),
    ("branch of 64 bits", X86, BRANCH, f"xor %eax,%eax; test %rdi,%rdi; {NUMBER}", DIFFERENT),
    ("computed jump", X86, ONE, f"lea 1f(%rip),%rax; mov %rax,-8(%rsp); {LOAD}; {STORE}; jmp *-8(%rsp); 1:", DECLINED),
    ("rows", X86, ROWS, f"lea (%rsi,%rdx,8),%rsi; {LOOP}", EQUAL),
    ("stride of 32 bits", X86, ROWS, f"mov %edx,%edx; lea (%rsi,%rdx,8),%rsi; {LOOP}", DIFFERENT),
    ("stride of another array", X86, ROWS, f"lea -8(%rsi,%r8,8),%rsi; {LOOP}", DIFFERENT),
]  # fmt: skip


@pytest.mark.parametrize(
    ("compiler", "text", "code", "wanted"), [pytest.param(*row, id=name) for name, *row in BY_HAND]
)
def test_code_written_by_hand(compiler: str, text: str, code: str, wanted: str, tmp_path: Path) -> None:
    assert hand_written(compiler, f"void f{text}", code, tmp_path) == wanted


def test_returned_integer_is_compared(tmp_path: Path) -> None:
    code = "movabs $0x4008000000000000,%rax; mov %rax,(%rdi); mov $1,%eax"
    for value, wanted in ((1, EQUAL), (2, DIFFERENT)):
        assert hand_written(X86, f"int f(double b[1]) {{ b[0] = 3; return {value}; }}", code, tmp_path) == wanted


def hand_written(compiler: str, text: str, code: str, folder: Path) -> str:
    """Return the verdict on assembly text against the last function of a header."""
    if not shutil.which(compiler):
        pytest.skip(f"{compiler} is missing")
    (folder / "hand.h").write_text(f"#include <stddef.h>\n{text}\n", encoding="utf-8")
    name = "f_rows" if "f_rows" in text else "f"
    head, body = f".globl {name}\n.type {name}, %function\n{name}:\n", code.replace("; ", "\n")
    (folder / "hand.s").write_text(f"{head}{body}\nret\n.size {name}, .-{name}\n", encoding="utf-8")
    subprocess.run([compiler, "-c", "-o", folder / "hand.o", folder / "hand.s"], check=True)
    return verdict(Source(folder, "hand", Trees("double")), folder / "hand.o", name).verdict


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("compiler", "level", "real"),
    [
        ("gcc", "-O0", "double"), ("gcc", "-O1", "float"), ("gcc", "-O2", "float"), ("gcc", "-O3", "double"),
        ("clang", "-O0", "float"), ("clang", "-O2", "double"), ("clang", "-O3", "float"),
        (ARM, "-O1", "float"), (ARM, "-O3", "double"),
    ],
)  # fmt: skip
def test_levels_of_optimisation(headers: Path, compiler: str, level: str, real: str, tmp_path: Path) -> None:
    if not shutil.which(compiler):
        pytest.skip(f"{compiler} is missing")
    source = Source(headers, "cayley2", Trees(real))
    proof = Proof(source, Program(made(headers, source, f"{compiler} -std=c99 {level} -ffp-contract=off", tmp_path)))
    found = [each for name in ("rate", "pose", "shadow") for each in proof.verdicts(f"{CHART}{name}")]
    unused = "never executed" if level == "-O0" else "none"  # lines of helpers, for arguments that no chart passes
    assert not [each for each in found if each.verdict != EQUAL and unused not in each.reason]


def test_missing_header_is_refused(tmp_path: Path) -> None:
    with pytest.raises(MachineError, match="lambert"):
        Source(tmp_path, "lambert", Trees("double"))
