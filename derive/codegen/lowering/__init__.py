"""Recipes of straight-line programs: geometry programs that all charts share, and scalar programs of one chart.

============ ========================================================================
forward      quaternion, tensor, pose, transform_point, transform_line, inverse
kinematics   tangent, tangent_inv, twist, rate, in space and body frames
calculus     derivatives of the tangent operator and its inverse, by time and by v
inverse      from_quaternion, from_tensor, from_pose, compose, between
shadows      shadows, screws, the angle, exponential coordinates, which exchange vectors between charts
groups       adjoint, Jacobians of composition and of moved points and lines
retraction   steps by the exponential, and the step from one vector to another
motion       the screw-linear motion between two vectors
point        traces of geometry, for poses and for rotations alone, and vectors in them
scalars      the scalar programs of a chart, traced from its formulas
============ ========================================================================

Recipes need no trust: validation proves their printed text equal to the formulas (``codegen.validation``).
"""
