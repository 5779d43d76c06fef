"""The command `crs`: picks the subcommand, and turns whatever goes wrong into an exit status.

0 to 255  `crs run` with one robot ends with the control program's own exit status
2         the command line is wrong
70        crs itself is at fault
121 122   the C source, the world file is at fault
123 124   a control program was stopped by an error, by a limit
130       interrupted by Ctrl-C
141       whoever read our output went away
"""

from __future__ import annotations

import os
import sys
import traceback
from collections.abc import Sequence

import click

from crs_cc import __version__
from crs_cc.cli.check import check
from crs_cc.cli.compile import compile_
from crs_cc.cli.messages import say, show
from crs_cc.cli.run import run
from crs_cc.cli.status import BROKEN_PIPE, INTERRUPTED
from crs_cc.errors import CrsError, InternalError

_EPILOG = """
\b
Examples:
  crs run wander.c                               in an empty world, until Ctrl-C
  crs run wander.c room.xml --max-time 60        a minute of simulated time
  crs run wander.c room.xml --plot path.svg      draws where the robot went
  crs check wander.c room.xml                    only says what is wrong
  crs compile --emit wat wander.c                shows the WebAssembly

\b
Exit status: that of the control program when there is one robot; 2 usage, 121 C source,
122 world file, 123 program stopped by an error, 124 by a limit, 70 crs itself, 130 Ctrl-C.
"""


class _Crs(click.Group):
    """Sees to a broken pipe before click does, which would end with 1."""

    def invoke(self, ctx: click.Context) -> object:
        try:
            result: object = super().invoke(ctx)
            sys.stdout.flush()
        except BrokenPipeError:
            # the interpreter's own last flush shall go nowhere instead of failing again
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            return BROKEN_PIPE
        return result


@click.group(
    cls=_Crs,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog=_EPILOG,
    no_args_is_help=True,
)
@click.version_option(__version__, "-V", "--version", message="crs %(version)s")
def crs() -> None:
    """Runs real C control programs of the Nomadic Scout in a simulated world."""


for command in (run, check, compile_):
    crs.add_command(command)


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs `crs` with these arguments, by default the process's own; gives the exit status."""
    try:
        status = crs.main(arguments, prog_name="crs", standalone_mode=False)
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except (KeyboardInterrupt, click.Abort):
        say("crs: interrupted")
        return INTERRUPTED
    except CrsError as error:
        show(error.diagnostics)
        if isinstance(error, InternalError):
            _ask_for_report()
        return error.exit_status
    except Exception as error:
        say(f"crs: internal error: {type(error).__name__}: {error}")
        _ask_for_report()
        return InternalError.exit_status
    return int(status or 0)


def _ask_for_report() -> None:
    if os.environ.get("CRS_DEBUG"):
        traceback.print_exc()
        return
    say("This is a mistake in crs, not in your program. Please report it with the C program, the")
    say("world file and the command line; CRS_DEBUG=1 in the environment shows where it happened.")
