ROTATIONS = {(6,): (3,), (8,): (4,), (4, 4): (3, 3), (2, 3, 3): (3, 3)}
"""Component axes for rotations alone, by those for poses."""


def shape_error(name: str, part: tuple[int, ...], axis: int, shape: tuple[int, ...]) -> ValueError:
    """Return the error of an argument with wrong component axes; it names the other axis, or modules of rotations."""
    inner, size = ", ".join(map(str, part)), len(part)
    expected = f"({inner}, ...)" if axis == 0 else f"(..., {inner})"
    alone, further = ROTATIONS.get(part, (0,)), ""
    if (shape[-size:] if axis == 0 else shape[:size]) == part:
        further = f"; components {'last: axis=-1' if axis == 0 else 'first: axis=0'}"
    elif (shape[: len(alone)] if axis == 0 else shape[-len(alone) :]) == alone:
        further = f"; rotations alone: {__package__}.rotation"
    return ValueError(f"{name} must have shape {expected}, got {shape}{further}")


def absent(text: str) -> Exception:
    """Return the error of a name that a module lacks: an ImportError for ``from … import``, which hides other texts."""
    asking = sys._getframe(2)
    by_import = asking.f_code.co_code[asking.f_lasti] == opmap["IMPORT_FROM"]
    return (ImportError if by_import else AttributeError)(text)
