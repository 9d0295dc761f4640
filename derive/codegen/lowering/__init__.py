"""Lowering: from the formulas of one order to straight-line programs, one recipe per kernel function.

============ ========================================================================
polynomial   Horner's rule and the pair chain
chart        the scalars x, p, q, N and the coefficients every tensor is made of
forward      quaternion, tensor, pose, transform_point, transform_line
kinematics   tangent, tangent_inv, twist, rate and their body forms
inverse      from_quaternion, from_tensor, from_pose, screws, shadows, compose
============ ========================================================================

A recipe needs no trust: what it prints is proved equal to the formula afterwards (``codegen.validation``).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ..program import Program
from . import forward, inverse, kinematics

RECIPES: Mapping[str, Callable[[int], Program]] = {
    recipe.__name__: recipe
    for recipe in (
        forward.quaternion,
        forward.tensor,
        forward.pose,
        forward.transform_point,
        forward.transform_line,
        kinematics.tangent,
        kinematics.tangent_inv,
        kinematics.twist,
        kinematics.rate,
        kinematics.body_twist,
        kinematics.body_rate,
        inverse.from_quaternion,
        inverse.from_tensor,
        inverse.from_pose,
        inverse.from_screw,
        inverse.to_screw,
        inverse.turn,
        inverse.shadow,
        inverse.principal,
        inverse.compose,
    )
}


def lower(order: int) -> dict[str, Program]:
    """Every program of the Cayley map of an order, by name."""
    return {name: recipe(order) for name, recipe in RECIPES.items()}
