"""Comparison of derivatives and composite maps with the oracle; tolerances follow from rounding the exact factors.

A result is a product of dual tensors, or a vector with such a product as Jacobian. The tolerance is the effect of one
rounding of each factor, or of each argument. The oracle computes the exact factors.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partialmethod
from typing import Any

import numpy as np

from tests.support import errors, ranges, sampling
from tests.support.accuracy import FUNCTIONS, Trial
from tests.support.errors import through
from tests.support.first_principles import E, pack
from tests.support.forward_accuracy import ForwardTrial
from tests.support.nilpotent import Nil, conjugate, hamilton, inverse, matmul, matvec, transpose
from tests.support.trial import Result, rounded

Tensor = Any


def product(*tensors: Tensor) -> Tensor:
    """Return the product of dual tensors, in the order given."""
    first, *others = tensors
    for other in others:
        first = matmul(first, other)
    return first


class CalculusTrial(Trial):
    """Trial that also has derivatives and composite maps, and so covers all functions."""

    # ---- exact factors -----------------------------------------------------------------------------------------

    def _operator(self, v: Any) -> Tensor:
        return self.oracle.operator_by_spin(self.oracle.unpack(v))

    def _rotation(self, v: Any) -> Tensor:
        return self.oracle.rotation(self.oracle.unpack(v))

    def _step(self, delta: Any) -> tuple[Tensor, Tensor]:
        """Return exp(δ) as a dual tensor, and dexp(δ)."""
        small = self.oracle.unpack(delta)
        q = self.oracle.step(small)
        turned = transpose([hamilton(hamilton(q, (0, *e)), conjugate(q))[1:] for e in E])
        return turned, self.oracle.step_operator(small)

    @property
    def _gates(self) -> tuple[float, float]:
        return self.gates("conditioned")

    # ---- one operator, or its derivative -----------------------------------------------------------------------

    adjoint = partialmethod(ForwardTrial._forward, "adjoint", "tensor", "rotation", "moment")
    cotangent = partialmethod(ForwardTrial._applied, "cotangent", "tangent", "conditioned")
    body_cotangent = partialmethod(ForwardTrial._applied, "body_cotangent", "tangent", "conditioned")
    body_tangent_dot = partialmethod(ForwardTrial._jacobian, "body_tangent_dot")
    body_twist_jacobian = partialmethod(ForwardTrial._jacobian, "body_twist_jacobian")
    body_cotangent_jacobian = partialmethod(ForwardTrial._jacobian, "body_cotangent_jacobian")

    def transform_point_jacobians(self) -> Iterator[Result]:
        """Yield Jacobians of Q r + ρ: by v° it is T, by Re v the derivative of Q r and of ρ = T v°, by r it is Q."""
        points = self.second(sampling.points, "transform_point_jacobians")
        by_v, by_r = self.module.transform_point_jacobians(self.v, points)
        for v, r, one, other in zip(self.v, points, by_v, by_r, strict=True):
            exact = self.oracle.transform_point_jacobians(v, r)
            local = errors.scales(self.order, v)
            size = Nil(local.tangent.re, local.tangent.re * errors.norm(r) + local.tangent.du)
            got, wanted = (np.stack([tensor[:, 3:], tensor[:, :3]]) for tensor in (one, exact[0]))
            yield Result(got, [wanted], [size], self._gates, (v, r), "by v")
            got, wanted = (np.stack([tensor, 0 * tensor]) for tensor in (other, exact[1]))
            yield Result(got, [wanted], [Nil(local.tensor.re, 0.0)], self._gates, (v, r), "by r")

    def transform_line_jacobians(self) -> Iterator[Result]:
        lines = self.second(sampling.dual_vectors, "transform_line_jacobians")
        found = self.module.transform_line_jacobians(self.v, lines)
        for v, line, *got in zip(self.v, lines, *found, strict=True):
            exact, local = self.oracle.transform_line_jacobians(v, line), errors.scales(self.order, v)
            sizes = local.tensor * errors.size(line) * local.tangent, local.tensor
            yield from self._both(got, exact, sizes, (v, line))

    def _both(self, got: Any, exact: Any, sizes: Any, given: tuple[np.ndarray, ...]) -> Iterator[Result]:
        """Yield both Jacobians of one function."""
        for note, *one in zip(("first", "second"), got, exact, sizes, strict=True):
            matrix, wanted, size = one
            yield Result(matrix, [wanted], [size], self._gates, given, note)

    # ---- vectors of known Jacobian -----------------------------------------------------------------------------

    def angle(self) -> Iterator[Result]:
        for v, got in zip(self.v, self.module.angle(self.v), strict=True):
            n, length, size = self.order, errors.norm(v[:3]), errors.norm(v[3:])
            turned = Nil(2 * n * math.atan(length), 2 * n / (1 + length**2) * size)
            yield Result(got, [self.oracle.angle(v)], [turned], self._gates, (v,))

    def to_exponential(self) -> Iterator[Result]:
        for v, got in zip(self.v, self.module.to_exponential(self.v), strict=True):
            exact = self.oracle.to_exponential(v)
            jacobian = product(inverse(self._step(exact)[1]), self._operator(v))
            yield Result(got, [exact], [self._moved(exact, (jacobian, v))], self._gates, (v,))

    def from_exponential(self) -> Iterator[Result]:
        given = np.stack([rounded(self.oracle.to_exponential(v), self.dtype) for v in self.v])
        for v, w, got in zip(self.v, given, self.module.from_exponential(given), strict=True):
            exact = self.oracle.from_exponential(w)
            jacobian = product(inverse(self._operator(exact)), self._step(w)[1])
            yield Result(got, [exact], [self._moved(exact, (jacobian, w))], self._gates, (v,), f"w = {w!r}")

    @staticmethod
    def _moved(exact: Any, *arguments: tuple[Tensor, Any]) -> Nil:
        """Return the scale of a result: its own rounding, plus roundings of its arguments through their Jacobians."""
        scale = errors.size(exact)
        for jacobian, argument in arguments:
            scale = scale + through(jacobian, errors.size(argument))
        return scale

    # ---- two poses ---------------------------------------------------------------------------------------------

    def _of_two(self, name: str, jacobians: Any) -> Iterator[Result]:
        """Yield results of a function of two vectors; `jacobians(v2, v1, result)` returns its Jacobians up to sign."""
        for v1 in self.partners():
            for a, b, got in zip(self.v, v1, getattr(self.module, name)(self.v, v1), strict=True):
                exact = getattr(self.oracle, name)(a, b)
                by_a, by_b = jacobians(a, b, exact)
                yield Result(got, [exact], [self._moved(exact, (by_a, a), (by_b, b))], self._gates, (a, b))

    def between_by(self, a: Any, b: Any, result: Any) -> tuple[Tensor, Tensor]:
        back = product(inverse(self._operator(result)), transpose(self._rotation(b)))
        return product(back, self._operator(a)), product(back, self._operator(b))

    def between(self) -> Iterator[Result]:
        return self._of_two("between", self.between_by)

    def local_by(self, a: Any, b: Any, result: Any) -> tuple[Tensor, Tensor]:
        turned, operator = self._step(result)
        back = inverse(operator)
        return product(back, self._operator(a)), product(back, turned, self._operator(b))

    def local(self) -> Iterator[Result]:
        return self._of_two("local", self.local_by)

    def body_local_by(self, a: Any, b: Any, result: Any) -> tuple[Tensor, Tensor]:
        back = product(inverse(self._step(result)[1]), transpose(self._rotation(b)))
        return product(back, self._operator(a)), product(back, self._operator(b))

    def body_local(self) -> Iterator[Result]:
        return self._of_two("body_local", self.body_local_by)

    def _transition(self, name: str) -> Iterator[Result]:
        for v0 in self.partners():
            for a, b, got in zip(self.v, v0, getattr(self.module, name)(self.v, v0), strict=True):
                size = self._scale(a, "tangent_inv") * errors.scales(self.order, b).tangent
                yield Result(got, [getattr(self.oracle, name)(a, b)], [size], self._gates, (a, b))

    transition = partialmethod(_transition, "transition")
    body_transition = partialmethod(_transition, "body_transition")

    def inverted(self, result: Any, moved: Nil) -> Nil:
        """Return the scale of T⁻¹ at a result with error ``moved``, which acts through T⁻¹ DT T⁻¹."""
        here, back = errors.scales(self.order, result), errors.majorant(inverse(self._operator(result)))
        return back * (1 + here.condition) + back * back * (here.slope * moved)

    def _jacobians_of_two(self, name: str, jacobians: Any) -> Iterator[Result]:
        """Yield both Jacobians of a function of two vectors, T⁻¹ T and T⁻¹ R T, with T⁻¹ at the result."""
        for v1 in self.partners():
            found = getattr(self.module, f"{name}_jacobians")(self.v, v1)
            for a, b, *got in zip(self.v, v1, *found, strict=True):
                result = getattr(self.oracle, name)(a, b)
                by_a, by_b = jacobians(a, b, result)
                back = self.inverted(result, self._moved(result, (by_a, a), (by_b, b)))
                one, other = errors.scales(self.order, a), errors.scales(self.order, b)
                sizes = back * other.tensor * one.tangent, back * one.tensor * other.tangent
                exact = getattr(self.oracle, f"{name}_jacobians")(a, b)
                yield from self._both(got, exact, sizes, (a, b))

    def compose_by(self, a: Any, b: Any, result: Any) -> tuple[Tensor, Tensor]:
        back = inverse(self._operator(result))
        return product(back, self._operator(a)), product(back, self._rotation(a), self._operator(b))

    def compose_jacobians(self) -> Iterator[Result]:
        return self._jacobians_of_two("compose", self.compose_by)

    def between_jacobians(self) -> Iterator[Result]:
        return self._jacobians_of_two("between", self.between_by)

    def _local_jacobians(self, name: str) -> Iterator[Result]:
        """Yield both Jacobians of a step δ, products of T and dexp(±δ)⁻¹; the slope of dexp is below 1."""
        for v1 in self.partners():
            found = getattr(self.module, f"{name}_jacobians")(self.v, v1)
            for a, b, *got in zip(self.v, v1, *found, strict=True):
                delta, exact = (getattr(self.oracle, of)(a, b) for of in (name, f"{name}_jacobians"))
                by_a, by_b = getattr(self, f"{name}_by")(a, b, delta)
                back = errors.majorant(inverse(self._step(delta)[1]))
                back = back + back * back * self._moved(delta, (by_a, a), (by_b, b))
                sizes = (back * errors.scales(self.order, v).tangent for v in (a, b))
                yield from self._both(got, exact, tuple(sizes), (a, b))

    local_jacobians = partialmethod(_local_jacobians, "local")
    body_local_jacobians = partialmethod(_local_jacobians, "body_local")

    def shadow_jacobian(self) -> Iterator[Result]:
        """Yield T(v_k)⁻¹ T(v), which is exactly I on branch 0."""
        for branch in self.branches():
            if branch and self.regime == "pure translation":
                continue  # a shadow of a translation has no derivative
            for v, got in zip(self.v, self.module.shadow_jacobian(self.v, branch), strict=True):
                sides = (branch, -branch) if self.tie else (branch,)
                there = [self.oracle.shadow(v, k) for k in sides]
                if all(ranges.in_range(self.order, rounded(w, self.dtype)) for w in there):
                    exact = [self.oracle.shadow_jacobian(v, k) for k in sides]
                    sizes = [self._of_branch(v, w) if branch else Nil(math.sqrt(3), 0.0) for w in there]
                    yield Result(got, exact, sizes, self._gates, (v,), f"branch {branch}")

    def _of_branch(self, v: Any, there: Any) -> Nil:
        return self.inverted(there, self.shadow_scale(v, there)) * errors.scales(self.order, v).tangent

    # ---- steps and motions -------------------------------------------------------------------------------------

    def _retract_by(self, v: Any, delta: Any, result: Any, body: bool) -> tuple[Tensor, Tensor]:
        turned, operator = self._step(delta)
        back = inverse(self._operator(result))
        if body:
            return product(back, self._operator(v)), product(back, self._rotation(v), operator)
        return product(back, turned, self._operator(v)), product(back, operator)

    def _retract(self, name: str) -> Iterator[Result]:
        steps = self.second(sampling.dual_vectors, name)
        for v, delta, got in zip(self.v, steps, getattr(self.module, name)(self.v, steps), strict=True):
            exact = getattr(self.oracle, name)(v, delta)
            by_v, by_delta = self._retract_by(v, delta, exact, name.startswith("body"))
            yield Result(got, [exact], [self._moved(exact, (by_v, v), (by_delta, delta))], self._gates, (v, delta))

    retract = partialmethod(_retract, "retract")
    body_retract = partialmethod(_retract, "body_retract")

    def _retract_jacobians(self, name: str) -> Iterator[Result]:
        steps = self.second(sampling.dual_vectors, name)
        body = name.startswith("body")
        found = getattr(self.module, f"{name}_jacobians")(self.v, steps)
        for v, delta, *got in zip(self.v, steps, *found, strict=True):
            result, exact = (getattr(self.oracle, of)(v, delta) for of in (name, f"{name}_jacobians"))
            by_v, by_delta = self._retract_by(v, delta, result, body)
            back = self.inverted(result, self._moved(result, (by_v, v), (by_delta, delta)))
            local, (turned, operator) = errors.scales(self.order, v), self._step(delta)
            dexp, own = errors.majorant(operator), local.tangent
            if body:
                sizes = back * own, back * local.tensor * dexp
            else:
                sizes = back * errors.majorant(turned) * own, back * dexp
            yield from self._both(got, exact, sizes, (v, delta))

    retract_jacobians = partialmethod(_retract_jacobians, "retract")
    body_retract_jacobians = partialmethod(_retract_jacobians, "body_retract")

    def interpolate(self) -> Iterator[Result]:
        """Yield interpolations. The twist is ω = t dexp(tδ) δ̇ + exp(tδ) ω1 + ṫ δ, with dexp(δ) δ̇ = ω2 − exp(δ) ω1.

        The scale includes an error of the result's angle. The regime near 2π is left out: between two steps of the
        oracle, the axis may swing round and leave the branch undecided.
        """
        if self.regime == "near 2 pi":
            return
        share = self.dtype(0.375)
        for v2 in self.partners():
            for a, b, got in zip(self.v, v2, self.module.interpolate(self.v, v2, share), strict=True):
                exact, delta = self.oracle.interpolate(a, b, share), self.oracle.local(b, a)
                yield Result(got, [exact], [self._moved_on_the_way(a, b, exact, delta, share)], self._gates, (a, b))

    def _moved_on_the_way(self, a: Any, b: Any, exact: Any, delta: Any, share: Any) -> Nil:
        (turned, operator), part = self._step(delta), self.oracle.field.number(share)
        some, way = self._step(part * delta)
        back = inverse(self._operator(exact))
        onward = product(back, tuple(tuple(part * c for c in row) for row in way), inverse(operator))
        by_start = product(back, some, self._operator(a))
        by_end = product(onward, self._operator(b))
        by_both = product(onward, turned, self._operator(a))
        by_time = pack(matvec(back, self.oracle.unpack(part * delta)))
        by_angle = pack(matvec(back, self.oracle.unpack(self.oracle.to_exponential(exact))))
        scale = self._moved(exact, (by_start, a), (by_both, a), (by_end, b))
        return scale + errors.size(by_time) + errors.size(by_angle)


CALCULUS = (
    "adjoint", "cotangent", "body_cotangent", "body_tangent_dot", "body_twist_jacobian", "body_cotangent_jacobian",
    "angle", "to_exponential", "from_exponential", "between", "local", "body_local", "retract", "body_retract",
    "interpolate", "compose_jacobians", "between_jacobians", "shadow_jacobian", "retract_jacobians",
    "body_retract_jacobians", "local_jacobians", "body_local_jacobians", "transform_point_jacobians",
    "transform_line_jacobians", "transition", "body_transition",
)  # fmt: skip
"""Names of functions added to `Trial`."""

EVERY = (*FUNCTIONS, *CALCULUS)
