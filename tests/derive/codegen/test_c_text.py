"""Validation of C headers by the interpreter: wrong signs, coefficients, indices, conditions, names are refused."""

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
from derive.codegen.validation.batches import batches, composed
from derive.codegen.validation.c_interpreter import CError, load
from derive.maps import Cayley
from derive.output import files
from tests.support.c_mutants import Excerpts, sample

pytestmark = pytest.mark.thorough

C, CHART = TARGETS["c"], Cayley(3)

EQUIVALENT = {
    r"\(z32 < 0\) & \(z33 < 0\)": "where e0 = e1 = e2 = 0 the last row has been taken, and its e3 is positive",
    r"still \? \d+ \* (cos|e0)": "it is multiplied by a vector that is 0 there",
    r"/ sign;": "sign is 1 or -1",
    r"still[1t] = ss[1t] <": "the root of 0 is 0: another number stands in its place for gradients alone",
    r"pose_at\[1[23] \* pose_by\] = \(\w+\)0;": "the same number is stored in both places",
    r"(turn|shadow|shadow_jacobian)_core: .* extent < 0 \?": "at the identity the axis is NaN, and so every entry",
    r"rotation_\w+_shadow_jacobian_core: const int still = total <": "the same",
    r"rotation_\w+retract_core: .*(factor|z0s) = still \?": "it is multiplied by a vector that is 0 there",
    r"rotation_\w+_exponential_scalars_core: made_at\[[567] \* \w+\] = [fgh]y;": "rotations read no slope of f, g, h",
    r"\((ss\w*|square) - \1\)|const dualcay_real (none|one) =": "0 is added or subtracted, which only infinity changes",
    r"const dualcay_real z\w = \(near\w \? (x\w) : \1 \+ \1\) / 4;": "what is far goes into no series",
    r"const int near\w = x\w < [57];": "next to the limit both sides are right",
    r"\* \(50[57] - z\w\)": "the last terms of the series: less than a condition makes of what is cut off",
    r"versine(\w) = tthalf\1 [<>]=? 1[567] \? 2 \* tthalf\1 / belowhalf\1 : 2 - 2 / belowhalf\1;": "both are 1 - cos",
    r"lost(\w) = (\(alpha\1 [<>]=? [789] \? -?left\1 : \(\w+\)0\)|-?left\1) / \(": "rounding takes nothing here",
    r"_in\b|lost": "nor here",
    r"identity_jacobian_core: \w+_quaternion_scalars\(": "s − s and w − w are 0 alike",
    r"returned_core: if \(3 <=? 1\)": "the chart has three branches: both comparisons are false",
    r"interpolate_core: const dualcay_real z0s = still": "it is multiplied by a vector that is 0 there, and by fe",
    r"const dualcay_real fe =": "Cayley maps compute T⁻¹ from x, not from fe",
    r"_interpolate_core: .*( / 6[35]\)|2[46] \* end < 157)": "next to the limit both sides are right",
    r"axis\d = along\d \* unit|const dualcay_real unit = \(resting": "the norm of a unit vector is 1 but for rounding",
    r"retract_jacobians_core: by_\w+_at\[.*= by_\w+\[": "entries of the upper right block, which is 0",
    r"rotation_\w+_exponential_scalars_core: .* (c4|\w+y) =": "slopes act on dual parts, which rotations lack",
    r"&\w+_(3, &\w+_2|5, &\w+_4)\b": "results that nothing reads change places",
}
"""Changes that leave all results unchanged: pattern of function and line, with the reason."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("c")
    files.write(found, print_package([CHART], C, tested=False).texts)
    return found


def survives(text: str, kernels: list[str], table=POSES) -> bool:
    """Tell whether a text passes validation on the cases of some functions."""
    every = (*batches(CHART, table), *composed(CHART, table))
    chosen = [batch for batch in every if batch.function in kernels]
    try:
        return c_text.check(load(text), CHART, chosen, table) > 0
    except (CError, ValidationFailed):
        return False


def test_printed_headers_pass_and_every_function_is_called(folder: Path) -> None:
    whole, own = (c_text.validate(folder, CHART, geometry, C.tables) for geometry in (True, False))
    assert whole > 1500 > 2 * own > 500


# --- wrong text ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("table", "each", "least"), [(POSES, 2, 40), (ROTATIONS, 1, 15)], ids=["poses", "rotations"])
def test_changed_text_fails(folder, table, each, least):
    """Check that validation catches at least ``least`` changes of signs, coefficients, indices, strides and orders.

    Rotations share the scalars of poses, so only their own geometry is changed.
    """
    excerpts = Excerpts(load(f'#include "{inside(table, "cayley3.h")}"\n', folder).source.text)
    prefix = c_text.prefix(Cayley(3), table)
    names = (*table.public, *table.composed)
    roots = {name: (f"{prefix}_{name}", f"{prefix}_{name}_rows") for name in names}
    needed = {name: set().union(*map(excerpts.needed, found)) for name, found in roots.items()}
    own = [f for f in excerpts.functions if f.startswith(prefix) or table is POSES]
    kernels = {f: [name for name in names if f in needed[name]][:3] for f in own}
    every = [
        mutant
        for function, called in kernels.items()
        for mutant in excerpts.mutants(function, [root for name in called for root in roots[name]])
        if called
    ]
    chosen = sample(every, each, seed=43)
    left = [m for m in chosen if survives(m.text, kernels[m.function], table=table)]
    lines = [f"{m.function}: {m.line}" for m in left]
    found = "\n".join(line for line in lines if not any(re.search(same, line) for same in EQUIVALENT))
    assert not found
    assert len(chosen) - len(left) >= least
    assert len({m.kind for m in chosen}) > 15


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
