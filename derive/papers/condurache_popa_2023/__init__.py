"""Condurache and Popa, Symmetry 15(11) 2011 (2023): formulas of its equations in Python, words in ``text.toml``."""
