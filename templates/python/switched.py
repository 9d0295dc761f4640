

def switched(
    kernels: Any, axis: int, v: ArrayLike, v_dot: ArrayLike | None, covariance: ArrayLike | None
) -> Array | tuple[Array, ...]:
    """Return the principal vector, the rate and the covariance; the arguments themselves if nothing changes."""
    n = len(kernels.identity())
    array = as_array("v", v, (n,), axis, real=True)
    rate = None if v_dot is None else as_array("v_dot", v_dot, (n,), axis, real=True)
    spread = None if covariance is None else as_array("covariance", covariance, (n, n), axis, real=True)
    if spread is not None:
        require_symmetric("covariance", spread, (0, 1) if axis == 0 else (-2, -1))
    moved = kernels.principal(array, axis=axis)
    with np.errstate(invalid="ignore"):
        changed = np.any((moved != array) | (array - array != 0), axis=axis, keepdims=True)
    if not changed.any():
        moved = array
    else:
        if rate is not None:
            rate = np.where(changed, kernels.rate(moved, kernels.twist(array, rate, axis=axis), axis=axis), rate)
        if spread is not None:
            spread = np.where(np.expand_dims(changed, axis), _spread(kernels, axis, array, moved, spread), spread)
    found = (moved, *(value for value in (rate, spread) if value is not None))
    return found if len(found) > 1 else moved


def require_symmetric(name: str, P: Array, axes: tuple[int, int] = (-2, -1)) -> None:
    """Raise ValueError unless matrices are symmetric but for rounding errors; NaN passes."""
    with np.errstate(all="ignore"):
        if (P.swapaxes(*axes) == P).all():  # a tenth of the time of what follows
            return
        off = abs(P - P.swapaxes(*axes))
        wrong = off * precision(P) > abs(P).sum(axes, keepdims=True)
    if wrong.any():
        raise ValueError(f"{name} must be symmetric, got entries that differ by {max(off[wrong]):g}")


def precision(P: Array) -> int:
    """Return the sum of absolute entries over the rounding error that a covariance of this type may have."""
    return int(2.0**-12 / np.finfo(P.dtype if P.dtype.kind == "f" else np.float64).eps)


def _spread(kernels: Any, axis: int, v: Array, moved: Array, covariance: Array) -> Array:
    """Return ``J P Jᵀ`` by two passes over columns, ``J x = T(moved)⁻¹ T(v) x``."""
    place, swap = (1, (0, 1)) if axis == 0 else (-2, (-1, -2))
    v, moved = np.expand_dims(v, place), np.expand_dims(moved, place)
    for _ in range(2):
        covariance = kernels.rate(moved, kernels.twist(v, covariance, axis=axis), axis=axis).swapaxes(*swap)
    return covariance
