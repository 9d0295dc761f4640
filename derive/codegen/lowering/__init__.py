"""Recipes of straight-line programs: of the geometry that all charts share, and of the scalars of one chart.

============ ========================================================================
forward      quaternion, tensor, pose, transform_point, transform_line, inverse
kinematics   tangent, tangent_inv, twist, rate, in space and body frames
inverse      from_quaternion, from_tensor, from_pose, screws, shadows, compose
calculus     derivatives of the tangent operator and its inverse, by time and by v
groups       between, adjoint, Jacobians of composition and of moved points and lines
retraction   steps by the exponential, and the step from one vector to another
coordinates  exponential coordinates of a vector, and back
motion       the screw-linear motion between two vectors
point        a trace that asks a chart for scalars, and v in it: x = v·v, y = v·v°
real         a trace of rotations alone: of the same recipes the real part
scalars      the scalar programs of a chart, traced from its formulas
============ ========================================================================

A recipe needs no trust: what is printed of it is proved equal to the formula afterwards (``codegen.validation``).
"""
