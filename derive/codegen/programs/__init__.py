"""Straight-line programs: recorded by tracing ordinary arithmetic, scheduled and placed in registers.

========= =======================================================================
program   assignments, calls, operation counts
value     traced numbers
folding   arithmetic of constants and values, constants folded
trace     the tracer that records what is left
registers the order of statements and scratch registers by liveness
========= =======================================================================
"""
