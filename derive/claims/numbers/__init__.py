"""Fields in which formulas are evaluated, and values of symbols, from coordinates or generic in an exact field."""
