"""Entries of the paper in printed order, one module for each section, and the names that all sections use."""

from ....claims.equation import *
from ....claims.language import values as values
from ....claims.language.environment import *
from ....claims.language.matrices import exp as exp
from ....claims.language.operator_table import *
from ....claims.language.printed import *
from ..cp23_notation import *
from ..definitions.dual_algebra import *
