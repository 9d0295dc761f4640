"""Names and constants that a module of a chart says by itself are those of its chart, whichever chart came first."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest
from derive.codegen.validation.offered import offered

import dualcay
from derive.codegen.catalogue import committed
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.validation.errors import ValidationFailed
from derive.maps import Cayley
from dualcay import cayley4
from dualcay.rotation import cayley4 as rotation4


@pytest.mark.parametrize("chart", committed(), ids=lambda chart: chart.name)
def test_committed_modules_offer_what_is_theirs(chart: Any) -> None:
    offered(getattr(dualcay, chart.name), chart, POSES)
    offered(getattr(dualcay.rotation, chart.name), chart, ROTATIONS)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"twist": cayley4.body_twist}, "twist is not the function twist of KERNELS"),
        ({"dcay": cayley4.tangent_inv}, "dcay is not the function tangent of KERNELS"),
        ({"identity": cayley4.random}, "identity is not the function identity"),
        ({"rate": rotation4.rate}, "rate is not the function rate of KERNELS"),
        ({"shadow": None}, "shadow is not the function"),
        ({"__all__": cayley4.__all__[1:]}, "__all__ holds other names"),
        ({"ORDER": 5}, "ORDER is 5, not 4"),
        ({"singular_angles": lambda: (2 * math.pi,)}, "singular_angles is not the function"),
    ],
)
def test_other_names_and_constants_are_noticed(changes: dict[str, Any], words: str) -> None:
    with pytest.raises(ValidationFailed, match=words):
        offered(SimpleNamespace(**{**vars(cayley4), **changes}), Cayley(4), POSES)


@pytest.mark.parametrize("angles", [(2 * math.pi,), (2 * math.pi, 3 * math.pi), (math.nextafter(6, 7), 4 * math.pi)])
def test_other_angles_are_noticed(angles: tuple[float, ...], monkeypatch: pytest.MonkeyPatch) -> None:
    kernels = type(cayley4.KERNELS)
    monkeypatch.setattr(kernels, "singular_angles", lambda self: angles)
    kernels.singular_angles.__name__ = "singular_angles"
    module = SimpleNamespace(**{**vars(cayley4), "singular_angles": cayley4.KERNELS.singular_angles})
    with pytest.raises(ValidationFailed, match=r"singular_angles\(\) is"):
        offered(module, Cayley(4), POSES)
