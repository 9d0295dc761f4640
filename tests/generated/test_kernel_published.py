"""Comparison of rotations alone with published numbers, from the tests of Basilisk's library of attitude kinematics.

Source: AVSLab, Basilisk, `src/architecture/utilitiesSelfCheck/avsLibrarySelfCheck.c` (ISC License). Definitions
are from H. Schaub and J. L. Junkins, *Analytical Mechanics of Space Systems*: C = [BN] takes space to body
coordinates, ω is in the body frame, σ̇ = ¼ B(σ) ω and q̇ = ½ B(q) ω.
"""

from __future__ import annotations

import importlib

import numpy as np
import pytest

from dualcay.rotation import cayley2

PRINTED = 1e-12
"""Tolerance for published numbers, which have at least 13 digits after the point; Basilisk's tests allow 1e-10."""
ROUNDING = 1e-15  # tolerance for rounding errors of results up to 5

DEGREE = np.pi / 180
ANGLES, OMEGA = np.array([30, -40, 15]) * DEGREE, np.array([0.2, 0.1, -0.5])
SIGMA, LONG, SHORT = np.array([0.25, 0.5, -0.5]), np.array([1.5, 0.5, 0.5]), np.array([-0.5, 0.25, 0.15])
SIGMA_DOT = np.array([0.0124791041517595, 0.0042760566673861, -0.0043633231299858])
OMEGA_OF_DOT = np.array([0.0174532925199433, 0.0349065850398866, -0.0174532925199433])
OMEGA_DOT = np.array([0.0022991473184427, 0.0035194052312667, -0.0070466757773158])
SIGMA_DDOT = np.array([0.0015, 0.0010, -0.0020])
QUATERNION = np.array([0.2526773896521122, 0.4276078901804977, -0.4859180570232927, 0.7191587243944733])
SIGMA_OF_C = np.array([0.2, -0.25, 0.3])
C = np.array([
    [0.1420873822677549, 0.4001248192538094, 0.9053790945330048],
    [-0.9626904702257736, 0.2686646537364468, 0.03234752493088797],
    [-0.2303003133666478, -0.876196001388834, 0.4233702077537369],
])  # fmt: skip
QUATERNION_OF_C = np.array([0.6771488469601677, 0.3354297693920336, -0.419287211740042, 0.5031446540880503])
B_MRP = np.array([[0.5625, 1.25, 0.75], [-0.75, 0.9375, -1.0], [-1.25, 0, 0.9375]])
B_INV_MRP = np.array([[0.2304, -0.3072, -0.512], [0.512, 0.384, 0], [0.3072, -0.4096, 0.384]])
B_GIBBS = np.array([[1.0625, 0.625, 0.375], [-0.375, 1.25, -0.5], [-0.625, 0, 1.25]])
B_INV_GIBBS = np.array([[0.64, -0.32, -0.32], [0.32, 0.64, 0.16], [0.32, -0.16, 0.64]])

MRP, GIBBS, ROTATION_VECTOR = "cayley2", "cayley1", "exponential"
PUBLISHED = {
    "dMRP": (MRP, "body_rate", (ANGLES, OMEGA), [0.144807895231133, 0.1948354871330581, 0.062187948908334]),
    "dGibbs": (GIBBS, "body_rate", (ANGLES, OMEGA), [0.236312018677072, 0.2405875488560276, -0.1665723597065136]),
    "dMRP2Omega": (MRP, "body_twist", (OMEGA, SIGMA_DOT), OMEGA_OF_DOT),
    "ddMRP": (MRP, "body_rate_dot", (OMEGA, OMEGA_OF_DOT, OMEGA_DOT), SIGMA_DDOT),
    "ddMRP2dOmega": (MRP, "body_twist_dot", (OMEGA, SIGMA_DOT, SIGMA_DDOT), OMEGA_DOT),
    "BmatMRP": (MRP, "body_tangent_inv", (SIGMA,), B_MRP / 4),
    "BinvMRP": (MRP, "body_tangent", (SIGMA,), B_INV_MRP * 4),
    "BmatGibbs": (GIBBS, "body_tangent_inv", (SIGMA,), B_GIBBS / 2),
    "BinvGibbs": (GIBBS, "body_tangent", (SIGMA,), B_INV_GIBBS * 2),
    # C(q) = C(q2) C(q1); our tensors are transposes of C, so the order is reversed
    "addMRP": (MRP, "compose", (LONG, SHORT), [0.58667769962764, -0.34919321472900, 0.43690525444766]),
    "addGibbs": (GIBBS, "compose", (LONG, SHORT), [0.61290322580645, 0.17741935483871, 0.82258064516129]),
    "subMRP": (MRP, "between", (LONG, SHORT), [-0.005376344086021518, 0.04301075268817203, -0.4408602150537635]),
    "subGibbs": (GIBBS, "between", (LONG, SHORT), [4.333333333333333, -0.5, 2.166666666666667]),
    "EP2MRP": (MRP, "from_quaternion", (QUATERNION,), [0.3413551595269481, -0.3879035903715319, 0.5740973137498672]),
    "EP2Gibbs": (GIBBS, "from_quaternion", (QUATERNION,), [1.692307692307693, -1.923076923076923, 2.846153846153846]),
    "EP2PRV": (
        ROTATION_VECTOR, "from_quaternion", (QUATERNION,), [1.162634795241009, -1.321175903682965, 1.955340337450788],
    ),
    "MRP2C": (MRP, "tensor", (SIGMA_OF_C,), C.T),
    "MRP2EP": (MRP, "quaternion", (SIGMA_OF_C,), QUATERNION_OF_C),
}  # fmt: skip


@pytest.mark.parametrize("published", PUBLISHED)
def test_published_numbers(published: str) -> None:
    chart, name, arguments, printed = PUBLISHED[published]
    found = getattr(importlib.import_module(f"dualcay.rotation.{chart}"), name)(*arguments)
    np.testing.assert_allclose(found, printed, rtol=0, atol=PRINTED)


def test_published_rate_of_the_matrix_of_mrp_kinematics() -> None:
    """Compare the columns of Ḃ(σ, σ̇): ¼ Ḃ ω is ∂σ̇/∂σ applied to σ̇."""
    sigma_dot = np.array([0.015, 0.045, -0.005]) / DEGREE
    printed = [
        [-0.4583662361046585, 1.7761691649055522, 4.1825919044550091],
        [0.6302535746439056, -0.1145915590261646, -4.3544792429942563],
        [-6.1306484078998089, -0.9167324722093173, -0.5729577951308232],
    ]
    columns = [cayley2.body_rate_jacobian(OMEGA, unit) @ sigma_dot for unit in np.eye(3)]
    np.testing.assert_allclose(4 * np.stack(columns, axis=-1), printed, rtol=0, atol=PRINTED * 5)


def test_composition_of_two_half_turns_is_the_identity() -> None:
    """Expect σ = 0 for the sum (addMRP) of two vectors of half a turn."""
    half = np.array([0.0, 0.0, 1.0])
    np.testing.assert_allclose(cayley2.compose(half, half), np.zeros(3), rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(cayley2.between(half, -half), np.zeros(3), rtol=0, atol=ROUNDING)
