"""Derivatives through JAX and PyTorch: equal to the complex step and the tangent operators, finite at v = 0."""

from __future__ import annotations

import numpy as np
import pytest

import dualcay
from tests.support import sampling
from tests.support.kernels import load
from tests.support.libraries import LIBRARIES

ORDERS = pytest.mark.parametrize("order", [1, 2, 3])
REGIMES = ("uniform", "angle 1e-7", "pure translation", "identity")
EPS = 2.0**-52


def jax_jacobian(function, *values):
    """Forward and reverse mode, which must agree."""
    LIBRARIES["jax"]()
    import jax

    values = [jax.numpy.asarray(v) for v in values]
    forward, reverse = jax.jit(lambda *at: (jax.jacfwd(function)(*at), jax.jacrev(function)(*at)))(*values)
    forward = np.asarray(forward)
    np.testing.assert_allclose(forward, np.asarray(reverse), atol=1e-12 * abs(forward).max())
    return forward


def torch_jacobian(function, *values):
    import torch

    values = [torch.asarray(v) for v in values]
    rest = values[1:]
    return torch.autograd.functional.jacobian(lambda v: function(v, *rest), values[0]).numpy()


JACOBIAN = pytest.mark.parametrize(
    "jacobian", [jax_jacobian, pytest.param(torch_jacobian, marks=pytest.mark.torch)], ids=["jax", "torch"]
)


def complex_step(function, v):
    """Column j is the imaginary part at v + i h e_j, over h: exact to rounding."""
    steps = v + 1e-30j * np.eye(v.size)
    return np.moveaxis(function(steps).imag / 1e-30, 0, -1)


def assert_equal_derivatives(got, expected, eps=200):
    assert np.isfinite(got).all()
    np.testing.assert_allclose(got, expected, rtol=0, atol=eps * EPS * max(1.0, abs(expected).max()))


@JACOBIAN
@ORDERS
@pytest.mark.parametrize("name", ["quaternion", "tensor", "pose", "tangent", "tangent_inv"])
def test_forward_maps(array_api, order, name, jacobian):
    for regime in (*REGIMES, "shadow") if order > 2 else REGIMES:
        v = sampling.poses(order, regime)[0]
        expected = complex_step(getattr(load(order), name), v)
        assert_equal_derivatives(jacobian(getattr(array_api(order), name), v), expected, 400 * order**2)


@JACOBIAN
@ORDERS
def test_the_tangent_operator_is_the_derivative_of_the_tensor(array_api, order, jacobian):
    module = array_api(order)
    v = sampling.poses(order, "uniform")[0]
    kernel = load(order)
    slopes = np.moveaxis(jacobian(module.tensor, v), -1, 0)
    Q, K = kernel.tensor(v)
    for slope, twist in zip(slopes, kernel.twist(v, np.eye(6)), strict=True):
        re, du = slope[0] @ Q.T, slope[1] @ Q.T + slope[0] @ K.T
        vects = [np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / 2 for m in (re, du)]
        assert_equal_derivatives(np.concatenate(vects), twist, 400)


@JACOBIAN
@ORDERS
@pytest.mark.parametrize("road", ["quaternion", "tensor", "pose"])
def test_inverse_maps_undo_the_forward_maps_to_first_order(array_api, order, road, jacobian):
    module = array_api(order)
    forward, back = getattr(module, road), getattr(module, f"from_{road}")
    for regime in REGIMES:
        v = sampling.poses(order, regime)[0]
        size = (1 + abs(v).max()) ** 2
        assert_equal_derivatives(jacobian(lambda v: back(forward(v)), v), np.eye(6), 400 * order * size)


@JACOBIAN
@ORDERS
@pytest.mark.parametrize("road", ["quaternion", "tensor", "pose"])
def test_inverse_maps_have_finite_derivatives_in_every_entry(array_api, order, road, jacobian):
    kernel = load(order)
    for regime in REGIMES:
        value = getattr(kernel, road)(sampling.poses(order, regime)[0])
        assert np.isfinite(jacobian(getattr(array_api(order), f"from_{road}"), value)).all()


@JACOBIAN
@ORDERS
def test_composition_with_the_identity_and_principal_v(array_api, order, jacobian):
    module = array_api(order)
    for regime in REGIMES:
        v = sampling.poses(order, regime)[0]
        eps = 400 * order * (1 + abs(v).max()) ** 2
        assert_equal_derivatives(jacobian(module.compose, v, np.zeros(6)), np.eye(6), eps)
        assert_equal_derivatives(jacobian(module.principal, v), np.eye(6), eps)


@JACOBIAN
@ORDERS
def test_shadows_and_screws(array_api, order, jacobian):
    """The derivative of a shadow is T(v_k)⁻¹ T(v)."""
    module, kernel = array_api(order), load(order)
    v = sampling.poses(order, "uniform")[0]
    if order > 1:
        matrix, back = (dualcay.matrix6(D) for D in (kernel.tangent(v), kernel.tangent_inv(kernel.shadow(v))))
        expected = back @ matrix
        assert_equal_derivatives(jacobian(module.shadow, v), expected, 4000)
        if order != 2:
            rest = sampling.poses(order, "pure translation")[0]
            assert np.isfinite(jacobian(module.shadow, rest)).all()
    for regime in ("uniform", "pure translation", "pure rotation", "angle 1e-7"):
        at = sampling.poses(order, regime)[0]
        for part in (0, 1):
            assert np.isfinite(jacobian(lambda v, part=part: module.to_screw(v)[part], at)).all()


def test_vmap_and_jit_agree_with_batches(array_api):
    LIBRARIES["jax"]()
    import jax

    module, kernel = array_api(3), load(3)
    v = sampling.poses(3, "uniform")
    for function in (jax.vmap(module.pose), jax.jit(module.pose), jax.jit(jax.vmap(module.pose))):
        np.testing.assert_allclose(function(v), kernel.pose(v), rtol=0, atol=1e-14)
    w = sampling.dual_vectors("vmap")
    np.testing.assert_allclose(jax.vmap(module.rate)(v, w), kernel.rate(v, w), rtol=0, atol=1e-13)
    gradients = jax.jit(jax.vmap(jax.grad(lambda v: module.pose(v)[0, 3])))(v)
    assert np.isfinite(gradients).all()


@pytest.mark.torch
def test_torch_vmap_and_backward(array_api):
    import torch

    module = array_api(3)
    v = torch.asarray(sampling.poses(3, "uniform"))
    torch.testing.assert_close(torch.func.vmap(module.pose)(v), module.pose(v))
    at = torch.zeros((2, 6), dtype=torch.float64, requires_grad=True)
    module.from_pose(module.pose(at)).sum().backward()
    torch.testing.assert_close(at.grad, torch.ones_like(at))
