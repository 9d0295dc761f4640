"""Decision of one claim, by its points and by proof at generic values.

==============  ================================================================================
claim           a claim with its letters, evaluated over balls at points given by coordinates
constrained     points moved onto the equations of a stated domain
singular        singular parts of a formula: divisors, radicands, arguments of inverse functions
zeros           zeros of singular parts along lines of points
proof           proof of a claim at generic values of an exact field, for all orders where it can
polar           letters in polar form: lengths, angles and directions
identity        proof of a claim at independent generators, exactly or modulo a random prime
equal_sides     points at which both sides of an order relation are equal or a floor jumps
uphill          corners of a bounded domain, and the way uphill from one
places          points at which a claim may fail
conditions      conditions of a claim, found from the points where a part has no value, and their sharpness
partial         partial operations of a statement, and what each asks of a number
existence       proof that both sides have a value
ordering        proof of order relations, by signs of exact numbers or along one number
regions         region on which a claim of one branch is true
changes         changes in one step that mend a claim, terms that do not matter, constraints that it needs
counterexample  numbers of a point at which a claim fails
finding         decision of one claim: points refute it or find its condition, and a proof confirms it
==============  ================================================================================

Each module imports only from modules above it in the table.
"""
