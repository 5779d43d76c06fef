"""`crs docs`: the pages of the documentation, in the terminal."""

from __future__ import annotations

import io
import re
import sys
from pathlib import Path
from typing import Final

import click
from click.shell_completion import CompletionItem

_EXAMPLES: Final = """
\b
Examples:
  crs docs              list the pages
  crs docs sensors      read one
"""
_TITLE: Final = re.compile(r"^# (.*)$", re.MULTILINE)
_COMMENT: Final = re.compile(r"<!--.*?-->\n*", re.DOTALL)
_IMAGE: Final = re.compile(r"!\[([^\]]*)\]\([^)]*\)")
_LINK: Final = re.compile(r"\[([^\]]+)\]\((?!http)[^)]*\)")
_MAX_COLUMNS: Final = 100


def _complete(
    _context: click.Context, _parameter: click.Parameter, start: str
) -> list[CompletionItem]:
    return [CompletionItem(name) for name in _pages() if name.startswith(start)]


@click.command(epilog=_EXAMPLES, short_help="Show a page of the documentation.")
@click.argument("page", required=False, shell_complete=_complete)
def docs(page: str | None) -> int:
    """Show a page of the documentation in the terminal's pager; list the pages if none is named."""
    pages = _pages()
    if page is None:
        width = max(map(len, pages))
        for name, path in pages.items():
            click.echo(f"{name:{width}}  {_title(path)}")
        return 0
    name = page.removesuffix(".md")
    if name not in pages:
        from crs_cc.core.suggest import closest

        near = closest(name, list(pages))
        hint = f"did you mean '{near}'?" if near else "'crs docs' lists the pages."
        raise click.UsageError(f"unknown page '{page}': {hint}")
    click.echo_via_pager(_rendered(pages[name]))
    return 0


def _pages() -> dict[str, Path]:
    from crs_cc.core.shared_files import shared_folder

    found = sorted(shared_folder("docs").glob("*.md"))
    return {path.stem: path for path in found if path.stem != "README"}


def _title(path: Path) -> str:
    title = _TITLE.search(path.read_text("utf-8"))
    return title[1] if title else ""


def _rendered(path: Path) -> str:
    """Return a page as text, with control sequences if stdout is a terminal."""
    from rich.console import Console
    from rich.markdown import Markdown

    from crs_cc.cli.messages import is_coloured

    text = _IMAGE.sub(r"*\1*", _COMMENT.sub("", path.read_text("utf-8")))
    text = _LINK.sub(r"\1", text)
    file = io.StringIO()
    coloured = is_coloured(sys.stdout)
    width = min(Console().width, _MAX_COLUMNS)
    console = Console(
        file=file, width=width, force_terminal=coloured, no_color=not coloured, legacy_windows=False
    )
    console.print(Markdown(text, hyperlinks=False))
    return file.getvalue()
