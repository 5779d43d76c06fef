"""`crs cache`: shows and clears what was compiled before."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.messages import say
from crs_cc.cli.status import SYSTEM

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.session.cache_size import StoredEntry

_UNITS: Final = ((2**30, "GiB"), (2**20, "MiB"), (2**10, "KiB"))
_EXAMPLES: Final = """
\b
Examples:
  crs cache             shows where it is, and how large
  crs cache clear       removes all of it
"""


@click.group(
    epilog=_EXAMPLES,
    short_help="Show and clear what was compiled before.",
    invoke_without_command=True,
)
@click.pass_context
def cache(context: click.Context) -> int:
    """Show where compiled programs are kept, how many entries there are, and how large they are.

    The folder is $CRS_CACHE, or crs_cc in the user's cache folder. When it grows over its limit,
    the least recently used entries are removed. The limit is 1 GiB, or what CRS_CACHE_SIZE in the
    environment says, such as 500M or 2G; 0 keeps nothing.
    """
    if context.invoked_subcommand is not None:
        return 0
    from crs_cc.session.cache_size import LIMIT_VARIABLE, bad_limit, limit_bytes

    folder = _folder()
    entries = _entries(folder)
    if bad_limit():
        say(f"warning: {LIMIT_VARIABLE}={bad_limit()} is not a size such as 500M or 2G")
    click.echo(f"folder   {folder}")
    click.echo(f"entries  {len(entries)}")
    click.echo(f"size     {_size(entries)}")
    click.echo(f"limit    {_amount(limit_bytes())}")
    return 0


@cache.command(
    epilog="\b\nExamples:\n  crs cache clear", short_help="Remove all that was compiled before."
)
def clear() -> int:
    """Remove all that was compiled before; programs are compiled again when they are next run."""
    from crs_cc.session.cache_size import remove

    folder = _folder()
    removed = []
    status = 0
    for entry in _entries(folder):
        try:
            remove(folder, entry)
            removed.append(entry)
        except OSError as error:
            say(f"{folder / entry.name}: error: cannot be removed: {error.strerror}")
            status = SYSTEM
    noun = "entry" if len(removed) == 1 else "entries"
    click.echo(f"{len(removed)} {noun} removed, {_size(removed)}")
    return status


def _folder() -> Path:
    """Return the folder of the cache, and warn if it is not used.

    Raises:
        click.UsageError: there is none.
    """
    from crs_cc.session.cache import folder, is_private

    place = folder()
    if place is None:
        raise click.UsageError("there is no cache: the user has no home folder; set CRS_CACHE.")
    if place.is_dir() and not is_private(place):
        say(f"warning: {place} is not used: it has to be yours, and nobody else may write there")
    return place


def _entries(folder: Path) -> list[StoredEntry]:
    """Return what is in the cache's folder: nothing if it is not there yet.

    Raises:
        OSError: it cannot be read.
    """
    from crs_cc.session.cache_size import stored_entries

    try:
        return stored_entries(folder)
    except FileNotFoundError:
        return []


def _size(entries: Sequence[StoredEntry]) -> str:
    return _amount(sum(entry.size for entry in entries))


def _amount(size: int) -> str:
    """Return a number of bytes for people.

    >>> _amount(2**30), _amount(1_500_000), _amount(12)
    ('1 GiB', '1.4 MiB', '12 bytes')
    """
    for unit, name in _UNITS:
        if size >= unit:
            return f"{size / unit:.1f}".removesuffix(".0") + f" {name}"
    return f"{size} bytes"
