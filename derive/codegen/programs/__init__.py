"""Straight-line programs: recorded by tracing ordinary arithmetic.

=========== =====================================================================
program     assignments, calls, operation counts
value       traced numbers
folding     arithmetic of constants and values, constants folded
trace       the tracer that records what is left
written_out programs with the programs that they call written out
=========== =====================================================================
"""
