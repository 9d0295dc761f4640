"""What the papers define: the polynomials p_n, q_n, the Cayley maps of order n and their inverses, screws and poses.

CP23 is Condurache and Popa, Symmetry 15(11) 2011 (2023), cited by equation number.
"""

from .any_phi.expressions import PhiError
from .cayley import Cayley
from .formula import Formula, IsotropicMap, QuaternionMap
from .named import family, parameterization
from .polynomials import x

__all__ = ["Cayley", "Formula", "IsotropicMap", "PhiError", "QuaternionMap", "family", "parameterization", "x"]
