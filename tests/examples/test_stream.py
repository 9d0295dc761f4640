"""The example of the stream: moments against NumPy and the first order, and memory that does not grow."""

from __future__ import annotations

import tracemalloc

import dask
import numpy as np
import pytest

from examples import stream


def test_moments_equal_those_of_all_points_at_once():
    moved = stream.points(5000, 700, 3)
    mean, covariance = stream.moments(moved)
    points = moved.compute()
    # sums of 5000 numbers of size 1 in another order
    np.testing.assert_allclose(mean, points.mean(axis=0), rtol=0, atol=1e-12)
    np.testing.assert_allclose(covariance, np.cov(points.T, bias=True), rtol=0, atol=1e-12)


def test_first_order_is_the_limit_of_small_deviations(monkeypatch: pytest.MonkeyPatch):
    count, small = 100_000, 1e-2 * stream.DEVIATION
    monkeypatch.setattr(stream, "DEVIATION", small)
    _, covariance = stream.moments(stream.points(count, 20_000, 1))
    sizes = np.sqrt(np.diag(covariance))
    # four deviations of an estimated covariance: 4 √(2/count) of the variances
    assert np.abs((covariance - stream.first_order()) / np.outer(sizes, sizes)).max() < 4 * np.sqrt(2 / count)


def peak(chunks: int) -> int:
    """Return the largest memory in use, in bytes, for a number of chunks of 20 000 poses."""
    with dask.config.set(scheduler="synchronous"):
        tracemalloc.start()
        stream.moments(stream.points(20_000 * chunks, 20_000, 1))
        found = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    return found


def test_memory_depends_on_the_chunk_only():
    peak(2)  # imports and scratch memory
    few, many = peak(5), peak(30)
    # 25 more chunks of 48 bytes per pose would be 24 MB; their tasks in the graph take some 30 kB each
    assert many - few < 0.1 * 25 * 48 * 20_000
