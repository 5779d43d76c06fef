"""The full screen of `crs debug`: when it is shown, and on what.

It is what a user sees who sits at a terminal and says nothing else. Its packages take half a second
to import, so nothing of it is imported before.
"""

from __future__ import annotations

import os
import sys
from importlib.util import find_spec
from typing import TYPE_CHECKING

import click

from crs_cc.cli.messages import say

if TYPE_CHECKING:
    from collections.abc import Callable

    from crs_cc.cli.debug import DebugOptions
    from crs_cc.debug.engine import Debugger
    from crs_cc.session.host import Input, Output


def is_wanted(options: DebugOptions) -> bool:
    """Tells whether to show it; where somebody would expect it and it cannot be, says why.

    Raises:
        click.UsageError: it was asked for, and cannot be shown.
    """
    if options.tui is False or options.batch:
        if options.tui:
            raise click.UsageError("--tui and --batch exclude each other.")
        return False
    reason = _reason_against()
    if reason and options.tui:
        raise click.UsageError(f"--tui: {reason}.")
    if reason and _is_terminal():
        say(f"crs: no full screen: {reason}; going on line by line")
    return not reason


def _reason_against() -> str:
    if not _is_terminal():
        return "standard input and output are no terminal"
    if os.environ.get("TERM", "dumb") == "dumb" and sys.platform != "win32":
        return "the terminal cannot show one"
    if find_spec("textual") is None:
        return "textual is not installed (pip install textual)"
    return ""


def _is_terminal() -> bool:
    return all(stream is not None and stream.isatty() for stream in (sys.stdin, sys.stdout))


def show(
    options: DebugOptions, make: Callable[[Output, Input], Debugger], file_input: Input | None
) -> Debugger:
    """Lets a user debug on the full screen until he leaves.

    Args:
        options: the scripts that come first.
        make: makes the debugger, given what takes the programs' output, and what they read from.
        file_input: what they read when that is a file.

    Raises:
        OSError: a script cannot be read.
    """
    from crs_cc.debug.repl.repl import Scripts
    from crs_cc.debug.tui.app import DebugApp
    from crs_cc.debug.tui.controller import Controller
    from crs_cc.debug.tui.program_streams import ProgramStreams

    streams = ProgramStreams()
    debugger = make(streams.write, file_input or streams.read)
    scripts = Scripts(options.scripts, options.commands)
    DebugApp(Controller(debugger, streams, scripts.lines())).show()
    return debugger
