"""Printed formulas: terms in a table of operators, their evaluation, claims in words, and shared definitions."""
