"""Rules of differentiation for JAX: chains of calls compile once, and transformations keep their results."""

from __future__ import annotations

import numpy as np
import pytest

from tests.support import sampling
from tests.support.libraries import LIBRARIES, QUICKLY

jax = pytest.importorskip("jax")

OTHERS = (
    "between", "retract", "body_retract", "local", "body_local", "twist", "body_twist", "rate", "body_rate"
)  # fmt: skip
MODES = ("jacfwd", "jacrev")
EVERY = pytest.mark.parametrize(
    ("name", "mode"),
    [
        *(("compose", mode) for mode in MODES),
        *(pytest.param(name, MODES[k % 2], marks=pytest.mark.thorough) for k, name in enumerate(OTHERS)),
    ],
)
EPS = 2.0**-52


@pytest.fixture(scope="module", autouse=True)
def double_precision():
    LIBRARIES["jax"]()


def arguments():
    """Return two vectors with rotation angles below half a turn in all charts, then two rates."""
    v2, v1, rate2, rate1 = (sampling.dual_vectors(f"rules {i}") for i in range(4))
    return [np.tanh(v2) / 10, np.tanh(v1) / 8, rate2, rate1]


def both_ways(function, v2, v1, rate2, rate1):
    """Return the derivative along the rates, and the gradients of the result weighted by the first rate."""
    _, forward = jax.jvp(function, (v2, v1), (rate2, rate1))
    found, back = jax.vjp(function, v2, v1)
    return forward, back(rate2.astype(found.dtype))


def compiled(function, *values):
    return jax.tree.map(np.asarray, jax.jit(function, compiler_options=QUICKLY)(*values))


def assert_equal(found, expected, eps=2000):
    """Compare with an error of some hundred operations, each of a relative error eps of the largest entry."""
    np.testing.assert_allclose(found, expected, rtol=0, atol=eps * EPS * abs(expected).max())


def text(function, *values):
    """Return the number of operations of a compiled function's input."""
    return jax.jit(function).lower(*values).as_text().count("stablehlo.")


def chain(function, count):
    """Return a function that applies another to its own result several times."""

    def repeated(w, v):
        for _ in range(count):
            w = function(w, v)
        return w

    return repeated


@EVERY
def test_six_calls_share_the_text_of_one(charts, name, mode, monkeypatch):
    """Allow twice the text of one call; without rules six calls take more than four times the text."""
    function, at = getattr(charts("cayley2"), name), [value[0] for value in arguments()[:2]]

    def growth():
        one, six = (text(getattr(jax, mode)(chain(function, count)), *at) for count in (1, 6))
        return six / one

    assert growth() < 2
    monkeypatch.setattr(charts("_rules"), "RULES", {})
    assert growth() > 4


@pytest.mark.thorough
def test_compiled_functions_multiply_about_as_often_as_their_programs(charts, monkeypatch):
    """Count products and quotients that XLA runs for two compositions; without stored values it repeats far more.

    XLA divides by constants by products, and its own inverse tangent adds some to those of the program.
    """
    module, given = charts("exponential"), arguments()[:2]

    def ratio():
        lowered = jax.jit(lambda b, a: module.compose(module.compose(b, a), a)).lower(*given)
        once, compiled = lowered.as_text(), lowered.compile().as_text()
        found = sum(compiled.count(f" {op}(") for op in ("multiply", "divide"))
        return found / sum(2 * once.count(f"stablehlo.{op}") for op in ("multiply", "divide"))  # both calls share text

    stored = ratio()
    monkeypatch.setattr(charts("_jax"), "apart", lambda values: values)
    charts("_jax").ruled.cache_clear()
    jax.clear_caches()
    repeated = ratio()
    charts("_jax").ruled.cache_clear()
    assert stored <= 1.5 < 2 < repeated


@pytest.mark.thorough
def test_layouts_types_and_transformations(charts):
    """Compare axis 0, broadcast batches, float32 (eps 2⁻²³), vmap and scan with the plain call."""
    module, (v2, v1, rate2, rate1) = charts("cayley3"), arguments()
    plain, back = compiled(lambda *given: both_ways(module.compose, *given), v2, v1, rate2, rate1)

    def first(a, b):
        return module.compose(a, b, axis=0)

    def transformed(*given):
        turned = both_ways(first, *(value.T for value in given))
        single = both_ways(module.compose, *(value.astype(np.float32) for value in given))
        mapped = jax.vmap(lambda *one: both_ways(module.compose, *one))(*given)
        table = jax.jvp(lambda a: module.compose(a[:, None], v1[None, :1]), given[:1], given[2:3])[1]
        scanned = jax.lax.scan(lambda _, one: (None, both_ways(module.compose, *one)), None, given)[1]
        return turned, single, mapped, table, scanned

    turned, single, mapped, table, scanned = compiled(transformed, v2, v1, rate2, rate1)
    for found in ((turned[0].T, [g.T for g in turned[1]]), mapped, scanned):
        for one, other in zip(jax.tree.leaves(found), jax.tree.leaves((plain, back)), strict=True):
            assert_equal(one, other)
    for one, other in zip(jax.tree.leaves(single), jax.tree.leaves((plain, back)), strict=True):
        assert one.dtype == np.float32
        assert_equal(one, other, eps=2000 * 2**29)
    assert table.shape == (len(v2), 1, 6)


def test_a_batch_that_does_not_broadcast_names_both_arguments(charts):
    with pytest.raises(ValueError, match=r"\(2,\) of v and \(3,\) of z"):
        charts("cayley3").cotangent(jax.numpy.ones((2, 6)), jax.numpy.ones((3, 6)))
