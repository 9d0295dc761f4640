r"""Derive, prove and emit the higher-order Cayley parameterization of rigid displacement.

Notation, with one meaning for each letter (CP23 = Condurache & Popa 2023, K10 = Karakılıç 2010):

=================  ==========================================================================================
ε, a°              dual unit, ε² = 0; dual part of a (a trailing ``o`` in code: ``v1o`` is the dual part of v1)
α, u               dual angle (rotation angle + ε translation along the axis) and unit dual vector of the axis
n, k               order n ≥ 1 and branch k = 0 … n−1 (0 principal)
θ                  α/2n
v                  vector φ(α) u of a chart; tan(θ) u is the Rodrigues dual vector, α u the Euler dual vector of CP23
x                  v·v as a dual number; the X of CP23 is its square root
p, q               the polynomials p_n(x), q_n(x); a quaternion is q̂, in code ``e0 … e3``
R, Q, ρ            orthogonal dual tensor R = (I + ε skew(ρ)) Q, rotation Q, translation ρ
dcay, dcay⁻¹       tangent operator ω = dcay v̇ and its inverse
f, g, h            coefficients of dcay: f I + g skew(v) + h v⊗v, and R = I + f skew(v) + g skew(v)²
φ                  an odd function of α in v = φ(α) u; the isomorphism SE(3) → dual tensors of CP23 (15), also called
                   φ there, is ``tensor_from_pose`` here
cay                CP23's bare ``cay`` is n = 1 on tensors (27) but n = 2 on quaternions (34); here ``Cayley(n)``
=================  ==========================================================================================

Names are loaded on first use, so that importing :mod:`derive` takes no time.
"""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import TYPE_CHECKING

from .about import INSTALL, __version__

if TYPE_CHECKING:
    from .claims.run import check
    from .codegen import generate
    from .front import Cayley, Parameterization, family
    from .maps import x
    from .maps.elementary import alpha
    from .motion_equations import motion_equation
    from .pages.comparison import compare
    from .pages.explain import explain
    from .papers import verify

_HOMES = dict.fromkeys(("Cayley", "Parameterization", "family"), "front") | {
    "alpha": "maps.elementary", "x": "maps", "motion_equation": "motion_equations", "generate": "codegen",
    "compare": "pages.comparison", "explain": "pages.explain", "check": "claims.run", "verify": "papers",
}  # fmt: skip
__all__ = [
    "Cayley", "Parameterization", "__version__", "alpha", "check", "compare", "explain", "family", "generate",
    "motion_equation", "verify", "x",
]  # fmt: skip

_OWN = {
    "__init__.py", "__main__.py", "about.py", "front.py", "mcp.py", "motion_equations.py", "workers.py",
    "algebra", "claims", "cli", "codegen", "maps", "output", "pages", "papers", "proof",
}  # fmt: skip
"""Modules and packages of this folder. An installed folder may also hold files of another distribution."""


def _refuse_company(folder: Path) -> None:
    """Raise ImportError if another distribution has installed its package ``derive`` into the same folder."""
    modules = {path.name for path in folder.iterdir() if path.suffix == ".py" or (path / "__init__.py").is_file()}
    if foreign := ", ".join(sorted(modules - _OWN)):
        raise ImportError(
            f"{folder} holds files of another distribution ({foreign}), which cannot be installed together with "
            "dualcay: remove it (pip uninstall derive), then install dualcay again"
        )


if (Path(__file__).parent / "_templates").is_dir():  # only in an installed package
    _refuse_company(Path(__file__).parent)


if not TYPE_CHECKING:  # type checkers know all names by the imports above

    def __getattr__(name: str) -> object:
        if name not in _HOMES:
            raise AttributeError(f"module 'derive' has no attribute {name!r}")
        try:
            return getattr(importlib.import_module(f"derive.{_HOMES[name]}"), name)
        except ModuleNotFoundError as error:
            message = f"derive.{name} needs {error.name}: install with  {INSTALL}"
            raise ModuleNotFoundError(message, name=error.name) from None


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
