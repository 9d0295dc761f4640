"""The front door: the maps of `derive.maps` with their proofs."""

from __future__ import annotations

from dataclasses import dataclass

from . import maps
from .output.listing import Listing
from .proof import Proof, proofs


@dataclass(frozen=True)
class Cayley(maps.Cayley):
    __doc__ = maps.Cayley.__doc__

    def prove(self) -> Listing[Proof]:
        """Decide everything claimed of this map, for all n and by components at this n; return each `Proof`.

        Whether all hold is ``all(proof.proved for proof in m.prove())``.
        """
        return Listing(proofs(self))
