"""NumPy functions in C for the kernels of dualcay, which its modules run if this package is installed.

A module for each parameterization holds a generalized ufunc for each program. Ufuncs take arrays with components last;
the last array holds the table of a program. Arguments are not checked: call the functions of ``dualcay`` instead.
"""
