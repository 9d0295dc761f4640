@dataclass(frozen=True, slots=True)
class Law:
    """Condition of an argument: the name, shape and noun of the argument, and the violations of the condition.

    ``violations`` yields groups of residues of the components, each with a message. Residues of dual parts are relative
    to 1 + the sum of absolute values of their components.
    """

    argument: str
    part: Shape
    noun: str
    violations: Callable[[Components], Iterator[tuple[str, list[Any]]]]


def _unit(u: Components) -> Iterator[tuple[str, list[Any]]]:
    yield "its square is not 1", [_dot(u, u) - 1]


def _quaternion(q: Components) -> Iterator[tuple[str, list[Any]]]:
    e, eo = q[:4], q[4:]
    yield "the square of its real part is not 1", [_dot(e, e) - 1]
    yield "its dual part is not perpendicular to its real part", [_dot(e, eo) / _size(eo)]


def _tensor(R: Components) -> Iterator[tuple[str, list[Any]]]:
    Q, D = _rows(R[:9]), _rows(R[9:])
    yield from _rotation(R[:9])
    size = _size(R[9:])
    pairs = [(i, j) for i in range(3) for j in range(i + 1)]
    yield "its dual part times Qᵀ is not skew", [(_dot(D[i], Q[j]) + _dot(D[j], Q[i])) / size for i, j in pairs]


def _pose(T: Components) -> Iterator[tuple[str, list[Any]]]:
    yield from _rotation([*T[0:3], *T[4:7], *T[8:11]])
    yield "its last row is not [0, 0, 0, 1]", [T[12], T[13], T[14], T[15] - 1]


def _line(u: Components) -> Iterator[tuple[str, list[Any]]]:
    direction, moment = u[:3], u[3:]
    yield "the square of its direction is not 1", [_dot(direction, direction) - 1]
    yield "its moment is not perpendicular to its direction", [_dot(direction, moment) / _size(moment)]


def _rotation(entries: Components) -> Iterator[tuple[str, list[Any]]]:
    Q = _rows(entries)
    pairs = [(i, j) for i in range(3) for j in range(i + 1)]
    yield "Q Qᵀ is not I", [_dot(Q[i], Q[j]) - int(i == j) for i, j in pairs]
    (a, b, c), (d, e, f), (g, h, i) = Q
    yield "det Q is not 1", [a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) - 1]


def _rows(entries: Components) -> list[Components]:
    return [entries[i : i + 3] for i in (0, 3, 6)]


def _dot(a: Components, b: Components) -> Any:
    first, *others = (x * y for x, y in zip(a, b, strict=True))
    return sum(others, start=first)


def _size(components: Components) -> Any:
    first, *others = map(abs, components)
    return sum(others, start=1 + first)


LAWS = {
    "from_quaternion": Law("q", (8,), "unit dual quaternion", _quaternion),
    "from_tensor": Law("R", (2, 3, 3), "orthogonal dual tensor of determinant 1", _tensor),
    "from_pose": Law("T", (4, 4), "homogeneous matrix of a rotation and a translation", _pose),
    "from_screw": Law("line", (6,), "unit dual vector", _line),
}
"""Conditions on arguments of functions of poses, by function name."""

ROTATION_LAWS = {
    "from_quaternion": Law("q", (4,), "unit quaternion", _unit),
    "from_tensor": Law("R", (3, 3), "orthogonal matrix of determinant 1", _rotation),
    "from_angle_axis": Law("u", (3,), "unit vector", _unit),
}
"""Conditions on arguments of functions of rotations, by function name."""


def require(law: Law, value: Any, axis: int, check: Any = True, start: Shape = ()) -> None:
    """Raise an error unless an argument meets its condition, as the keyword ``check`` of a function asks.

    An argument that is a block of a larger batch has a start there, which counts in the index of the message.

    Raises
    ------
    ValueError
        If an element violates it. The message names the first one, its largest violation, and the allowed one.
    """
    asked = _asked(check)
    if asked is False:
        return
    usual, components = _given(law, value, axis)
    allowed = usual if asked is True else asked
    with silent():
        groups = ((words, residue) for words, residues in law.violations(components) for residue in residues)
        found = [(*first, words) for words, residue in groups if (first := _first_above(residue, allowed))]
    if found:
        # first element, then largest violation; NaN counts as the largest
        index, violation, words = min(found, key=lambda at: (at[0], -at[1] if at[1] == at[1] else -inf))
        place = _place(tuple(map(sum, zip(index, start))) if start else index, axis)
        raise ValueError(
            f"{law.argument}{place} is no {law.noun}: {words}, off by {violation:.2g} (allowed {allowed:.3g})"
        )


def _asked(check: Any) -> bool | float:
    """Return the keyword ``check`` as a bool, or as the largest violation allowed."""
    if type(check).__name__ in ("bool", "bool_"):  # of Python or NumPy
        return bool(check)
    if not isinstance(check, Real):
        raise TypeError(f"check must be a bool or a number, the largest violation allowed, got {check!r}")
    allowed = float(check)
    if not allowed >= 0:
        raise ValueError(f"check must be at least 0, got {check!r}")
    return allowed


def _place(index: Shape, axis: int) -> str:
    """Return the index of a batch element as text to follow a variable name."""
    numbers = [*(["..."] if axis == 0 else []), *map(str, index)]
    return f"[{', '.join(numbers)}]" if index else ""
