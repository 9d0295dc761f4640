"""Numbers that formulas are executed on, and values of symbols.

===========  ==================================================================================
fields       60 digits, and exact rational functions
every_order  the exact field for symbolic n
quantities   table of quantities, with special values
generic      symbols at generic values of an exact field
===========  ==================================================================================
"""
