"""Kernels under transformations of PyTorch: values and gradients equal those of plain calls."""

from __future__ import annotations

import importlib

import numpy as np
import pytest

from derive.codegen.signatures import POSES
from tests.support.kernels import load
from tests.support.signatures import SIGNATURES, inputs

pytestmark = [
    pytest.mark.torch,
    # PyTorch's own: on its tracer and its compiler, and on sizes that a tracer compares
    pytest.mark.filterwarnings(
        "ignore:.torch.jit:DeprecationWarning", "ignore:Converting a tensor", "ignore:.*should not be instantiated",
        "ignore:Dynamo detected a call",
    ),
]
SOME = ("pose", "from_pose", "compose", "to_exponential", "interpolate", "to_screw")
"""Sample for transformations that take seconds: one to three arguments, a tuple, with a rule and without."""

EPS = 2.0**-52


@pytest.fixture
def torch():
    return importlib.import_module("torch")


@pytest.fixture
def module(array_api):
    return array_api(3)


def given(torch, name, batch=(3,), gradient=False):
    """Return arguments of a function as tensors."""
    known = next(one for one in (name, name.removesuffix("_jacobians"), "pose") if one in SIGNATURES)
    return [torch.asarray(value).requires_grad_(gradient) for value in inputs(load(3), known, 3, batch)]


def several(found):
    return found if isinstance(found, tuple) else (found,)


def assert_near(found, expected, eps=100):
    """Compare with an error of some hundred operations, of a relative error eps of the largest entry each."""
    for one, other in zip(several(found), several(expected), strict=True):
        assert one.shape == other.shape
        assert (one - other).abs().max() <= eps * EPS * other.abs().max(), (one, other)


def gradients(torch, function, values):
    return torch.autograd.grad(sum((part**2).sum() for part in several(function(*values))), values)


@pytest.mark.parametrize("name", SOME)
def test_checkpoints_keep_gradients(torch, module, name):
    function, values = getattr(module, name), given(torch, name, gradient=True)
    again = importlib.import_module("torch.utils.checkpoint").checkpoint
    found = gradients(torch, lambda *at: again(function, *at, use_reentrant=False), values)
    assert_near(found, gradients(torch, function, values))


@pytest.mark.parametrize("name", SOME[:3])
def test_exported_and_traced_functions_take_other_batches(torch, module, name):
    function, values = getattr(module, name), given(torch, name)

    class Module(torch.nn.Module):
        def forward(self, *values):
            return function(*values)

    batch = torch.export.Dim("batch")
    shapes = {"values": tuple({0: batch} for _ in values)}
    exported = torch.export.export(Module(), tuple(values), dynamic_shapes=shapes)
    wider = given(torch, name, (5,))
    for found in (exported.module(), torch.jit.trace(function, tuple(values))):
        assert_near(found(*wider), function(*wider))


@pytest.mark.parametrize("name", ["to_exponential", "compose_jacobians"])
def test_compiled_functions_keep_gradients(torch, module, name):
    """Compare beside the identity too, where only a rule has digits."""
    function, values = getattr(module, name), given(torch, name)
    values[0][..., :3] *= 1e-8
    values = [value.requires_grad_() for value in values]
    compiled = torch.compile(function, fullgraph=True, backend="aot_eager")
    assert_near(gradients(torch, compiled, values), gradients(torch, function, values), eps=2000)


def test_transformations_within_a_compiled_function(torch, module):
    """Expect no derivative that is silently 0: compilers follow no rule there."""
    (v,) = given(torch, "pose", ())
    slope = lambda at: torch.func.jacfwd(module.from_pose)(module.pose(at))  # noqa: E731
    assert_near(torch.compile(slope, fullgraph=True, backend="aot_eager")(v), slope(v))


def test_subclasses_are_arrays_of_pytorch(torch, module):
    class Sub(torch.Tensor):
        pass

    v, w = given(torch, "compose")
    assert_near(module.compose(v.as_subclass(Sub), w), module.compose(v, w))


@pytest.mark.parametrize("axis", [0, -1])
def test_vmap_over_every_function(torch, module, axis):
    for name in SIGNATURES:
        function, values = getattr(module, name), given(torch, name)
        found = torch.func.vmap(lambda *at, function=function: function(*at, axis=axis))(*values)
        assert_near(found, function(*values))


@pytest.mark.parametrize("name", [name for name in POSES.public if name.endswith("_jacobians")])
def test_forward_mode_outside_transformations(torch, module, name):
    forward_ad = importlib.import_module("torch.autograd.forward_ad")
    function, values = getattr(module, name), given(torch, name)
    rates = [torch.cos(7 * value) for value in values]
    _, expected = torch.func.jvp(function, tuple(values), tuple(rates))
    with forward_ad.dual_level():
        found = function(*map(forward_ad.make_dual, values, rates))
        assert_near(tuple(forward_ad.unpack_dual(part).tangent for part in found), expected, eps=2000)


def test_autocast_keeps_every_gradient(torch, module):
    """Compare exactly: no product of matrices is left that autocast computes with fewer digits."""
    for name in ("shadow", "principal", "twist", "rate"):
        values = [value.float().detach().requires_grad_() for value in given(torch, name)]
        plain = gradients(torch, getattr(module, name), values)
        with torch.autocast("cpu", dtype=torch.bfloat16):
            found = gradients(torch, getattr(module, name), values)
        np.testing.assert_array_equal(found[0], plain[0])
