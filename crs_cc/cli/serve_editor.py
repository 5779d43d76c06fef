"""`crs debug --dap`: serve an editor over the Debug Adapter Protocol."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.load import load
from crs_cc.cli.make_debugger import end_at, make_debugger
from crs_cc.cli.messages import WARNINGS_BEFORE_RUN, left_out_text, render, say
from crs_cc.cli.start_debugger import fixed_input
from crs_cc.core.loopback import MIN_TOKEN, new_token
from crs_cc.core.source import Diagnostics
from crs_cc.debug.dap.port import serve_port
from crs_cc.debug.dap.serve import serve_stdio
from crs_cc.debug.dap.session import OpenRun
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.session.host import Output, no_input

if TYPE_CHECKING:
    from crs_cc.cli.debug_options import DebugOptions

VARIABLE: Final = "CRS_DAP_TOKEN"
"""Where users put a token of their own choice."""


def serve_editor(where: str, read: Callable[[Sequence[str]], DebugOptions]) -> int:
    """Serve an editor, and return the exit status.

    Args:
        where: `stdio`, or a port number, on which one editor after the other is served.
        read: parses a command line of `crs debug`.

    Raises:
        OSError: the port is in use.
    """

    def open_run(line: Sequence[str], output: Output, report: Callable[[str], None]) -> Debugger:
        try:
            return _open(read(line), output, report)
        except click.ClickException as error:
            raise DebugError(error.format_message()) from None

    if where == "stdio":
        serve_stdio(open_run)
    else:
        _serve_port(int(where), open_run)
    return 0


def _serve_port(port: int, open_run: OpenRun) -> None:
    """Serve the clients that know the token of the environment, or a new one, which is printed.

    Raises:
        click.UsageError: that of the environment is too short.
        OSError: the port is in use.
    """
    chosen = os.environ.get(VARIABLE)
    if chosen is not None and len(chosen) < MIN_TOKEN:
        raise click.UsageError(f"{VARIABLE} has fewer than {MIN_TOKEN} characters.")
    token = chosen or new_token()

    def announce(address: str) -> None:
        say(f"waiting for an editor on {address}")
        say(f"token: {token if chosen is None else f'that of {VARIABLE}'}")

    serve_port(port, open_run, token, announce)


def _open(options: DebugOptions, output: Output, report: Callable[[str], None]) -> Debugger:
    diagnostics = Diagnostics()
    loaded = load(options, diagnostics, debug=True)
    messages = diagnostics.messages
    for message in messages[:WARNINGS_BEFORE_RUN]:
        report(render(message, coloured=False))
    if len(messages) > WARNINGS_BEFORE_RUN:
        report(left_out_text(len(messages) - WARNINGS_BEFORE_RUN))
    read, waiting = fixed_input(options)
    debugger = make_debugger(loaded, options, output, read or no_input, waiting=waiting)
    end_at(debugger, options.max_time_s or loaded.world.duration_s)
    return debugger
