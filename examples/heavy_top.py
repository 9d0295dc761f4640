"""A heavy top by Lie-group generalized-α
======================================

Run ``python examples/heavy_top.py [--figure FILE]``.

The benchmark of Brüls, Cardona and Arnold (Mech. Mach. Theory 48, 2012): a top on a fixed point, sideways, spun at
150 rad/s. Unknowns are the pose of its centre of mass and the reaction λ at the fixed point. A model by rotations alone
would not contain λ. The axes of all motions pass through the fixed point: this is linear in v, and holds to rounding.

Each step is described in the frame of the body at its start; v is the motion since then. Inertia is a wrench z in the
moving frame, weight and reaction are a wrench w in the frame of the step. Their generalized forces balance: T z = Tᵀ w.
T depends on v, so Newton's method needs the derivatives of both sides at fixed wrenches, the cotangent Jacobians.

.. image:: /figures/heavy_top.svg
"""

# sphinx_gallery_thumbnail_path = 'reference/generated/thumbnail_heavy_top.svg'

import argparse
from collections import namedtuple
from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from dualcay import cayley1, cayley2, exponential, matrix6

CHARTS = {"n = 1": cayley1, "n = 2": cayley2, "exponential": exponential}
STEPS = (4e-3, 2e-3, 1e-3, 5e-4)  # s
UNIT, ZERO = np.eye(3), np.zeros((3, 3))
MASS, INERTIA, WEIGHT = 15.0, np.diag([0.234375, 0.46875, 0.234375]), np.array([0, 0, -15 * 9.81])  # kg, kg m², N
ARM, SPIN = np.array([0.0, 1, 0]), np.array([0, 150, -4.61538])  # from fixed point to centre (m), rad/s: at t = 0
ABOUT = INERTIA + MASS * (UNIT - np.outer(ARM, ARM))  # inertia about the fixed point
MOMENTUM = np.block([[ZERO, MASS * UNIT], [INERTIA, ZERO]])  # from twist [ω, v] to momentum and angular momentum
REACTION = np.vstack([UNIT, np.cross(ARM, UNIT)])  # from force at the fixed point, −ARM in the step's frame, to wrench
AM, AF, GAMMA, BETA = 1 / 3, 4 / 9, 11 / 18, 25 / 81  # generalized-α of spectral radius 0.8
TOLERANCE = 1e-11  # of the balance; a = v/(βh²) has a rounding error of 3e-13 of itself for h = 0.5 ms
State = namedtuple("State", "pose twist accel a reaction")  # twist, its derivative, a: body frame; reaction: space, N


def euler(_: float, y: np.ndarray) -> np.ndarray:
    """Return the derivatives of Q and ω by Euler's equation of rotation about the fixed point."""
    Q, omega = y[:9].reshape(3, 3), y[9:]
    moment = np.cross(ARM, WEIGHT @ Q) - np.cross(omega, ABOUT @ omega)
    return np.concatenate([(Q @ np.cross(UNIT, omega)).ravel(), np.linalg.solve(ABOUT, moment)])


def moved(state: State, step: np.ndarray, h: float) -> tuple[np.ndarray, ...]:
    """Return twist, derivative and a after a step, h times the mean twist; they are affine in it."""
    a = ((step / h - state.twist) / h - (0.5 - BETA) * state.a) / BETA
    accel = ((1 - AM) * a + AM * state.a - AF * state.accel) / (1 - AF)
    return state.twist + h * (1 - GAMMA) * state.a + h * GAMMA * a, accel, a


def balance(chart: Any, state: State, v: np.ndarray, force: np.ndarray, h: float, full: bool) -> tuple[np.ndarray, ...]:
    """Return T z, its excess over Tᵀ w with the gap at the fixed point, and their derivative by v and the force."""
    scale, T, transposed = chart.tangent(v * 0)[0, 0, 0], matrix6(chart.tangent(v)), matrix6(chart.body_tangent(v))
    twist, accel, _ = moved(state, scale * v, h)
    turn, by_turn = (matrix6(np.cross(UNIT, a.reshape(2, 1, 3))) for a in (twist, MOMENTUM @ twist))
    z = MOMENTUM @ accel + turn @ MOMENTUM @ twist
    z_by_v = scale / (BETA * h) * ((1 - AM) / (1 - AF) / h * MOMENTUM + GAMMA * (turn @ MOMENTUM - by_turn))
    weight, (centre_by_v, _) = WEIGHT @ state.pose[:3, :3], chart.transform_point_jacobians(v, np.zeros(3))
    w = REACTION @ force + np.concatenate([weight, np.cross(chart.pose(v)[:3, 3], weight)])
    by_v = T @ z_by_v - transposed[:, 3:] @ np.cross(weight, UNIT) @ centre_by_v
    if full:
        by_v += chart.body_cotangent_jacobian(v, z) - chart.cotangent_jacobian(v, w)
    gap, (gap_by_v, _) = chart.transform_point(v, -ARM) + ARM, chart.transform_point_jacobians(v, -ARM)
    matrix = np.block([[by_v, -transposed @ REACTION], [gap_by_v, ZERO]])
    return T @ z, np.concatenate([T @ z - transposed @ w, gap]), matrix


def simulate(chart: Any, h: float, end: float, full: bool = True) -> tuple[list[State], float]:
    """Return the states and the mean number of Newton iterations, with or without cotangent Jacobians."""
    scale, steps, total = chart.tangent(np.zeros(6))[0, 0, 0], round(end / h), 0
    at_start = SPIN, euler(0, np.concatenate([UNIT.ravel(), SPIN]))[9:]
    twist, accel = (np.concatenate([a, np.cross(a, ARM)]) for a in at_start)
    states = [State(np.block([[UNIT, ARM[:, None]], [0, 0, 0, 1]]), twist, accel, accel, np.zeros(3))]
    while len(states) <= steps:
        state, Q = states[-1], states[-1].pose[:3, :3]
        v, force = h * (state.twist + h / 2 * state.a) / scale, state.reaction @ Q
        inertia, excess, matrix = balance(chart, state, v, force, h, full)
        while np.abs(excess).max() > TOLERANCE * np.abs(inertia).max():
            change, total = np.linalg.solve(matrix, -excess), total + 1
            v, force = v + change[:6], force + change[6:]
            inertia, excess, matrix = balance(chart, state, v, force, h, full)
            if total > 20 * len(states):
                raise ArithmeticError(f"Newton's method did not converge at h = {h} s")
        states.append(State(state.pose @ chart.pose(v), *moved(state, scale * v, h), Q @ force))
    return states, total / steps


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="A heavy top by Lie-group generalized-α")
    parser.add_argument("--end", type=float, default=0.5, help="time simulated (s)")
    parser.add_argument("--figure", help="file for the picture")
    options, found = parser.parse_args(argv), {}
    y = solve_ivp(euler, (0, options.end), [*UNIT.ravel(), *SPIN], method="DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    Q, omega, alpha = y[:9].reshape(3, 3), y[9:], euler(0, y)[9:]
    reaction = MASS * Q @ (np.cross(alpha, ARM) + np.cross(omega, np.cross(omega, ARM))) - WEIGHT
    print("chart        h (ms)  error (m)  error of λ (N)  energy change  iterations  without Jacobians")
    for name, h in product(CHARTS, STEPS):
        (states, count), (_, plain) = (simulate(CHARTS[name], h, options.end, full) for full in (True, False))
        energy = np.array([s.twist @ np.roll(MOMENTUM @ s.twist, 3) / 2 - WEIGHT @ s.pose[:3, 3] for s in states])
        error, drift = found[name, h] = np.linalg.norm(states[-1].pose[:3, 3] - Q @ ARM), energy / energy[0] - 1
        print(f"{name:11} {1e3 * h:7} {error:10.2e} {np.linalg.norm(states[-1].reaction - reaction):15.2e}", end="")
        print(f" {np.ptp(drift):14.1e} {count:11.2f} {plain:18.2f}")
        assert h > 1e-3 or count < plain - 0.5  # with cotangent Jacobians Newton's matrix is the whole derivative
        assert max(np.abs(s.pose[:3, :3] @ ARM - s.pose[:3, 3]).max() for s in states) < 1e-15 * len(states) + 1e-14
    for name in CHARTS:  # of order 2; the next term is smaller by (Ω h)², at most 2 % here
        assert abs(found[name, STEPS[-2]][0] / found[name, STEPS[-1]][0] - 4) < 0.1
    if options.figure:
        from matplotlib.figure import Figure

        figure = Figure(figsize=(8.2, 4), layout="constrained")
        left, right = figure.subplots(1, 2)
        for name in CHARTS:
            left.loglog(STEPS, [found[name, h][0] for h in STEPS], "o-", label=name)
            right.plot(np.linspace(0, options.end, len(found[name, 1e-3][1])), found[name, 1e-3][1], label=name)
        left.loglog(STEPS, np.square(STEPS) * 1e5, "k:", label="order 2")
        left.set(xlabel="step h (ms)", ylabel="error of the centre of mass (m)")
        left.set_xticks(STEPS, [f"{1e3 * h:g}" for h in STEPS])
        left.tick_params(axis="x", which="minor", labelbottom=False)
        right.set(xlabel="time (s)", ylabel="relative change of energy, h = 1 ms")
        left.legend()
        figure.savefig(options.figure, metadata={"Date": None})


if __name__ == "__main__":
    main()
