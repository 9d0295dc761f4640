"""Recipes of straight-line programs: geometry programs that all charts share, and scalar programs of one chart.

Recipes need no trust: validation proves their printed text equal to the formulas (``codegen.validation``).
"""
