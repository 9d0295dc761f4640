"""Validation of C headers by the interpreter: wrong signs, indices, strides, conditions and names are refused."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from derive.codegen import ValidationFailed
from derive.codegen.build import print_package
from derive.codegen.rows import inside
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.codegen.validation import c_text
from derive.maps import Cayley
from derive.output import files

pytestmark = pytest.mark.thorough

C, CHART = TARGETS["c"], Cayley(3)

@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("c")
    files.write(found, print_package([CHART], C, tested=False).texts)
    return found


def test_printed_headers_pass_and_every_function_is_called(folder: Path) -> None:
    whole, own = (c_text.validate(folder, CHART, geometry, C.tables) for geometry in (True, False))
    assert whole > 1500 > 2 * own > 500


# --- wrong text ---------------------------------------------------------------------------------------------------


EARLY = [
    (POSES, r"#define DUALCAY_CAYLEY3_ORDER 3", "#define DUALCAY_CAYLEY3_ORDER 4", "ORDER is 4, not 3"),
    (POSES, r"(_dcay_inv dualcay_cayley3_tangent)_inv", r"\1", "dcay_inv is dualcay_cayley3_tangent, not"),
    (POSES, r"(angles_at\[0 \* angles_by\] =) 2 \* pi", r"\1 3 * pi", "singular_angles, component 0"),
    (POSES, r"return DUALCAY_CAYLEY3_SINGULAR_ANGLES", "return 3", "singular_angles does not return 2"),
    (POSES, r"3\.14159265358979323846", "3.14159265358979323847", "singular_angles, component 0"),
    (POSES, r"const dualcay_real h = 16 \* r;", "const float h = 16 * r;", "the interpreter of C reads no type float"),
    (POSES, r'#include "dualcay.h"', '#include "dualkay.h"', r"dualkay\.h is neither in the folder"),
    (ROTATIONS, r"(_dcay_inv \w+_tangent)_inv", r"\1", r"dcay_inv is dualcay_rotation_\w+_tangent, not"),
    (ROTATIONS, r'#include "../cayley3.h"', '#include "../../cayley3.h"', r"neither in the folder nor"),
]
"""Errors seen before a function of the geometry is called: table, pattern, replacement, and message."""
LATE = [
    (POSES, r"const dualcay_real h = 16 \* r;", "const dualcay_real h = 33 / 2 * s;", r"3\.h:\d+: an integer div"),
    (POSES, r"(v_dot_at\[v_dot_by\] = \()w2", r"\1omega_at[omega_by]", "an argument is read after a result is written"),
    (POSES, r"(v_stride\), DUALCAY_MADE\(8, q )\+ j", r"\1", "cell 1 of 40 is read"),
    (POSES, r"v \+ j, v_stride", "v + j, v_stride + 1", "quaternion"),
    (POSES, r"gvv1 - fv3", "gvv1 + fv3", "tensor, component 1"),
    (POSES, r"2 \* v_by\], v1o", "1 * v_by], v1o", "not a perfect square"),
    (POSES, r"&f, &g", "&g, &f", "component"),
    (POSES, r"larger3 = best2 < t3", "larger3 = t3 < best2", "component"),
    (POSES, r"still \? (\w+) : (\w+)", r"still ? \2 : \1", "component"),
    (ROTATIONS, r"gvv1 - fv3", "gvv1 + fv3", "component"),
    (POSES, r"(?=\n#endif\n*\Z)", "\nDUALCAY_CORE int dualcay_new(void) { return 1; }\n", "nothing calls .*_new"),
]


@pytest.mark.parametrize(
    ("called", "table", "pattern", "replacement", "message"),
    [*((False, *error) for error in EARLY), *((True, *error) for error in LATE)],
)
def test_errors_in_headers_are_named(folder, tmp_path, called, table, pattern, replacement, message):
    texts = {str(path.relative_to(folder)): path.read_text() for path in sorted(folder.rglob("*.h"))}
    texts |= {} if called else dict.fromkeys((inside(each, "geometry.h") for each in C.tables), "")  # slow to read
    own = [name for name in texts if inside(table, Path(name).name) == name]
    changed = next(name for name in own if re.search(pattern, texts[name]))
    files.write(tmp_path, texts | {changed: re.sub(pattern, replacement, texts[changed], count=1)})
    with pytest.raises(ValidationFailed, match=f"^{inside(table, 'cayley3.h')}: .*{message}"):
        c_text.validate(tmp_path, CHART, True, (table,))
