"""Settings of Sphinx for the documentation site: `make site` writes it to build/site.

All pages of the project are part of it, where they stand. A link that leads nowhere is a warning,
which `make site` treats as an error; one to a folder leads nowhere in the site and becomes text.
"""

from __future__ import annotations

import re
from pathlib import Path

from sphinx.application import Sphinx

ROOT = Path(__file__).parents[2]
PAGES = {
    "Start": (
        *("README", "docs/first-steps", "docs/tutorial*", "samples/README"),
        *("docs/command-line", "docs/platforms", "docs/glossary"),
    ),
    "Programs": (
        *("docs/robot-api", "docs/crs-h", "docs/language", "docs/library", "docs/warnings"),
        *("docs/errors", "docs/checks"),
    ),
    "Worlds": (
        *("docs/world-format", "docs/robots", "docs/sensors", "docs/actuators"),
        *("docs/communication", "docs/terrain", "docs/degradation"),
    ),
    "Runs": (
        *("docs/workbench", "docs/debugger", "docs/editors", "docs/recordings"),
        *("docs/determinism", "docs/performance"),
    ),
    "Python and teaching": (
        "docs/python",
        "docs/teaching",
        "docs/experiments",
        "docs/swarms",
        "docs/extending",
    ),
    "More": ("docs/*", "samples/**/README", "*", "docs/adr/README", "docs/adr/*"),
}
"""The table of contents: what a pattern matches is listed where it is matched first."""

project = "crs_cc"
author = "the crs_cc authors"
copyright = f"2026, {author}"  # noqa: A001 - the name that Sphinx wants
extensions = ["myst_parser"]
root_doc = "docs/README"
include_patterns = [
    "*.md",
    "docs/*.md",
    "docs/adr/*.md",
    "samples/README.md",
    "samples/**/README.md",
]
html_theme = "furo"
html_title = "crs_cc"
html_copy_source = False
html_show_sphinx = False
html_extra_path = ["index.html"]
html_static_path = ["site.css"]
html_css_files = ["site.css"]
myst_heading_anchors = 4

_LINK = re.compile(r"(?<!!)\[([^\]]+)\]\(([^)#:]+)\)")


def contents() -> str:
    """Return the tables of contents of the site."""
    listed: set[str] = {root_doc}
    tables = []
    for title, patterns in PAGES.items():
        names = []
        for pattern in patterns:
            found = (path.relative_to(ROOT) for path in sorted(ROOT.glob(f"{pattern}.md")))
            names += [str(path.with_suffix("")) for path in found]
        new = [name for name in dict.fromkeys(names) if name not in listed]
        listed |= set(new)
        lines = "\n".join(f"/{name}" for name in new)
        tables.append(
            f"```{{toctree}}\n:hidden:\n:caption: {title}\n:maxdepth: 1\n\n{lines}\n```\n"
        )
    return "\n" + "\n".join(tables)


def prepare(_app: Sphinx, page: str, text: list[str]) -> None:
    """Add the tables of contents to the first page, and make text of links to folders."""
    folder = (ROOT / page).parent

    def kept(link: re.Match[str]) -> str:
        return link[1] if (folder / link[2]).is_dir() else link[0]

    text[0] = _LINK.sub(kept, text[0])
    if page == root_doc:
        text[0] += contents()


def setup(app: Sphinx) -> None:
    """Register what is done to each page."""
    app.connect("source-read", prepare)
