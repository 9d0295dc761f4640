"""Formulas that people read: each holds, and a wrong one is refused before anything is written."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, cast

import pytest

from derive.codegen.build import print_package
from derive.codegen.lowering.scalar_programs import FORMULAS
from derive.codegen.targets import TARGETS
from derive.codegen.targets.python import formula_of
from derive.maps import Cayley, cayley, chart, family, parameterization
from derive.proof import ProofFailed, prove, shown
from derive.proof.texts import MARKED, compared, shown_with

CHARTS = [
    *map(Cayley, (1, 2, 3, 4, 9, 12, 33)), *map(family, ("exponential", "lambert", "breusing", "sine3", "scaled2")),
    parameterization("alpha/(1 + alpha**2/40)", "rational"),
]  # fmt: skip


@pytest.mark.parametrize("of", CHARTS, ids=lambda of: of.name)
def test_shown_formulas_hold(of: chart.Chart) -> None:
    assert all(proof.proved for proof in shown_with(of))
    assert "v(x)v" in formula_of("pose_scalars", of)


def _texts() -> Iterator[tuple[str, Cayley | None]]:
    """Yield every formula of the tables, for order 4 where it holds at an order."""
    four = Cayley(4)
    maps = [getattr(four, name) for name in chart.DEFINITIONS]
    yield from ((text, four) for of in maps for text in (f"{of.symbol} = {of.definition}", *of.identities))
    yield from ((text, None) for texts in chart.IDENTITIES.values() for text in texts)
    yield from ((text, None) for text in chart.DEFINITIONS.values())
    for general, of_order, _ in FORMULAS.values():
        yield from ((text, None) for text in MARKED.findall(general))
        yield from ((text, four) for text in MARKED.findall(of_order))


def _refused(text: str, of: Cayley | None) -> bool:
    try:
        return not compared(text, of).proved
    except ValueError:
        return True


@pytest.mark.parametrize(("text", "of"), dict.fromkeys(_texts()))
def test_altered_formulas_are_refused(text: str, of: Cayley | None) -> None:
    """Raise each integer by one, exchange each sign, double each side."""
    integers = (f"{text[: i.start()]}{int(i[0]) + 1}{text[i.end() :]}" for i in re.finditer(r"\d+", text))
    signs = (f"{text[: i.start()]}{'-' if i[0] == '+' else '+'}{text[i.end() :]}" for i in re.finditer("[-+]", text))
    doubled = (f"{text[: i.end()]} 2 ({text[i.end() :]})" for i in re.finditer("= ", text) if "quad" not in text)
    assert compared(text, of).proved
    for altered in (*integers, *signs, *doubled):
        assert _refused(altered, of), altered


def test_generation_refuses_a_wrong_map_of_an_order(monkeypatch: pytest.MonkeyPatch) -> None:
    right = cayley._definitions

    def wrong(n: int) -> dict[str, str]:
        return {name: text.replace(f"2 q_{{{n}}}^2", f"3 q_{{{n}}}^2") for name, text in right(n).items()}

    monkeypatch.setattr(cayley, "_definitions", wrong)
    for n in (1, 3, 12):
        with pytest.raises(ProofFailed, match=rf"not proved: R = .*\[n = {n}\].*; dcay_n = .*\[n = {n}\]"):
            print_package([Cayley(n)], TARGETS["numpy"])


def test_proof_refuses_a_wrong_map_of_every_chart(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(chart.DEFINITIONS, "tensor", chart.DEFINITIONS["tensor"].replace("g = 2 w^2", "g = 3 w^2"))
    for of in (Cayley(3), family("lambert"), family("exponential"), family("scaled2")):
        with pytest.raises(ProofFailed, match=r"g = 3\*w\^2 \[every phi\]"):
            prove(of)


@pytest.mark.parametrize(
    ("scalar", "right", "wrong"),
    [
        ("pose_scalars", "g = 2 q^2", "g = 5 q^2"), ("pose_scalars", "x c = n", "x c = 2 n"),
        ("quaternion_scalars", "wy = 2 dw", "wy = 3 dw"), ("tangent_scalars", "df/dx", "dg/dx"),
        ("rate_scalars", "1/phi'", "phi'"), ("rate_scalars", "2n/(1 + x)", "n/(1 + x)"),
        ("ray", "a/b = p/q", "a = p"), ("gain_unit", "sin(alpha/2)", "phi"),
    ],
)  # fmt: skip
def test_generation_refuses_a_wrong_comment(
    scalar: str, right: str, wrong: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Alter the formulas above scalar programs; a and b are p and q up to order 8 only."""
    general, of_order, maps = FORMULAS[scalar]
    assert right in general + of_order
    altered = general.replace(right, wrong), of_order.replace(right, wrong), maps
    monkeypatch.setitem(cast(dict[str, Any], FORMULAS), scalar, altered)
    with pytest.raises(ProofFailed, match="not proved: "):
        print_package([Cayley(9)], TARGETS["numpy"])


def test_formulas_need_marks_and_known_names() -> None:
    assert shown("size > 0 and e0 >= 0, `f = 2 s w`") == "size > 0 and e0 >= 0, f = 2 s w"
    for text, message in (
        ("g = 2 w^2", "without marks"), ("`2 w^2`", "no equation"), ("`f = 2 s k`", "not understood"),
        ("`f = 2(s w)`", "not understood"), ("`f = 2 s w)`", "not understood"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=message):
            shown(text)
