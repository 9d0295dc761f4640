"""The numbers that formulas are executed on, and the values that letters take.

===========  ==================================================================================
fields       60 digits, and exact rational functions
every_order  the exact field for symbolic n
kinds        what a letter may stand for, special values included
generic      letters at generic values of an exact field
===========  ==================================================================================
"""
