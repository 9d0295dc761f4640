"""Ten million poses in constant memory
====================================

Run ``python examples/stream.py [--count N] [--chunk N] [--seed N] [--figure FILE]``.

A camera stands on an arm whose pose is uncertain: a normal perturbation in the space frame about a known pose. A point
that the camera sees has a mean and a covariance in space. The first-order formula J P Jᵀ uses a Jacobian of the
kernels. The Monte Carlo sum shows what the formula leaves out: here up to 2.4 per cent of a deviation.

Chunks are drawn, moved and summed one by one. The peak of memory depends on the size of a chunk, not on the count.

.. image:: /figures/stream.svg
"""

# sphinx_gallery_thumbnail_path = 'reference/generated/thumbnail_stream.svg'

import argparse
import resource
from collections.abc import Sequence

import dask.array as da
import numpy as np
from dask.diagnostics import ProgressBar

from dualcay import cayley2
from dualcay.dask import apply

POSE = np.array([0.2, -0.1, 0.4, 0.3, 0.5, -0.2])  # tan(α/4) u of the camera
POINT = np.array([0.1, -0.2, 3])  # seen by the camera, m
DEVIATION = np.array([0.05, 0.05, 0.05, 0.01, 0.01, 0.01])  # of the perturbation: rad, then m


def points(count: int, chunk: int, seed: int) -> da.Array:
    """Return the point in space for each drawn pose, lazily."""
    delta = DEVIATION * da.random.default_rng(seed).standard_normal((count, 6), chunks=(chunk, 6))
    return apply(cayley2.transform_point, apply(cayley2.retract, POSE, delta), POINT)


def moments(moved: da.Array) -> tuple[np.ndarray, np.ndarray]:
    """Return mean and covariance of points, from one small matrix of sums per chunk."""
    shift = cayley2.transform_point(POSE, POINT)  # sums of small offsets lose no digits in the covariance

    def sums(block: np.ndarray) -> np.ndarray:
        offset = np.column_stack([block - shift, np.ones(len(block))])
        return (offset.T @ offset)[None]

    found = moved.map_blocks(sums, new_axis=2, chunks=((1,) * moved.numblocks[0], 4, 4), dtype=float).sum(axis=0)
    total = found.compute() / len(moved)
    mean = total[3, :3]
    return shift + mean, total[:3, :3] - np.outer(mean, mean)


def first_order() -> np.ndarray:
    """Return the covariance J P Jᵀ of the point."""
    _, by_delta = cayley2.retract_jacobians(POSE, np.zeros(6))
    by_v, _ = cayley2.transform_point_jacobians(POSE, POINT)
    slope = by_v @ by_delta
    return slope @ np.diag(DEVIATION**2) @ slope.T


def picture(file: str, drawn: np.ndarray, ellipses: dict[str, tuple[np.ndarray, np.ndarray]]) -> None:
    """Draw points in the x-z plane, and ellipses of three deviations by mean and covariance."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8, 4), layout="constrained")
    axes = figure.subplots()
    axes.plot(*drawn[:, [0, 2]].T, ".", color="0.6", markersize=3, rasterized=True, label=f"{len(drawn)} of the points")
    t = np.linspace(0, 2 * np.pi, 200)
    for (name, (mean, covariance)), style in zip(ellipses.items(), ("C0-", "C1--"), strict=True):
        edge = mean[[0, 2], None] + 3 * np.linalg.cholesky(covariance[::2, ::2]) @ [np.cos(t), np.sin(t)]
        axes.plot(*edge, style, label=f"three deviations, {name}")
    axes.set(xlabel="x (m)", ylabel="z (m)")
    axes.legend(loc="upper right")
    figure.savefig(file, metadata={"Date": None})


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="Monte Carlo of poses in constant memory")
    parser.add_argument("--count", type=int, default=10_000_000, help="number of poses")
    parser.add_argument("--chunk", type=int, default=100_000, help="number of poses in a chunk")
    parser.add_argument("--seed", type=int, default=1, help="seed of the random numbers")
    parser.add_argument("--figure", help="file for the picture")
    options = parser.parse_args(argv)
    moved = points(options.count, options.chunk, options.seed)
    with ProgressBar():
        mean, covariance = moments(moved)
    few = points(5000, 700, options.seed)
    at_once = few.compute().mean(axis=0), np.cov(few.compute().T, bias=True)
    assert all(np.allclose(a, b, rtol=0, atol=1e-12) for a, b in zip(moments(few), at_once, strict=True))
    center = cayley2.transform_point(POSE, POINT)
    print(f"{options.count} poses in chunks of {options.chunk}; the poses alone hold {48e-6 * options.count:.0f} MB")
    print(f"mean of the point   {mean.round(4)} m, at the mean pose {center.round(4)} m")
    ellipses = {"Monte Carlo": (mean, covariance), "first order": (center, first_order())}
    for name, (_, found) in ellipses.items():
        print(f"deviations, {name} {np.sqrt(np.diag(found)).round(5)} m")
    sizes = np.sqrt(np.diag(covariance))
    # 2.4 per cent of a deviation are left out; an estimated variance has the deviation √(2/count) of itself
    assert np.all(np.abs(covariance - first_order()) < (0.05 + 4 * np.sqrt(2 / options.count)) * np.outer(sizes, sizes))
    print(f"peak of memory      {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB")
    if options.figure:
        picture(options.figure, moved[:3000].compute(), ellipses)


if __name__ == "__main__":
    main()
