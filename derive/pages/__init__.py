"""Pages that commands write: theorems with their controls, the formula sheet, parameterizations side by side."""
