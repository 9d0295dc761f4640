r"""Charts of a user's own φ: how an expression φ(α) becomes scalar programs that hold to the last digit.

A chart is ``v = φ(α) u``. Its scalars are functions of ``x = v · v``, and φ⁻¹ has no formula in general. So the scalars
are computed in two ranges, and the limit between them is the chart's own:

========================  ==========================================================================================
near v = 0                ``a(x) = α/|v|`` is analytic. An interpolating polynomial replaces it, with a proved bound
                          of the error. Series (Stumpff functions) in ``ξ = x a²`` then give all scalars.
beyond                    Newton's method finds the angle from ``|v|``. Scalars follow from α, φ and its derivatives.
========================  ==========================================================================================

The steps, in the order of their use, and the module of each:

====================  ==============================================================================================
grammar               Check the text against a list of allowed syntax. Nothing is evaluated, SymPy is not loaded.
expressions           Build the SymPy expression, and decide that it is odd by its structure.
recognition           Decide whether φ is a multiple of a chart that has a name. That chart is used, then.
edges                 Find the edge of the chart: the first pole of φ or zero of φ′, or 4π.
intervals             Bound |φ| from below on a circle by interval arithmetic, and prove that φ is analytic inside.
near_zero             Interpolate a(x) with a bound of the error, which follows from that circle.
closed_inverse        Find φ⁻¹ in closed form, where there is one.
first_guess           Choose the start of Newton's method, and count the steps that it needs.
lowering              Write φ and its derivatives as arithmetic of ``+ − × /``, roots, tangents, exponentials.
real_constants        Write real constants as sums of small integers, which every number type holds.
angle_chart           Branches and inverse maps of a chart that finds its angle from ``|v|``.
general               The chart itself: scalars in both ranges.
====================  ==============================================================================================

Two modules serve other purposes: ``elementary`` evaluates an expression at numbers of any type, and ``stretch``
compares charts by the singular values of their tangent operators.

This package imports nothing, so that `grammar` is available before SymPy is loaded.
"""
