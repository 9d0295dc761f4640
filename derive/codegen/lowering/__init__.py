"""Recipes of straight-line programs: of the geometry that all charts share, and of the scalars of one chart.

============ ========================================================================
forward      quaternion, tensor, pose, transform_point, transform_line, inverse
kinematics   tangent, tangent_inv, twist, rate, in space and body frames
calculus     derivatives of the tangent operator and its inverse, by time and by v
inverse      from_quaternion, from_tensor, from_pose, compose, between, screws, shadows
groups       adjoint, Jacobians of composition and of moved points and lines
retraction   steps by the exponential, and the step from one vector to another
motion       the screw-linear motion between two vectors
coordinates  exponential coordinates of a vector, and back
point        traces of geometry, of poses and of rotations alone, and the vectors in them
scalars      the scalar programs of a chart, traced from its formulas
============ ========================================================================

A recipe needs no trust: its printed text is proved equal to the formula afterwards (``codegen.validation``).
"""
