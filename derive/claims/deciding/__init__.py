"""Decision of one claim, by its points and by generic values of an exact field.

===========  ================================================================================
claim        a claim with its letters, evaluated over balls at points given by coordinates
constrained  points moved onto the equations of a stated domain
singular     singular parts of a formula: divisors, radicands, arguments of inverse functions
zeros        zeros of singular parts along lines of points
places       points at which a claim may fail
conditions   conditions of a claim, found from the points where a part has no value, and their sharpness
regions      region on which a claim of one branch is true
changes      changes in one step that mend a claim, terms that do not matter, constraints that it needs
proof        proof of a claim at generic values of an exact field
finding      decision of one claim: what its points and generic values tell, with a certified counterexample
===========  ================================================================================

Each module imports only from modules above it in the table.
"""
