"""Start the debugger: load the programs, and run the prompt or the full-screen interface."""

from __future__ import annotations

import contextlib
import functools
import io
import shutil
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from crs_cc.cli import full_screen
from crs_cc.cli.exit_status import SYSTEM
from crs_cc.cli.load import Loaded, load
from crs_cc.cli.make_debugger import end_at, make_debugger
from crs_cc.cli.messages import is_coloured, show_before_run
from crs_cc.cli.save_files import save_all
from crs_cc.cli.typed_input import read_script
from crs_cc.core.source import Diagnostics
from crs_cc.debug.engine import Debugger
from crs_cc.debug.repl.keyboard import Keyboard
from crs_cc.debug.repl.repl import Repl, Scripts
from crs_cc.debug.repl.terminal import Terminal
from crs_cc.debug.timeline.console import WaitingAfter
from crs_cc.session.host import Input, Output, never_waits, no_input

if TYPE_CHECKING:
    from crs_cc.cli.debug_options import DebugOptions
    from crs_cc.cli.recorded_run import RecordedRunCheck


def debug_programs(options: DebugOptions, recorded: RecordedRunCheck | None = None) -> int:
    """Debug programs interactively, and return the exit status.

    Args:
        options: what to debug.
        recorded: the recording of the run, which gives the programs their input.

    Raises:
        CrsError: the programs cannot be loaded.
        click.UsageError: a robot has no program, or there is no terminal for the full screen.
        OSError: the programs' input cannot be read.
    """
    on_screen = full_screen.is_wanted(options)
    loaded = _load(options)
    read, waiting = fixed_input(options, recorded)
    make = functools.partial(_new_debugger, loaded, options, recorded=recorded, waiting=waiting)
    if on_screen:
        debugger = full_screen.show(options, make, read)
        record_at_end(debugger, loaded, options, waiting)
        return 0 if _save_files(debugger, options) else SYSTEM
    names = [robot.id for robot in loaded.world.robots]
    columns = _columns if sys.stdout.isatty() else None
    coloured = is_coloured(sys.stdout)
    terminal = Terminal(sys.stdout.buffer, names, is_coloured=coloured, columns=columns)
    keyboard = Keyboard(terminal)
    debugger = make(terminal.program, read or _typed_input(options, keyboard))
    scripts = Scripts(options.scripts, options.commands)
    with contextlib.closing(debugger.session):
        failed = Repl(debugger, terminal, keyboard).run(scripts, batch=options.batch)
        record_at_end(debugger, loaded, options, waiting)
        is_saved = _save_files(debugger, options)
    if not is_saved:
        return SYSTEM
    return int(bool(failed)) if options.batch else 0


def _columns() -> int:
    return shutil.get_terminal_size().columns


def record_at_end(
    debugger: Debugger, loaded: Loaded, options: DebugOptions, waiting: WaitingAfter
) -> None:
    """Record the run in its final state when the debugger ends, if requested."""
    if options.record is not None:
        record(loaded, options, waiting, debugger, options.record)


def record(
    loaded: Loaded, options: DebugOptions, waiting: WaitingAfter, debugger: Debugger, path: Path
) -> None:
    """Record the run in its current state; raise OSError if the recording cannot be written."""
    from crs_cc.cli.record_debugged import record_debugged

    record_debugged(debugger, loaded, replace(options, record=path), waiting)


def fixed_input(
    options: DebugOptions, recorded: RecordedRunCheck | None = None
) -> tuple[Input | None, WaitingAfter]:
    """Return the programs' standard input if it is fixed, and its known part.

    Raises:
        click.UsageError: there are two, or a line of a script is invalid.
        OSError: the file cannot be read.
    """
    if options.input is not None and options.stdin is not None:
        raise click.UsageError("--input and --stdin are mutually exclusive.")
    if recorded is not None:
        return recorded.read, recorded.waiting
    if options.input is not None:
        script = read_script(options.input)
        return script.read, script.waiting
    return None if options.stdin is None else file_input(options.stdin), never_waits


def _typed_input(options: DebugOptions, keyboard: Keyboard) -> Input:
    """Return the input that is typed for programs, which is never a script of commands."""
    if keyboard.is_typed or options.batch:
        return keyboard.read
    return no_input  # stdin holds commands


def file_input(path: Path) -> Input:
    """Return a reader of a file, line by line; raise OSError if the file cannot be read."""
    stream = io.BytesIO(path.read_bytes())
    return lambda _robot, wanted: stream.readline(wanted)


def _save_files(debugger: Debugger, options: DebugOptions) -> bool:
    """Save the files written so far, if requested; return whether all were saved."""
    if options.outputs is None:
        return True
    files = [(name, debugger.session.files(n)) for n, name in enumerate(debugger.names)]
    return save_all(options.outputs, files)


def _load(options: DebugOptions) -> Loaded:
    diagnostics = Diagnostics()
    loaded = load(options, diagnostics, debug=True)
    if not options.quiet:
        show_before_run(diagnostics.messages)
    return loaded


def _new_debugger(
    loaded: Loaded,
    options: DebugOptions,
    output: Output,
    read: Input,
    *,
    waiting: WaitingAfter,
    recorded: RecordedRunCheck | None,
) -> Debugger:
    """Return a debugger of a new run, or of a recorded one with its changes."""
    debugger = make_debugger(loaded, options, output, read, observer=recorded, waiting=waiting)
    if recorded is None:
        end_at(debugger, options.max_time_s or loaded.world.duration_s)
    else:  # it may have run longer than its world specifies
        recorded.begin(debugger)
    is_given = options.stdin is not None or options.input is not None
    debugger.run.console.is_typed = recorded is None and not is_given
    debugger.save = functools.partial(record, loaded, options, waiting)
    return debugger
