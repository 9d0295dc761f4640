"""Pages that commands write: theorems with controls, the formula sheet, formulas in use, charts side by side."""
