"""Straight-line programs, recorded by tracing ordinary arithmetic.

======= ===========================================================================
program assignments, calls, operation counts
value   traced numbers, and their arithmetic, which folds constants
trace   the tracer that records all other operations; programs without inner calls
shared  helper programs for steps that several programs share
======= ===========================================================================
"""
