"""The full-screen interface of `crs debug`: when to show it, and how to start it.

It is the default on a terminal. Its packages take half a second to import, so they are imported
only when it is shown.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from importlib.util import find_spec
from typing import TYPE_CHECKING

import click

from crs_cc.cli.messages import say

if TYPE_CHECKING:
    from crs_cc.cli.debug_options import DebugOptions
    from crs_cc.debug.engine import Debugger
    from crs_cc.session.host import Input, Output


def is_wanted(options: DebugOptions) -> bool:
    """Return whether to show it; report why not where it would be the default.

    Raises:
        click.UsageError: it was requested and cannot be shown.
    """
    if options.tui is False or options.batch:
        if options.tui:
            raise click.UsageError("--tui and --batch are mutually exclusive.")
        return False
    reason = _reason_against()
    if reason and options.tui:
        raise click.UsageError(f"--tui: {reason}.")
    if reason and _is_terminal():
        say(f"crs: no full-screen interface: {reason}; using the prompt")
    return not reason


def _reason_against() -> str:
    if not _is_terminal():
        return "standard input and output are not a terminal"
    if os.environ.get("TERM", "dumb") == "dumb" and sys.platform != "win32":
        return "the terminal does not support it"
    if find_spec("textual") is None:
        return "textual is not installed (pip install textual)"
    return ""


def _is_terminal() -> bool:
    return all(stream is not None and stream.isatty() for stream in (sys.stdin, sys.stdout))


def show(
    options: DebugOptions, make: Callable[[Output, Input], Debugger], file_input: Input | None
) -> Debugger:
    """Run the full-screen interface until the user quits.

    Args:
        options: name the scripts to execute first.
        make: creates the debugger, given the programs' output and input.
        file_input: their input if it is a file.

    Raises:
        OSError: a script cannot be read.
    """
    from crs_cc.debug.commands.user_session import UserSession
    from crs_cc.debug.repl.repl import Scripts
    from crs_cc.debug.tui.app import DebugApp
    from crs_cc.debug.tui.controller import Controller
    from crs_cc.debug.tui.program_streams import ProgramStreams

    streams = ProgramStreams()
    debugger = make(streams.write, file_input or streams.read)
    scripts = Scripts(options.scripts, options.commands)
    controller = Controller(debugger, streams, scripts.lines())
    user = UserSession(controller.shell.context)
    for text in user.load_settings():
        say(f"crs: {text}")
    user.keep_settings()
    app = DebugApp(controller, user.commands)
    try:
        app.show()
    finally:
        user.keep_commands(app.typed)
    return debugger
