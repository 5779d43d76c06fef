"""Options for the files that a command writes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

_Command = TypeVar("_Command", bound=Callable[..., Any])


def written_file(
    name: str, text: str, *, to: str | None = None, metavar: str = "FILE"
) -> Callable[[_Command], _Command]:
    """Return an option for a file to write; the command receives its `Path`, or None.

    Args:
        name: the option.
        text: its help.
        to: the parameter that receives it; by default the option's name.
        metavar: the placeholder of the file in the help.
    """
    kind = click.Path(dir_okay=False, path_type=Path)
    return click.option(name, to or _plain(name), type=kind, metavar=metavar, help=text)


def written_folder(
    name: str, text: str, *, to: str | None = None
) -> Callable[[_Command], _Command]:
    """Return an option for a folder to write to, see `written_file`."""
    kind = click.Path(file_okay=False, path_type=Path)
    return click.option(name, to or _plain(name), type=kind, metavar="DIR", help=text)


def _plain(name: str) -> str:
    return name.removeprefix("--").replace("-", "_")
