"""Fields in which formulas are evaluated, and values of symbols: drawn at 60 digits or generic in an exact field."""
