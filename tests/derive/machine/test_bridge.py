"""Emitted programs proved by Coq, and altered texts refused."""

import shutil
from pathlib import Path

import pytest

from derive.machine.bridge import main, prove, table
from derive.machine.checker import compiled, find
from derive.machine.emitted import printed
from derive.machine.goals import goals
from derive.machine.statements import MachineError

NUMPY = Path(__file__).parents[3] / "generated" / "dualcay"


@pytest.mark.coq
def test_text_is_proved_and_a_flipped_sign_is_refused(tmp_path: Path) -> None:
    printed(tmp_path / "c", [1])
    kernels = shutil.copytree(NUMPY, tmp_path / "numpy")
    coq = find(tmp_path / "proofs")
    list(compiled(coq))

    def pose(target: str, function: str = "pose") -> str:
        goal = next(g for g in goals(kernels, tmp_path / "c", [1]) if (g.target, g.function) == (target, function))
        return table([prove(goal, coq)])

    assert "numpy" in pose("numpy")
    for path, old in ((kernels / "_geometry.py", "gvv1 - fv3"), (tmp_path / "c" / "geometry.h", "gvv1 - fv3")):
        path.write_text(path.read_text().replace(old, old.replace("-", "+")))
    for target, name in (("numpy", "_geometry.py"), ("c", "geometry.h")):
        with pytest.raises(MachineError, match=rf"{name}:\d+: pose \({target}\) differs .*: pose\[1\]"):
            pose(target)


def test_missing_coq_and_headers_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COQBIN", str(tmp_path))
    assert main(["--c", str(tmp_path)]) == 3
    with pytest.raises(MachineError, match=r"cayley1.h"):
        list(goals(NUMPY, tmp_path, [1]))
