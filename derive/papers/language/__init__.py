"""Printed formulas: terms, operators and their values.

===========  =================================================================================
values       sums, products and equality of numbers, vectors, quaternions and tensors
terms        formulas as trees: typesetting, characters, symbols
evaluation   value of a term from the values of its symbols
notation     table of operators: LaTeX, extracted characters, value
claims       operators for claims in words
definitions  definitions shared by both papers
===========  =================================================================================
"""
