"""Claims whose truth is known: identities and order relations, made false at one place, point, bound, order or part.

``python -m tests.support.claims_of_known_truth --seed 3 --count 1000`` decides many, and prints wrong verdicts and the
share of open ones.
"""

from __future__ import annotations

import argparse
import random
import re
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from derive.claims.decide import decide
from derive.claims.result import Result, Status
from derive.claims.sheet import claim_alone

LETTERS = {
    "x": "real", "y": "real", "s": "positive", "a": "angle", "b": "angle", "v": "vector", "w": "vector", "u": "vector",
    "R": "rotation", "S": "rotation", "q": "unit quaternion", "n": "order", "k": "integer", "A": "tensor",
    "X": "dual number",
    "xi": "twist", "T": "pose", "e": "unit vector",
}  # fmt: skip
IDENTITIES = (
    ("sin(a + b)", "sin(a)*cos(b)", "cos(a)*sin(b)"), ("cos(2*a)", "1", "-2*sin(a)**2"),
    ("sin(3*a)", "3*sin(a)", "-4*sin(a)**3"),
    ("cross(u, cross(v, w))", "v*dot(u, w)", "-w*dot(u, v)"),
    ("norm(v + w)**2", "norm(v)**2 + norm(w)**2", "2*dot(v, w)"),
    ("norm(cross(v, w))**2", "norm(v)**2*norm(w)**2", "-dot(v, w)**2"),
    ("skew(v)*skew(w)", "dyad(w, v)", "-dot(v, w)*I"),
    ("exp(skew(v))*w", "w + sinc(norm(v))*cross(v, w)", "sinc(norm(v)/2)**2/2*cross(v, cross(v, w))"),
    ("exp(a*skew(e))", "cos(a)*I + sin(a)*skew(e)", "(1 - cos(a))*dyad(e, e)"),
    ("trace(exp(skew(v)))", "1", "2*cos(norm(v))"),
    ("cosh(x)**2", "1", "sinh(x)**2"), ("sinh(x + y)", "sinh(x)*cosh(y)", "cosh(x)*sinh(y)"),
    ("(x + y)**3", "x**3 + y**3", "3*x*y*(x + y)"), ("rate(x*y)", "x*rate(y)", "y*rate(x)"),
    ("rate(R*S)", "rate(R)*S", "R*rate(S)"),
    ("rate(sin(x))", "0*x", "cos(x)*rate(x)"), ("rate(dot(v, w))", "dot(v, rate(w))", "dot(w, rate(v))"),
    ("du(X*X)", "re(X)*du(X)", "du(X)*re(X)"),
    ("adjoint(T)*xi - xi", "(adjoint(T) - identity(6))*xi/2", "(adjoint(T) - identity(6))*xi/2"),
    ("sum(k, 0, n, k)", "n/2", "n**2/2"), ("binomial(n + 1, 2)", "binomial(n, 2)", "n"),
    ("norm(x*v)**2", "x**2*dot(v, v)/2", "x**2*norm(v)**2/2"),
    ("log(s*exp(x))", "log(s)", "x"), ("sqrt(s**2*x**2)", "s*norm(x)/2", "norm(s*x)/2"),
    ("det(A*R)", "det(A)/2", "det(A)/2"),
    ("jacobian(norm(v)**2, v)", "transpose(v)", "transpose(v)"),
    ("R*skew(v)*transpose(R)", "skew(R*v)/2", "skew(R*v)/2"),
)  # fmt: skip
"""Left side, and the two terms of the right side."""
ZEROS = ("x - {c}", "x*y - {c}", "norm(v)**2 - {d}", "sin(a)", "s - {d}", "dot(v, w)", "entry(v, 1) - {c}")
"""Numbers that vanish at some points, for claims that are false beside these."""
BOUNDS = (
    ("norm(v + w)", "norm(v) <= {c} and norm(w) <= {d}", "{c} + {d}"),
    ("x*y", "0 <= x and x <= {c} and 0 <= y and y <= {d}", "{c}*{d}"),
    ("x + 2*y", "norm(x) <= {c} and norm(y) <= {d}", "{c} + 2*{d}"),
    ("dot(v, w)", "norm(v) <= {c} and norm(w) <= {d}", "{c}*{d}"),
    ("entry(v, 2)", "norm(v) <= {c}", "{c}"), ("x**2", "norm(x) <= {c}", "{c}**2"),
    ("norm(cross(v, w))", "norm(v) <= {c} and norm(w) <= {d}", "{c}*{d}"),
    ("entry(v, 1) + entry(v, 2)", "norm(v) <= {c}", "{c}*sqrt(2)"),
    ("x*y", "norm(x) <= {c} and norm(y) <= {d}", "{c}*{d}"),
    ("x*y*s", "0 <= x and x <= {c} and 0 <= y and y <= {d} and s <= 3", "3*{c}*{d}"),
    ("norm(v - 2*w)", "norm(v) <= {c} and norm(w) <= {d}", "{c} + 2*{d}"),
    ("-dot(v, w)", "norm(v) <= {c} and norm(w) <= {d}", "{c}*{d}"),
    ("norm(R*v + w)", "norm(v) <= {c} and norm(w) <= {d}", "{c} + {d}"),
    ("norm(x*v)", "norm(x) <= {c} and norm(v) <= {d}", "{c}*{d}"), ("dot(e, v)", "norm(v) <= {c}", "{c}"),
    ("{c}*sin(x) + {c}*cos(y)", "norm(x) <= 9", "2*{c}"), ("x*({c} - x)", "norm(x) <= 9", "{c}**2/4"),
    ("exp(-x**2)*{c}", "norm(x) <= {d}", "{c}"), ("{c}*x - x**3", "0 <= x and x <= {d}", "2*{c}/3*sqrt({c}/3)"),
)  # fmt: skip
"""A number, a domain, and its largest value there."""
BELOW = (
    "exp(x) + {c} > exp(x)", "tanh(x) < 1", "1/(1 + exp(-x)) < 1", "cosh(x) != sinh(x)", "acos(tanh(x)) > 0",
    "x**2 + {c} > 0",
    "tanh(x) != 1", "exp(x) != 0", "1 + exp(-x**2) > 1", "x**2 + y**2 >= 2*x*y", "norm(v)*norm(w) >= dot(v, w)",
    "trace(R) <= 3",
    "exp(x) >= 1 + x", "cosh({c}*x) >= 1 + {c}**2*x**2/2", "norm(sin({c}*x)) <= {c}*norm(x)",
    "log(s) <= s/{c} - 1 + log({c})",
    "tanh(x)*x <= x**2", "trace(R) >= -1", "norm(entry(R, 1, 2)) <= 1", "norm(dot(v, w)) <= (dot(v, v) + dot(w, w))/2",
    "x**4 + y**4 >= 2*{c}*x*y - {c}**2/2", "norm(v + w + u) <= norm(v) + norm(w) + norm(u)", "sin(x)*cos(y) <= 1",
    "implies(tanh(x) == 1, x == {c})", "implies(exp(-x**2) == 0, x == {c})", "floor(tanh(x)) < 1",
)  # fmt: skip
"""Relations that are true, some nearer to equality than numbers of any precision show."""
ABOVE = (
    "tanh(x) > 1", "exp(x) > {c}", "x**2 > 0", "norm(v) > 0", "x != {c}", "norm(v) != {d}", "rate(x) != 0",
    "norm(rate(v)) <= {c}0",
    "sin(pi*du(X)) == 0", "(rate(x)**2 - 1)*(rate(x)**2 - 4)*(rate(x)**2 - 9) == 0", "exp(-(x - 37)**2) < 1/2",
    "floor(k/97)*97 != k", "(x**2 - {d})**2 > 0", "rate(x)*rate(y) != {c}", "floor(sin(x)**2) == 0", "cos(x) < 1",
    "(1 + x)**3 >= 1 + 3*x", "sin(x) < 1", "sin(x)*cos(x) < 1/2", "floor(cos(x)**2) == 0", "tan(x) >= x",
    "exp(x) >= 1 + {d}*x",
    "exp(-{c}*(x + 1{c}1)**2) < 1/3", "norm(v) - entry(v, 3) > 0", "trace(R) + 1 + norm(v) > 0",
    "norm(x) + norm(x - {c}) > {c}", "norm(v - vector({c}, 1, {d})) + norm(w) > 0", "2 + entry(e, 3) + sin(x) > 0",
    "norm(cross(v, w)) < norm(v)*norm(w)",
    "x**4 + y**4 >= 2*{c}*x*y - {c}**2/3", "(cos(x) - x/{d})**2 > 0", "1/(1 + (x - 3{c})**2) < 1",
)  # fmt: skip
"""Relations that are false, some at single points alone."""

EXISTING = (
    ("sqrt({p})**2 == {p}", "log({p}) == log({p})", "({p})/({p}) == 1", "norm(x)/({p}) == norm(x)*({p})**-1",
     "integral(1/(t + {p})**2, t, 0, 1) == 1/({p})/({p} + 1)", "rate(sqrt({p})) == rate({p})/(2*sqrt({p}))"),
    ("x**2 + {c}", "exp(x)", "{c} + sin(x)*cos(y)", "cosh(x) - 1/2", "dot(v, v) + {c}", "s + {c}", "4 + trace(R)"),
    ("x - {c}", "x*y", "sin(x)", "x**2 - {d}", "norm(v) - {d}", "entry(v, 1)", "trace(R)", "s - {c}"),
)  # fmt: skip
"""Claims with a partial operation of p, numbers p that are positive, and those that are not everywhere."""


@dataclass(frozen=True)
class Known:
    """Claim with its truth: True, False, or None if it is true under a condition only."""

    claim: str
    truth: bool | None
    domain: str = ""


def _identity(source: random.Random) -> Known:
    left, one, two = source.choice(IDENTITIES)
    return Known(f"{left} == {one} + ({two})", True)


def _changed(source: random.Random) -> Known:
    left, one, two = source.choice(IDENTITIES)
    scale = source.choice(("2", "-1", "1/2", f"(1 + 1/10**{source.choice((3, 12, 30, 45))})"))
    return Known(f"{left} == {one} + {scale}*({two})", False)


def _at_a_point(source: random.Random) -> Known:
    """Divide both sides by a number that vanishes somewhere."""
    left, one, two = source.choice(IDENTITIES[:6])
    zero = source.choice(ZEROS).format(c=source.randint(1, 9), d=source.randint(2, 9))
    vector = "cross(u" in left
    return Known(f"({zero})/({zero}) == 1" if vector else f"({left} - ({one}) - ({two}))/({zero}) + 1 == 1", None)


def _bound(source: random.Random, slack: str, truth: bool) -> Known:
    number, domain, most = source.choice(BOUNDS)
    c, d = source.randint(2, 5), source.randint(2, 5)
    return Known(f"{number.format(c=c, d=d)} <= {most.format(c=c, d=d)}{slack}", truth, domain.format(c=c, d=d))


def _relation(source: random.Random, rows: tuple[str, ...], truth: bool) -> Known:
    return Known(source.choice(rows).format(c=source.randint(1, 9), d=source.randint(2, 9)), truth)


def _existing(source: random.Random, positive: bool) -> Known:
    forms, above, mixed = EXISTING
    p = source.choice(above if positive else mixed).format(c=source.randint(2, 9), d=source.randint(2, 9))
    return Known(source.choice(forms).format(p=p), True if positive else None)


def _at_an_order(source: random.Random) -> Known:
    n = source.choice((3, 7, 20, 41, 97))
    return Known(f"n != {n}" if source.random() < 0.5 else f"(n - {n})**2 > 0", False)


KINDS: tuple[Callable[[random.Random], Known], ...] = (
    _identity, _changed, _at_a_point, lambda s: _bound(s, "", True), lambda s: _bound(s, " - 1/5", False),
    lambda s: _relation(s, BELOW, True), lambda s: _relation(s, ABOVE, False), _at_an_order,
    lambda s: _existing(s, True), lambda s: _existing(s, False),
)


def drawn(seed: int, count: int) -> Iterator[Known]:
    """Yield claims of all kinds in turn."""
    source = random.Random(seed)
    for i in range(count):
        yield KINDS[i % len(KINDS)](source)


def used(text: str) -> dict[str, str]:
    """Return the kinds of the letters in a text."""
    return {name: kind for name, kind in LETTERS.items() if re.search(rf"\b{name}\b", text)}


def decided(known: Known) -> Result:
    """Return the result of a claim."""
    (entry,) = claim_alone(known.claim, used(known.claim + known.domain), domain=known.domain).entries()
    return decide("known", entry)


def is_wrong(known: Known, status: Status) -> bool:
    """Return whether a status contradicts the truth of a claim."""
    right = {True: Status.HOLDS, False: Status.FALSE, None: Status.HOLDS_IF}
    return status not in (right[known.truth], Status.UNREFUTED, Status.UNDECIDED)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=200)
    given = parser.parse_args()
    tally: Counter[str] = Counter()
    for known in drawn(given.seed, given.count):
        result = decided(known)
        tally[f"{known.truth}: {result.status}"] += 1
        if is_wrong(known, result.status):
            print(f"WRONG {known.claim} [{known.domain}] is {known.truth}: {result!r} {result.method}", flush=True)
        elif result.status in (Status.UNREFUTED, Status.UNDECIDED):
            print(f"open  {known.claim} [{known.domain}] is {known.truth}: {result.method}", flush=True)
    print(dict(sorted(tally.items())))


if __name__ == "__main__":
    main()
