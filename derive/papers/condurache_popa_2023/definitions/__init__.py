"""Definitions of the paper's symbols, against which its printed formulas are checked.

Each function takes the arguments of `derive.claims.language.environment.Definition`: the environment, then values.
"""
