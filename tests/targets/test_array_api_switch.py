"""Switch of branches in the array-api target: compiled, inside a scan, and in other libraries."""

from __future__ import annotations

from itertools import product

import array_api_strict
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import dualcay


def arguments() -> list[np.ndarray]:
    rng = np.random.default_rng(0)
    root = rng.normal(size=(5, 6, 6))
    return [rng.normal(size=(5, 6)), rng.normal(size=(5, 6)), root @ root.swapaxes(-1, -2)]


@pytest.mark.parametrize("library", ["numpy", "strict", "jax"])
def test_a_switch_agrees_with_the_numpy_kernels(array_api, library):
    """Compare to 1e-12: entries reach 60, and both targets run the same programs."""
    make, run = {
        "numpy": (np.asarray, array_api(2).switch),
        "strict": (array_api_strict.asarray, array_api(2).switch),
        "jax": (jnp.asarray, jax.jit(array_api(2).switch)),
    }[library]
    with jax.enable_x64(True):
        found = run(*map(make, arguments()))
    wanted = dualcay.cayley2.switch(*arguments())
    changed = np.any(wanted[0] != arguments()[0], axis=-1)
    assert changed.sum() == 4
    for a, b, given in zip(found, wanted, arguments(), strict=True):
        np.testing.assert_allclose(np.asarray(a), b, rtol=0, atol=1e-12)
        np.testing.assert_array_equal(np.asarray(a)[~changed], given[~changed])


def test_covariances_that_are_not_symmetric_are_refused_where_values_are_known(array_api):
    v, v_dot, P = arguments()
    P[3, 1, 2] += 1e-6
    for make, axis in product((np.asarray, array_api_strict.asarray), (-1, 0)):
        given = [v, v_dot, P] if axis else [v.T, v_dot.T, np.moveaxis(P, 0, -1)]
        with pytest.raises(ValueError, match="covariance must be symmetric, got entries that differ by 1e-06"):
            array_api(2).switch(*map(make, given), axis=axis)
    assert jax.jit(array_api(2).switch)(*map(jnp.asarray, (v, v_dot, P)))[2].shape == P.shape


def test_a_scan_that_switches_never_leaves_the_principal_branch(array_api):
    module, omega = array_api(2), jnp.array([1, 0.2, 0.3, 0.1, 0, 0])

    def step(v, _):
        v = module.switch(v + 0.01 * module.rate(v, omega))
        return v, v

    _, v = jax.lax.scan(step, jnp.zeros(6), None, length=1000)
    sizes = np.linalg.norm(np.asarray(v)[:, :3], axis=-1)
    assert 0.99 < sizes.max() <= 1 + 1e-6
    assert np.count_nonzero(np.diff(np.asarray(v)[:, 0]) < -0.5) == 2  # 10 s at 1.06 rad/s pass π and 3π
