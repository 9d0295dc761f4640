"""Dual numbers, vectors, tensors and quaternions over any commutative coefficients, and the algebra {I, skew(v), v⊗v}.

Nothing here knows what it will be used for. The classes are immutable values; ``Dual`` coefficients turn a vector,
tensor or quaternion into a dual one, with ``.re`` and ``.du`` its parts.

========== ============================================================================
dual       `Dual`: ``a + ε a°``, its inverse, powers, magnitude and ``f(a) + ε a° f'(a)``
functions  sin, cos, tan, cot, atan, atan2, sqrt, expm1, log1p and others of plain and dual numbers
vector     `Vector`: sum, multiple, dot, cross, magnitude
tensor     `Tensor`: skew, dyad, vect, trace, det, transpose, product, inverse
quaternion `Quaternion`: product, conjugate, norm, inverse, sandwich
isotropic  `Isotropic`: ``a I + b skew(v) + c v⊗v`` as an algebra over functions of ``x = v · v``
mixed      sums and products of different ones side by side, as the papers write them
========== ============================================================================
"""

from .coefficients import Coefficient, Structure, ZeroDivisorError
from .dual import Dual, dual_part, real_part
from .isotropic import Isotropic
from .quaternion import Quaternion
from .tensor import Tensor
from .vector import Vector

__all__ = [
    "Coefficient",
    "Dual",
    "Isotropic",
    "Quaternion",
    "Structure",
    "Tensor",
    "Vector",
    "ZeroDivisorError",
    "dual_part",
    "real_part",
]
