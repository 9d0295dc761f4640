ROTATIONS = {(6,): (3,), (8,): (4,), (4, 4): (3, 3), (2, 3, 3): (3, 3)}
"""Component axes for rotations alone, by those for poses."""


def shape_error(name: str, part: tuple[int, ...], axis: int, shape: tuple[int, ...]) -> ValueError:
    """Return the error of an argument with wrong component axes; for rotations alone it names their modules."""
    inner = ", ".join(map(str, part))
    expected = f"({inner}, ...)" if axis == 0 else f"(..., {inner})"
    alone = ROTATIONS.get(part, (0,))
    given = shape[: len(alone)] if axis == 0 else shape[-len(alone) :]
    further = f"; rotations alone: {__package__}.rotation" if given == alone else ""
    return ValueError(f"{name} must have shape {expected}, got {shape}{further}")
