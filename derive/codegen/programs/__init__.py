"""Straight-line programs, recorded by tracing ordinary arithmetic.

=========== =====================================================================
program     assignments, calls, operation counts
value       traced numbers
folding     arithmetic of constants and values, which folds constants
trace       the tracer that records all other operations
shared      helper programs for steps that several programs share
written_out programs with their called programs written out in place
=========== =====================================================================
"""
