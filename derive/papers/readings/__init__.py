"""All ways to read a display whose marks were lost.

===========  ==================================================================================
tokens       what survives of a formula, in the order of the page
items        parts that are read one way: value, looks, what they are made of
coordinates  values as residues, and the algebra of those
combine      how two parts are put together again, and what nobody prints
search       the table of all readings of a side, by value
targets      what a stretch is asked for, where its readings are too many to list
lists        the values of a stretch, where they can be listed
stretches    what is known of it without asking: components, and those that are not 0
reach        whether a side can have a value
enumeration  from the display of an entry to the number of its readings and the true ones
===========  ==================================================================================
"""
