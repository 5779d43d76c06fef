"""`crs debug`: the command and its options; `start_debugger` does the work."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import click

from crs_cc.cli.inputs import check_recording_path
from crs_cc.cli.instants import parse_time
from crs_cc.cli.program_options import WithProgramArguments, program_options
from crs_cc.cli.record_options import record_options
from crs_cc.cli.time_options import MAX_TIME

if TYPE_CHECKING:
    from crs_cc.cli.debug_options import DebugOptions

_EXAMPLES: Final = """
\b
Examples:
  crs debug wander.c room.xml
  crs debug wander.c room.xml -- 500
  crs debug --batch -x crash.dbg wander.c room.xml
  crs debug -ex "break turn if speed > 100" -ex continue wander.c room.xml
  crs debug run.mcap --at 12.5s                  a recorded run
  crs debug --dap stdio                          act as a debug adapter (see crs docs editors)
"""

_PORTS: Final = 65536


def _dap(_ctx: click.Context, _option: click.Parameter, where: str | None) -> str | None:
    is_number = where is not None and where.isascii() and where.isdigit() and len(where) < 6
    if where is None or where == "stdio" or (is_number and int(where) < _PORTS):
        return where
    raise click.BadParameter(f"'{where}' is neither stdio nor a port number.")


_OPTIONS: Final = (
    click.option(
        "-x", "scripts", multiple=True, metavar="FILE",
        type=click.Path(exists=True, dir_okay=False, path_type=Path),
        help="Execute the commands in FILE at startup; may be repeated.",
    ),
    click.option(
        "-ex", "commands", multiple=True, metavar="COMMAND",
        help="Execute COMMAND at startup, after any -x files; may be repeated.",
    ),
    click.option(
        "--batch", is_flag=True,
        help="Exit after executing the -x and -ex commands, with status 0 if all succeeded, "
        "otherwise 1.",
    ),
    click.option(
        "--input", metavar="FILE",
        type=click.Path(exists=True, dir_okay=False, path_type=Path),
        help="Send each line of FILE to the programs at the simulated time given at the "
        "start of the line, as in crs run.",
    ),
    click.option(
        "--stdin", metavar="FILE",
        type=click.Path(exists=True, dir_okay=False, path_type=Path),
        help="File to use as the programs' standard input. Default: the terminal, or with --batch "
        "the standard input of crs.",
    ),
    click.option(
        "--tui/--repl", default=None,
        help="Show the full-screen interface (default on a terminal) or a plain prompt.",
    ),
    click.option(
        "--dap", metavar="stdio|PORT", callback=_dap,
        help="Act as a debug adapter for an editor (Debug Adapter Protocol), on stdin and "
        "stdout or on a local port; 0 picks a free one.",
    ),
    click.option(
        "--at", "at_s", metavar="TIME", callback=parse_time,
        help="Start at TIME (recordings only).",
    ),
    MAX_TIME,
    click.option("-q", "--quiet", is_flag=True, help="Suppress compiler warnings."),
)  # fmt: skip


def _debug_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add all arguments and options of `crs debug` to a command."""
    command = record_options(program_options(command, needs_files=False))
    for option in reversed(_OPTIONS):
        command = option(command)
    return command


@click.command(
    cls=WithProgramArguments,
    epilog=_EXAMPLES,
    short_help="Step through C programs and their world, forward and backward.",
    options_metavar="[OPTIONS]",
)
@_debug_options
def debug(**options: Any) -> int:
    """Compile a C control program and debug it in a simulated world.

    The programs and the world run together, forward or backward: see the commands reverse-step,
    reverse-continue and goto. To debug a recording (see crs run --record), use crs debug run.mcap;
    no other files are needed, as a recording contains the files and the input of its run. Programs,
    worlds and most options are given as for crs run. Commands are named as in gdb; the help command
    lists them. In the full-screen interface, F1 shows the keys.
    """
    from crs_cc.cli.debug_options import DebugOptions  # not needed for other commands

    wanted = DebugOptions(**options)
    if wanted.record is not None:
        check_recording_path(wanted.record)
    if wanted.dap is not None:
        from crs_cc.cli.serve_editor import serve_editor

        return serve_editor(wanted.dap, read_options)
    if not wanted.inputs.sources and wanted.inputs.world is None:
        raise click.UsageError("no C file to debug.")
    if any(path.suffix.lower() == ".mcap" for path in wanted.inputs.sources):
        from crs_cc.cli.debug_recording import debug_recording

        return debug_recording(wanted)
    if wanted.at_s is not None:
        raise click.UsageError("--at is for recordings; in a run, the command goto does the same.")
    from crs_cc.cli.start_debugger import debug_programs

    return debug_programs(wanted)


def read_options(arguments: Sequence[str]) -> DebugOptions:
    """Return the options in a command line of `crs debug`.

    Raises:
        click.ClickException: it is invalid.
    """
    from crs_cc.cli.debug_options import DebugOptions

    options = _reader().main(list(arguments), prog_name="crs debug", standalone_mode=False)
    assert isinstance(options, DebugOptions)
    return options


@functools.cache
def _reader() -> click.Command:
    """Return a command that only parses its options."""
    from crs_cc.cli.debug_options import DebugOptions

    command = click.command(cls=WithProgramArguments, add_help_option=False)
    return command(_debug_options(DebugOptions))
