"""Dual numbers, vectors, tensors and quaternions over any commutative coefficients, and the algebra {I, skew(v), v⊗v}.

The classes are immutable values. A vector, tensor or quaternion with ``Dual`` coefficients is dual, with parts ``.re``
and ``.du``.
"""

from .dual import Coefficient, Dual, Structure, ZeroDivisorError, dual_part, real_part
from .structures import Isotropic, Quaternion, Tensor, Vector

__all__ = [
    "Coefficient", "Dual", "Isotropic", "Quaternion", "Structure", "Tensor", "Vector", "ZeroDivisorError", "dual_part",
    "real_part",
]  # fmt: skip
