"""All ways to read a display whose marks were lost.

===========  ==================================================================================
tokens       what survives of a formula, in the order of the page
items        how two parts are put together again, and what nobody prints
search       the table of all readings of a side, by value
reach        whether a side can have a value, where its readings are too many to list
enumeration  from the display of an entry to the number of its readings and the true ones
===========  ==================================================================================
"""
