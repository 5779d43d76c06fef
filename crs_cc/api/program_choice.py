"""Which program each robot runs."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Final, TypeAlias

from crs_cc.api.programs import ProgramSource, compile_c
from crs_cc.core.suggest import unknown
from crs_cc.runtime.executable import Executable

if TYPE_CHECKING:
    from crs_cc.sim.model.world import Robot, WorldModel

Program: TypeAlias = Executable | ProgramSource | None
"""A compiled program, what `compile_c` compiles, or None: in a list or a dictionary for a robot
that Python steers, by itself for what the world names.
"""

Programs: TypeAlias = Program | Sequence[Program] | Mapping[str, Program]
"""One program for all, one for each robot in the world's order, or programs by robots' names."""

NONE: Final = "(none)"
"""The name of the program of a robot that Python steers."""

_SLEEPS: Final = "#include <unistd.h>\nint main(void) { for (;;) sleep(1000000000); }\n"
"""The program of a robot that Python steers: it never does anything."""


def executables_of(
    world: WorldModel, programs: Programs, arguments: Sequence[str]
) -> tuple[list[Executable], list[list[str]]]:
    """Return the program and `argv` of each robot.

    Args:
        world: the world.
        programs: the programs.
        arguments: arguments of robots to which the world gives neither these nor a program.

    Raises:
        TypeError: a program or the arguments have the wrong type.
        ValueError: there are too many or too few programs, or a name is unknown.
        CompileError: a program is invalid.
    """
    check_arguments(arguments)
    chosen = _chosen(world, programs)
    built: dict[tuple[ProgramSource | None, str | None], Executable] = {}
    executables, rows = [], []
    for robot, program in zip(world.robots, chosen, strict=True):
        if isinstance(program, Executable):
            executable = program
        else:
            _check_program(program, robot)
            key = program, robot.dialect
            if key not in built:
                built[key] = executable_of(program, robot)
            executable = built[key]
        own = robot.arguments or (() if robot.program else arguments)
        executables.append(executable)
        rows.append([executable.command, *own])
    return executables, rows


def _chosen(world: WorldModel, programs: Programs) -> list[Program]:
    """Return the program of each robot, uncompiled."""
    names = [robot.id for robot in world.robots]
    own: list[Program] = [own_program(robot) for robot in world.robots]
    if programs is None or isinstance(programs, Executable | str | os.PathLike):
        return [each or programs for each in own]  # as on the command line
    if isinstance(programs, Mapping):
        for name in programs:
            if name not in names:
                raise ValueError(unknown("robot", name, names))
        return [programs.get(name, each) for name, each in zip(names, own, strict=True)]
    if not isinstance(programs, Sequence):
        kind = type(programs).__name__
        raise TypeError(f"programs must be a program, a list or a dictionary, not {kind}")
    if len(programs) != len(names):
        raise ValueError(f"{len(programs)} programs for {len(names)} robots (expected one each)")
    return list(programs)


def own_program(robot: Robot) -> Path | None:
    """Return the path of the program that the world names for a robot; it is never source text."""
    return Path(robot.program) if robot.program else None


def check_arguments(arguments: Sequence[str]) -> None:
    """Check the arguments of a program.

    Raises:
        TypeError: they are a single string, each letter of which would be an argument.
    """
    if isinstance(arguments, str | bytes):
        raise TypeError(f"arguments must be a list, such as arguments=[{arguments!r}]")


def _check_program(program: object, robot: Robot) -> None:
    if program is not None and not isinstance(program, str | os.PathLike):
        expected = "a program must be a path or C source text"
        if isinstance(program, Sequence):
            expected = "a program of several files is what compile_c returns for them"
        raise TypeError(f"{robot.id}: {expected}, not {type(program).__name__}")


def executable_of(program: ProgramSource | None, robot: Robot) -> Executable:
    """Return the compiled program of a robot; one that does nothing for None."""
    if program is None:
        return replace(compile_c(_SLEEPS), name=NONE)
    return compile_c(program, dialect=robot.dialect)
