"""The numbers that formulas are executed on, and the values that symbols take.

===========  ==================================================================================
fields       60 digits, and exact rational functions
every_order  the exact field for symbolic n
quantities   what a symbol may stand for, special values included
generic      symbols at generic values of an exact field
===========  ==================================================================================
"""
