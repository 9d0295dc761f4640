"""C headers executed as text: what validation by interpretation catches, and why each of its cases is there."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache

import mpmath
import pytest
from derive.codegen.cases.decimals import DIGITS

from derive.codegen import ValidationFailed, cases
from derive.codegen.build import build
from derive.codegen.rows import inside
from derive.codegen.signatures import POSES, PUBLIC, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.codegen.validation import c_text
from derive.codegen.validation.c_interpreter import CError, load
from derive.maps import Cayley
from derive.output import files
from tests.support.c_mutants import Excerpts, sample
from tests.support.packages import Otherwise, unvalidated

pytestmark = pytest.mark.thorough

C = TARGETS["c"]
ORDERS = (3, 4)
CHECKED = {3: [2396, 1240], 4: [2443, 1283]}
"""Results that are compared, of poses and of rotations."""

PREFIX = "dualcay_cayley3_"
ROOTS = {name: (PREFIX + name, f"{PREFIX}{name}_rows") for name in PUBLIC}

EQUIVALENT = {
    r"\(z32 < 0\) & \(z33 < 0\)": "where e0 = e1 = e2 = 0 the last row has been taken, and its e3 is positive",
    r"still \? \d+ \* (cos|e0)": "it is multiplied by a vector that is 0 there",
    r"/ sign;": "sign is 1 or -1",
    r"still[1t] = ss[1t] <": "the root of 0 is 0: another number stands in its place for gradients alone",
    r"pose_at\[1[23] \* pose_by\] = \(\w+\)0;": "the same number is stored in both places",
    r"(turn|shadow|shadow_jacobian)_core: .* extent < 0 \?": "at the identity the axis is NaN, and so every entry",
    r"rotation_\w+_shadow_jacobian_core: const int still = total <": "the same",
    r"rotation_\w+retract_core: .*(factor|z0s) = still \?": "it is multiplied by a vector that is 0 there",
    r"angle_core: const int resting = x <": "of v = 0 the angle that is computed is 0 too: it is chosen for gradients",
    r"const dualcay_real z\w = \(near\w \? (x\w) : \1 \+ \1\) / 4;": "what is far goes into no series",
    r"const int near\w = x\w < [57];": "next to the limit both sides are right",
    r"\* \(50[57] - z\w\)": "the last terms of the series: less than a condition makes of what is cut off",
    r"versine(\w) = tthalf\1 [<>]=? 1[567] \? 2 \* tthalf\1 / belowhalf\1 : 2 - 2 / belowhalf\1;": "both are 1 - cos",
    r"lost(\w) = (\(alpha\1 [<>]=? [789] \? -?left\1 : \(\w+\)0\)|-?left\1) / \(": "rounding takes nothing here",
    r"v\d\d\w_in\b": "nor here",
    r"_scalars\(.*&\w+_(3, &\w+_2|5, &\w+_4)\b": "results that nothing reads change places",
}
"""Changes that change no result, by their function and line, and why."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    found = tmp_path_factory.mktemp("c")
    headers = Otherwise(unvalidated(C), companions=C.further)  # their compiled tests are not run here
    files.write(found, build([Cayley(n) for n in ORDERS], headers).texts)
    return found


@pytest.fixture(scope="module")
def excerpts(folder):
    """The functions of order 3, preprocessed, to be changed one by one."""
    return Excerpts(load('#include "cayley3.h"\n', folder).source.text)


@cache
def batches(order, table=POSES):
    return cases.batches(Cayley(order), table)


def survives(text, kernels, keep=lambda function, arguments: True, table=POSES):
    """Whether a text passes the cases of some functions that are kept."""
    chosen = []
    for batch in batches(3, table):
        with mpmath.workdps(DIGITS):
            cases = tuple(case for case in batch.cases if batch.exact or keep(case.function, numbers(case)))
        if cases and batch.function in kernels:
            chosen.append(replace(batch, cases=cases))
    assert chosen
    try:
        return c_text.check(load(text), Cayley(3), chosen, table) > 0
    except (CError, ValidationFailed):
        return False


def numbers(case):
    return [[mpmath.mpf(str(component.value)) for component in argument] for argument in case.arguments]


# --- the text is right --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("order", ORDERS)
def test_every_condition_of_the_text_takes_both_values(folder, order):
    headers = [inside(table, f"cayley{order}.h") for table in C.tables]
    unit = load("".join(f'#include "{header}"\n' for header in headers), folder)
    checked = [c_text.check(unit, Cayley(order), batches(order, table), table) for table in C.tables]
    assert checked == CHECKED[order]
    # only a chart without end has no number of branches
    assert [str(c) for c in unit.one_sided if not str(c).endswith(": branches")] == []
    assert all(condition.taken for condition in unit.scope.conditions)
    assert unit.idle == [f"dualcay_cayley{order}_singular_angles"]


# --- the text is wrong --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("table", "each", "least"), [(POSES, 3, 60), (ROTATIONS, 1, 15)], ids=["poses", "rotations"])
def test_changed_text_fails(folder, table, each, least):
    """Signs, coefficients, components, indices, strides, orders of results: so many changes, all caught.

    Of rotations those of their own geometry: scalars are those of poses.
    """
    excerpts = Excerpts(load(f'#include "{inside(table, "cayley3.h")}"\n', folder).source.text)
    prefix = c_text.prefix(Cayley(3), table)
    roots = {name: (f"{prefix}_{name}", f"{prefix}_{name}_rows") for name in table.public}
    needed = {name: set().union(*map(excerpts.needed, found)) for name, found in roots.items()}
    own = [f for f in excerpts.functions if f.startswith(prefix) or table is POSES]
    kernels = {f: [name for name in table.public if f in needed[name]][:3] for f in own}
    every = [
        mutant
        for function, names in kernels.items()
        for mutant in excerpts.mutants(function, [root for name in names for root in roots[name]])
        if names
    ]
    chosen = sample(every, each, seed=43)
    left = [m for m in chosen if survives(m.text, kernels[m.function], table=table)]
    assert [m for m in left if not any(re.search(line, f"{m.function}: {m.line}") for line in EQUIVALENT)] == []
    assert len(chosen) - len(left) >= least
    assert len({m.kind for m in chosen}) > 15


@pytest.mark.parametrize(
    ("pattern", "replacement", "message"),
    [
        (r"#define DUALCAY_CAYLEY3_ORDER 3", "#define DUALCAY_CAYLEY3_ORDER 4", "ORDER is 4, not 3"),
        (r"(_dcay_inv dualcay_cayley3_tangent)_inv", r"\1", "dcay_inv is dualcay_cayley3_tangent, not"),
        (r"angles\[0\] = 2 \* pi", "angles[0] = 3 * pi", "singular_angles, component 0"),
        (r"return DUALCAY_CAYLEY3_SINGULAR_ANGLES", "return 3", "singular_angles does not return 2"),
        (r"3\.14159265358979323846", "3.14159265358979323847", "singular_angles, component 0"),
        (r"const dualcay_real h = 16 \* r;", "const dualcay_real h = 33 / 2 * s;", r"cayley3\.h:\d+: an integer div"),
        (r"const dualcay_real h = 16 \* r;", "const float h = 16 * r;", "the type float is not read here"),
        (r"(?=\n#endif\n*\Z)", "\nDUALCAY_CORE int dualcay_cayley3_new(void) { return 1; }\n", "nothing calls .*_new"),
        (r"void DUALCAY_NAME\(pose\)\(", "void DUALCAY_NAME(posed)(", "there is no function dualcay_cayley3_pose"),
        (r'#include "dualcay.h"', '#include "dualkay.h"', r"dualkay\.h is neither in the folder"),
    ],
)
def test_what_is_wrong_is_named(folder, tmp_path, pattern, replacement, message):
    texts = {name: (folder / name).read_text() for name in ("cayley3.h", "geometry.h", "dualcay.h")}
    changed = next(name for name, text in texts.items() if re.search(pattern, text))
    files.write(tmp_path, texts | {changed: re.sub(pattern, replacement, texts[changed], count=1)})
    with pytest.raises(ValidationFailed, match=f"cayley3.h: .*{message}"):
        c_text.validate(tmp_path, Cayley(3))


@pytest.mark.parametrize(
    ("pattern", "replacement", "message"),
    [
        (r"(_dcay_inv dualcay_rotation_cayley3_tangent)_inv", r"\1", r"dcay_inv is dualcay_rotation_\w+_tangent, not"),
        (r"void DUALCAY_NAME\(tensor\)\(", "void DUALCAY_NAME(matrix)(", "there is no function dualcay_rotation_"),
        (r'#include "../dualcay.h"', '#include "../../dualcay.h"', r"neither in the folder nor"),
    ],
)
def test_what_is_wrong_of_rotations_is_named(folder, tmp_path, pattern, replacement, message):
    texts = {str(path.relative_to(folder)): path.read_text() for path in folder.rglob("*.h")}
    changed = next(name for name, text in texts.items() if name.startswith("rotation/") and re.search(pattern, text))
    files.write(tmp_path, texts | {changed: re.sub(pattern, replacement, texts[changed], count=1)})
    with pytest.raises(ValidationFailed, match=f"^rotation/cayley3.h: .*{message}"):
        c_text.validate(tmp_path, Cayley(3), (ROTATIONS,))


# --- every case is needed -----------------------------------------------------------------------------------------


def row(function, arguments):
    """The row a rotation's quaternion is taken from; that row's product with the scalar part; four squares."""
    if not function.startswith("from_pose"):
        return None
    q11, q12, q13, _, q21, q22, q23, _, q31, q32, q33, *_ = arguments[0]
    squares = [1 + q11 + q22 + q33, 1 + q11 - q22 - q33, 1 - q11 + q22 - q33, 1 - q11 - q22 + q33]
    return squares.index(max(squares)), [0, q32 - q23, q13 - q31, q21 - q12], squares


def not_row(k):
    return lambda function, arguments: (found := row(function, arguments)) is None or found[0] != k


def not_backwards(function, arguments):
    found = row(function, arguments)
    return found is None or found[0] == 0 or found[1][found[0]] >= 0


def not_half_turn(function, arguments):
    found = row(function, arguments)
    return found is None or any(found[1])


def not_steep(growing):
    def keep(function, arguments):
        found = row(function, arguments)
        t0, _, t2, _ = found[2] if found else (0,) * 4
        return not (found and found[0] == 1 and t0 < 1e-30 and (t0 < t2) == growing)

    return keep


def not_negative(function, arguments):
    return not function.startswith("from_quaternion") or arguments[0][0] > 0


def not_at_half_turn(function, arguments):
    return not function.startswith("from_quaternion") or arguments[0][0] != 0


def not_on_branch(function, arguments):
    return function != "to_screw" or 3 * sum(c * c for c in arguments[0][:3]) < 1


def not_undecided(function, arguments):
    return sum(c * c for c in arguments[0][:3]) != 3


def not_near_a_tie(function, arguments):
    x = sum(c * c for c in arguments[0][:3])
    return function != "principal" or abs(3 * x - 1) > mpmath.mpf(10) ** -25


def not_two_translations(function, arguments):
    return function != "compose" or any(c for argument in arguments for c in argument[:3])


def not_a_translation(function, arguments):
    return any(arguments[0][:3])


def not_the_identity(function, arguments):
    return any(arguments[0])


@pytest.mark.parametrize(
    ("kernel", "function", "old", "new", "without"),
    [
        ("from_pose", "from_pose_core", "z11 = larger1 ? t1 : a1", "z11 = larger1 ? t1 : a2", not_row(0)),
        ("from_pose", "from_pose_core", "z12 = larger1 ? s12 : a2", "z12 = larger1 ? s13 : a2", not_row(1)),
        ("from_pose", "from_pose_core", "z23 = larger2 ? s23 : z13", "z23 = larger2 ? s13 : z13", not_row(2)),
        ("from_pose", "from_pose_core", "z31 = larger3 ? s13 : z21", "z31 = larger3 ? s23 : z21", not_row(3)),
        ("from_pose", "from_pose_core", "(z30 < 0) | ", "(z30 > 4) | ", not_backwards),
        ("from_pose", "from_pose_core", "(z31 < 0) | ((z31 == 0)", "(z31 > 0) | ((z31 == 0)", not_half_turn),
        ("from_pose", "from_pose_core", "best1 = larger1 ? t1 : t0", "best1 = t0", not_steep(growing=True)),
        ("from_pose", "from_pose_core", "larger1 = t0 < t1", "larger1 = t0 < t2", not_steep(growing=False)),
        (
            "from_quaternion", "gain_unit_scalars",
            "negative ? (dualcay_real)-1", "negative ? (dualcay_real)1", not_negative,
        ),
        ("from_quaternion", "gain_unit_scalars", "negative = e0 < 0", "negative = e0 <= 0", not_at_half_turn),
        ("to_screw", "natural_scalars", "(y < 0)) ? (dualcay_real)-1", "(y < 0)) ? (dualcay_real)1", not_on_branch),
        ("to_screw", "natural_scalars", "fabs(p)", "p", not_on_branch),
        ("to_screw", "natural_scalars", "(q == 0) & (y < 0)", "(q == 0) & (y > 0)", not_undecided),
        ("shadow", "direction_scalars", "(q == 0) & (y < 0)", "(q == 0) & (y > 0)", not_undecided),
        ("shadow", "shadow_core", "ro = still ? scale", "ro = still ? -scale", not_a_translation),
        ("to_screw", "to_screw_core", "extent == 0 ? (dualcay_real)1 : extent", "extent", not_the_identity),
        ("principal", "beyond_scalars", f"0.{28 * '3'}", f"0.{27 * '3'}4", not_near_a_tie),
        ("compose", "gain_product_scalars", "still = ss == 0", "still = ss < 0", not_two_translations),
    ],
)
def test_each_kind_of_case_is_needed(excerpts, kernel, function, old, new, without):
    """A change is caught, and no longer when the cases of one kind are left out: no other kind would see it."""
    text = excerpts.replaced(PREFIX + function, ROOTS[kernel], old, new)
    assert not survives(text, [kernel])
    assert survives(text, [kernel], keep=without)


def test_the_changes_of_those_cases_are_real(excerpts):
    """What is not changed passes with and without them."""
    assert survives(excerpts.text(ROOTS["from_pose"], {}), ["from_pose"])
    assert survives(excerpts.text(ROOTS["from_pose"], {}), ["from_pose"], keep=not_row(0))
