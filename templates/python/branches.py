DECIMALS = Context(prec=50)
"""Decimal arithmetic for the turn angle of charts with infinitely many branches."""


def turn_of(chart: Chart, branch: int) -> tuple[str, ...]:
    """Return the pair of numbers for the turn by ``branch`` branches, as decimals; an empty tuple for no turn.

    The branch is taken modulo the number of branches. With infinitely many branches, the pair is 1 and an angle.

    Raises
    ------
    TypeError
        If branch is not an integer.
    """
    try:
        index = operator.index(branch)
    except TypeError:
        raise TypeError(f"branch must be an integer, got {branch!r}") from None
    if chart.branches:
        index %= chart.branches
        return chart.turns[index] if index else ()
    one, angle = chart.turns[0]
    return (one, str(DECIMALS.multiply(index, Decimal(angle)))) if index else ()


def call_branch(chart: Chart, name: str, branch: int, *given: Any) -> Array:
    """Run an inverse map, then turn its principal vector to the given branch."""
    turn = turn_of(chart, branch)
    v = call(chart, name, *given)
    return call(chart, "turn", *given[:-1], v, table=turn) if turn else v


def shifted(chart: Chart, branch: int, *given: Any) -> Array:
    """Return the shadow of v after ``branch`` branches; v itself for branch 0."""
    turn = turn_of(chart, branch)
    return call(chart, "shadow", *given, table=turn) if turn else stayed(chart, *given)


def shifted_jacobian(chart: Chart, branch: int, *given: Any) -> Array:
    """Return the derivative by v of the shadow after ``branch`` branches; the unit matrix for branch 0."""
    turn = turn_of(chart, branch)
    return call(chart, "shadow_jacobian" if turn else "identity_jacobian", *given, table=turn)


def returned(chart: Chart, *given: Any) -> Array:
    """Return the vector on the principal branch; v itself if the chart has one branch only."""
    return call(chart, "principal", *given, table=chart.returns) if chart.returns else stayed(chart, *given)


def stayed(chart: Chart, *given: Any) -> Array:
    """Return v itself; NaN beyond the end of the chart."""
    return call(chart, "stay", *given) if chart.ends else unchanged(chart, *given)
