"""NumPy functions in C for the kernels of rotations alone, with one module for each parameterization."""
