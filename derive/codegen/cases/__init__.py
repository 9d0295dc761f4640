"""What kernel functions must return: cases from the formulas alone, for whoever executes a kernel.

======== ========================================================================================
exact    algebraic functions on symbols (elements of an exact ring), or at numbers
digits   maps with sqrt, tan and atan2 at seeded screws, to 50 digits
decimals these numbers, and how near they have to be
batches  both, for the validation of a text; complete, or an error
seeded   numbers that a float holds and their results, for languages whose kernels take no others
floats   results at all combinations of arguments, for calls on arrays of floats
point    numbers in place of the symbols of formulas
vectors  φ(α + 2πk) u of a chart and the way back to α and u, from φ alone
maps_at  by these, inverse maps, screws, shadows and composition at given numbers
steps    far steps and motions, and steps next to a pole, to 50 digits
screws   seeded screws on which every side of every selection is taken
======== ========================================================================================
"""

from .batches import Batch, batches
from .floats import Samples, far, samples
from .seeded import Case, cases

__all__ = ["Batch", "Case", "Samples", "batches", "cases", "far", "samples"]
