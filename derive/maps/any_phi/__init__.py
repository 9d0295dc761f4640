r"""Charts of a user's φ: the steps from the text of φ(α) to scalar programs that keep all digits.

A chart is ``v = φ(α) u``. Its scalars are functions of ``x = v · v``, and φ⁻¹ has no formula in general. Scalars are
therefore computed in two ranges of x. Each chart has its own limit between them:

========================  ==========================================================================================
near v = 0                ``a(x) = α/|v|`` is analytic. An interpolating polynomial replaces it, with a proved bound
                          of the error. Series (Stumpff functions) in ``ξ = x a²`` then give all scalars.
beyond                    Newton's method finds the angle from ``|v|``. Scalars follow from α, φ and its derivatives.
========================  ==========================================================================================

The modules, in the order of their use:

====================  ==============================================================================================
grammar               Check the text against a list of allowed syntax, without evaluation and without SymPy.
expressions           Build the SymPy expression. Decide whether it is odd, or a multiple of a named chart.
edges                 Find the edge: the first pole of φ or zero of φ′, or 4π. Invert φ in closed form.
near_zero             Interpolate a(x) with a bound of the error, proved by interval arithmetic on a circle.
first_guess           Choose the start of Newton's method, and count the steps that it needs.
phi_values            Write φ and its derivatives as arithmetic of ``+ − × /``, roots, tangents, exponentials.
general               The chart itself: scalars in both ranges.
parameterization      The chart of a φ: a named chart, a multiple of one, or a general chart.
====================  ==============================================================================================

Other modules of `derive.maps` import `parameterization` alone.

This file imports nothing, so that `grammar` can be used before SymPy is loaded.
"""
