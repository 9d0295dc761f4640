"""Entries of the paper in printed order, by section.

======  =============================================================================
s02_1   dual numbers
s02_2   dual vectors
s02_3   dual tensors
s03     rigid motion by orthogonal dual tensors
s04     dual quaternions
s05     Cayley transforms of tensors
s06     Cayley transforms of quaternions
s07     symbols of a general order n, for sections 7 to 9
s07a    the fractional transform of order n, theorems 11 to 14
s07b    the fractional transform at orders 1 to 5
s07c    vectorial parameterizations, theorems 15 to 17
s07d    five families
s07e    references to wrong equation numbers
s08a    kinematics, theorems 18 and 19
s08b    tangent operators, theorem 20
s09a    explicit formulas for orders 1 to 3
s09b    explicit formulas for orders 4 and 5
s09c    order 1 by components
s10     the conclusions
======  =============================================================================
"""
