"""Continuous branches of a sequence of vectors."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import dualcay
from dualcay import _sequences, _switching, unwrap
from tests.generated.test_switching import EPS, charts


def test_unwrap_of_rotation_vectors_that_jump_at_half_a_turn() -> None:
    """Compare with numpy.unwrap about a fixed axis; the first vector keeps its branch. Control: the given ones jump."""
    angles = 0.4 + 0.3 * np.arange(90) * np.cos(np.arange(90) / 30)
    axis, rotation = np.array([0.6, 0, 0.8]), dualcay.rotation.exponential
    v = rotation.principal(angles[:, None] * axis)
    assert np.linalg.norm(np.diff(v, axis=0), axis=-1).max() > 3
    for start in (0, 1, -4):
        given = np.concatenate([rotation.shadow(v[:1], start), v[1:]])
        found, branch = unwrap(rotation, given, branch=True)
        assert branch[0] == start
        np.testing.assert_allclose(found @ axis, angles + 2 * np.pi * start, rtol=0, atol=1e-12)


def test_unwrap_refuses_a_single_vector_and_complex_ones() -> None:
    with pytest.raises(ValueError, match=r"v must have shape \(T, ..., 6\), got \(6,\)"):
        unwrap(dualcay.cayley2, np.zeros(6))
    with pytest.raises(TypeError, match="v must be real"):
        unwrap(dualcay.cayley1, np.zeros((2, 6), complex))
    v = dualcay.cayley1.random(5, rng=1)
    assert np.array_equal(unwrap(dualcay.cayley1, v), v)  # a pose has one vector only


@pytest.mark.parametrize("table", ["", "rotation"])
def test_a_continuous_choice_within_the_switch_angle_is_found_through_half_turns(table: str) -> None:
    """Rows at half turns within rounding have the axis of either side; the branches are those of `shadow`."""
    t = np.linspace(0, 12, 241)
    axis = np.stack([0.8 * np.cos(4 * t), 0.8 * np.sin(4 * t), np.full_like(t, -0.6)], axis=1)  # far round
    beyond = 1.7 * np.sin(t)
    angle = np.pi + np.sign(beyond) * np.maximum(abs(beyond) - 0.3, 0)
    half = angle == np.pi
    w = np.concatenate([angle[:, None] * axis, np.outer(np.sin(t), [0.5, 0.2, -1.0])], axis=1)
    for module, dtype in zip(charts(table), itertools.cycle((np.float32, np.float64, np.longdouble))):
        n = len(module.identity())
        true = module.from_exponential(w[:, :n].astype(dtype))
        given = module.from_quaternion(module.quaternion(true))
        given[half] = np.where((np.arange(half.sum()) % 2)[:, None], module.shadow(given[half], -1), given[half])
        given[0] = true[0]
        found, k = unwrap(module, given, branch=True)
        assert found.dtype == dtype
        exact = 3e4 * np.finfo(dtype).eps
        np.testing.assert_allclose(found.astype(float), true.astype(float), rtol=0, atol=exact)
        back = [module.shadow(one, int(branch)) for one, branch in zip(module.principal(given), k, strict=True)]
        np.testing.assert_allclose(np.array(back, float), found.astype(float), rtol=0, atol=exact)


def test_a_half_turn_from_a_tensor_continues() -> None:
    u, rotation = np.array([0, -0.8, -0.6]), dualcay.rotation.exponential
    half = rotation.from_tensor(2 * np.outer(u, u) - np.eye(3))
    found, branch = unwrap(rotation, np.stack([3.0 * u, half, 3.3 * u]), branch=True)
    np.testing.assert_allclose(found @ u, [3.0, np.pi, 3.3], rtol=1e-15)
    np.testing.assert_array_equal(found[1], rotation.shadow(half, -1))
    assert branch.tolist() == [0, -1, -1]


def test_rows_at_whole_turns_and_gaps_keep_the_axis_and_the_branch_of_their_neighbours() -> None:
    """Rows are 0, beside it by rounding, or NaN; the first one that is none of them keeps its branch."""
    screw = np.array([0.48, 0.6, 0.64, 0.3, -0.2, 0.5])
    turn = np.array([np.nan, 8.0, 2 * np.pi, 4.5, 6.0, np.nan, 2 * np.pi, 2 * np.pi, 7.0, 9.0, 11.0, 4 * np.pi, 14.0])
    wanted = np.multiply.outer(turn, screw)
    for module in (dualcay.exponential, dualcay.rotation.exponential):
        n = len(module.identity())
        given = module.principal(wanted[:, :n])
        given[[2, 6]] = given[2] if n == 6 else 0
        if n == 3:
            given[[7, 11]] = [[1e-17, 2e-16, 0], [0, -1e-16, 0]]
            given[5] = 1e20
        given[1] = wanted[1, :n]
        found, branch = unwrap(module, given, branch=True)
        np.testing.assert_allclose(np.delete(found, 5, axis=0), np.delete(wanted[:, :n], 5, axis=0), rtol=1e-12)
        np.testing.assert_array_equal(found[5], given[5])
        assert branch[[0, 1, 3, 4, 5, 8, 9, 10, 12]].tolist() == [0, 1, -1, -1, 0, 1, 1, -2, 2]
    still = np.zeros((4, 3))
    still[2] = [1e-16, -2e-16, 0]
    for rotation in (dualcay.rotation.exponential, dualcay.rotation.cayley3):  # no row tells an axis
        found, branch = unwrap(rotation, still, branch=True)
        assert np.array_equal(found, still)
        assert not branch.any()
    a, b = np.array([[0, 0, 0.1]]), np.array([[0, 0, 0.2]])  # between them a whole turn about another axis
    found = unwrap(dualcay.rotation.exponential, np.concatenate([a, [[2 * np.pi, 0, 0]], b]))
    np.testing.assert_allclose(found[1], [0, 0, 0], atol=1e-15)
    small = np.concatenate([a, [[1e-17, -1e-17, 0]], b])
    np.testing.assert_array_equal(unwrap(dualcay.rotation.exponential, small), small)
    w = np.multiply.outer(np.linspace(5, 7.5, 11), [0, 0.6, 0.8, 0, 0, 0])
    w[5] = [0, 0, 0, 0.1, 0, 0]  # a translation beside the axis
    found = unwrap(dualcay.exponential, w)
    np.testing.assert_allclose(dualcay.exponential.pose(found), dualcay.exponential.pose(w), rtol=0, atol=1e-14)


def test_the_first_vector_changes_its_branch_only_for_a_better_way_within_the_switch_angle() -> None:
    mrp, u = dualcay.rotation.cayley2, np.array([0, 0.6, 0.8])
    falling, rising = (mrp.from_exponential(np.outer(np.linspace(3.6, end, 40), u)) for end in (0.5, 4.6))
    np.testing.assert_allclose(unwrap(mrp, mrp.principal(falling)), falling, rtol=1e-12)
    np.testing.assert_array_equal(unwrap(mrp, mrp.principal(rising)), mrp.principal(rising))
    np.testing.assert_array_equal(unwrap(mrp, rising), mrp.principal(rising))  # with shorter steps
    t = np.linspace(0, 9, 200)[:, None]
    for chart in (dualcay.rotation.exponential, dualcay.rotation.cayley8):  # from a branch that is left at once
        cone = np.concatenate([0.8 * np.cos(4 * t), 0.8 * np.sin(4 * t), 0 * t + 0.6], axis=1)
        v = chart.from_exponential((2.8 - 1.8 * np.cos(t)) * cone)
        given = chart.principal(v)
        given[0] = chart.shadow(v[0], 3)
        np.testing.assert_allclose(unwrap(chart, given), v, rtol=0, atol=1e-13)
    alone = mrp.from_exponential(6.0 * u[None])
    np.testing.assert_array_equal(unwrap(mrp, alone), mrp.principal(alone))  # too near the edge


def test_turns_of_single_precision_are_counted_in_double_precision() -> None:
    """10 000 turns in steps of 3 rad: sums of single precision lose some."""
    angles, rotation = 3.0 * np.arange(20000), dualcay.rotation.exponential
    given = rotation.principal(angles[:, None] * np.array([0, 0.6, 0.8])).astype(np.float32)
    k = _sequences.near(_sequences.folded(rotation, given[:, None]), 0)[0, :, 0]
    turns = angles // (2 * np.pi)
    np.testing.assert_array_equal(k, np.where(angles % (2 * np.pi) > np.pi, -1 - turns, turns))


def test_the_cheapest_way_is_that_of_all_ways() -> None:
    """Compare with a search through all ways of 1 to 6 rows, with forbidden steps."""
    rng = np.random.default_rng(2)
    for rows in range(1, 7):
        costs, first = rng.uniform(size=(3, 3, rows - 1, 8)), rng.uniform(size=(3, 8))
        costs[rng.uniform(size=costs.shape) < 0.2] = np.inf
        path = _sequences.cheapest(costs, first)
        for b in range(8):
            ways = {
                way: first[way[0], b] + sum(costs[i, j, t, b] for t, (i, j) in enumerate(itertools.pairwise(way)))
                for way in itertools.product(range(3), repeat=rows)
            }
            assert ways[tuple(path[:, b])] == pytest.approx(min(ways.values()))


def test_explained_steps_and_short_sequences_of_large_rotations() -> None:
    """Compare the longest step that is no jump with C θ at quaternions of unlike sign; count jumps of sequences."""
    rotation = dualcay.rotation.exponential
    rows = _sequences.folded(rotation, np.array([[[0, 0, 3.1]], [[0, 0, -3.1]]]))
    wanted = 3 * np.pi / 4 / np.sin(3 * np.pi / 4) * (2 * np.pi - 6.2)
    assert _sequences.explained(rotation, rows, np.zeros((1, 2, 1)), 3 * np.pi / 2) == pytest.approx(wanted)
    still = _sequences.folded(rotation, np.ones((2, 1, 3)))  # rounding of equal rows is no jump
    assert _sequences.explained(rotation, still, np.ones((1, 2, 1)), 3 * np.pi / 2) > EPS
    for module in charts("rotation"):
        v = module.from_exponential(rotation.random((5, 3000), rng=6))
        sizes = [np.linalg.norm(np.diff(one, axis=0), axis=-1) for one in (unwrap(module, v), v)]
        jumps, before = (np.sum(size > module.from_exponential([np.pi + 1e-9, 0, 0])[0], axis=0) for size in sizes)
        assert np.all(jumps <= before)


def test_columns_are_unwrapped_alone_in_any_block(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("cayley3", "cayley8", "exponential"):
        module = getattr(dualcay, name)
        v = module.from_exponential(3 * np.random.default_rng(4).normal(size=(12, 2, 3, 6)))
        v[:, 0, 1] = np.nan
        found, branch = unwrap(module, v, branch=True)
        monkeypatch.setattr(_switching, "ROWS", 24)
        np.testing.assert_array_equal(unwrap(module, np.asfortranarray(v)), found)
        np.testing.assert_array_equal(unwrap(module, v[:, 1, 2]), found[:, 1, 2])
        assert not branch[:, 0, 1].any()
        np.testing.assert_array_equal(found[:, 0, 1], v[:, 0, 1])
        assert unwrap(module, v[:0]).shape == (0, 2, 3, 6)
        monkeypatch.undo()
