"""How a printed formula is written down and what it means.

==========  ==================================================================================
values      what sums, products and equality mean on numbers, vectors, quaternions, tensors
terms       formulas as trees: typeset, compared with the text, executed, mutated
evaluation  executing a term: the symbols have values
notation    the table of marks: LaTeX, surviving text, meaning
claims      marks of claims in words
==========  ==================================================================================
"""
