"""Section 3, derivation steps of (19)-(22): lines 230-245.

Each step uses only the equations it cites: they are solved for the unknown, and all other symbols are free.
"""

from typing import Any

from derive.algebra import dual_part, real_part

from . import *
from .s3b_components import b1_, b2_, b3_, equations, f, general, ss, ss_

unit = Symbol("s^", "unit vector", r"\hat{s}")
COMPONENTS = (
    *(let(symbol, component_of(n, real_part), unit) for n, symbol in enumerate(ss, 1)),
    *(let(symbol, component_of(n, dual_part), unit) for n, symbol in enumerate(ss_, 1)),
)


def solved(unknown: Symbol, left: Term, right: Term) -> Definition:
    """Return the definition of an unknown as the solution of a linear equation."""

    def solution(env: Env, *_: Any) -> Any:
        at_0, at_1 = (env.bound(unknown, value).value(left - right) for value in (0, 1))
        return -at_0 / (at_1 - at_0)

    return let(unknown, solution, *(symbol for symbol in symbols(left - right) if symbol != unknown))


def step(number: str, line: int, given: Definition, conclusion: str) -> Equation:
    """Return the entry about a derivation step whose conclusion is a numbered equation."""
    left, right = equations[conclusion]
    return equation(f"step-{conclusion}", f"{number} give ({conclusion})", line, equal(left, right), claimed=general,
                    stated=(219, r"Now we take $s_1 \neq 0, s_2 \neq 0, s_3 \neq 0$"),
                    where=(*COMPONENTS, given), condition=nonzero(cos(f / 2)), components=True)


(_, on_14), (_, on_15), (_, on_18), (sum_19, on_19), (_, on_20), (_, on_21) = (
    equations[number] for number in ("14", "15", "18", "19", "20", "21")
)

ENTRIES = (
    step("(14) and (18)", 230, solved(b2_, on_14, on_18), "19"),
    step("(18) and (15)", 235, solved(b2_, b2_, on_15.xreplace({b1_: on_18})), "20"),
    step("(20) and (19)", 240, solved(b3_, sum_19.xreplace({b2_: on_20}), on_19), "21"),
    step("(20), (21) and (15)", 245, solved(b1_, on_20, on_15.xreplace({b3_: on_21})), "22"),
)
