"""The options of commands that serve a page to the browser."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

_Command = TypeVar("_Command", bound=Callable[..., Any])


def page_options(command: _Command) -> _Command:
    """Add the options for the page: its port, and whether to open it in the browser.

    The command receives them as `port`, 0 for any that is free, and `opens`.
    """
    command = click.option(
        "--open/--no-open",
        "opens",
        default=True,
        help="Open the page in the browser (default), or only print its address.",
    )(command)
    return click.option(
        "--port",
        type=click.IntRange(0, 65535),
        default=0,
        metavar="PORT",
        help="Serve the page on this port of this machine. Default: any free port.",
    )(command)
