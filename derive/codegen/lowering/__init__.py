"""Recipes of straight-line programs: geometry programs that all charts share, and scalar programs of one chart.

`point` defines traces and recipes, and `scalar_programs` what is traced from a chart's formulas. The other modules have
one recipe for each function of geometry. Recipes need no trust: validation proves their printed text equal to the
formulas (``codegen.validation``).
"""
