"""Derivatives by JAX and PyTorch: they equal complex steps and tangent operators, and are finite at v = 0."""

from __future__ import annotations

import numpy as np
import pytest

import dualcay
from tests.support import sampling
from tests.support.kernels import load
from tests.support.libraries import LIBRARIES, QUICKLY

pytestmark = pytest.mark.thorough

ORDERS = pytest.mark.parametrize("order", [3])
# orders from 2 on share their geometry
ROADS = pytest.mark.parametrize(
    ("order", "road"),
    [(1, "quaternion"), (1, "tensor"), (2, "quaternion"), (2, "pose"), (3, "quaternion"), (3, "tensor"), (3, "pose")],
)
REGIMES = ("uniform", "angle 1e-7", "pure translation", "identity")
EPS = 2.0**-52


def jax_jacobians(function, *values):
    """Return Jacobians of all rows by forward mode, compared with reverse mode; one compiled call computes both."""
    LIBRARIES["jax"]()
    import jax

    both = jax.vmap(lambda *at: (jax.jacfwd(function)(*at), jax.jacrev(function)(*at)))
    compiled = jax.jit(both, compiler_options=QUICKLY)
    forward, reverse = (np.asarray(found) for found in compiled(*map(jax.numpy.asarray, values)))
    for one, other in zip(forward, reverse, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-12 * abs(one).max())
    return forward


def torch_jacobians(function, *values):
    import torch

    rows = zip(*(torch.asarray(np.array(value)) for value in values), strict=True)  # writable copies
    jacobian = torch.autograd.functional.jacobian
    return np.stack([jacobian(lambda v, rest=rest: function(v, *rest), v).numpy() for v, *rest in rows])


JACOBIANS = pytest.mark.parametrize(
    "jacobians", [jax_jacobians, pytest.param(torch_jacobians, marks=pytest.mark.torch)], ids=["jax", "torch"]
)


def samples(order, *regimes):
    """Return one vector of each regime."""
    return np.stack([sampling.poses(order, regime)[0] for regime in regimes])


def complex_step(function, v):
    """Return the derivative with columns Im f(v + i h e_j) / h, accurate to rounding."""
    steps = v + 1e-30j * np.eye(v.size)
    return np.moveaxis(function(steps).imag / 1e-30, 0, -1)


def assert_equal_derivatives(got, expected, eps=200):
    assert np.isfinite(got).all()
    np.testing.assert_allclose(got, expected, rtol=0, atol=eps * EPS * max(1.0, abs(expected).max()))


@JACOBIANS
@ORDERS
@pytest.mark.parametrize("name", ["quaternion", "tensor", "pose", "tangent", "tangent_inv"])
def test_forward_maps(array_api, order, name, jacobians):
    at = samples(order, *REGIMES, *(("shadow",) if order > 2 else ()))
    for v, jacobian in zip(at, jacobians(getattr(array_api(order), name), at), strict=True):
        assert_equal_derivatives(jacobian, complex_step(getattr(load(order), name), v), 400 * order**2)


@JACOBIANS
@ORDERS
def test_the_tangent_operator_is_the_derivative_of_the_tensor(array_api, order, jacobians):
    module = array_api(order)
    at = samples(order, "uniform")
    kernel = load(order)
    slopes = np.moveaxis(jacobians(module.tensor, at)[0], -1, 0)
    Q, K = kernel.tensor(at[0])
    for slope, twist in zip(slopes, kernel.twist(at[0], np.eye(6)), strict=True):
        re, du = slope[0] @ Q.T, slope[1] @ Q.T + slope[0] @ K.T
        vects = [np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / 2 for m in (re, du)]
        assert_equal_derivatives(np.concatenate(vects), twist, 400)


@JACOBIANS
@ROADS
def test_inverse_maps_undo_the_forward_maps_to_first_order(array_api, order, road, jacobians):
    module, at = array_api(order), samples(order, *REGIMES)
    forward, back = getattr(module, road), getattr(module, f"from_{road}")
    for v, jacobian in zip(at, jacobians(lambda v: back(forward(v)), at), strict=True):
        size = (1 + abs(v).max()) ** 2
        assert_equal_derivatives(jacobian, np.eye(6), 400 * order * size)


@JACOBIANS
@ROADS
def test_inverse_maps_have_finite_derivatives_in_every_entry(array_api, order, road, jacobians):
    values = getattr(load(order), road)(samples(order, *REGIMES))
    assert np.isfinite(jacobians(getattr(array_api(order), f"from_{road}"), values)).all()


@JACOBIANS
@ORDERS
def test_composition_with_the_identity_and_principal_v(array_api, order, jacobians):
    module, at = array_api(order), samples(order, *REGIMES)
    composed, principal = jacobians(module.compose, at, 0 * at), jacobians(module.principal, at)
    for v, *found in zip(at, composed, principal, strict=True):
        for jacobian in found:
            assert_equal_derivatives(jacobian, np.eye(6), 400 * order * (1 + abs(v).max()) ** 2)


@JACOBIANS
@ORDERS
def test_shadows_and_screws(array_api, order, jacobians):
    """Compare derivatives of shadows with T(v_k)⁻¹ T(v); expect finite derivatives of screws."""
    module, kernel = array_api(order), load(order)
    if order > 1:
        at = samples(order, "uniform", *(("pure translation",) if order != 2 else ()))
        found = jacobians(module.shadow, at)
        matrix, back = (dualcay.matrix6(D) for D in (kernel.tangent(at[0]), kernel.tangent_inv(kernel.shadow(at[0]))))
        assert_equal_derivatives(found[0], back @ matrix, 4000)
        assert np.isfinite(found).all()
    at = samples(order, "uniform", "pure translation", "pure rotation", "angle 1e-7")
    for part in (0, 1):
        assert np.isfinite(jacobians(lambda v, part=part: module.to_screw(v)[part], at)).all()


@JACOBIANS
def test_steps_of_half_a_turn_and_more(array_api, jacobians):
    """Compare derivatives by δ with T(v')⁻¹ dexp(δ); tan(|δ|/2) is huge at half a turn and 0 at a whole turn."""
    module, v = array_api(3), np.repeat(samples(3, "uniform"), 3, axis=0)
    third = np.pi / 3
    delta = np.array([[0, 0, np.pi, 0.1, 0.2, 0.3], [-third, 2 * third, 2 * third, 1, 2, 3], [0, 5, 0, 1, 0, 0]])
    closed = load(3).retract_jacobians(v, delta)[1]
    for got, expected in zip(jacobians(lambda d, at: module.retract(at, d), delta, v), closed, strict=True):
        assert_equal_derivatives(got, expected, 2000)


@JACOBIANS
def test_motions_past_a_whole_turn(array_api, jacobians):
    """Differentiate by v a motion about the axis of v; n = 1 has one branch, so nothing is singular at a whole turn.

    Allow 1e-8 for central differences with step 1e-6, of a function with derivatives of about ten.
    """
    module, kernel = array_api(1), load(1)
    at, end = np.array([0, 0, 0.1, 0.3, 0.2, 0.1]), np.array([0, 0, 2, 0, 0, 0.0])
    (found,) = jacobians(lambda v: module.interpolate(v, end, 4.0), at[None])
    step = 1e-6 * np.eye(6)
    expected = (kernel.interpolate(at + step, end, 4.0) - kernel.interpolate(at - step, end, 4.0)).T / 2e-6
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-8 * abs(expected).max())


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


@JACOBIANS
def test_closed_forms_are_the_derivatives(array_api, jacobians):
    """Differentiate one weighted sum of all functions, to compile only once."""
    module, kernel, at = array_api(3), load(3), samples(3, "uniform", "angle 1e-7", "pure translation", "shadow")
    w = np.broadcast_to(0.3 * sampling.dual_vectors("closed forms")[0], at.shape)

    def total(v, w):
        return module.compose(w, v) + 2 * module.body_twist(v, w) + 4 * module.rate(v, w)

    closed = kernel.compose_jacobians(w, at)[1]
    closed += 2 * kernel.body_twist_jacobian(at, w) + 4 * kernel.rate_jacobian(at, w)
    for got, expected in zip(jacobians(total, at, w), closed, strict=True):
        assert_equal_derivatives(got, expected, 2000)
