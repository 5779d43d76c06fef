"""From loaded programs to a debugger of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Final

from crs_cc.debug.engine import Debugger
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.timeline.console import WaitingAfter
from crs_cc.frontend.dialect import dialect_of
from crs_cc.frontend.preprocess.options import Dialect, Options
from crs_cc.session.host import Input, Output, never_waits
from crs_cc.session.library import library_options

_SLACK: Final = 1e-9  # timesteps

if TYPE_CHECKING:
    from crs_cc.cli.compiler_options import CompilerOptions
    from crs_cc.cli.load import Loaded
    from crs_cc.cli.program_options import ProgramOptions
    from crs_cc.session.session import Listener


def make_debugger(
    loaded: Loaded,
    options: ProgramOptions,
    output: Output,
    read: Input,
    *,
    observer: Listener | None = None,
    waiting: WaitingAfter = never_waits,
) -> Debugger:
    """Return a debugger of loaded programs.

    Args:
        loaded: the world and the programs, in their debug builds.
        options: how to run them.
        output: receives what they write.
        read: returns what they read.
        observer: is notified of timesteps.
        waiting: returns how much input is available.
    """
    return Debugger(
        loaded.world,
        _programs(loaded, options.compiler),
        options.seed if options.seed is not None else loaded.world.seed or 0,
        arguments=loaded.arguments,
        output=output,
        read=read,
        files=loaded.files,
        client=options.client,
        observer=observer,
        waiting=waiting,
    )


def end_at(debugger: Debugger, time_s: float | None) -> None:
    """End a run at the first timestep that ends at or after a time [s]; None for no limit."""
    if time_s:
        timestep_s = debugger.session.environment.world.timestep_s
        debugger.run.last_timestep = math.ceil(time_s / timestep_s - _SLACK)


def _programs(loaded: Loaded, compiler: CompilerOptions) -> list[DebugProgram]:
    """Return each robot's program; robots with the same program share it."""
    made: dict[int, DebugProgram] = {}
    rows = zip(loaded.executables, loaded.sources, loaded.dialects, strict=True)
    for executable, sources, dialect in rows:
        if id(executable) not in made:
            front_end = _front_end(compiler, sources, dialect)
            made[id(executable)] = DebugProgram(executable, sources, front_end)
    return [made[id(executable)] for executable in loaded.executables]


def _front_end(
    compiler: CompilerOptions, sources: Sequence[Path], dialect: Dialect | None
) -> Options:
    """Return the options that the files were compiled with, for parsing expressions."""
    options = library_options(
        compiler.include_paths,
        compiler.defines,
        compiler.undefines,
        compiler.standard,
        compiler.root,
        named_from=compiler.named_from,
    )
    return replace(options, dialect=dialect or dialect_of(sources, options))
