"""Decision of claims: formulas of papers, of files and of the command line.

===========  ================================================================================
numbers      fields in which formulas are evaluated, and values of symbols
language     grammar, terms, operators, values and evaluation of formulas
equation     entries for printed equations and claims, and papers
result       verdicts and status of an entry
deciding     one claim: points where it may fail, conditions, regions, changes that mend it, proof
decide       decision of an entry
transcript   equations of a file that follows a paper's text, with stated conditions
sheet        papers as TOML files, read to entries
run          decision of a file's equations in worker processes
report       results as text, JSON, Markdown, HTML and LaTeX
===========  ================================================================================

Each module imports only from modules above it in the table. No chart and no paper is known here.
"""
