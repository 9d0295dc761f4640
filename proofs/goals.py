"""Emitted programs proved equal to their definitions by Coq, from the text on disk.

Geometry programs are proved once for every chart: the results of scalar programs are any numbers. Scalar programs are
proved for some orders of the Cayley map. Together they make every function of these orders equal to its definition.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial, reduce
from pathlib import Path

from derive.codegen.validation.loading import loaded

from .coq_definitions import GEOMETRY, HALF, SCALARS, GeometryDefinition, X
from .emitted import CHeader, PythonModule, reading
from .transcript import Transcript, product

TARGETS = ("numpy", "c")
ORDERS = (1, 2, 3, 5)  # orders of the Cayley map whose scalar programs are proved
HEAD = """From dualcay Require Import Programs{imports}.
Section Text.
  Variable K : Field.
  Add Field numbers : (field_laws K).
  Variable sqrt : K -> K.
  Implicit Types (v vo u uo : Vector K) (power root half q_inverse n_inverse : dual K).
"""


def geometry_file(name: str, program: Transcript) -> str:
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


def _components(goal: GeometryDefinition) -> str:
    return " ".join(f"(v{i} {part})" for part in ("v", "vo", *("u", "uo") * goal.second) for i in (1, 2, 3))


def chart_file(target: str, scalars: str, order: int, program: Transcript) -> str:
    """Return the file that proves a scalar program of the Cayley map of an order, and the functions that call it."""
    goal = SCALARS[scalars]
    root = f"pow (1 + dot v v) {order // 2}" if order % 2 == 0 else f"sqrt (pow (1 + dot v v) {order})"
    fill = partial(str.format, X=X, n=order, before=order - 1, root=root)
    premises = "".join(f"{fill(each)} -> " for each in goal.premises)
    called, pattern = f"{scalars}_text {goal.given}", f"({', '.join(goal.results)})"
    users = {name: each for name, each in GEOMETRY.items() if each.scalars == scalars}
    known = " ".join(f"H{i + 1}" for i in range(len(goal.premises)))
    nested = reduce(lambda before, name: f"[{before} {name}]", goal.results)
    split = " & ".join("ABC"[: len(goal.equations)])
    functions = "".join(
        f"""
  Theorem {name}_right v vo{_second(user)} {goal.numbers} : {premises}
    {name}_text K {scalars}_text {_components(user)} = {fill(user.at_order)}.
  Proof. (* {name} *)
    intros {known}. pose proof ({scalars}_text_right v vo {goal.numbers} {known}) as S.
    destruct ({called}) as {nested} eqn:E. destruct S as ({split}).
    rewrite ({name}_text_right K {scalars}_text v vo{_second(user)}{_half(user)} {' '.join(goal.results)} E){user.by}.
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


def _second(goal: GeometryDefinition) -> str:
    return " u uo" if goal.second else ""


def _half(goal: GeometryDefinition) -> str:
    return " half" if goal.premises == HALF else ""


def _written(equation: str) -> list[str]:
    """Return the results that an equation ``Dual f (fy * …) = …`` or ``f = …`` of a scalar program is about."""
    left = equation.split(" = ")[0].removeprefix("Dual ").replace("(", "").split(" ")
    return left[:2]


@dataclass(frozen=True)
class Goal:
    """File of Coq that proves a program of a target; a goal with an order needs the compiled ones without first."""

    target: str
    function: str
    order: int | None
    text: str
    place: str  # of the program on disk

    @property
    def name(self) -> str:
        return f"{self.target}_{self.function}{self.order or ''}"


def goals(numpy: Path, c: Path, orders: Sequence[int] = ORDERS) -> Iterator[Goal]:
    """Execute the programs of two folders of kernels and yield their goals, geometry programs first."""
    with reading(numpy.name), loaded(numpy) as package:
        modules = [PythonModule(numpy, package, f"cayley{order}") for order in orders]
        headers = [CHeader(c / f"cayley{order}.h") for order in orders]
        opaque = CHeader(headers[-1].path, opaque=True)
        for name in GEOMETRY:
            for target, made in zip(TARGETS, (modules[-1].geometry(name), opaque.geometry(name)), strict=True):
                yield Goal(target, name, None, geometry_file(name, made), made.place)
        for order, module, header in zip(orders, modules, headers, strict=True):
            for name in SCALARS:
                for target, made in zip(TARGETS, (module.scalars(name), header.scalars(name)), strict=True):
                    yield Goal(target, name, order, chart_file(target, name, order, made), made.place)
