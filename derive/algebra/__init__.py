"""Dual numbers, vectors, tensors and quaternions over any commutative coefficients, and the algebra {I, skew(v), v⊗v}.

The classes are immutable values. A vector, tensor or quaternion with ``Dual`` coefficients is dual, with parts ``.re``
and ``.du``.

================== ====================================================================
dual               `Dual`: ``a + ε a°``, its inverse, powers, magnitude and ``f(a) + ε a° f'(a)``
functions          sin, cos, tan, cot, atan, atan2, sqrt, expm1, log1p and others of plain and dual numbers
structures         `Vector` (dot, cross, magnitude), `Tensor` (skew, dyad, vect, trace, det, transpose, inverse),
                   `Quaternion` (conjugate, norm, inverse, sandwich), with sums and products
isotropic          `Isotropic`: ``a I + b skew(v) + c v⊗v`` as an algebra over functions of ``x = v · v``
mixed              sums and products between numbers, vectors, quaternions and tensors, as in the papers
element, exact     `Element` and its ring: rational functions over Q, modulo relations
angles             exact sine and cosine of multiples of given angles
polynomial_backend polynomials over Q by python-flint or SymPy
arithmetic         operations of formulas other than + − ×, on numbers; traces override the operations
================== ====================================================================
"""

from .dual import Coefficient, Dual, Structure, ZeroDivisorError, dual_part, real_part
from .isotropic import Isotropic
from .structures import Quaternion, Tensor, Vector

__all__ = [
    "Coefficient", "Dual", "Isotropic", "Quaternion", "Structure", "Tensor", "Vector", "ZeroDivisorError", "dual_part",
    "real_part",
]  # fmt: skip
