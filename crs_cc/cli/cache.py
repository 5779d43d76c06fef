"""`crs cache`: show and clear the compile cache."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.exit_status import SYSTEM
from crs_cc.cli.messages import say

if TYPE_CHECKING:
    from crs_cc.toolchain.cache_size import StoredEntry

_UNITS: Final = ((2**30, "GiB"), (2**20, "MiB"), (2**10, "KiB"))
_EXAMPLES: Final = """
\b
Examples:
  crs cache             show its folder and size
  crs cache clear       remove all entries
"""


@click.group(
    epilog=_EXAMPLES,
    short_help="Show or clear the compile cache.",
    invoke_without_command=True,
)
@click.pass_context
def cache(context: click.Context) -> int:
    """Show the folder, the number of entries and the size of the compile cache.

    The folder is $CRS_CACHE, or crs_cc in the user's cache folder. When the cache exceeds its
    size limit, the least recently used entries are removed. The limit is 1 GiB by default; set
    CRS_CACHE_SIZE, such as 500M or 2G, to change it, or to 0 to disable the cache.
    """
    if context.invoked_subcommand is not None:
        return 0
    from crs_cc.toolchain.cache_size import LIMIT_VARIABLE, invalid_limit, limit_bytes

    folder = _folder()
    entries = _entries(folder)
    if invalid_limit():
        say(f"warning: {LIMIT_VARIABLE}={invalid_limit()} is not a size such as 500M or 2G")
    click.echo(f"folder   {folder}")
    click.echo(f"entries  {len(entries)}")
    click.echo(f"size     {_size(entries)}")
    click.echo(f"limit    {_amount(limit_bytes())}")
    return 0


@cache.command(epilog="\b\nExamples:\n  crs cache clear", short_help="Remove all entries.")
def clear() -> int:
    """Remove all entries; programs are compiled again the next time they run."""
    from crs_cc.toolchain.cache_size import remove

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
    """Return the cache folder; warn if it is not used.

    Raises:
        click.UsageError: there is none.
    """
    from crs_cc.toolchain.cache import folder, is_private

    place = folder()
    if place is None:
        raise click.UsageError("no cache folder: the user has no home folder; set CRS_CACHE.")
    if place.is_dir() and not is_private(place):
        say(f"warning: {place} is not used: it must belong to you and not be writable by others")
    return place


def _entries(folder: Path) -> list[StoredEntry]:
    """Return the entries in the cache folder; none if it does not exist yet.

    Raises:
        OSError: the folder cannot be read.
    """
    from crs_cc.toolchain.cache_size import stored_entries

    try:
        return stored_entries(folder)
    except FileNotFoundError:
        return []


def _size(entries: Sequence[StoredEntry]) -> str:
    return _amount(sum(entry.size for entry in entries))


def _amount(size: int) -> str:
    """Return a number of bytes in human-readable form.

    >>> _amount(2**30), _amount(1_500_000), _amount(12)
    ('1 GiB', '1.4 MiB', '12 bytes')
    """
    for unit, name in _UNITS:
        if size >= unit:
            return f"{size / unit:.1f}".removesuffix(".0") + f" {name}"
    return f"{size} bytes"
