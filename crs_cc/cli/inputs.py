"""The files that a user names on the command line.

>>> sort_files(("wander.c", "turn.c", "room.XML"))
Inputs(sources=(PosixPath('wander.c'), PosixPath('turn.c')), world=PosixPath('room.XML'))
"""

from __future__ import annotations

import os
import stat
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import click

from crs_cc.core.errors import CompileError, CrsError, WorldError
from crs_cc.core.source import Location
from crs_cc.session.files import EEXIST, Disk

LARGEST_FILE: Final = 64 * 2**20  # of --file [bytes]


@dataclass(frozen=True, slots=True)
class Inputs:
    """The files named on the command line.

    Attributes:
        sources: the C files of one program.
        world: the world file, if any.
    """

    sources: tuple[Path, ...]
    world: Path | None


def sort_files(names: Sequence[str]) -> Inputs:
    """Separate C files and the world file by the extension `.xml`.

    Raises:
        click.UsageError: more than one world is named, or a C file twice.
    """
    worlds = [name for name in names if is_world(name)]
    if len(worlds) > 1:
        raise click.UsageError(f"more than one world file: {' '.join(worlds)}")
    sources = tuple(Path(name) for name in names if not is_world(name))
    seen: set[str] = set()
    for source in sources:
        real = os.path.realpath(source)
        if real in seen:
            raise click.UsageError(f"{source} is given twice")
        seen.add(real)
    return Inputs(sources, Path(worlds[0]) if worlds else None)


def is_world(name: str) -> bool:
    """Return whether a file name is that of a world file."""
    return name.lower().endswith(".xml")


def check_readable(path: Path, hint: str = "") -> None:
    """Check that a file can be read.

    Args:
        path: the file.
        hint: a hint for a missing file, if there is none of a similar name.

    Raises:
        CompileError: a C file cannot be read.
        WorldError: a world file cannot be read.
    """
    blame: type[CrsError] = WorldError if is_world(path.name) else CompileError
    place = Location(str(path))
    try:
        mode = path.stat().st_mode
    except FileNotFoundError:
        raise blame.at(place, "no such file", _similar(path) or _sample(path) or hint) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise blame.at(place, f"cannot be read: {reason}") from None
    if stat.S_ISDIR(mode):
        raise blame.at(place, "is a directory, not a file")
    if not os.access(path, os.R_OK):
        raise blame.at(place, "cannot be read: permission denied")


def parse_named_files(options: Sequence[str]) -> dict[str, Path]:
    """Return the files that programs may read, by name, from `FILE` or `NAME=FILE`.

    Raises:
        click.UsageError: a file does not exist, cannot be read or is too large, or its
            name is invalid or a duplicate on a program's disk.

    >>> parse_named_files(["pyproject.toml", "map=README.md"])
    {'pyproject.toml': PosixPath('pyproject.toml'), 'map': PosixPath('README.md')}
    """
    named: dict[str, Path] = {}
    disk = Disk({})
    for option in options:
        name, _, file = option.rpartition("=")
        path = Path(file)
        if not path.is_file() or not os.access(path, os.R_OK):
            raise click.UsageError(f"--file '{file}': no such file, or not readable.")
        if path.stat().st_size > LARGEST_FILE:
            raise click.UsageError(f"--file '{file}' is larger than {LARGEST_FILE >> 20} MiB.")
        failed = disk.put(name or file, b"")
        if failed:
            why = "is given twice" if failed == -EEXIST else "is not a valid file name for programs"
            raise click.UsageError(f"--file '{option}': '{name or file}' {why}.")
        named[name or file] = path
    return named


def make_folder(path: Path) -> None:
    """Create the folder for results, unless it exists.

    Raises:
        click.UsageError: it cannot be created.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise click.UsageError(f"cannot create folder '{path}': {error.strerror}.") from None


def check_plot_path(path: Path) -> None:
    """Check that a picture can be written to a file, and that the file is not a source.

    Raises:
        click.UsageError: it cannot.
    """
    _check_writable(path)
    device = path.exists() and not path.is_file()
    if path.suffix.lower() != ".svg" and not is_animation(path) and not device:
        raise click.UsageError(
            f"'{path}' is not an SVG file: the plot is written as SVG, name it {path.stem}.svg, or"
            f" {path.stem}.gif or {path.stem}.apng for an animation."
        )


def is_animation(path: Path) -> bool:
    """Return whether a plot is to be an animation."""
    return path.suffix.lower() in (".gif", ".apng")


def check_recording_path(path: Path) -> None:
    """Check that a recording can be written to a file, and that the file is not a source.

    Raises:
        click.UsageError: it cannot.
    """
    _check_writable(path)
    if path.suffix.lower() != ".mcap":
        raise click.UsageError(
            f"'{path}' is not an MCAP file: recordings are written as MCAP, name it"
            f" {path.stem}.mcap."
        )


def _check_writable(path: Path) -> None:
    """Check, as far as possible without writing, that a file can be written."""
    folder = path.absolute().parent
    try:
        if not stat.S_ISDIR(folder.stat().st_mode):
            raise click.UsageError(f"'{path.parent}' is not a folder.")
        target = path if path.exists() else folder
    except FileNotFoundError:
        raise click.UsageError(f"cannot write '{path}': no such folder.") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise click.UsageError(f"cannot write '{path}': {reason}.") from None
    if not os.access(target, os.W_OK):
        raise click.UsageError(f"cannot write '{path}': permission denied.")


def _similar(path: Path) -> str:
    """Return a hint to a file of a similar name."""
    try:
        names = sorted(each.name for each in path.parent.iterdir() if each.suffix == path.suffix)
    except OSError:
        return ""
    import difflib  # rarely needed

    close = difflib.get_close_matches(path.name, names, n=1)
    return f"did you mean '{path.with_name(close[0])}'?" if close else ""


def _sample(path: Path) -> str:
    """Return a hint to a sample of a name."""
    from crs_cc.cli.sample_files import all_samples  # rarely needed

    is_sample = any(path.name == each.name for each in all_samples())
    return f"there is a sample of that name: crs samples copy {path.name} ." if is_sample else ""
