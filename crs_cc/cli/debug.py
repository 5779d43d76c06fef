"""`crs debug`: the options of a run that is stepped through; what it does stands in `debugging`."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Final

import click

from crs_cc.cli.debug_options import DebugOptions
from crs_cc.cli.program_options import WithProgramArguments, program_options

_EXAMPLES: Final = """
\b
Examples:
  crs debug wander.c room.xml
  crs debug wander.c room.xml -- 500
  crs debug --batch -x crash.dbg wander.c room.xml
  crs debug -ex "break turn if speed > 100" -ex continue wander.c room.xml
  crs debug --dap stdio                          for an editor, see docs/editors.md
"""

_PORTS: Final = 65536


def _dap(_ctx: click.Context, _option: click.Parameter, where: str | None) -> str | None:
    is_number = where is not None and where.isascii() and where.isdigit() and len(where) < 6
    if where is None or where == "stdio" or (is_number and int(where) < _PORTS):
        return where
    raise click.BadParameter(f"'{where}' is neither stdio nor the number of a port.")


_OPTIONS: Final = (
    click.option(
        "-x", "scripts", multiple=True, metavar="FILE",
        type=click.Path(exists=True, dir_okay=False, path_type=Path),
        help="Do the commands in a file first; may be given again.",
    ),
    click.option(
        "-ex", "commands", multiple=True, metavar="COMMAND",
        help="Do a command first, behind those of -x; may be given again.",
    ),
    click.option(
        "--batch", is_flag=True,
        help="End when the commands of -x and -ex are done: with 0 if all could be done, else 1.",
    ),
    click.option(
        "--input", metavar="FILE",
        type=click.Path(exists=True, dir_okay=False, path_type=Path),
        help="What the programs read from their standard input; by default what is typed, and "
        "with --batch our own standard input.",
    ),
    click.option(
        "--tui/--repl", default=None,
        help="Show the full screen, or a plain prompt; by default the screen on a terminal.",
    ),
    click.option(
        "--dap", metavar="stdio|PORT", callback=_dap,
        help="Serve an editor by the Debug Adapter Protocol, on our standard streams or on a port "
        "of this computer; 0 is any free one.",
    ),
    click.option("-q", "--quiet", is_flag=True, help="Leave out the compiler's warnings."),
)  # fmt: skip


def _debug_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Return a command all arguments and options of `crs debug`."""
    command = program_options(command, needs_files=False)
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
    """Compile a C control program, and steps through its run in a simulated world.

    Programs and world go together, forward and backward: reverse-step, reverse-continue, goto.
    Programs, worlds and options are those of crs run. Commands have gdb's names, help lists
    them; on the full screen, F1 tells the keys.
    """
    wanted = DebugOptions(**options)
    if wanted.dap is not None:
        from crs_cc.cli.editor import serve_editor

        return serve_editor(wanted.dap, read_options)
    if not wanted.inputs.sources and wanted.inputs.world is None:
        raise click.UsageError("name a C file to debug.")
    from crs_cc.cli.debugging import debug_programs

    return debug_programs(wanted)


def read_options(arguments: Sequence[str]) -> DebugOptions:
    """Return what a command line of `crs debug` says.

    Raises:
        click.ClickException: it is wrong.
    """
    options = _reader().main(list(arguments), prog_name="crs debug", standalone_mode=False)
    assert isinstance(options, DebugOptions)
    return options


@functools.cache
def _reader() -> click.Command:
    """Return a command that does nothing but to read its options."""
    command = click.command(cls=WithProgramArguments, add_help_option=False)
    return command(_debug_options(DebugOptions))
