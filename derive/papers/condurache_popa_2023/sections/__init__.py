"""Entries of the paper in printed order, one module for each section, and the names that all sections use."""

from ...equation import *
from ...language import values as values
from ...language.definitions import *
from ...language.evaluation import *
from ...language.notation import *
from ...language.terms import *
from ...numbers.draw import Draw as Draw
from ..operators import *
from ..symbols import *
