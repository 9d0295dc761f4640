"""Style of all pictures: drawn for the width of an article of the site, with text of at least 9 pt.

Pictures are SVG with black ink on white ground. The site makes a dark one of each (docs/_ext/dark.py); the other
colours are visible on both grounds.
"""

from __future__ import annotations

from pathlib import Path

FOLDER = Path(__file__).parents[1] / "docs" / "figures"
WIDTH = 8.2
"""Width of a picture in inches: 787 px of the site."""

GREY, BLUE, GREEN, ORANGE, PINK, GOLD = "#808890", "#2F81C4", "#1F9E73", "#D5601A", "#C26A9B", "#B58A12"
STYLE = {
    "font.size": 10, "axes.titlesize": 10, "legend.fontsize": 9, "xtick.labelsize": 9, "ytick.labelsize": 9,
    "axes.spines.top": False, "axes.spines.right": False, "grid.color": GREY, "grid.alpha": 0.25, "grid.linewidth": 0.6,
    "lines.linewidth": 1.6, "svg.hashsalt": "dualcay", "svg.fonttype": "path", "savefig.dpi": 150,
}  # fmt: skip


