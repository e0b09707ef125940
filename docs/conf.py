"""Sphinx configuration; `setup` lets the code write its tables before the pages are read."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
TESTS = HERE.parent / "tests"
sys.path[:0] = [
    str(HERE.parent),
    str(HERE),
    str(HERE.parent / "benchmarks"),
    str(TESTS),
    str(TESTS / "validation"),
    str(TESTS / "app"),
]

import inventories  # noqa: E402
import pages  # noqa: E402

import stayput  # noqa: E402

project = "stayput"
author = copyright = "The stayput authors"  # noqa: A001
version = release = stayput.__version__

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx.ext.intersphinx",
    "sphinx.ext.viewcode",
    "sphinx_copybutton",
    "sphinx_gallery.gen_gallery",
    "formulas",
]
myst_enable_extensions = ["dollarmath", "amsmath", "deflist", "colon_fence"]
myst_heading_anchors = 3
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300
nb_merge_streams = True
exclude_patterns = ["_build", "generated/**.md", "studies/*.md", "gallery/used/*", "gallery/*.ipynb"]
default_role = "py:obj"  # single backquotes in docstrings name Python objects

autosummary_generate = True
templates_path = ["_templates"]
autodoc_typehints = "signature"
autodoc_preserve_defaults = True
autodoc_member_order = "bysource"
autodoc_class_signature = "mixed"
napoleon_google_docstring = False
napoleon_custom_sections = [("Attributes", "params_style")]  # "x, z : ndarray" documents both
napoleon_preprocess_types = False
suppress_warnings = ["ref.python"]  # a word of a shape, as (levels,), may be the name of several attributes
python_maximum_signature_line_length = 90

html_theme = "furo"
html_title = f"stayput {version}"
html_static_path = ["_static"]
html_css_files = ["extra.css"]
html_math_renderer = "svg"
html_copy_source = False
html_show_sphinx = False

# Names of other projects lead to their pages, where the network has them; else they are plain names.
intersphinx_mapping = {
    name: (address, (None, inventories.none(HERE / "_build" / "none.inv")))
    for name, address in {
        "python": "https://docs.python.org/3",
        "numpy": "https://numpy.org/doc/stable",
        "xarray": "https://docs.xarray.dev/en/stable",
        "matplotlib": "https://matplotlib.org/stable",
        "pandas": "https://pandas.pydata.org/docs",
    }.items()
}
intersphinx_timeout = 10

sphinx_gallery_conf = {
    "examples_dirs": str(HERE.parent / "examples"),
    "gallery_dirs": "gallery",
    "filename_pattern": r"\.py$",
    "image_scrapers": ("gallery_figures.figures_made",),
    "capture_repr": (),
    "within_subsection_order": "FileNameSortKey",
    "abort_on_example_error": True,
    "download_all_examples": False,
    "min_reported_time": 1e9,
    "write_computation_times": False,
    "show_signature": False,
    "backreferences_dir": "gallery/used",
    "doc_module": ("stayput",),
    "inspect_global_variables": False,
}

copybutton_exclude = ".linenos, .gp, .go"  # neither prompts nor what a program prints


_properties: dict[str, list[str]] = {}


def _before_napoleon(app: Any, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Set a property's docstring aside: "name: text" in it is no type."""
    if what == "property":
        _properties[name] = list(lines)


def _after_napoleon(app: Any, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Let |tilt| in a docstring be a magnitude, not a substitution of reStructuredText."""
    lines[:] = [line.replace("|", "\\|") for line in _properties.pop(name, lines)]


def setup(app: Any) -> None:
    """Write the generated parts, once a build; with the tag ``references`` those alone that need no run."""
    write = pages.write_placeholders if app.tags.has("references") else pages.write
    app.connect("builder-inited", lambda _: write(HERE / "generated"), priority=1)
    app.connect("autodoc-process-docstring", _before_napoleon, priority=400)
    app.connect("autodoc-process-docstring", _after_napoleon, priority=600)
