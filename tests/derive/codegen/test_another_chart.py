"""Proof, printing and validation of a chart unknown to the toolkit, v = sin(α/6) u."""

from __future__ import annotations

import importlib
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy

from derive.algebra import Vector
from derive.codegen import ValidationFailed
from derive.codegen.build import build
from derive.codegen.lowering import calculus
from derive.codegen.signatures import FUNCTIONS, KERNELS, POSES, PUBLIC
from derive.codegen.targets import TARGETS
from derive.codegen.validation.run import chosen
from derive.codegen.validation.vectors import Vectors, flat, vectors_of
from derive.maps import Cayley, x
from derive.maps.families import alpha
from derive.output import files
from derive.proof import ProofFailed, prove
from derive.proof.controls import controls_of
from tests.support import errors, sampling
from tests.support.oracle import SineOracle
from tests.support.packages import unvalidated
from tests.support.sine import Sine

pytestmark = pytest.mark.thorough

# --- proof ----------------------------------------------------------------------------------------------------------


def test_scalars_of_an_unknown_chart_are_proved():
    proved = prove(Sine())
    assert {proof.scope for proof in proved.proofs} == {"sine6"}
    assert sum(len(proof.residues) for proof in proved.proofs) > 20


def test_each_wrong_scalar_is_refused():
    found = list(controls_of(Sine()))
    assert len(found) == 27
    assert [str(control) for control in found if not control.noticed] == []


@pytest.mark.parametrize("name", ["quaternion", "tensor", "tangent", "tangent_inv"])
def test_a_wrong_formula_is_not_proved(name: str):
    right = getattr(Sine(), name)
    for i, coefficient in enumerate(right.coefficients):
        changed = (*right.coefficients[:i], coefficient + x, *right.coefficients[i + 1 :])
        chart = Sine()
        chart.__dict__[name] = replace(right, coefficients=changed)
        with pytest.raises(ProofFailed, match=rf"{name}\[{i}\]"):
            prove(chart)


@pytest.mark.parametrize("phi", [sympy.tan(alpha / 6), sympy.sin(alpha / 4), 2 * sympy.sin(alpha / 6)])
def test_scalars_of_another_phi_are_not_proved(phi: sympy.Expr):
    class Mistaken(Sine):
        pass

    Mistaken.phi = phi
    with pytest.raises(ProofFailed, match="phi'"):
        prove(Mistaken())


DERIVATIVES = (calculus.rate_dot, calculus.rate_jacobian)

BY_STEPS = ("retract_jacobians", "body_retract_jacobians")
"""Functions with errors tested in tests/generated/test_kernel_motions.py, not here."""


# --- kernels --------------------------------------------------------------------------------------------------------


# the native target uses the C headers; tests/targets builds its package
@pytest.mark.parametrize("target", [t for t in TARGETS.values() if t.name != "native"], ids=lambda target: target.name)
def test_unknown_chart_generates_in_every_target(target):
    (module,) = build([Sine()], target).modules
    assert module.name == f"sine6.{target.extension}"
    assert module.counts.validated >= sum(len(batch.cases) for batch in chosen(Sine(), POSES, whole=False))


@pytest.fixture(scope="module")
def texts() -> dict[str, str]:
    return build([Sine()], unvalidated(TARGETS["numpy"])).texts


@pytest.mark.parametrize(
    ("function", "right", "wrong"),
    [
        ("_quaternion_scalars", "-3 * (w / c)", "-2 * (w / c)"),
        ("_tangent_scalars", "128 * c", "64 * c"),
        ("_gain_unit", "/ 6", "/ 4"),
        ("_gain_positive", "1 + tt", "1 - tt"),
        ("_direction", "y < 0", "0 < y"),
        ("_natural", "6 / c", "3 / c"),
        ("_turned", "further < 0", "1 < 0"),
        ("_beyond", "limit1 < limit1 +", "limit1 < limit1 -"),
        ("_coefficient", "1 - tt", "1 + tt"),
    ],
)
def test_a_wrong_kernel_fails_validation(texts: dict[str, str], tmp_path: Path, function: str, right: str, wrong: str):
    head, rest = texts["sine6.py"].split(f"def {function}(", 1)
    assert right in rest
    files.write(tmp_path, {**texts, "sine6.py": f"{head}def {function}({rest.replace(right, wrong, 1)}"})
    with pytest.raises(ValidationFailed, match=r"sine6\.\w+.*component"):
        TARGETS["numpy"].validate(tmp_path, Sine(), geometry=True)


@pytest.fixture(scope="module")
def kernels(texts: dict[str, str], tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    folder = tmp_path_factory.mktemp("another")
    files.write(folder / "another_chart", texts)
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(folder)
        return importlib.import_module("another_chart.sine6")


def vectors(low: float, high: float, count: int = 4) -> np.ndarray:
    """Return dual vectors with angles between ``low`` and ``high``."""
    rng = sampling.generator("another chart", low, high)
    theta = rng.uniform(low, high, (count, 1)) / 6
    axis = sampling.unit_vectors(rng, (count,))
    return np.concatenate([np.sin(theta) * axis, rng.normal(size=(count, 3))], axis=-1)


def arguments(kernels: ModuleType, name: str, v: np.ndarray) -> list[np.ndarray]:
    """Return the arguments of a function: first v or a representation of its pose, then the others."""
    first = FUNCTIONS[name].arguments[0].name
    given = {"q": kernels.quaternion, "R": kernels.tensor, "T": kernels.pose}
    if first == "angle":
        return [np.array(part) for part in kernels.to_screw(v)]
    others = [
        v[::-1]
        if a.name in ("v0", "v1", "v2")
        else np.roll(sampling.dual_vectors(name, count=len(v))[:, : a.size], 1).reshape(-1, *a.shape)
        for a in FUNCTIONS[name].arguments[1:]
    ]
    if name == "interpolate":
        others[-1] %= 1  # times above 1 may cross the edge, where the sign of v is ambiguous
    return [given.get(first, np.array)(v), *others]


def scale(function: Any, given: list[np.ndarray], exact: list[Any]) -> list[float]:
    """Return the norm of each part of a result plus its change per relative change of every argument component."""
    step = mpmath.mpf(2) ** -60
    sizes = [errors.norm(part) for part in exact]
    for i, argument in enumerate(given):
        for index, component in np.ndenumerate(argument):
            moved = argument.astype(object)
            moved[index] = mpmath.mpf(component) * (1 + step)
            other = parts(function(*given[:i], moved, *given[i + 1 :]))
            sizes = [size + errors.norm((b - a) / step) for size, a, b in zip(sizes, exact, other, strict=True)]
    return sizes


def scale_of_poses(oracle: SineOracle, one: list[np.ndarray], exact: list[Any]) -> list[float]:
    """Return the condition of an interpolation: its change per relative change of the quaternions of both end poses.

    Every interpolation rounds poses. Near the edge T is large and T⁻¹ small along the axis, but not across it. There
    the rounding of poses has a larger effect than the rounding of components of v.
    """
    step, sizes = mpmath.mpf(2) ** -60, [0.0] * len(exact)
    for i, v in enumerate(one[:2]):
        q = oracle.quaternion(v)
        for place, unit in enumerate([errors.norm(q[1:4])] * 3 + [errors.norm(q[5:])] * 3):
            ends = one[:2]
            ends[i] = oracle.retract(v, [unit * step * (place == k) for k in range(6)])
            other = parts(oracle.interpolate(*ends, one[2]))
            sizes = [size + errors.norm((b - a) / step) for size, a, b in zip(sizes, exact, other, strict=True)]
    return sizes


def parts(result: Any) -> list[Any]:
    """Return the real and dual part of each result; a point or a rotation matrix counts as one part."""
    if isinstance(result, tuple):
        return [part for array in result for part in errors.parts(array)]
    if np.shape(result) == (3, 6):
        return [result[:, :3], result[:, 3:]]
    return [result] if np.shape(result) in ((3,), (3, 3)) else list(errors.parts(result))


@pytest.mark.parametrize("angles", [(1e-7, 1e-6), (0.05, 3.0), (3.4, 6.0), (6.5, 9.0)], ids=str)
@pytest.mark.parametrize("name", [name for name in PUBLIC if name not in BY_STEPS])
def test_floats_agree_with_first_principles(kernels: ModuleType, name: str, angles: tuple[float, float]):
    """Allow 20 eps (two maps in a chain), or 30 eps for derivatives, times norm and condition of the result."""
    oracle = SineOracle(3)
    row = FUNCTIONS[name]
    derived = KERNELS[row.kernel].recipe in DERIVATIVES
    gate = errors.THREE if derived else errors.GENERAL
    low, high = angles
    # near the edge 3π φ′ is small, and the terms f_i and h_i of T⁻¹ cancel along the axis
    count = 2 if name == "interpolate" else 4  # its oracle takes many steps
    given = arguments(kernels, name, vectors(low, min(high, 8.0) if derived else high, count))
    for branch in range(3) if row.branch else (None,):
        chosen = () if branch is None else (branch,)

        def function(*values: Any, chosen: Any = chosen) -> Any:
            return getattr(oracle, name)(*values, *chosen)

        found = getattr(kernels, name)(*given, *chosen)
        for i in range(len(given[0])):
            one = [np.asarray(argument[i]) for argument in given]
            got = parts(tuple(array[i] for array in found) if isinstance(found, tuple) else found[i])
            exact = parts(function(*one))
            sizes = scale(function, one, exact)
            if name == "interpolate":
                sizes = [a + b for a, b in zip(sizes, scale_of_poses(oracle, one, exact), strict=True)]
            for a, b, size in zip(got, exact, sizes, strict=True):
                error = errors.norm(b - a.astype(object)) / np.finfo(float).eps
                assert error <= gate * size, (name, branch, one, got, exact, error / size)


def test_maps_and_operators_are_inverse_to_each_other(kernels: ModuleType):
    """Allow 1e-12: 40 eps (errors.AGREE) times a condition number below 100 at these angles."""
    v, w = vectors(0.05, 3.0), sampling.dual_vectors("another chart", count=4)
    close = {"rtol": 0, "atol": 1e-12}
    np.testing.assert_allclose(kernels.from_quaternion(kernels.quaternion(v)), v, **close)
    np.testing.assert_allclose(kernels.from_pose(kernels.pose(v)), v, **close)
    np.testing.assert_allclose(kernels.from_tensor(kernels.tensor(v)), v, **close)
    np.testing.assert_allclose(kernels.from_screw(*kernels.to_screw(v)), v, **close)
    np.testing.assert_allclose(kernels.rate(v, kernels.twist(v, w)), w, **close)
    np.testing.assert_allclose(kernels.body_rate(v, kernels.body_twist(v, w)), w, **close)
    there = kernels.shadow(v, 1)
    assert (np.linalg.norm(there[:, :3], axis=-1) > 0.5).all()
    np.testing.assert_allclose(kernels.pose(there), kernels.pose(v), **close)
    np.testing.assert_allclose(kernels.principal(there), v, **close)
    np.testing.assert_allclose(kernels.shadow(there, -1), v, **close)


# --- angles of a vector ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("phi", "edge", "angles"),
    [
        (sympy.sin(alpha / 6), 3 * sympy.pi, ("1e-30", "0.1", "9.4247")),
        (sympy.tan(alpha / 2), sympy.pi, ("1e-30", "3.1", "3.14159265")),
        (alpha, sympy.oo, ("1e-30", "1", "100")),
    ],
)
def test_angles_of_vectors_are_found(phi: sympy.Expr, edge: sympy.Expr, angles: tuple[str, ...]):
    class Other(Sine):
        pass

    Other.phi, Other.edge = phi, edge
    with mpmath.workdps(50):
        chart = Vectors(Other())
        for text in angles:
            angle = mpmath.mpf(text)
            found = chart.angle(chart.size(angle))
            # a relative error eps of |v| changes α by φ/(α φ′) eps, which is 3e3 eps for the sine near its edge
            assert abs(found / angle - 1) < 10 ** mpmath.mpf(-44)


def test_length_without_angle_below_the_edge_is_an_error():
    with mpmath.workdps(50), pytest.raises(ArithmeticError, match=r"no angle below 3\*pi has \|v\| = 1.5 in sine6"):
        Vectors(Sine()).angle(mpmath.mpf("1.5"))


def test_edges_have_full_precision_at_any_working_precision():
    with mpmath.workdps(50):
        chart = vectors_of(Cayley(3))
    found = chart.edge, chart.first_pole
    with mpmath.workdps(50):
        assert chart is vectors_of(Cayley(3))
        assert all(abs(angle - k * mpmath.pi) < mpmath.mpf(10) ** -48 for angle, k in zip(found, (3, 2), strict=True))


def test_long_vector_below_half_a_turn_is_on_branch_0():
    """Check that α is not mistaken for π: 1 − α/π is about 1e-155, far from 0 at 670 digits."""
    with mpmath.workdps(670):
        v = Vector.dual((mpmath.mpf(10) ** 155, 0, 0), (1, 2, 3))
        chart = Vectors(Cayley(1))
        screw, branch = chart.screw(v)
        assert branch == 0
        assert screw.angle.re < mpmath.pi
        assert all(abs(a - b) < mpmath.mpf(10) ** -300 for a, b in zip(flat(chart.at(screw)), flat(v), strict=True))
