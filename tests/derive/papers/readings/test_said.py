"""What the search says of many values, yes, no, or why it cannot tell, is what it said before.

``python -m tests.derive.papers.readings.test_said`` prints what it says, for where a change is meant.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator

import pytest

from derive.papers.language.notation import norm
from derive.papers.language.terms import MARKS
from derive.papers.numbers.residues import PRIME
from derive.papers.readings.reach import Reach
from derive.papers.readings.stretches import Stretches
from derive.papers.readings.targets import Target, UndecidedSearchError, scaled
from derive.papers.readings.tokens import Place, Token
from tests.derive.papers.readings.test_no_is_final import DISPLAYS, name, values
from tests.derive.papers.readings.test_reach import ALONG, LISTED, I, a, b, c, f, n, one, plus, side, tilde, two, v

bars = Token(mark=norm, place=Place.BEFORE)
star, transposed = (Token(mark=MARKS[mark], place=Place.AFTER) for mark in ("conjugate", "transpose"))
APPLIED = [
    (f, a, b), (a, f, b, v), (f, n, a, v), (v, f, two, a), (f, two, n, v), (f, n, plus, two, v), (bars, v, a),
    (bars, a, b, v), (a, bars, v, two), (I, f, a, v, tilde), (I, bars, v, v, tilde), (I, v, tilde, f, n, two),
    (a, b, plus, I, v, tilde), (a, b, n, v), (a, b, c, v), (a, v, b, c), (a, v, star), (I, a, v, one, transposed),
    (I, v, v, v), (I, a, v, v, v), (I, a, b, one), (I, plus, a, v, b, v), (I, plus, v, v, two), (I, v, v, a, one),
]  # fmt: skip
"""Functions, a mark before what it is of or behind it, and further products and powers."""

ALL = {name(tokens): tokens for tokens in (*DISPLAYS, *(tokens for tokens, _ in LISTED), *APPLIED)}
MOST = 24
"""Values of a stretch that are tried: the first and the last of them, and as many wrong ones of each kind."""
SHORT = 2


def tried(found: dict[Target, None]) -> Iterator[Target]:
    """Values, and what differs from them in one component or all."""
    listed = list(found)
    for t in dict.fromkeys((*listed[: MOST // 2], *listed[-MOST // 2 :])):
        yield from (t, scaled(7, t), tuple((x + 5) % PRIME for x in t), tuple(0 * x for x in t))
        if len(t) > 1:
            yield from (tuple(x if k == m else 0 for k, x in enumerate(t)) for m in range(len(t)))
            yield from (tuple(7 * x % PRIME if k == m else x for k, x in enumerate(t)) for m in range(len(t)))


def said(tokens) -> str:
    """By which components stretches are known, and what the search says of values of each; as a count and a digest."""
    lines = []
    for (i, j), found in values(Stretches(side(tokens, 100_000), ALONG)):
        for few in (1, 3):
            for short in (0, SHORT):
                reach = Reach(side(tokens, few), ALONG, short)
                for t in tried(found or {}):
                    known = _known(reach.stretches, i, j, len(t))
                    lines.append(f"{i} {j} {few} {short} {t} {known} {_says(reach, i, j, t)}")
    return f"{len(lines)} {hashlib.sha256(chr(10).join(lines).encode()).hexdigest()[:12]}"


def _known(stretches: Stretches, i: int, j: int, n: int) -> str:
    try:
        parts = sorted(stretches.support(i, j, n))
        listed = [stretches.listed_component(i, j, k, n) for k in parts]
    except UndecidedSearchError as error:
        return str(error)
    return str([(k, None if few is None else (len(few), sum(few))) for k, few in zip(parts, listed, strict=True)])


def _says(reach: Reach, i: int, j: int, t: Target) -> str:
    try:
        return str(reach.can(i, j, t))
    except UndecidedSearchError as error:
        return str(error)


SAID = {
    "a b v": "1568 9e57a97dcb62", "a v b": "1616 7afaa33bb90c", "v a b": "1568 dea302f27aca",
    "v a v": "1664 bd5ad3b05c21", "v v a": "1712 8e9dcd53020b", "a v v": "1712 04201aaa1d8b",
    "2 v a": "1824 72c080b294d4", "v 2 a": "1888 faabb685f0b7", "a v 2": "1952 4a98095378e0",
    "a b v c": "3984 96191b6e0dcb", "a plus v b": "880 968f5984dad5", "a plus v 2 b": "4208 e4dc67c34939",
    "a b 2 plus v": "3648 75fb83fa805d", "a b plus c v": "2400 4dde4468a2ca", "v plus a v b": "3584 88553b2d0fa0",
    "v plus a v plus v": "3376 4acd48aa78d3", "a plus b plus c plus v": "608 5120a795351a",
    "a 12 b": "1344 1edd131805ff", "b v skew 2 I": "720 550180353853", "v skew 2 a I": "888 c84034475297",
    "I plus b v skew 2": "520 45f36cb8d898", "I plus v skew 2 a": "808 64aeec2c1e56",
    "I v skew a": "472 a25e80830571", "I a v v": "2032 68c10c2079d1", "I v a v": "2264 a9139f31bfe2",
    "I v b v skew": "3280 34a0edb67831", "I plus v skew v skew": "712 7a9ce20e59cf",
    "I v skew 2 v": "1520 af4e84ff510e", "I plus v plus a v v": "1960 8f18941d1655",
    "I a b v skew 2": "3432 631d0294f87e", "I a v skew c 2": "2376 79eea38dca49", "a I v v skew": "2280 82816ba89c8c",
    "a I 1 b v skew": "3400 a70f5e9dbbfa", "a v skew v skew": "560 0dd21c6a0d71", "a b c": "1104 e7e69648fc4e",
    "a b c d": "3120 5917f60b8876", "a 2 b": "1344 50bc6f4627de", "a 2 3 b": "2880 7c9b67ff45ad",
    "a b plus c d": "2208 75df3b1ff270", "a plus b 2 c": "2928 81b8c41a9193", "a b 2 plus c": "3072 a0da3a356f33",
    "a plus b plus 2 c": "1056 1f3688b690ae", "2 a plus 3 b": "2208 51c4c98717d9", "1 a b": "864 47d7738b4cfd",
    "a a b": "1008 a0081da9f247", "a I v skew": "592 e255df3fcb32", "a b I v skew": "1616 989b92e43bbd",
    "a I plus b v skew": "440 c72fb3009c51", "I plus a b v skew": "888 b8f9e7a42dc7",
    "a b I plus v skew": "768 879595732bd3", "a I plus v skew": "304 53a9bd73b975",
    "I plus v skew a": "304 dd006b975b71", "I plus a v skew b": "480 913b3b0c5fd3",
    "2 a I plus v skew b": "1624 a2817023bbe2", "I plus a v skew plus v skew 2": "848 2474234703e8",
    "a I plus b v skew plus c v skew 2": "2000 0a5c4c550e2c",
    "2 I plus a v skew plus b v skew 2": "2000 a067252dc45c", "f a b": "576 f0c2356188c2",
    "a f b v": "2128 90966b75c658", "f n a v": "3168 96155faa653a", "v f 2 a": "2224 ab108c8cfd32",
    "f 2 n v": "3312 131ab0a6ab67", "f n plus 2 v": "2256 995a6376d031", "norm v a": "528 7bc7a803b460",
    "norm a b v": "2832 3ba2043eeb9d", "a norm v 2": "2224 352cb1ab5c03", "I f a v skew": "1040 c446321c89cb",
    "I norm v v skew": "992 564168f136c5", "I v skew f n 2": "2032 2dfed61bca98",
    "a b plus I v skew": "488 c75735966325", "a b n v": "4320 57d9302c71de", "a b c v": "3536 f66602f332d9",
    "a v b c": "3952 083b09eed055", "a v conjugate": "704 635bf0f7748d", "I a v 1 transpose": "1704 fca37c7e7384",
    "I v v v": "2536 ee7e3a1ee397", "I a v v v": "6280 8eb5d7ca33f9", "I a b 1": "1000 60a937ea6b0d",
    "I plus a v b v": "2104 0fcef1821e9e", "I plus v v 2": "1112 fdb71eb36868", "I v v a 1": "5232 e01335334c77",
}  # fmt: skip


@pytest.mark.parametrize("display", ALL)
def test_the_search_says_what_it_said(display) -> None:
    assert said(ALL[display]) == SAID[display]


if __name__ == "__main__":
    for display, tokens in ALL.items():
        print(f"    {display!r}: {said(tokens)!r},")
