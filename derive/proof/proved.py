"""From a formula to a proved formula: the only way to one leads through here."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import InitVar, dataclass

from ..maps import Cayley
from .at_order import CayleyFormulas, instances
from .components import Components
from .computations import computations
from .displacement_theorems import COMPOSITION_AT
from .every_order import theorems
from .identity import Proof

Progress = Callable[[str], None]
_MADE_HERE = object()


class ProofFailed(Exception):
    """A statement about a formula is not true.

    Attributes
    ----------
    failed : tuple of Proof
        The statements that failed; ``failures`` of each has the residues.
    """

    def __init__(self, failed: tuple[Proof, ...]) -> None:
        self.failed = failed
        lines = (f"{proof.statement} [{proof.scope}]: {_first_failure(proof)}" for proof in failed)
        super().__init__("not proved: " + "; ".join(lines))


@dataclass(frozen=True)
class Proved:
    """Formulas and the proofs that they hold. Made by :func:`prove` only.

    Attributes
    ----------
    formulas : Cayley
        What was proved.
    proofs : tuple of Proof
        Theorems for all n, their instances at this order, the componentwise road at this order.
    """

    formulas: Cayley
    proofs: tuple[Proof, ...]
    token: InitVar[object] = None

    def __post_init__(self, token: object) -> None:
        if token is not _MADE_HERE:
            raise TypeError("only derive.proof.prove makes a Proved")


def proofs(cayley: CayleyFormulas, progress: Progress | None = None, backend: str | None = None) -> tuple[Proof, ...]:
    """Decide every statement about a Cayley map, failed ones included.

    Parameters
    ----------
    cayley : CayleyFormulas
        Such as ``derive.Cayley(7)``.
    progress : callable, optional
        Called with a line of text before each stage.
    backend : {"flint", "sympy"}, optional
        Polynomial library of the componentwise road; by default python-flint where it is installed.
    """
    return tuple(_decided(cayley, progress or (lambda line: None), backend))


def prove(cayley: Cayley, progress: Progress | None = None, backend: str | None = None) -> Proved:
    """Prove a Cayley map on both roads.

    Parameters are those of :func:`proofs`.

    Raises
    ------
    ProofFailed
        If any statement fails.
    """
    decided = proofs(cayley, progress, backend)
    failed = tuple(proof for proof in decided if not proof.proved)
    if failed:
        raise ProofFailed(failed)
    return Proved(cayley, decided, _MADE_HERE)


def _decided(cayley: CayleyFormulas, progress: Progress, backend: str | None) -> Iterator[Proof]:
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
