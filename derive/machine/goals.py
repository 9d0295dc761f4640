"""Emitted programs proved equal to their definitions by Coq, from the text on disk.

Geometry programs are proved once for every chart: the results of scalar programs are any numbers. Scalar programs are
proved for some orders of the Cayley map. Together they make every function of these orders equal to its definition.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

from .c_text import CText
from .definitions import GEOMETRY, HALF, OPAQUE, SCALARS, Geometry, U, V, X
from .python_text import PythonText
from .terms import Program, number, product

ORDERS = (1, 2, 3, 5)
"""Orders of the Cayley map whose scalar programs are proved."""

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
    return " half" if goal.premises == HALF else ""


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
