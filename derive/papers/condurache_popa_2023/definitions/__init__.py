"""Definitions of the paper's symbols, which its printed formulas are checked against.

===============  ========================================================================
orders           p_n, q_n, the Cayley map of an order, its rotation and tangent operator
dual_algebra     section 2: dual numbers, vectors and tensors by their parts
motions          sections 3 to 5: poses, the tensors that move lines, screws
quaternion_maps  section 4: unit dual quaternions, their displacements and exponentials
low_orders       sections 5, 6 and 9: Cayley maps of the orders 1 and 2 by their rotations
cayley_maps      section 7: maps with their preimages, families, factors a(v)
references       section 7: what a named equation displays
velocities       section 8: twists and tangent operators, by derivatives
===============  ========================================================================

Every function has the arguments of `derive.papers.language.evaluation.Definition`: the environment, then values.
"""
