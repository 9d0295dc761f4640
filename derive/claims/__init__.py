"""Decision of claims: formulas of papers, of files and of the command line.

===========  ================================================================================
numbers      fields in which formulas are evaluated, and values of symbols
language     grammar, terms, operators, values and evaluation of formulas
equation     entries for printed equations and claims, and papers
result       verdicts and status of an entry
deciding     one claim: points where it may fail, conditions, regions, changes that mend it, proof
decide       decision of an entry
transcript   equations of a file that follows a paper's text, with stated conditions
sheet        papers as TOML files, read to entries
run          decision of a file's equations in worker processes
report       results as text, JSON, Markdown, HTML and LaTeX
===========  ================================================================================

Each module imports only from modules above it in the table. No chart and no paper is known here.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from ..output.listing import Listing
from ..output.progress import bar, no_op
from .deciding.claim import ORDERS
from .equation import Entry, Paper, Reading, UndecidedError, equation
from .language.abbreviations import ClaimError
from .result import Result, Status, Verdict
from .run import SECONDS, decide_each
from .sheet import Sheet, SheetError, claim_alone, load


def check(claim: str, /, *, domain: str = "", seconds: float = SECONDS, **letters: str) -> Result:
    """Decide one claim.

    Parameters
    ----------
    claim : str
        Relation in plain text, such as ``"R*transpose(R) == I"``. It is parsed, never evaluated.
    domain : str, optional
        Relation that states where the claim is said to hold.
    seconds : float, optional
        Time limit; a slower claim is undecided.
    **letters : str
        Kind of each letter, such as ``v="vector"`` or ``n="unit vector"``.

    Returns
    -------
    Result
        Its `status` is "holds", "holds-if" with the condition `found`, "false" with a counterexample and `changes` that
        make the claim true, or "undecided" with the reason as `method`.

    Raises
    ------
    ValueError
        If the claim, the domain or a kind cannot be read: with the column and what was expected.

    Examples
    --------
    >>> import derive
    >>> derive.check("inverse(exp(skew(v))) == exp(skew(-v))", v="vector")
    <Result holds>
    """
    with bar() as step:
        step("claim")
        (result,) = check_sheets([claim_alone(claim, letters, domain)], None, seconds)
    return result


def check_sheets(
    sheets: Sequence[Sheet], numbers: Collection[str] | None = None, seconds: float = SECONDS,
    step: Callable[[str], None] = no_op,
) -> Listing[Result]:
    """Decide the equations of files; `numbers` chooses some, and `step` is called after each."""
    places = [(sheet, place, entry.number) for sheet in sheets for place, entry in enumerate(sheet.entries())]
    items = [(sheet, place) for sheet, place, number in places if numbers is None or number in numbers]
    return Listing(decide_each(items, seconds, step))


__all__ = [
    "ORDERS", "SECONDS", "ClaimError", "Entry", "Paper", "Reading", "Result", "Sheet", "SheetError", "Status",
    "UndecidedError", "Verdict", "check", "check_sheets", "claim_alone", "equation", "load",
]  # fmt: skip
