r"""Charts of a user's φ: the steps from the text of φ(α) to scalar programs that keep all digits.

A chart is ``v = φ(α) u``. Its scalars are functions of ``x = v · v``, and φ⁻¹ has no formula in general. Scalars are
therefore computed in two ranges of x. Each chart has its own limit between them:

========================  ==========================================================================================
near v = 0                ``a(x) = α/|v|`` is analytic. An interpolating polynomial replaces it, with a proved bound
                          of the error. Series (Stumpff functions) in ``ξ = x a²`` then give all scalars.
beyond                    A proved number of Newton's steps finds the angle from ``|v|``. Scalars follow from α, φ
                          and its derivatives.
========================  ==========================================================================================

In the order of their use: `expressions`, `regular`, `intervals`, `edges`, `near_zero`, `rounding`, `phi_values`,
`guesses`, `first_guess`, `lengths`, `general`. Of the other rooms, `derive.maps.named` alone imports them.
"""
