"""Ideal of exact numbers, which decides what the equations of a domain make 0."""

from __future__ import annotations

from collections.abc import Sequence
from math import lcm
from typing import Any

import flint

from ...algebra.element import Element

LIMITS = (200, 500, 1000)
"""Largest numbers of polynomials in a basis, of terms and of bits of coefficients; a cut basis decides less."""


class Ideal:
    """Ideal of the numerators of exact numbers; `contains` is sound, and complete if the basis was not cut."""

    def __init__(self, elements: Sequence[Element]) -> None:
        self.elements = elements
        names = [f"g{i}" for i in range(len(elements[0].ring.names))]
        self._context = flint.fmpz_mpoly_ctx.get(names, flint.Ordering.degrevlex)
        given = flint.fmpz_mpoly_vec([self._integral(a) for a in elements], self._context)
        self._basis, _ = given.buchberger_naive(limits=LIMITS)

    def contains(self, element: Element) -> bool:
        return bool(self._integral(element).reduction_primitive_part(self._basis) == 0)

    def _integral(self, element: Element) -> Any:
        terms = element.ring.library.terms(element.numerator)
        scale = lcm(*(c.denominator for c in terms.values()))
        return self._context.from_dict({powers: int(c * scale) for powers, c in terms.items()})
