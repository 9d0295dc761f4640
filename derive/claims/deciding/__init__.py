"""Decision of one claim, by its points and by proof at generic values.

==============  ================================================================================
terms           parts of terms: operators, differences of relations, what vanishes where a term does
place           points at which a claim is evaluated
claim           a claim with its letters, evaluated over balls at points given by coordinates
frames          rotations in other forms: frames at rest as the identity, a product in a logarithm as one
solved          equations of a stated domain, solved for letters
constrained     points moved onto the equations of a stated domain
singular        singular parts of a formula: divisors, radicands, arguments of inverse functions
zeros           zeros of singular parts along lines of points
polar           letters in polar form: lengths, angles and directions
identity        proof of a claim at independent generators: for every order, exactly, or modulo a random prime
equal_sides     points at which both sides of an order relation are equal or a floor jumps
uphill          corners of a bounded domain, and the way uphill from one
places          points at which a claim may fail
conditions      conditions of a claim, found from the points where a part has no value, and their sharpness
partial         partial operations of a statement, and what each asks of a number
far             numbers where a generator is infinite, as the tangent of a half turn
signs           signs of exact numbers on a stated domain
existence       proof that both sides have a value
ordering        proof of order relations, by signs of exact numbers or along one number
regions         region on which a claim of one branch is true
changes         changes in one step that mend a claim, terms that do not matter, constraints that it needs
counterexample  numbers of a point at which a claim fails
split           claims without logic and cases that together say what one claim says
finding         decision of one claim: points refute it or find its condition, and a proof confirms it
==============  ================================================================================

Each module imports only from modules above it in the table.
"""
