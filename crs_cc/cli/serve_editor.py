"""`crs debug --dap`: serve an editor over the Debug Adapter Protocol."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import click

from crs_cc.cli.load import load
from crs_cc.cli.make_debugger import make_debugger
from crs_cc.cli.messages import WARNINGS_BEFORE_RUN, render, say
from crs_cc.cli.start_debugger import given_input
from crs_cc.core.source import Diagnostics
from crs_cc.debug.dap.serve import serve_port, serve_stdio
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.session.host import Output, no_input

if TYPE_CHECKING:
    from crs_cc.cli.debug_options import DebugOptions


def serve_editor(where: str, read: Callable[[Sequence[str]], DebugOptions]) -> int:
    """Serve an editor, and return the exit status.

    Args:
        where: `stdio`, or a port number, on which one editor after the other is served.
        read: parses a command line of `crs debug`.

    Raises:
        OSError: the port is in use.
    """

    def open_run(line: Sequence[str], output: Output, tell: Callable[[str], None]) -> Debugger:
        try:
            return _open(read(line), output, tell)
        except click.ClickException as error:
            raise DebugError(error.format_message()) from None

    if where == "stdio":
        serve_stdio(open_run)
    else:
        serve_port(int(where), open_run, say)
    return 0


def _open(options: DebugOptions, output: Output, tell: Callable[[str], None]) -> Debugger:
    diagnostics = Diagnostics()
    loaded = load(options, diagnostics, debug=True)
    messages = diagnostics.messages
    for message in messages[:WARNINGS_BEFORE_RUN]:
        tell(render(message, coloured=False))
    if len(messages) > WARNINGS_BEFORE_RUN:
        left_out = len(messages) - WARNINGS_BEFORE_RUN
        tell(f"... and {left_out} more warnings; crs check shows them all")
    read, waiting = given_input(options)
    return make_debugger(loaded, options, output, read or no_input, waiting=waiting)
