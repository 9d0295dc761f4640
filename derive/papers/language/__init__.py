"""Printed formulas: terms, operators and their values.

===========  =================================================================================
values       sums, products and equality of numbers, vectors, quaternions, tensors
terms        formulas as trees: typeset, compared with the text, executed, mutated
evaluation   executing a term: the symbols have values
notation     table of operators: LaTeX, surviving text, value
claims       operators of claims in words
definitions  definitions that both papers share
===========  =================================================================================
"""
