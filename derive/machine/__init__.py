"""Theorems of proofs/ checked by Coq, an independent proof assistant that shares nothing with the toolkit's prover."""
