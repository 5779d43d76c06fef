"""The command `crs`: dispatch to the subcommands, and map errors to exit statuses."""

from __future__ import annotations

import contextlib
import importlib
import os
import sys
import traceback
from collections.abc import Iterator, Sequence
from typing import Any, Final

import click

from crs_cc import __version__
from crs_cc.cli.exit_status import BROKEN_PIPE, INTERRUPTED, SYSTEM
from crs_cc.cli.messages import say, show
from crs_cc.cli.streams import mute, prepare_streams
from crs_cc.core.errors import CrsError, InternalError

COMMANDS: Final = (
    *("run", "view", "debug", "replay", "check", "grade", "sweep", "serve", "join"),
    *("compile", "new", "build", "world", "samples", "docs", "cache", "completion"),
)
"""The subcommands; each is in a module of its name."""

_EPILOG = """
\b
Examples:
  crs run wander.c                               in an empty world, until Ctrl-C
  crs run wander.c room.xml --max-time 60        for a minute of simulated time
  crs run wander.c room.xml --plot path.svg      plot the robot's path
  crs view wander.c room.xml                     watch, control and debug in the browser
  crs debug wander.c room.xml                    debug, forward and backward
  crs replay run.mcap                            summarise a recorded run
  crs check wander.c room.xml                    report errors without running anything
  crs grade submissions/ course.xml              grade many programs against a world's goals
  crs sweep trial.toml --out runs                run all combinations of parameter values and seeds
  crs serve room.xml                             serve a world to programs on other machines
  crs join robot0 127.0.0.1:8000 wander.c        run a robot's program in a served world
  crs new world room                             write a commented template
  crs build room.xml                             draw a world in the browser
  crs world move room.xml crate --x 1m           edit a world from the command line
  crs samples copy wander.c room.xml .           copy a sample program and a world
  crs docs sensors                               read a page of the documentation
  crs compile --emit wat wander.c                show the WebAssembly

\b
Exit status:
  0 to 255  one robot: the exit status of its program, or 0 if it is still running at --max-time
  0 or 1    several robots: 0 if all programs exited with 0, otherwise 1
  1         a system error, such as a full disk
  2         invalid command line, or a device package that cannot be loaded
  70        internal error in crs
  120       not a crs recording, or a damaged recording
  121       invalid C source
  122       invalid world file
  123       one robot: its program was stopped by a runtime error
  125       a recorded run, when repeated, differs from its recording
  130       interrupted by Ctrl-C
  141       broken pipe: the reader closed the output
"""


class _SystemFailure(Exception):  # noqa: N818 - wraps an error
    """Wraps an `OSError` to get it past click, which would exit with 1 silently."""

    def __init__(self, error: OSError) -> None:
        super().__init__(str(error))
        self.error = error


@contextlib.contextmanager
def _wrap_system_errors() -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise _SystemFailure(error) from None


class _Crs(click.Group):
    """Imports the command that runs, not all of them, which takes longer than running some."""

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:  # noqa: ARG002
        if cmd_name not in COMMANDS:
            return None
        module = importlib.import_module(f"crs_cc.cli.{cmd_name}")
        found = (each for each in vars(module).values() if isinstance(each, click.Command))
        return next(each for each in found if each.name == cmd_name)

    def make_context(self, *args: Any, **extra: Any) -> click.Context:
        with _wrap_system_errors():  # --help and --version write here already
            return super().make_context(*args, **extra)

    def invoke(self, ctx: click.Context) -> object:
        with _wrap_system_errors():
            result: object = super().invoke(ctx)
            sys.stdout.flush()
        return result


@click.group(
    cls=_Crs,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog=_EPILOG,
    no_args_is_help=True,
)
@click.version_option(__version__, "-V", "--version", message="crs %(version)s")
def crs() -> None:
    """Run unmodified C control programs for Nomadic robots in a simulated world."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run `crs` with these arguments, by default `sys.argv`, and return the exit status."""
    prepare_streams()
    try:
        return _main(arguments)
    except OSError as error:  # while reporting an error
        return _system_failure(error)


def _main(arguments: Sequence[str] | None) -> int:
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
    except _SystemFailure as failure:
        return _system_failure(failure.error)
    except Exception as error:
        say(f"crs: internal error: {type(error).__name__}: {error}")
        _ask_for_report()
        return InternalError.exit_status
    return int(status or 0)


def _system_failure(error: OSError) -> int:
    """Report a system error if possible; unwritten output is lost."""
    mute(sys.stdout)
    if isinstance(error, BrokenPipeError):
        mute(sys.stderr)
        return BROKEN_PIPE
    say(f"crs: error: {error.strerror or error}{f': {error.filename}' if error.filename else ''}")
    return SYSTEM


def _ask_for_report() -> None:
    if os.environ.get("CRS_DEBUG"):
        traceback.print_exc()
        return
    say("This is a bug in crs, not in your program. Please report it with the C program, the")
    say("world file and the command line; set CRS_DEBUG=1 in the environment for a traceback.")
