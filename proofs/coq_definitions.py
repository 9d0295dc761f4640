"""Definitions that emitted programs must equal, as texts of Coq: of scalar and of geometry programs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

V, U = ("v1", "v2", "v3", "v1o", "v2o", "v3o"), ("u1", "u2", "u3", "u1o", "u2o", "u3o")
SQUARES = "(v1 v * v1 v) (v2 v * v2 v) (v3 v * v3 v)"
X = "(dot (vdual v vo) (vdual v vo))"


@dataclass(frozen=True)
class ScalarDefinition:
    """Scalar program: its parameters and results, and its definition for the Cayley map of order n."""

    parameters: tuple[str, ...]
    results: tuple[str, ...]
    given: str  # arguments in terms of v
    numbers: str  # numbers that ``premises`` define, such as inverses
    premises: tuple[str, ...]
    equations: tuple[str, ...]
    proof: str
    root: str = ""


@dataclass(frozen=True)
class GeometryDefinition:
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

SCALARS: Mapping[str, ScalarDefinition] = {
    "quaternion_scalars": ScalarDefinition(
        ("x",), ("s", "w", "sy", "wy"), "(dot v v)", "root",
        ("root * root * pow (1 + {X}) {n} = 1", "re root * {root} = 1"),
        ("Dual s (sy * dot v vo) = p {X} {n} * root", "Dual w (wy * dot v vo) = q {X} {n} * root"),
        "intros H R. rewrite parts_of_dot in *. destruct root as [r r']. "
        "apply root_parts in H as (N & M & D). subst r'.",
        "all: cbn; known_root sqrt R.",
    ),
    "pose_scalars": ScalarDefinition(
        ("v11", "v22", "v33"), ("f", "g", "h"), SQUARES, "power", POWER,
        tuple(f"{each} = cayley_{each} {{n}} (re power) v" for each in "fgh"),
        "intros [N ->]%inverse_parts_left. unfold cayley_f, cayley_g, cayley_h. rewrite parts_of_dot in *.",
    ),
    "tangent_scalars": ScalarDefinition(
        ("v11", "v22", "v33"), ("f", "g", "h", "fy", "gy", "hy"), SQUARES, "power", POWER,
        tuple(f"Dual {each} ({each}y * dot v vo) = cayley_{each} {{n}} power (vdual v vo)" for each in "fgh"),
        "intros [N ->]%inverse_parts_left. unfold cayley_f, cayley_g, cayley_h. rewrite parts_of_dot in *.",
    ),
    "tangent_inv_scalars": ScalarDefinition(
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
HALF = ("half * 2 = 1",)
_ROTATION = (
    "rotation (Dual f (((1 - g * dot v v) * h - f * g) * dot v vo) : dual K) "
    "(Dual g ((f * h - g * g) * dot v vo)) (vdual v vo)"
)


def _tangents() -> Iterator[tuple[str, GeometryDefinition]]:
    """Yield the tangent operators of both frames, and the maps between rates and twists."""
    for frame, of in ("", "({})"), ("body_", "(transpose ({}))"):
        for name, scalars, value, order, halves in (
            ("tangent", "tangent_scalars", _TANGENT, _DCAY, ()),
            ("tangent_inv", "tangent_inv_scalars", _INVERSE, _DCAY_INV, HALF),
        ):
            sides = [of.format(value), of.format(order)]
            first, second = (f"tensor_parts {side}" for side in sides)
            yield f"{frame}{name}", GeometryDefinition(scalars, "tangent", first, second, premises=halves)
            name, result = ("rate", "v_dot") if halves else ("twist", "omega")
            first, second = (f"vector_parts (apply {side} (vdual u uo))" for side in sides)
            yield f"{frame}{name}", GeometryDefinition(scalars, result, first, second, second=True, premises=halves)


GEOMETRY: Mapping[str, GeometryDefinition] = {
    "quaternion": GeometryDefinition(
        "quaternion_scalars", "q",
        "quaternion_parts (quaternion (Dual s (sy * dot v vo) : dual K) (Dual w (wy * dot v vo)) (vdual v vo))",
        "quaternion_parts (cayley_quaternion {n} root (vdual v vo))",
    ),
    "tensor": GeometryDefinition(
        "pose_scalars", "tensor", f"tensor_parts ({_ROTATION})", "tensor_parts (cayley_tensor {n} power (vdual v vo))",
        premises=(_UNIT,), proof="unfold tensor_parts. rewrite (twist K f g h v vo E1).",
        by=" by (rewrite A, B; destruct power; eapply cayley_unit, real_part_of_power, H1)",
        chart="destruct power as [power power']. destruct (cayley_slopes K {before} v vo power power' H1) as [F G]. "
        "unfold cayley_tensor. rewrite F, G. cbn [re] in *. rewrite <- A, <- B, <- C. easy.",
    ),
    "pose": GeometryDefinition(
        "pose_scalars", "pose", "pose_parts (rotation f g v) (apply (tangent f g h v) vo)",
        "pose_parts (cayley_tensor {n} (re power) v) (apply (dcay {n} (re power) v) vo)",
        chart="unfold dcay, cayley_tensor. now rewrite A, B, C.",
    ),
    **dict(_tangents()),
}  # fmt: skip
"""Geometry programs that are proved. R = Q + ε skew(ρ) Q of a pose is the tensor, by the theorem `twist`."""
