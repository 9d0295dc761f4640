"""Pages that commands write: the formula sheet, charts side by side, explanations of functions."""
