"""Machine code of C headers compared with their text, bit by bit: `python -m proofs.bytes`."""
