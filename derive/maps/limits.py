r"""The scaled charts ``2n tan(α/2n)`` tend to the exponential one, like 1/n²: how far scalars are off, to first order.

At a fixed v let ``r = |v|`` and ``ε = 1/(2n)²``. Then ``tan(α/2n) = √ε r``, so that

.. math::
    \alpha = \frac{\arctan(\sqrt\varepsilon\,r)}{\sqrt\varepsilon} = r - \tfrac13 \varepsilon r^3 + \dots \qquad
    \varphi' = 1 + \varepsilon r^2

The first is a power series in ε r², which converges for ``ε r² < 1``, that is for angles up to nπ/2; scalars are
analytic functions of α², φ′ and x = r². So they are analytic in ε there; their value at 0 is that of the exponential
chart, and the difference is ``ε`` times what `deviation` returns, but for terms of order ε².
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import sympy

r = sympy.Symbol("r", positive=True)
"""|v|."""

_epsilon, _alpha = sympy.symbols("epsilon alpha", positive=True)


@cache
def deviation() -> Mapping[str, sympy.Expr]:
    """The derivatives by ε = 1/(2n)², at ε = 0, of s, w, f, g, h (see `chart.Scalars`) as functions of |v|."""
    z = sympy.Symbol("z")
    bend = sympy.series(sympy.atan(z) / z, z, 0, 4).removeO().coeff(z, 2)
    rates = {_alpha: bend * r**3, _epsilon: sympy.Integer(1)}
    found = {}
    for name, value in _scalars().items():
        change = sum(value.diff(letter) * rate for letter, rate in rates.items())
        found[name] = change.subs({_alpha: r, _epsilon: 0})
    return found


def exponential() -> Mapping[str, sympy.Expr]:
    """The scalars at ε = 0, functions of |v|."""
    return {name: value.subs({_alpha: r, _epsilon: 0}) for name, value in _scalars().items()}


def _scalars() -> Mapping[str, sympy.Expr]:
    """By the theorems on every φ, in α, ε and |v|."""
    half, along = _alpha / 2, sympy.sin(_alpha) / r
    rate = 1 / (1 + _epsilon * r**2)
    return {
        "s": sympy.cos(half),
        "w": sympy.sin(half) / r,
        "f": along,
        "g": 2 * sympy.sin(half) ** 2 / r**2,
        "h": (rate - along) / r**2,
    }
