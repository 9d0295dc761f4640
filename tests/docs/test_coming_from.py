"""Pages for users of other libraries: both columns of their tables have one value, where the library is installed."""

from __future__ import annotations

import contextlib
import importlib
import re
from typing import Any

import numpy as np
import pytest

from dualcay import rotation
from tests.support import examples, pages
from tests.support.libraries import jax

FOLDER = pages.ROOT / "docs" / "coming_from"
LIBRARIES = {
    "scipy": "scipy.spatial.transform", "manif": "manifpy", "gtsam": "gtsam", "pinocchio": "pinocchio",
    "jaxlie": "jaxlie", "basilisk": "Basilisk.utilities.RigidBodyKinematics",
}  # fmt: skip
"""Module of the library by page; the others are of other languages."""
ROW = re.compile(r"^\| `(.+)` \| `(.+)` \|$", re.M)


def named() -> dict[str, Any]:
    """Return the names that the first page gives to arrays."""
    names: dict[str, Any] = {}
    [session] = pages.blocks((FOLDER / "index.md").read_text(encoding="utf-8"), "python")
    exec(re.sub(r"^>>> ", "", session, flags=re.M), names)
    return names | {"mrp": rotation.cayley2}


def of_library(page: str, names: dict[str, Any]) -> dict[str, Any]:
    """Return the names of a page that belong to its library; skip without the library."""
    module: Any = pytest.importorskip(LIBRARIES[page])
    M, M2, Q, Q2 = (names[name] for name in ("M", "M2", "Q", "Q2"))
    if page == "scipy":
        pose, turn = module.RigidTransform.from_matrix, module.Rotation.from_matrix
        classes = {name: getattr(module, name) for name in ("RigidTransform", "Rotation", "RotationSpline", "Slerp")}
        return {**classes, "T": pose(M), "T2": pose(M2), "R": turn(Q), "R2": turn(Q2)}
    if page == "basilisk":
        return {"bsk": module}
    if page == "manif":
        turns = (names["interop"].to_ros(names["exponential"], v) for v in (names["v"], names["v2"]))
        X, Y = (module.SE3(np.concatenate(parts)) for parts in turns)
        return {"manifpy": module, "X": X, "Y": Y, "t": module.SE3Tangent(names["xi"])}
    make = {"gtsam": "Pose3", "pinocchio": "SE3", "jaxlie": "SE3"}[page]
    made = getattr(module, make)
    made = made.from_matrix if page == "jaxlie" else made
    if page == "jaxlie":
        importlib.import_module("jaxlie.manifold")
    return {page: module, "X": made(M), "Y": made(M2)}


def rows(page: str) -> list[tuple[str, str]]:
    """Return the rows of a page's tables."""
    return ROW.findall((FOLDER / f"{page}.md").read_text(encoding="utf-8"))


PAGES = sorted(path.stem for path in FOLDER.glob("*.md") if path.stem != "index")


@pytest.mark.parametrize("page", PAGES)
def test_names_of_dualcay_have_values(page: str) -> None:
    names = named()
    assert len(rows(page)) > 10
    for _, ours in rows(page):
        assert np.isfinite(eval(ours, dict(names))).all(), ours


@pytest.mark.parametrize(
    "page", [pytest.param(name, marks=pytest.mark.thorough if name == "jaxlie" else ()) for name in LIBRARIES]
)
def test_both_columns_agree(page: str) -> None:
    names = named()
    with jax.enable_x64(True) if page == "jaxlie" else contextlib.nullcontext():
        names |= of_library(page, names)
        text = (FOLDER / f"{page}.md").read_text(encoding="utf-8").partition(", in C++ |")[0]
        assert [row for row in ROW.findall(text) if not agree(*row, names)] == []


def test_custom_factor_of_gtsam_is_its_own_one() -> None:
    """Residual and Jacobians of the factor on the page are those of ``BetweenFactorPose3``, within roundings."""
    gtsam = pytest.importorskip("gtsam")
    text, names = (FOLDER.parent / "howto" / "pose_graph.md").read_text(encoding="utf-8"), dict[str, Any]()
    sessions = [block for block in pages.blocks(text, "python") if ">>>" in block]
    assert [examples.failures(block, "pose_graph.md", names) for block in sessions] == [""] * len(sessions)
    exec(next(block for block in pages.blocks(text, "python") if "import gtsam" in block), names)
    z, *x = (names["cayley2"].random(max_angle=1.0, rng=seed) for seed in range(3))
    values, noise = gtsam.Values(), gtsam.noiseModel.Unit.Create(6)
    for key, v in enumerate(x):
        values.insert(key, gtsam.Pose3(names["cayley2"].pose(v)))
    theirs = gtsam.BetweenFactorPose3(0, 1, gtsam.Pose3(names["cayley2"].pose(z)), noise)
    found, expected = (one.linearize(values).jacobian() for one in (names["between"](0, 1, z, noise), theirs))
    for one, other in zip(found, expected, strict=True):
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-12)


def agree(theirs: str, ours: str, names: dict[str, Any]) -> bool:
    """Return whether two expressions have one value; a quaternion may have the other sign. Errors are some 1e-15."""
    left, right = (np.asarray(eval(text, dict(names)), float) for text in (theirs, ours))
    signs = (1, -1) if "quat" in ours or "quat" in theirs else (1,)
    return left.shape == right.shape and any(np.allclose(sign * left, right, rtol=0, atol=1e-12) for sign in signs)


def test_another_value_is_seen() -> None:
    names = named()
    assert agree("v + 0", "v", names)
    assert not agree("exponential.compose(v2, v)", "exponential.compose(v, v2)", names)
    assert not agree("exponential.tangent(v)", "exponential.body_tangent(v)", names)
