"""The road end to end: nothing false gets through, and the same text comes out every time."""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import derive
from derive.codegen import ValidationFailed, build, catalogue, check, compiler, files
from derive.codegen.targets import TARGETS
from derive.codegen.validation import validate
from derive.maps import Cayley
from derive.proof import ProofFailed

ROOT = Path(__file__).parents[3]
NUMPY = TARGETS["numpy"]


@pytest.fixture(scope="module")
def package():
    return build([3, 4], NUMPY)


def flipped(text: str, function: str, pattern: str, replacement: str) -> str:
    """The module with one place inside a core changed."""
    head, rest = text.split(f"def _{function}(", 1)
    changed, count = re.subn(pattern, replacement, rest, count=1)
    assert count == 1
    return f"{head}def _{function}({changed}"


@pytest.mark.parametrize(
    ("order", "function", "pattern", "replacement"),
    [
        (3, "quaternion", r"p = 1 - 3 \* x", "p = 1 + 3 * x"),
        (3, "tensor", r"gvv1 - fv3", "gvv1 + fv3"),
        (3, "pose", r"h = 16 \* s", "h = 8 * s"),
        (3, "transform_line", r"q = 3 - x", "q = 3 + x"),
        (3, "tangent", r"xo = 2 \* y", "xo = y"),
        (3, "tangent_inv", r"d = 11 - x", "d = 11 + x"),
        (3, "twist", r"w1o \* f", "w2o * f"),
        (3, "rate", r"v1 / -2", "v1 / 2"),
        (3, "body_twist", r"w2 \* gv3 - w3 \* gv2", "w3 * gv2 - w2 * gv3"),
        (3, "from_pose", r"Q32 - Q23", "Q23 - Q32"),
        (3, "from_tensor", r"/ 2\b", "/ 3"),
        (3, "from_quaternion", r"/ 3\b", "/ 4"),
        (3, "compose", r"z0 = pb \* pa - ", "z0 = pb * pa + "),
        (3, "shadow", r"r \* cos \+ sn", "r * cos - sn"),
        (3, "turn", r"iden \* iden", "iden"),
        (3, "to_screw", r"2 \* m\.atan2", "m.atan2"),
        (3, "from_screw", r"/ 6", "/ 3"),
        (4, "from_quaternion", r"\(1 \+ ", "(1 - "),
        (3, "pose_blocks", r"v22 = mul\(v2, v2, k\d+\)", "v22 = mul(v2, v2, k1)"),
        (3, "tangent_blocks", r"o13\)", "o14)"),
        (3, "rate_blocks", r"sub\(", "add("),
        (3, "from_pose_blocks", r"m\.where\(larger3, s23", "m.where(larger3, s13"),
        (3, "from_quaternion_blocks", r"still = m\.equal", "still = m.less"),
        (3, "principal_blocks", r"add\(mul\(r, cos1", "sub(mul(r, cos1"),
        (3, "principal_blocks", r"m\.less\(limit1, x", "m.less(x, limit1"),
        (3, "shadow_blocks", r"m\.both", "m.either"),
    ],
)
def test_a_wrong_sign_or_factor_in_a_printed_kernel_fails_validation(
    package, tmp_path: Path, order, function, pattern, replacement
):
    name = NUMPY.module_name(order)
    texts = dict(package.texts)
    texts[name] = flipped(texts[name], function, pattern, replacement)
    files.write(tmp_path, texts)
    with pytest.raises(ValidationFailed, match=rf"cayley{order}\.\w+.*component"):
        validate(tmp_path, Cayley(order))


def test_untouched_kernels_pass_and_every_call_is_compared_in_both_layouts(package, tmp_path: Path):
    files.write(tmp_path, package.texts)
    # 11 exact expectations (12 with the round trip of n = 4); on a batch of 5 screws 4, and 5 per branch; each in both
    # layouts, and each pose alone
    assert validate(tmp_path, Cayley(3)) == (2 + 1) * 11 + (2 + 5) * (4 + 5 * 3)
    # but a translation is infinite on branch 2 of 4
    assert validate(tmp_path, Cayley(4)) == (2 + 1) * 12 + (2 + 5) * (4 + 5 * 4) - 5


def test_a_failed_proof_writes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    wrong = Cayley(2).tensor
    monkeypatch.setattr(Cayley, "tangent", wrong)
    with pytest.raises(ProofFailed, match="tangent"):
        derive.generate([2], output=tmp_path / "kernels")
    assert not (tmp_path / "kernels").exists()


def test_a_failed_validation_writes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    original = compiler.module_text

    def wrong(*arguments):
        return flipped(original(*arguments), "pose", r"N / N / N", "1 / N / N")

    monkeypatch.setattr(compiler, "module_text", wrong)
    with pytest.raises(ValidationFailed, match="pose"):
        derive.generate([2], output=tmp_path / "kernels")
    assert not (tmp_path / "kernels").exists()


def test_any_order_and_a_bare_folder_work_without_the_toolkit(tmp_path: Path):
    derive.generate([7], output=tmp_path / "kernels")
    code = (
        "import sys; sys.modules['sympy'] = sys.modules['jinja2'] = sys.modules['derive'] = None\n"
        "from kernels import cayley7\n"
        "import numpy as np\n"
        "print(np.allclose(cayley7.from_pose(cayley7.pose([.1, 0, 0, 1, 2, 3])), [.1, 0, 0, 1, 2, 3]))"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "True"


@pytest.mark.parametrize("seed", ["0", "1", "31337"])
def test_the_same_bytes_under_every_hash_seed(package, seed):
    code = (
        "import hashlib\n"
        "from derive.codegen import build\n"
        "from derive.codegen.targets import TARGETS\n"
        "texts = build([3, 4], TARGETS['numpy']).texts\n"
        "print(hashlib.sha256(repr(sorted(texts.items())).encode()).hexdigest())"
    )
    here = hashlib.sha256(repr(sorted(package.texts.items())).encode()).hexdigest()
    env = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == here


@pytest.mark.smoke
def test_the_committed_kernels_are_current():
    assert check(catalogue.COMMITTED) == []


def test_check_regenerates_a_module_outside_the_catalogue_by_its_header(package, tmp_path: Path):
    files.write(tmp_path, package.texts)
    path = tmp_path / "cayley4.py"
    path.write_text(path.read_text() + "# touched\n")
    (tmp_path / "cayley3.py").unlink()
    found = check(tmp_path, orders=[3])
    assert [(d.path.name, d.kind) for d in found] == [("cayley3.py", "missing"), ("cayley4.py", "stale")]


def test_bad_orders_and_targets_are_refused(tmp_path: Path):
    with pytest.raises(ValueError, match="order n must be an integer >= 1, got 0"):
        derive.generate([0], output=tmp_path / "k")
    with pytest.raises(TypeError, match=r"order n must be an integer >= 1, got 2\.5"):
        derive.generate([2.5], output=tmp_path / "k")  # type: ignore[list-item]
    with pytest.raises(ValueError, match=r"target must be one of numpy.*got 'fortran'"):
        derive.generate([2], target="fortran", output=tmp_path / "k")
    assert not (tmp_path / "k").exists()
