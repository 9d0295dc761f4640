"""Law of one decider: a claim has the same verdict alone, in a file, and in a transcript that states its condition."""

from __future__ import annotations

import pytest

from derive.claims.decide import decide
from derive.claims.result import Result
from derive.claims.sheet import Sheet, claim_alone, sheet

V, N = {"v": "dual vector"}, {"n": "order", "v": "dual vector"}
SCREW = {"alpha": "dual angle", "u": "unit dual vector"}
P, Q, X = "p(n, norm(v)**2)", "q(n, norm(v)**2)", "(1 + norm(v)**2)"
CLAIMS = [  # with letters, condition, and how they are proved; many are equations of CP23
    (f"(1 + v)**n == {P} + {Q}*v", N, "", "exact, all n"),
    (f"cay(n, v) == I + 2*{Q}*{P}/{X}**n*skew(v) + 2*{Q}**2/{X}**n*skew(v)**2", N, "", "exact, all n"),
    ("vect(rate(cay(n, v))*transpose(cay(n, v))) == dcay(n, v)*rate(v)", N, "", "exact, all n"),
    (f"dcay(n, v) == 2*{Q}*{P}/{X}**n*I + 2*{Q}**2/{X}**n*skew(v) + 2*(n*{X}**(n - 1) - {Q}*{P})/(norm(v)**2*{X}**n)"
     "*dyad(v, v)", N, "norm(re(v)) != 0", "exact, all n"),
    ("norm((1 + v)**n) == (1 + norm(v)**2)**(n/2)", N, "", "exact, all n"),
    ("cos(alpha/2) + u*sin(alpha/2) == exp(alpha/2*u)", SCREW, "", "exact"),
    ("exp(alpha*skew(u)) == I + sin(alpha)*skew(u) + (1 - cos(alpha))*skew(u)**2", SCREW, "", "exact"),
    ("dexp(v)*rate(v) == vect(rate(exp(skew(v)))*transpose(exp(skew(v))))", V, "", "exact"),
    ("norm(A*v) == norm(v)", {"A": "orthogonal dual tensor", **V}, "", "exact"),
    ("a/b*b == a", {"a": "dual number", "b": "dual number"}, "re(b) != 0", "exact"),
    ("tan(x)*cos(x) == sin(x)", {"x": "angle"}, "cos(x) != 0", "exact"),
]  # fmt: skip


def verdict(read: Sheet) -> Result:
    assert read.problems == ()
    (entry,) = read.entries()
    return decide("", entry)


SLOW = (2, 3, 7)
"""Places of claims that are tested in thorough runs alone."""


@pytest.mark.parametrize(
    ("claim", "letters", "condition", "how"),
    [pytest.param(*c, id=c[0][:40], marks=pytest.mark.thorough if k in SLOW else ()) for k, c in enumerate(CLAIMS)],
)
def test_verdict_is_the_same_alone_in_a_file_and_in_a_transcript(claim, letters, condition, how) -> None:
    def text(conditions: str, key: str) -> str:
        kinds = "".join(f'{name} = "{kind}"\n' for name, kind in letters.items())
        head = f'[paper]\nconditions = "{conditions}"\n[letters]\n{kinds}'
        return f'{head}[definitions]\nleft = "{claim.split(" == ")[0]}"\n[[equation]]\nnumber = "1"\n{key}' \
               f'claim = "left == {claim.split(" == ")[1]}"\n'  # fmt: skip

    alone = verdict(claim_alone(claim, letters))
    file = verdict(sheet(text("found", ""), "file.toml"))
    stated = f'condition = "{condition}"\n' if condition else ""
    transcript = verdict(sheet(text("stated", stated), "transcript.toml"))
    status = "holds-if" if condition else "holds"
    verdicts = {(str(found.status), found.method.partition(";")[0]) for found in (alone, file, transcript)}
    assert verdicts == {(status, how)}
    assert bool(alone.found) is bool(condition)


@pytest.mark.parametrize(
    ("claim", "letters"),
    [("norm(v) == tan(alpha/(2*n))", {**N, "alpha": "angle"}), ("n/(n - 7) == n/(n - 7)", {"n": "order"}),
     (f"cay(n, v) == I + 2*{Q}*{P}/{X}**n*skew(v)", N), ("a*b == 0", {"a": "dual number", "b": "dual number"}),
     ("norm(v - vector(1, 2, 3))/norm(v - vector(1, 2, 3)) == 1", {"v": "vector"})],
)  # fmt: skip
def test_what_fails_somewhere_is_not_proved_without_condition(claim, letters) -> None:
    assert str(verdict(claim_alone(claim, letters)).status) != "holds"
