"""Emitted programs proved equal to their definitions by Coq, from the text on disk.

Geometry programs are proved once for every chart: the results of scalar programs are any numbers. Scalar programs are
proved for some orders of the Cayley map. Together they make every function of these orders equal to its definition.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

from .terms import CText, Program, PythonText, number, product

ORDERS = (1, 2, 3, 5)
"""Orders of the Cayley map whose scalar programs are proved."""

V, U = ("v1", "v2", "v3", "v1o", "v2o", "v3o"), ("u1", "u2", "u3", "u1o", "u2o", "u3o")
SQUARES = "(v1 v * v1 v) (v2 v * v2 v) (v3 v * v3 v)"
X = "(dot (vdual v vo) (vdual v vo))"


@dataclass(frozen=True)
class Scalars:
    """Scalar program: names of its parameters and results, and its definition for the Cayley map of order n.

    ``given`` are the arguments in terms of v; ``numbers`` are the numbers that ``premises`` define, such as inverses.
    """

    parameters: tuple[str, ...]
    results: tuple[str, ...]
    given: str
    numbers: str
    premises: tuple[str, ...]
    equations: tuple[str, ...]
    proof: str
    root: str = ""


@dataclass(frozen=True)
class Geometry:
    """Geometry program: its scalar program, and its value for any scalars and for the Cayley map of order n.

    ``result`` names the components in messages. ``chart`` holds steps that prove the value of order n.
    """

    scalars: str
    result: str
    value: str
    at_order: str
    second: bool = False
    premises: tuple[str, ...] = ()
    proof: str = ""
    by: str = " by assumption"
    chart: str = "unfold dcay, dcay_inv, cayley_quaternion. now rewrite ?A, ?B, ?C."


POWER = ("power * pow (1 + {X}) {n} = 1",)
INVERSES = ("half * 2 = 1", "q {X} {n} * q_inverse = 1", "of_nat {n} * n_inverse = 1")

SCALARS: Mapping[str, Scalars] = {
    "quaternion_scalars": Scalars(
        ("x",), ("s", "w", "sy", "wy"), "(dot v v)", "root",
        ("root * root * pow (1 + {X}) {n} = 1", "re root * {root} = 1"),
        ("Dual s (sy * dot v vo) = p {X} {n} * root", "Dual w (wy * dot v vo) = q {X} {n} * root"),
        "intros H R. rewrite parts_of_dot in *. destruct root as [r r']. "
        "apply root_parts in H as (N & M & D). subst r'.",
        "all: cbn; known_root sqrt R.",
    ),
    "pose_scalars": Scalars(
        ("v11", "v22", "v33"), ("f", "g", "h"), SQUARES, "power", POWER,
        tuple(f"{each} = cayley_{each} {{n}} (re power) v" for each in "fgh"),
        "intros [N ->]%inverse_parts_left. unfold cayley_f, cayley_g, cayley_h. rewrite parts_of_dot in *.",
    ),
    "tangent_scalars": Scalars(
        ("v11", "v22", "v33"), ("f", "g", "h", "fy", "gy", "hy"), SQUARES, "power", POWER,
        tuple(f"Dual {each} ({each}y * dot v vo) = cayley_{each} {{n}} power (vdual v vo)" for each in "fgh"),
        "intros [N ->]%inverse_parts_left. unfold cayley_f, cayley_g, cayley_h. rewrite parts_of_dot in *.",
    ),
    "tangent_inv_scalars": Scalars(
        ("x",), ("fi", "hi", "fiy", "hiy"), "(dot v v)", "half q_inverse n_inverse", INVERSES,
        ("Dual fi (fiy * dot v vo) = p {X} {n} * q_inverse",
         "Dual hi (hiy * dot v vo) = d {X} {n} * (q_inverse * n_inverse)"),
        "intros _ [N ->]%inverse_parts [M ->]%inverse_parts. rewrite parts_of_dot in *.",
    ),
}  # fmt: skip

_TANGENT = "tangent (Dual f (fy * dot v vo) : dual K) (Dual g (gy * dot v vo)) (Dual h (hy * dot v vo)) (vdual v vo)"
_INVERSE = "tangent_inv half (Dual fi (fiy * dot v vo)) (Dual hi (hiy * dot v vo)) (vdual v vo)"
_DCAY, _DCAY_INV = "dcay {n} power (vdual v vo)", "dcay_inv half {n} q_inverse n_inverse (vdual v vo)"
_UNIT = "f * f + dot v v * (g * g) = 2 * g"
_HALF = ("half * 2 = 1",)
_ROTATION = (
    "rotation (Dual f (((1 - g * dot v v) * h - f * g) * dot v vo) : dual K) "
    "(Dual g ((f * h - g * g) * dot v vo)) (vdual v vo)"
)


def _tangents() -> Iterator[tuple[str, Geometry]]:
    """Yield the tangent operators of both frames, and the maps between rates and twists."""
    for frame, of in ("", "({})"), ("body_", "(transpose ({}))"):
        for name, scalars, value, order, halves in (
            ("tangent", "tangent_scalars", _TANGENT, _DCAY, ()),
            ("tangent_inv", "tangent_inv_scalars", _INVERSE, _DCAY_INV, _HALF),
        ):
            sides = [of.format(value), of.format(order)]
            first, second = (f"tensor_parts {side}" for side in sides)
            yield f"{frame}{name}", Geometry(scalars, "tangent", first, second, premises=halves)
            name, result = ("rate", "v_dot") if halves else ("twist", "omega")
            first, second = (f"vector_parts (apply {side} (vdual u uo))" for side in sides)
            yield f"{frame}{name}", Geometry(scalars, result, first, second, second=True, premises=halves)


GEOMETRY: Mapping[str, Geometry] = {
    "quaternion": Geometry(
        "quaternion_scalars", "q",
        "quaternion_parts (quaternion (Dual s (sy * dot v vo) : dual K) (Dual w (wy * dot v vo)) (vdual v vo))",
        "quaternion_parts (cayley_quaternion {n} root (vdual v vo))",
    ),
    "tensor": Geometry(
        "pose_scalars", "tensor", f"tensor_parts ({_ROTATION})", "tensor_parts (cayley_tensor {n} power (vdual v vo))",
        premises=(_UNIT,), proof="unfold tensor_parts. rewrite (twist K f g h v vo E1).",
        by=" by (rewrite A, B; destruct power; eapply cayley_unit, real_part_of_power, H1)",
        chart="destruct power as [power power']. destruct (cayley_slopes K {before} v vo power power' H1) as [F G]. "
        "unfold cayley_tensor. rewrite F, G. cbn [re] in *. rewrite <- A, <- B, <- C. easy.",
    ),
    "pose": Geometry(
        "pose_scalars", "pose", "pose_parts (rotation f g v) (apply (tangent f g h v) vo)",
        "pose_parts (cayley_tensor {n} (re power) v) (apply (dcay {n} (re power) v) vo)",
        chart="unfold dcay, cayley_tensor. now rewrite A, B, C.",
    ),
    **dict(_tangents()),
}  # fmt: skip
"""Geometry programs that are proved. R = Q + ε skew(ρ) Q of a pose is the tensor, by the theorem `twist`."""

OPAQUE = {name: scalars.results for name, scalars in SCALARS.items()}

HEAD = """From dualcay Require Import Programs{imports}.
Section Text.
  Variable K : Field.
  Add Field numbers : (field_laws K).
  Variable sqrt : K -> K.
  Implicit Types (v vo u uo : Vector K) (power root half q_inverse n_inverse : dual K).
"""


def geometry_file(name: str, program: Program) -> str:
    """Return the file that proves a geometry program for any scalars."""
    goal = GEOMETRY[name]
    scalars = SCALARS[goal.scalars]
    kinds = " -> ".join(["K"] * len(scalars.parameters))
    premises = " -> ".join((f"{goal.scalars} {scalars.given} = ({', '.join(scalars.results)})", *goal.premises, ""))
    start = "rewrite (proj2 (inverse_parts_left E1))." if _half(goal) else goal.proof
    entries = "\n".join(f"  - entry K. (* {goal.result}[{i}] *)" for i in range(len(program.results)))
    return f"""{HEAD.format(imports='')}
  Variable {goal.scalars} : {kinds} -> {product(len(scalars.results))}.

{program.definition(f'{name}_text')}

  Theorem {name}_text_right v vo{_second(goal)}{_half(goal)} {' '.join(scalars.results)} : {premises}
    {name}_text {_components(goal)} = {goal.value}.
  Proof.
  intros E{' E1' * len(goal.premises)}. {start} unfold {name}_text, {_PARTS}.
  cbv zeta. unfold dot in E. rewrite E. (* call of {goal.scalars} *)
  split_entries.
{entries}
  Qed.
End Text.
Print Assumptions {name}_text_right.
"""


_PARTS = "tensor_parts, vector_parts, quaternion_parts, pose_parts"


def _components(goal: Geometry) -> str:
    return " ".join(f"(v{i} {part})" for part in ("v", "vo", *("u", "uo") * goal.second) for i in (1, 2, 3))


def chart_file(target: str, scalars: str, order: int, program: Program) -> str:
    """Return the file that proves a scalar program of the Cayley map of an order, and the functions that call it."""
    goal = SCALARS[scalars]
    root = f"pow (1 + dot v v) {order // 2}" if order % 2 == 0 else f"sqrt (pow (1 + dot v v) {order})"
    fill = partial(str.format, X=X, n=order, before=order - 1, root=root)
    premises = "".join(f"{fill(each)} -> " for each in goal.premises)
    called, pattern = f"{scalars}_text {goal.given}", f"({', '.join(goal.results)})"
    users = {name: each for name, each in GEOMETRY.items() if each.scalars == scalars}
    known = _names("H", len(goal.premises))
    functions = "".join(
        f"""
  Theorem {name}_right v vo{_second(user)} {goal.numbers} : {premises}
    {name}_text K {scalars}_text {_components(user)} = {fill(user.at_order)}.
  Proof. (* {name} *)
    intros {known}. pose proof ({scalars}_text_right v vo {goal.numbers} {known}) as S.
    destruct ({called}) as {_nested(goal.results)} eqn:E. destruct S as {_split(len(goal.equations))}.
    rewrite ({name}_text_right K {scalars}_text v vo{_second(user)}{_half(user)} {' '.join(goal.results)} E){_by(user)}.
    {fill(user.chart)}
  Qed.
"""
        for name, user in users.items()
    )
    conclusion = " /\\ ".join(map(fill, goal.equations))
    printed = "\n".join(f"Print Assumptions {name}_right." for name in (f"{scalars}_text", *users))
    parts = [name for each in goal.equations for name in _written(each)]
    entries = "\n".join(f"  - entry K. (* {name} *)" for name in parts)
    return f"""{HEAD.format(imports=''.join(f' {target}_{name}' for name in users))}
{program.definition(f'{scalars}_text')}

  Theorem {scalars}_text_right v vo {goal.numbers} : {premises}
    let '{pattern} := {called} in {conclusion}.
  Proof.
  unfold {scalars}_text. cbv zeta.
  {goal.proof}
  scalar_entries v vo. {goal.root}
{entries}
  Qed.
{functions}End Text.
{printed}
"""


def _names(letter: str, count: int) -> str:
    return " ".join(f"{letter}{i + 1}" for i in range(count))


def _nested(names: Sequence[str]) -> str:
    """Return the pattern of a tuple, which is a nest of pairs."""
    first, *others = names
    return first if not others else f"[{_nested(names[:-1])} {names[-1]}]"


def _split(count: int) -> str:
    return f"({' & '.join('ABC'[:count])})"


def _second(goal: Geometry) -> str:
    return " u uo" if goal.second else ""


def _half(goal: Geometry) -> str:
    return " half" if goal.premises == _HALF else ""


def _by(goal: Geometry) -> str:
    return goal.by if goal.premises else ""


def _written(equation: str) -> list[str]:
    """Return the results that an equation ``Dual f (fy * …) = …`` or ``f = …`` of a scalar program is about."""
    left = equation.split(" = ")[0].removeprefix("Dual ").replace("(", "").split(" ")
    return left[:2]


@dataclass(frozen=True)
class Goal:
    """File of Coq that proves a program of a target: its name, its text, and the place of the program on disk.

    A goal of a chart needs the compiled goals of the geometry programs first.
    """

    target: str
    function: str
    order: int | None
    text: str
    place: str

    @property
    def name(self) -> str:
        """Name of the file without suffix."""
        return f"{self.target}_{self.function}{self.order or ''}"


def goals(numpy: Path, c: Path, orders: Sequence[int] = ORDERS) -> Iterator[Goal]:
    """Read the programs of two folders of kernels and yield their goals, geometry programs first."""
    python, interface = PythonText(numpy / "_geometry.py"), PythonText(numpy / "_interface.py")
    headers = {order: CText(c / f"cayley{order}.h", f"dualcay_cayley{order}_") for order in orders}
    for name, goal in GEOMETRY.items():
        arguments = (V, U) if goal.second else (V,)
        yield _geometry("numpy", name, _of_kernel(python, interface, name, arguments))
        yield _geometry("c", name, headers[orders[-1]].program(name, arguments, OPAQUE))
    for order in orders:
        module = PythonText(numpy / f"cayley{order}.py")
        for name, scalars in SCALARS.items():
            yield _chart("numpy", name, order, module.program(f"_{name}", scalars.parameters, {}))
            yield _chart("c", name, order, headers[order].program(name, scalars.parameters, {}))


def _of_kernel(python: PythonText, interface: PythonText, name: str, arguments: Sequence[Any]) -> Program:
    """Read a geometry program of the NumPy kernels; the interface passes some a table that selects the frame."""
    if name not in python.functions:
        name, method = name.removeprefix("body_"), name
    else:
        method = name
    table = (tuple(number(Fraction(each)) for each in interface.table(method)),) if len(arguments) == 2 else ()
    return python.program(name, [*arguments, *table], OPAQUE)


def _geometry(target: str, name: str, program: Program) -> Goal:
    return Goal(target, name, None, geometry_file(name, program), program.place)


def _chart(target: str, name: str, order: int, program: Program) -> Goal:
    return Goal(target, name, order, chart_file(target, name, order, program), program.place)
