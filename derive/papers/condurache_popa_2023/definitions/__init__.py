"""Definitions of the paper's symbols, against which its printed formulas are checked.

===============  ========================================================================
orders           p_n, q_n, the Cayley map of order n, its rotation and tangent operator
dual_algebra     section 2: dual numbers, vectors and tensors
motions          sections 3 to 6: poses, their action on lines, screws, unit dual quaternions
low_orders       sections 5, 6 and 9: Cayley maps of orders 1 and 2
cayley_maps      section 7: maps with their preimages, families, factors a(v)
references       section 7: claims that name an equation by its number
velocities       section 8: twists and tangent operators
===============  ========================================================================

Each function takes the arguments of `derive.papers.language.evaluation.Definition`: the environment, then values.
"""
