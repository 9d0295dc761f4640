"""Tracing: selections are folded, shared values have unique names, and printing keeps the order of evaluation."""

from __future__ import annotations

from fractions import Fraction

import pytest

from derive.codegen.programs.trace import Trace
from derive.codegen.signatures import ROTATIONS, lower_chart, printed_geometry
from derive.codegen.targets import expression
from derive.maps import Cayley

pytestmark = pytest.mark.smoke


def traced(count: int = 2):
    trace = Trace()
    return trace, *trace.inputs("v", [f"v{i}" for i in range(1, count + 1)])


def test_selection_on_constants_is_folded():
    trace, a, b = traced()
    assert trace.where(trace.less(0, 1), a, b) is a
    assert trace.both(trace.equal(1, 2), trace.less(a, b)) is False
    assert trace.either(False, True) is True


def test_division_by_constant_0_is_an_error():
    _, a, _ = traced()
    with pytest.raises(ZeroDivisionError, match="divides by the constant 0"):
        a / 0


def test_shared_value_needs_a_name_that_is_unique():
    trace, a, b = traced()
    shared = a + b
    with pytest.raises(ValueError, match="'f' uses unnamed values more than once or in a call: add"):
        trace.program("f", (shared * a, shared / b))
    trace.name("ab", shared)
    with pytest.raises(ValueError, match="'ab' is already taken"):
        trace.name("ab", a - b)
    with pytest.raises(ValueError, match="'short' is already taken in this program, or is a keyword"):
        trace.name("short", a - b)


def test_printing_keeps_the_order_of_evaluation():
    trace, a, b = traced()
    for value, text in [
        (a * (b / a), "v1 * (v2 / v1)"),
        (a - (b - a), "v1 - (v2 - v1)"),
        (a / (a * b), "v1 / (v1 * v2)"),
        (-(a + b) * a, "-(v1 + v2) * v1"),
        (a / Fraction(2, 3), "3 * v1 / 2"),
        (Fraction(2, 3) / a, "2 / (3 * v1)"),
        (trace.where(trace.both(trace.less(a, b), trace.equal(a, 0)), a, b), "m.where((v1 < v2) & (v1 == 0), v1, v2)"),
    ]:
        assert expression.body(trace.program("f", (value,))).splitlines()[-1] == f"    return {text},"


def test_call_is_recorded_once_and_needs_named_arguments():
    trace, a, b = traced()
    first, second = trace.call("scalars", (a, b), ("f", "g"))
    again, _ = trace.call("scalars", (a, b), ("f", "g"))
    assert again.index == first.index
    program = trace.program("f", (first * a, second))
    (call,) = program.calls
    assert (call.names, call.function, call.args) == (("f", "g"), "scalars", ("v1", "v2"))
    assert "    f, g = c.scalars(m, v1, v2)" in expression.body(program).splitlines()
    trace, a, b = traced()
    (result,) = trace.call("scalars", (a * b,), ("f",))
    with pytest.raises(ValueError, match="in a call: mul"):
        trace.program("f", (result,))


def test_wrapped_statement_computes_the_same():
    trace, *inputs = traced(12)
    value = trace.name("total", sum((a * a * a * a for a in inputs[1:]), inputs[0]))
    program = trace.program("f", (value, *(a + value for a in inputs)))
    source = expression.body(program)
    assert max(map(len, source.splitlines())) <= expression.WIDTH
    space: dict = {}
    exec(f"def f(v):\n{source}", space)
    numbers = list(range(12))
    total = sum(n**4 for n in numbers)
    assert space["f"](numbers) == (total, *(n + total for n in numbers))


@pytest.mark.parametrize("order", [1, 2, 3, 4, 6, 7, 8, 9, 16, 33])
def test_every_recipe_names_its_values(order):
    lowered = lower_chart(Cayley(order))
    for name, program in (*lowered.scalars.items(), *printed_geometry().items(), *printed_geometry(ROTATIONS).items()):
        assert program.name == name
        assert not [step.name for step in program.steps if not step.inline and step.name.startswith("t_")]


def test_forward_maps_have_no_trigonometry():
    forward = ("quaternion", "tensor", "pose", "tangent", "tangent_inv", "twist", "rate", "transform_point")
    inverse = ("from_quaternion", "from_tensor", "from_pose", "shadow", "turn", "compose")
    for order in (1, 2, 3, 4, 5, 8):
        chart = Cayley(order)
        # such a chart has one v for each pose: `shadow` and `turn` are trivial and have no program
        unasked = {"shadow", "turn"} if chart.branches == 1 else set()
        names = {*forward, *(inverse if order in (1, 2, 4, 8) else ())} - unasked
        operations = lower_chart(chart).operations
        for name in names:
            assert not {"tan", "atan2"} & set(operations[name]), (order, name)
