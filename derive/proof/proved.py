"""Theorems for every order n ≥ 1, proofs of a chart, and `Proved`, a chart with its proofs; only `prove` makes it."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Iterator
from dataclasses import InitVar, dataclass
from functools import cache
from itertools import chain

from ..maps import Cayley
from ..maps.chart import Chart
from .at_order import computations, instances
from .calculus_theorems import CALCULUS_THEOREMS, GROWING_ORDER
from .components import Components
from .displacement_theorems import CLOSED_AT, DISPLACEMENT_THEOREMS, TRANSPORT_THEOREMS
from .identity import Proof
from .map_theorems import MAP_THEOREMS, POLYNOMIAL_THEOREMS
from .methods import decided
from .phi_theorems import ANY_PHI
from .scalars import ScalarProofs, instance
from .texts import MARKED, compared, shown_with

_MADE_HERE = object()


STATED = (*POLYNOMIAL_THEOREMS, *MAP_THEOREMS, *DISPLACEMENT_THEOREMS, *CALCULUS_THEOREMS, *TRANSPORT_THEOREMS)
"""Theorems for every n, each after the theorems it uses."""

CLAIMS = (*STATED, *chain(*CLOSED_AT.values()), *ANY_PHI, *GROWING_ORDER)
"""Theorems that are proved once instead of at each order."""


def citing(numbers: Container[int]) -> tuple[Proof, ...]:
    """Prove the theorems that claim the given equations of CP23, after all theorems they use."""
    wanted = {t.name for t in STATED if any(n in numbers for equation in t.claim for n in equation.numbers)}
    needed = set(wanted)
    for theorem in reversed(STATED):
        if theorem.name in needed:
            needed |= {premise.theorem for premise in theorem.premises}
    return tuple(proof for proof in decided(t for t in STATED if t.name in needed) if proof.name in wanted)


@cache
def theorems() -> tuple[Proof, ...]:
    """Return the proofs of scope "all n", decided once per process."""
    return decided(STATED)


class ProofFailed(Exception):
    """Error for statements about a formula that are not proved; each of the `failed` proofs lists its ``failures``."""

    def __init__(self, failed: tuple[Proof, ...]) -> None:
        self.failed = failed
        lines = (f"{proof.statement} [{proof.scope}]: {_first_failure(proof)}" for proof in failed)
        super().__init__("not proved: " + "; ".join(lines))


def require(decided: Iterable[Proof]) -> None:
    """Raise `ProofFailed` if any statement is not proved."""
    if failed := tuple(proof for proof in decided if not proof.proved):
        raise ProofFailed(failed)


def shown(text: str, cayley: Cayley | None = None) -> str:
    """Return a text without the marks of its formulas; raise `ProofFailed` if one of them is not proved.

    Formulas hold for a Cayley map if given, otherwise for every chart. One without marks raises ValueError.
    """
    if re.search(r"(?<![<>])=", MARKED.sub("", text)):
        raise ValueError(f"a formula without marks is compared with nothing: {text!r}")
    require(compared(formula, cayley) for formula in MARKED.findall(text))
    return text.replace("`", "")


@dataclass(frozen=True)
class Proved:
    """Chart with the proofs of its formulas, made only by :func:`prove`.

    A Cayley map has theorems for all n, their instances at its order, and proofs by components. An algebraic chart has
    proofs that its scalars agree with its formulas and its φ. For any other chart, proofs show that its formulas in α
    are instances of the theorems on every φ.
    """

    formulas: Chart
    proofs: tuple[Proof, ...]
    token: InitVar[object] = None

    def __post_init__(self, token: object) -> None:
        if token is not _MADE_HERE:
            raise TypeError("only derive.proof.prove makes a Proved")

    def __repr__(self) -> str:
        return f"<Proved {self.formulas.name}: {len(self.proofs)} proofs>"


def proofs(chart: Chart) -> tuple[Proof, ...]:
    """Decide every statement about a chart and return all proofs, including failed ones."""
    decided = tuple(_proofs_of_order(chart.cayley)) if chart.cayley else ()
    return (*decided, *(ScalarProofs(chart).proofs() if chart.algebraic else instance(chart)))


def prove(chart: Chart) -> Proved:
    """Prove a chart and the formulas shown with it; raise `ProofFailed` if any statement fails."""
    decided = proofs(chart)
    require(decided)
    require(shown_with(chart))
    return Proved(chart, decided, _MADE_HERE)


def _proofs_of_order(cayley: Cayley) -> Iterator[Proof]:
    yield from theorems()
    yield from instances(cayley)
    yield from computations(cayley.order)
    yield from decided(CLOSED_AT.get(cayley.order, ()))
    yield from Components(cayley).proofs()


def _first_failure(proof: Proof) -> str:
    if not proof.failures:
        return "nothing was checked"
    first = proof.failures[0]
    text = str(first.value)
    return f"{first.label}, residue {text if len(text) <= 200 else f'{text[:200]} ...'}"
