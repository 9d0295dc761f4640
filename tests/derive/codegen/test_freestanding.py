"""Headers compiled without math.h call only their own functions."""

from __future__ import annotations

import re
from pathlib import Path

from derive.codegen.build import print_package
from derive.codegen.targets import TARGETS
from derive.codegen.validation.c_interpreter.source import parse
from derive.maps import Cayley
from derive.output import files


def test_freestanding_header_calls_only_what_it_defines(tmp_path: Path) -> None:
    """Check n = 1: `tensor` needs no function of math.h, but `from_tensor` does."""
    files.write(tmp_path, print_package([Cayley(1)], TARGETS["c"]).texts)
    for header in ("cayley1.h", "rotation/cayley1.h"):
        text = parse(f'#include "{header}"\n', tmp_path, {"DUALCAY_FREESTANDING": ""}).text
        defined = set(re.findall(r"static inline \w+ (\w+)\(", text))
        called = set(re.findall(r"\b(dualcay_\w+)\(", text))
        kernels = {name.partition("cayley1_")[2] for name in defined}
        assert ("tensor" in kernels, "from_tensor" in kernels) == (True, False)
        assert called <= defined
