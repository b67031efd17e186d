"""Sphinx settings of the documentation; scripts/site runs it."""

import os
import re

project = "Autocuts"
release = os.environ["AUTOCUTS_VERSION"]
extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc"]
exclude_patterns = ["site"]
html_theme = "sphinx_rtd_theme"
html_show_sphinx = False
html_copy_source = False
myst_heading_anchors = 4
breathe_projects = {"autocuts": os.environ["AUTOCUTS_DOXYGEN"]}
breathe_default_project = "autocuts"
autodoc_typehints = "none"


def link_pages(app, name, source):
    """Files of the source tree that have a page here are linked as that page."""
    text = re.sub(r"\]\(\.\./examples/[^)]*\)", "](examples.md)", source[0])
    source[0] = text.replace("](../include/autocuts/autocuts.h)", "](c.rst)")
    if name == "guide":
        # Its chapters are pages below it, in the order of its table.
        chapters = re.findall(r"\*\*\[[^]]*\]\((guide/[a-z-]+)\.md\)\*\*", text)
        source[0] += "\n```{toctree}\n:hidden:\n" + "\n".join(chapters) + "\n```\n"


def setup(app):
    app.connect("source-read", link_pages)
