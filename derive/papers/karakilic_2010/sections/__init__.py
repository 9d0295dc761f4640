"""Entries of the paper in printed order, by section.

====  ==================================================
s1a   dual numbers and their functions
s1b   dual vectors, their norm, and lines
s2    Cayley's formula
s3a   Rodrigues equations, (1) to (7)
s3b   components of the dual vector, (8) to (22)
s3c   derivation steps of (19) to (22)
s4    the conclusion
====  ==================================================
"""
