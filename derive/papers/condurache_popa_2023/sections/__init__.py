"""Entries of the paper in printed order, one module for each section, and the names that all sections use."""

from ...equation import *
from ...language import values as values
from ...language.common_definitions import *
from ...language.environment import *
from ...language.matrices import exp as exp
from ...language.operator_table import *
from ...language.printed import *
from ..cp23_notation import *
