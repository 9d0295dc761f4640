"""Theorems and emitted programs checked by Coq, and rounding errors bounded by Gappa; they share nothing with proof."""
