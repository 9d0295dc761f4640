"""Straight-line programs: recorded by tracing ordinary arithmetic, scheduled and placed in registers.

========= =======================================================================
program   assignments, calls, operation counts
trace     the tracer that records them
value     traced numbers
registers the order of statements and scratch registers by liveness
========= =======================================================================
"""
