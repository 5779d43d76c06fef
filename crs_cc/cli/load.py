"""Load the files of the command line: a world, and a program for each robot."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.compiler_options import gathered, merged
from crs_cc.cli.inputs import check_readable
from crs_cc.core.input_files import logged
from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.preprocess.options import Dialect
from crs_cc.runtime.executable import Executable
from crs_cc.session.empty_world import empty_world
from crs_cc.sim.files.known_robots import known_robots
from crs_cc.sim.model.world import Robot, WorldModel
from crs_cc.toolchain.fingerprint import PACKAGE

if TYPE_CHECKING:
    from collections.abc import Mapping

    from crs_cc.cli.program_options import ProgramOptions


_ARGUMENT_HINT: Final = "arguments of the program follow --"


@dataclass(frozen=True, slots=True)
class Loaded:
    """A world and its programs, loaded.

    Attributes:
        executables: each robot's program.
        sources: each robot's C files.
        dialects: the API that each robot's program calls; None to detect it.
        arguments: each robot's `argv`.
        files: the initial contents of every program's disk, by file name.
        files_read: the user's files that describe the world, with their contents.
        compiled: the files that the compiler looked for, found or not.
    """

    world: WorldModel
    executables: tuple[Executable, ...]
    sources: tuple[tuple[Path, ...], ...]
    dialects: tuple[Dialect | None, ...]
    arguments: tuple[tuple[str, ...], ...]
    files: dict[str, bytes]
    files_read: dict[Path, bytes]
    compiled: tuple[Path, ...]


def load(options: ProgramOptions, diagnostics: Diagnostics, *, debug: bool = False) -> Loaded:
    """Load the world, and compile every program that its robots run once.

    Raises:
        CompileError: a C source is invalid.
        WorldError: the world file is invalid.
        click.UsageError: a robot has no program.
    """
    with (
        gathered(diagnostics, options.compiler.warnings, quiet=options.quiet),
        logged() as files_read,
    ):
        world = load_world_of(options)
        programs = [program_of(robot, options) for robot in world.robots]
        dialects = [options.compiler.dialect or robot.dialect for robot in world.robots]
        wanted = list(zip(programs, dialects, strict=True))
        if options.inputs.sources and options.inputs.sources not in programs:
            place = Location(str(options.inputs.sources[0]))
            text = "unused: the world file names a program for every robot"
            diagnostics.warning(place, text, flag="unused-program")
        built = {
            each: build_program(*each, options, diagnostics, debug=debug)
            for each in dict.fromkeys(wanted)
        }
    return Loaded(
        world,
        tuple(built[each] for each in wanted),
        tuple(programs),
        tuple(dialects),
        tuple(
            (built[each].command, *arguments_of(robot, options))
            for robot, each in zip(world.robots, wanted, strict=True)
        ),
        {name: path.read_bytes() for name, path in options.inputs_on_disk.items()},
        user_files(files_read),
        compiled_files(diagnostics),
    )


def user_files(files_read: Mapping[Path, bytes]) -> dict[Path, bytes]:
    """Return those files that are the user's own."""
    return {path: each for path, each in files_read.items() if not _is_bundled(path)}


def compiled_files(diagnostics: Diagnostics) -> tuple[Path, ...]:
    """Return the user's files that the compiler looked for, found or not."""
    return tuple(path for path in sorted(map(Path, diagnostics.digests)) if not _is_bundled(path))


def _is_bundled(path: Path) -> bool:
    return path.is_absolute() and path.is_relative_to(PACKAGE)


def load_world_of(options: ProgramOptions) -> WorldModel:
    """Load the world of a run.

    Raises:
        WorldError: it is invalid.
        click.UsageError: the robot is unknown.
    """
    path, robot = options.inputs.world, options.robot
    if robot not in known_robots() and not robot.endswith(".xml"):
        names = ", ".join(known_robots())
        raise click.UsageError(f"unknown robot '{robot}' (known: {names}, or an .xml file).")
    if path is None:
        world = empty_world(options.setup, robot)
    else:
        check_readable(path)
        from crs_cc.sim.files.world_xml import load_world

        world = load_world(path, options.setup, robot, seed=options.seed)
    return world.with_ideal_link() if options.link == "ideal" else world


def program_of(robot: Robot, options: ProgramOptions) -> tuple[Path, ...]:
    """Return the C files of a robot's program.

    Raises:
        click.UsageError: it has none.
    """
    if robot.id in options.programs:
        return options.programs[robot.id].sources
    if robot.program:
        return (Path(robot.program),)
    if not options.inputs.sources:
        name = options.inputs.world
        raise click.UsageError(f"no program for '{robot.id}': give a C file, {name} names none.")
    return options.inputs.sources


def arguments_of(robot: Robot, options: ProgramOptions) -> tuple[str, ...]:
    """Return the world's arguments if it names a program; ours are for the program given here."""
    if robot.id in options.programs:
        return options.programs[robot.id].arguments
    return robot.arguments or (() if robot.program else options.arguments)


def build_program(
    sources: tuple[Path, ...],
    dialect: Dialect | None,
    options: ProgramOptions,
    diagnostics: Diagnostics,
    *,
    debug: bool = False,
) -> Executable:
    """Compile a program; its messages are added to those of others.

    Raises:
        CompileError: it is not valid.
    """
    for path in sources:
        is_word = path.suffix != ".c" and not options.arguments
        check_readable(path, _ARGUMENT_HINT if is_word else "")
    own = Diagnostics()
    try:
        flags = {"checked": options.checked, "trap_overflow": options.trap_overflow}
        return options.compiler.build(sources, own, dialect, debug=debug, **flags)
    finally:
        diagnostics.messages[:] = merged(diagnostics.messages, own.messages)
        diagnostics.digests.update(own.digests)
