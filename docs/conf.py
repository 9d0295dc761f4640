"""Configuration of the site: ``make docs`` builds it offline from this folder."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "generated"), str(ROOT / "docs")]

from _ext import publication  # noqa: E402

from derive import about  # noqa: E402
from derive.output.files import put  # noqa: E402

project = "dualcay"
author = "The dualcay developers"
copyright = author
release = version = about.__version__

extensions = [
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.mathjax",
    "sphinx.ext.viewcode",
    "numpydoc",
    "myst_nb",
    "sphinx_design",
    "sphinx_gallery.gen_gallery",
    "_ext.dark",
    "_ext.function_pages",
    "_ext.in_browser",
    "_ext.live",
    "_ext.printed",
    "_ext.publication",
    "_ext.reference",
    "_ext.sheet",
    "_ext.try_it",
]
# myst-nb would run the notebooks; the figures of all charts are part of a guide
exclude_patterns = ["_build", "_templates", "**/README.md", "examples/*.ipynb", "parameterizations.md"]
nitpicky = False
suppress_warnings = ["config.cache"]

# Pages are MyST Markdown; pages with code cells run. An error is a warning with page, cell and traceback on the
# console: other pages are still written, and `make docs`, for which warnings are errors, fails.
myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence", "deflist", "attrs_inline"]
myst_heading_anchors = 3
nb_execution_mode = "cache"
nb_execution_cache_path = str(ROOT / "build" / "docs" / "cache")
nb_execution_show_tb = True
nb_execution_timeout = -1  # a busy machine fails no page
nb_merge_streams = True
os.environ["TTY_INTERACTIVE"] = "0"  # no progress bars in the output of cells

# Kernels of notebooks serve this build alone: their warning that connections are not encrypted is switched off,
# and figures are SVG, of which the extension `dark` makes dark ones.
profile = ROOT / "build" / "docs" / "ipython" / "profile_default"
SETTINGS = 'c.IPKernelApp.log_level = "ERROR"\nc.InlineBackend.figure_formats = {"svg"}\n'
put(profile / "ipython_kernel_config.py", SETTINGS)
os.environ["IPYTHONDIR"] = str(profile.parent)

# Formulas: MathJax 4 from its npm package, which the Makefile unpacks; the site loads nothing from elsewhere.
# A formula is set when it comes into view, and without the trees for speech: the errata have hundreds.
mathjax_path = "mathjax/tex-chtml.js"
mathjax4_config = {
    "loader": {
        "load": ["ui/lazy", "[tex]/boldsymbol", "[tex]/colorv2"],
        "paths": {"mathjax-newcm": "[mathjax]/mathjax-newcm-font"},
    },
    "output": {"fontPath": "[mathjax]/mathjax-newcm-font", "displayOverflow": "scroll"},
    "options": {"enableMenu": False, "enableEnrichment": False, "enableSpeech": False, "enableBraille": False},
    # an unknown command is an error, which a test finds
    "tex": {"packages": {"[+]": ["boldsymbol", "colorv2"], "[-]": ["noundefined"]}},
}

html_theme = "pydata_sphinx_theme"
REPOSITORY = publication.repository()
html_context = {"default_mode": "auto", **publication.html_context(REPOSITORY)}  # light or dark, as the reader's system
html_title = "dualcay"
html_favicon = "_static/favicon.svg"
html_static_path = ["_static", str(ROOT / "build" / "docs" / "assets")]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_search_scorer = str(ROOT / "docs" / "_ext" / "scorer.js")
html_theme_options = {
    "navbar_end": ["theme-switcher", "navbar-icon-links"],
    "header_links_before_dropdown": 6,
    "show_prev_next": True,
    "secondary_sidebar_items": ["page-toc", "edit-this-page"],
    "footer_start": ["about"],
    "footer_end": [],
    **publication.theme_options(REPOSITORY),
}
WITHOUT_PAGES_BELOW = ("index", "install", "try", "symptoms", "glossary", "sheet", "changelog", "cite", "licence")
html_sidebars = {page: [] for page in WITHOUT_PAGES_BELOW}
templates_path = ["_templates", "_templates/components"]

autodoc_typehints = "none"
autosummary_generate = [f"reference/{page}.md" for page in ("functions", "charts", "tools", "toolkit")]
autosummary_ignore_module_all = False  # functions of a module are those of its __all__
default_role = "py:obj"
toc_object_entries = False
numpydoc_show_class_members = False
numpydoc_xref_param_type = False

sphinx_gallery_conf = {
    "examples_dirs": [str(ROOT / "examples")],
    "gallery_dirs": ["examples"],
    "filename_pattern": r"\.py$",
    "plot_gallery": False,
    "download_all_examples": False,
    "show_signature": False,
    "within_subsection_order": "FileNameSortKey",
    "remove_config_comments": True,
    "write_computation_times": False,
}


def from_github(app: object, name: str, source: list[str]) -> None:
    """Turn what GitHub reads in a report into MyST: formulas $`x`$, and targets of links."""
    text = re.sub(r"\$`(.+?)`\$", r"{math}`\1`", source[0])
    source[0] = re.sub(r"^<a id=\"(.+?)\"></a>$", r"(\1)=", text, flags=re.MULTILINE)


def setup(app: object) -> None:
    """Connect the reader of reports to Sphinx."""
    app.connect("source-read", from_github)  # type: ignore[attr-defined]
