"""Headers without math.h: what is left of them calls nothing that has been left out."""

from __future__ import annotations

import re
from pathlib import Path

from derive.codegen.build import print_package
from derive.codegen.targets import TARGETS
from derive.codegen.validation.c_interpreter.source import parse
from derive.maps import Cayley
from derive.output import files


def test_what_needs_a_turn_is_left_out_with_it(tmp_path: Path) -> None:
    """Of n = 1 the way back from rotations needs no root, and the turn to another branch does."""
    files.write(tmp_path, print_package([Cayley(1)], TARGETS["c"]).texts)
    for header in ("cayley1.h", "rotation/cayley1.h"):
        text = parse(f'#include "{header}"\n', tmp_path, {"DUALCAY_FREESTANDING": ""}).text
        defined = set(re.findall(r"static inline \w+ (\w+)\(", text))
        called = set(re.findall(r"\b(dualcay_\w+)\(", text))
        kernels = {name.partition("cayley1_")[2] for name in defined}
        assert ("tensor" in kernels, "from_tensor" in kernels) == (True, False)
        assert called <= defined
