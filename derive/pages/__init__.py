"""Pages that commands write: theorems with their controls, the formula sheet, parameterizations side by side.

``python -m derive.pages`` proves everything, runs all controls and writes the page of theorems.
"""
