"""Fields in which formulas are evaluated, and values of symbols.

===========  ==================================================================================
fields       60-digit numbers and exact rational functions
every_order  exact field for symbolic n
quantities   table of quantities with special values
generic      generic values of symbols in an exact field
===========  ==================================================================================
"""
