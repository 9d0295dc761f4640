"""``python -m derive.mcp``: `derive.check` as a tool of the Model Context Protocol, on standard input and output.

It needs the extra ``mcp``. A claim is parsed, never evaluated.
"""

from __future__ import annotations

import sys
from contextlib import suppress
from typing import Any


def check(claim: str, letters: dict[str, str], domain: str = "") -> dict[str, Any]:
    """Decide a claim on vectors, rotations, quaternions or poses: true, true where, or false with a counterexample.

    The claim is a relation in plain text, such as "inverse(exp(skew(v))) == exp(skew(-v))". Each letter has a kind,
    such as {"v": "vector"}. The domain is a relation under which the claim is said to hold; empty for none.
    """
    from mcp.server.mcpserver.exceptions import ToolError

    from .claims.run import check_sheets
    from .claims.sheet import claim_alone

    try:
        (result,) = check_sheets([claim_alone(claim, letters, domain)], keep=True)
    except ValueError as error:
        raise ToolError(str(error)) from None
    return result.as_json()


def main() -> int:
    """Serve until the standard input ends, and return the exit code: 3 if a library is missing."""
    try:
        from mcp.server.mcpserver import MCPServer

        from .claims.language.letters import LETTERS
        from .claims.language.operations import OPERATIONS
    except ModuleNotFoundError as error:
        print(f'derive.mcp: needs {error.name}: install with  pip install ".[mcp]"', file=sys.stderr)
        return 3
    words = f"Kinds of letters: {', '.join(LETTERS)}. Operations: {', '.join(OPERATIONS)}."
    server = MCPServer("dualcay", instructions=words)
    server.add_tool(check)
    with suppress(KeyboardInterrupt):
        server.run()
    return 0


if __name__ == "__main__":
    sys.exit(main())
