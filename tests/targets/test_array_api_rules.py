"""Rules of differentiation: they are differences of their functions; under JAX, chains of calls compile once."""

from __future__ import annotations

import ast
from functools import partial

import numpy as np
import pytest

import dualcay
from derive.codegen.lowering.scalar_programs import SCALARS
from derive.codegen.signatures import SIDES
from derive.output import pages
from tests.support import sampling, traced
from tests.support.libraries import LIBRARIES, jax


@pytest.fixture(scope="module", autouse=True)
def double_precision():
    LIBRARIES["jax"]()


def arguments():
    """Return two vectors with rotation angles below half a turn in all charts, then two rates."""
    v2, v1, rate2, rate1 = (sampling.dual_vectors(f"rules {i}") for i in range(4))
    return [np.tanh(v2) / 10, np.tanh(v1) / 8, rate2, rate1]


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


# --- rules run on NumPy arrays ------------------------------------------------------------------------------------

STEP = 2.0**-11
NEARLY = 1e-8
"""Error of a difference of fourth order: STEP⁴/30 ≈ 2e-15 times a fifth derivative up to 1e6, and eps/STEP ≈ 5e-13."""

SIDED = {"twist": (SIDES["SPACE"], SIDES["BODY"]), "rate": (SIDES["SPACE_INV"], SIDES["BODY_INV"])}
"""Tables of kernels that take a side; turns are those of a chart, and others take none."""

OF_AXIS = ("turn", "shadow")
"""Kernels of one vector and a turn. They have no derivative at rest; a turn is of principal vectors alone."""

LEFT_OUT = {("turn", "at rest"), ("shadow", "at rest"), ("turn", "beyond")}

RULED_CHARTS = pytest.mark.parametrize("chart", ["cayley3", "exponential", "sine3", "rotation.cayley3"])


def difference(function, values, rates):
    """Return the difference quotient of a function along the rates of its arguments."""

    def at(steps):
        return function(*(v + steps * STEP * rate for v, rate in zip(values, rates, strict=True)))

    return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * STEP)


def places(module, n):
    """Return pairs of unequal vectors: at rest, near the identity, and beyond half a turn."""
    near, other = (np.array(row[:n]) for row in ((0.2, -0.1, 0.15, 0.3, -0.2, 0.5), (-0.1, 0.25, 0.3, 0.1, 0.4, -0.6)))
    far = module.from_exponential(np.array([2.0, -3.0, 1.5, 0.4, 0.7, -0.3][:n]))
    return {"at rest": (0 * near, 0 * other), "near": (near, other), "beyond": (far, near)}


@RULED_CHARTS
def test_each_rule_is_the_difference_of_its_kernel(charts, chart):
    rules, call, module = charts("_rules"), charts("_chart").Call, charts(chart)
    n, turns = 3 if chart.startswith("rotation") else 6, module.CHART.turns[-1:]
    tables = dict.fromkeys((*rules.RULES, *rules.JACOBIANS), ((),)) | SIDED
    tables |= {**dict.fromkeys(OF_AXIS, turns), "principal": (module.CHART.returns,)}
    draw = np.random.default_rng(7).normal
    for regime, vectors in places(module, n).items():
        for name in (name for name in tables if (name, regime) not in LEFT_OUT):
            arguments = module.CHART.kernels[name].arguments[: 1 if name in OF_AXIS else None]
            shapes = [shape for _, shape in arguments]
            values = [*vectors, np.array(0.375)][: len(shapes)]
            rates = [draw(size=shape) for shape in shapes]
            for table in tables[name]:
                asked = call(module.CHART, name, arguments, table)
                if name in rules.JACOBIANS:
                    found = rules.columns(rules.Motions(module.CHART), rules.JACOBIANS[name], values)
                    expected = rules.value_of(asked, *values)
                else:
                    found = rules.slope_of(asked, rules.value_of(asked, *values), values, rates)
                    expected = difference(lambda *at, asked=asked: rules.value_of(asked, *at), values, rates)
                error = np.max(abs(found - expected)) / np.max(abs(expected))
                assert error < NEARLY, (name, regime, error)


def along_a_ray(m, chart, length):
    """Return arguments of scalar programs, by name, at a multiple of an axis; an angle alone has the same value."""
    (angle,) = chart.scalars.unfolded(m, length**2, length)
    _, _, known = chart.scalars.coefficient(m, angle)
    squares = dict(zip(SCALARS["pose_scalars"].arguments, (0.5, 0.375, 0.125), strict=True))
    return {name: share * length**2 for name, share in squares.items()} | {
        "x": length**2, "r": length, "alpha": length, "angle": known, "fe": length / np.tan(angle / 2),
        "y": 0 * length + 0.2, "e0": np.cos(length / 2), "size": 1 + 0 * length,
        **{f"e{k}": u * np.sin(length / 2) for k, u in ((1, 0.48), (2, -0.6), (3, 0.64))},
    }  # fmt: skip


@RULED_CHARTS
def test_slopes_are_differences_of_scalar_programs_along_a_ray(charts, chart):
    """Weigh every column of a rule's rows; a ray alone is differentiated at a constant size, not along a path."""
    slopes, chart = charts("_slopes"), charts(chart).CHART
    m, edge = charts("_libraries").functions_of("x", np.ones(1)), chart.scalars.coefficient
    programs, bare = slopes.Ruled(chart), charts("_libraries").functions_of("x", np.ones(1))
    bare.held = lambda a: 0 * a  # leaves the values of the expressions that give last results their derivatives
    for angle in (0.3, 1.0, 4.0):
        length = np.array([edge(m, np.array([angle]))[0][0]])
        for name, rule in slopes.SLOPES.items():
            if rule is None or name == "ray":
                continue

            def given(r, name=name):
                found = along_a_ray(m, chart, r)
                return [found[argument] for argument in SCALARS[name].arguments]

            def value(r, name=name, given=given):
                return np.stack([0 * r + one for one in getattr(chart.scalars, name)(m, *given(r))])

            found, at = getattr(chart.scalars, name)(m, *given(length)), given(length)
            last = slopes.LAST.get(name, lambda *_: ())(bare, chart.scalars, lambda *_, found=found: found, found, at)
            constant = (
                name == "tangent_dot_scalars"
                and angle > 2
                and not hasattr(programs.rate_scalars(m, length)[0], "shape")
            )
            ends = 0 if constant else len(last)  # at a constant rate and obtuse angles the last result has a slope too
            for one, other in zip(last, found[len(found) - len(last) :], strict=True):
                assert np.allclose(one, other, NEARLY, NEARLY), (name, angle)
            rates = difference(lambda r, given=given: np.stack(given(r)), [length], [1.0])
            expected = difference(value, [length], [1.0])[: len(found) - ends]
            rows = rule(m, programs, found, at)[: len(expected)]
            total = np.stack([sum(part * rate for part, rate in zip(row, rates, strict=True)) for row in rows])
            assert np.max(abs(total - expected)) < NEARLY * max(1, np.max(abs(expected))), (name, angle)


@RULED_CHARTS
def test_slopes_of_shares_are_differences(charts, chart):
    """Take squares on both sides of the limit between the two forms of a share's slopes."""
    slopes, chart = charts("_slopes"), charts(chart).CHART
    m = charts("_libraries").functions_of("x", np.ones(1))
    programs = slopes.Ruled(chart), slopes.Ruled(slopes.STEPS)
    for angle in (0.3, 1.5, 2.5):
        length = chart.scalars.coefficient(m, np.array([angle]))[0]
        for name, square in (("share_of_square", length**2), ("share_of_angle", np.array([angle**2]))):
            share = partial(getattr(slopes, name), m, *programs)
            _, slope, second, *bend = share(square)
            found = np.stack([0 * square + one for one in (slope, second, *bend)])

            def value(u, name=name, share=share):
                further = getattr(slopes, f"_{name}")(m, *programs, u) if name == "share_of_angle" else ()
                return np.stack([0 * u + one for one in (*share(u)[:2], *further[1:])])

            expected = 2 * difference(value, [square], [1.0])
            assert np.max(abs(found - expected)) < NEARLY * max(1, np.max(abs(expected))), (name, angle)


def test_jax_and_pytorch_have_the_same_functions_of_rules():
    """Compare parameters in the text, which needs neither library."""
    found = []
    for file in ("_jax.py", "_torch.py"):
        body = ast.parse(pages.generated(f"array-api/{file}", "")).body
        found.append({f.name: [a.arg for a in f.args.args] for f in body if isinstance(f, ast.FunctionDef)})
    for name in ("held", "carry", "ruled", "unruled", "derivative"):
        assert found[0][name] == found[1][name], name


BY_TEXT = {"beyond", "coefficient_of", "followed", "inverse_at", "tangent_inv_at", "turned"}
"""Scalar programs that are differentiated by their text."""


def test_other_scalar_programs_have_rules(charts):
    """Expect a rule for each: texts of roots and angles may lose digits once differentiated."""
    assert set(SCALARS) - set(charts("_slopes").SLOPES) == BY_TEXT


def test_scalar_programs_are_differentiated_by_their_rules_in_jax(charts, monkeypatch):
    """Take a rule with another slope, which the text of the program does not have."""
    monkeypatch.setitem(charts("_slopes").SLOPES, "rate_scalars", lambda *_: [(7,)])
    x, chart = jax.numpy.array([0.5]), charts("cayley3").CHART
    m = charts("_libraries").functions_of("x", x)
    (found,) = jax.jvp(lambda x: m.scalars(chart).rate_scalars(m, x), (x,), (x / x,))[1]
    assert found == 7


@pytest.mark.parametrize(("dtype", "size"), [(np.float64, 1e-300), (np.float32, 1e-25)])
def test_an_angle_has_its_gradient_and_hessian_where_squares_underflow(charts, dtype, size):
    """Compare with α = 6|v|, of which third and higher powers of v are lost."""
    u = np.array([2, -2, 1]) / 3
    at, angle = (u * size).astype(dtype), charts("rotation.cayley3").angle
    first, second = traced.run(lambda v: (jax.grad(angle)(v), jax.jacfwd(jax.grad(angle))(v)), at)
    np.testing.assert_allclose(first, 6 * u, rtol=0, atol=100 * np.finfo(dtype).eps)
    across = 6 * (np.eye(3) - np.outer(u, u))
    np.testing.assert_allclose(second * dtype(size), across, rtol=0, atol=1000 * np.finfo(dtype).eps)


@pytest.mark.parametrize("mode", [pytest.param("jacfwd", marks=pytest.mark.thorough), "jacrev"])
def test_six_calls_share_the_text_of_one(charts, mode, monkeypatch):
    """Allow a tenth more text than one call has: it grows without rules, and more where calls share no text."""
    function, at = charts("rotation.cayley2").compose, [value[0, :3] for value in arguments()[:2]]

    def growth():
        one, six = (text(getattr(jax, mode)(chain(function, count)), *at) for count in (1, 6))
        return six / one

    assert growth() < 1.1
    monkeypatch.setattr(charts("_rules"), "RULES", {})
    assert growth() > 1.4
    monkeypatch.setattr(charts("_jax"), "unruled", lambda *asked: partial(charts("_rules").text_of, *asked))
    assert growth() > 4


def test_compiled_functions_multiply_about_as_often_as_their_programs(charts, monkeypatch):
    """Count products and quotients that XLA runs for two compositions; without stored values it repeats far more.

    XLA divides by constants by products, and its own inverse tangent adds some to those of the program.
    """
    module, given = charts("cayley3"), arguments()[:2]

    def ratio():
        lowered = jax.jit(chain(module.compose, 2)).lower(*given)
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


@pytest.mark.parametrize(("axis", "dtype"), [(-1, np.float64), (0, np.float32)])
def test_gradients_of_arguments_that_broadcast_are_sums(charts, axis, dtype):
    """Allow some hundred roundings of the weighted sum of all compositions' Jacobians."""
    v2, v1, weights, _ = arguments()

    def loss(a, b):
        pair = (a[:, None], b) if axis else (a.T[:, :, None], b.T[:, None])
        return (jax.numpy.moveaxis(charts("cayley3").compose(*pair, axis=axis), axis, -1) * weights.astype(dtype)).sum()

    found = traced.run(jax.grad(loss, (0, 1)), v2.astype(dtype), v1.astype(dtype))
    for one, J, row in zip(found, dualcay.cayley3.compose_jacobians(v2[:, None], v1), "ij", strict=True):
        expected = np.einsum(f"ijab,ja->{row}b", J, weights)
        assert one.dtype == dtype
        np.testing.assert_allclose(one, expected, rtol=0, atol=2000 * np.finfo(dtype).eps * abs(expected).max())


def test_a_batch_that_does_not_broadcast_names_both_arguments(charts):
    with pytest.raises(ValueError, match=r"\(2,\) of v and \(3,\) of z"):
        charts("cayley3").cotangent(jax.numpy.ones((2, 6)), jax.numpy.ones((3, 6)))
