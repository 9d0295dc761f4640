"""Proof of a chart by `prove`, the only function that makes a `Proved`."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import InitVar, dataclass

from ..maps.chart import Chart
from .at_order import CayleyFormulas, instances
from .components import Components
from .computations import computations
from .displacement_theorems import COMPOSITION_AT
from .every_order import theorems
from .identity import Proof
from .phi_instances import instance
from .scalars import ScalarProofs, is_algebraic

Progress = Callable[[str], None]
_MADE_HERE = object()


class ProofFailed(Exception):
    """Error: a statement about a formula is not proved.

    Attributes
    ----------
    failed : tuple of Proof
        Failed statements; each lists its residues in ``failures``.
    """

    def __init__(self, failed: tuple[Proof, ...]) -> None:
        self.failed = failed
        lines = (f"{proof.statement} [{proof.scope}]: {_first_failure(proof)}" for proof in failed)
        super().__init__("not proved: " + "; ".join(lines))


@dataclass(frozen=True)
class Proved:
    """Chart with the proofs of its formulas, made only by :func:`prove`.

    Attributes
    ----------
    formulas : Chart
        The proved chart.
    proofs : tuple of Proof
        A Cayley map has theorems for all n, their instances at its order, and the componentwise road. Every algebraic
        chart has proofs that its scalars agree with its formulas and its φ. Any other chart has proofs that its
        formulas in α are instances of the theorems on every φ.
    """

    formulas: Chart
    proofs: tuple[Proof, ...]
    token: InitVar[object] = None

    def __post_init__(self, token: object) -> None:
        if token is not _MADE_HERE:
            raise TypeError("only derive.proof.prove makes a Proved")

    def __repr__(self) -> str:
        return f"<Proved {self.formulas.name}: {len(self.proofs)} proofs>"


def proofs(chart: Chart, progress: Progress | None = None, backend: str | None = None) -> tuple[Proof, ...]:
    """Decide every statement about a chart and return all proofs, including failed ones.

    Parameters
    ----------
    chart : Chart
        Chart to prove, e.g. ``derive.Cayley(7)``.
    progress : callable, optional
        Function called with a line of text before each stage.
    backend : {"flint", "sympy"}, optional
        Library of polynomials in x; by default python-flint where it is installed.
    """
    return tuple(_decided(chart, progress or (lambda line: None), backend))


def prove(chart: Chart, progress: Progress | None = None, backend: str | None = None) -> Proved:
    """Prove a chart; a Cayley map is proved by theorems and, independently, by components.

    See :func:`proofs` for the parameters.

    Raises
    ------
    ProofFailed
        If any statement fails.
    """
    decided = proofs(chart, progress, backend)
    failed = tuple(proof for proof in decided if not proof.proved)
    if failed:
        raise ProofFailed(failed)
    return Proved(chart, decided, _MADE_HERE)


def _decided(chart: Chart, progress: Progress, backend: str | None) -> Iterator[Proof]:
    if chart.cayley:
        yield from _cayley(chart.cayley, progress, backend)
    progress(f"{chart.name}: scalars and formulas")
    yield from ScalarProofs(chart, backend).proofs() if is_algebraic(chart) else instance(chart)


def _cayley(cayley: CayleyFormulas, progress: Progress, backend: str | None) -> Iterator[Proof]:
    progress("theorems for all n")
    yield from theorems()
    progress(f"n = {cayley.order}: formulas as in the theorems")
    yield from instances(cayley)
    yield from computations(cayley.order)
    if cayley.order in COMPOSITION_AT:
        yield COMPOSITION_AT[cayley.order].decide({})
    progress(f"n = {cayley.order}: componentwise from the definition")
    yield from Components(cayley, backend).proofs()


def _first_failure(proof: Proof) -> str:
    if not proof.failures:
        return "nothing was checked"
    first = proof.failures[0]
    text = str(first.value)
    shown = text if len(text) <= 200 else f"{text[:200]} ..."
    return f"{first.label}, residue {shown}"
