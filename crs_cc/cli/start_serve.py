"""Serve a world: listen, wait for the robots' programs, and run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import click

from crs_cc.cli.inputs import Inputs
from crs_cc.cli.load import Loaded, arguments_of, load_world_of, program_of, user_files
from crs_cc.cli.messages import say
from crs_cc.cli.net_address import shown_address
from crs_cc.cli.own_hosts import OwnHosts
from crs_cc.cli.program_options import RobotProgram
from crs_cc.cli.remote_hosts import RemoteHosts, shown_names
from crs_cc.cli.resumption import Resumption
from crs_cc.cli.served_port import ServedPort, greet, is_own_name, served_port
from crs_cc.cli.simulate import run_loaded
from crs_cc.core.input_files import logged
from crs_cc.core.source import Diagnostics
from crs_cc.net.host_registry import HostRegistry
from crs_cc.runtime.executable import Executable

if TYPE_CHECKING:
    from crs_cc.cli.serve_options import ServeOptions
    from crs_cc.net.handshake import Program
    from crs_cc.net.host_registry import Assignment
    from crs_cc.sim.model.world import Robot, WorldModel


def start_serve(options: ServeOptions) -> int:
    """Wait for the programs of a world's robots, run them, and return the exit status.

    Raises:
        CrsError: the world is not valid.
        click.UsageError: the options do not go together.
        OSError: the port is in use.
    """
    with logged() as files_read:
        world = load_world_of(options)
    resumption = None if options.resume is None else Resumption(options.resume)
    registry = HostRegistry(world.robots, _required_robots(world, options, resumption))
    with served_port(options, registry) as port:
        _greet(options, port)
        try:
            assignments = _wait_for_hosts(registry, options, resumption)
        except KeyboardInterrupt:
            say("crs: interrupted before the run started")
            return 130
        programs = _programs(world, assignments)
        loaded = _loaded(options, world, programs, user_files(files_read))
        run = _as_run(options, world, programs)
        names = [robot.id for robot in world.robots]
        own = None
        if options.on_loss == "restart":
            own = OwnHosts(names, to_stderr=options.as_json, threads=options.threads)
        remote_hosts = RemoteHosts(
            registry,
            assignments,
            names,
            loaded.executables,
            waits=options.on_loss == "wait",
            own=own,
            front=port.front,
            resumption=resumption,
            late=_late_joins(world, assignments, resumption),
        )
        return run_loaded(loaded, run, Diagnostics(), remote_hosts)


def _greet(options: ServeOptions, port: ServedPort) -> None:
    greet(options, port)
    if options.tokens is None:
        secured = f" --fingerprint {port.fingerprint}" if options.tls else ""
        is_own = is_own_name(options.listen[0])
        host = shown_address((options.listen[0] if is_own else "HOST", port.number))
        others = "through a tunnel" if is_own else "from other machines"
        say(f"crs: to join: crs join ROBOT {host} PROGRAM.c{secured}")
        say(f"crs: {others} with: --token {port.access.token('robot')}")


def _wait_for_hosts(
    registry: HostRegistry, options: ServeOptions, resumption: Resumption | None
) -> list[Assignment]:
    """Wait until the run can start; return the connected hosts.

    Args:
        registry: the assignment of robots to hosts.
        options: whether to begin with the first.
        resumption: the state of a run that is resumed; None for a new run.
    """
    absent = frozenset() if resumption is None else resumption.absent
    reported: list[str] = []
    every = len(registry.missing())
    while missing := [name for name in registry.missing() if name not in absent]:
        if options.start == "now" and resumption is None and len(missing) < every:
            break
        if missing != reported and not options.quiet:
            say(f"crs: waiting for {shown_names(missing)}")
        reported = missing
        registry.wait()
    assignments = registry.begin()
    if not options.quiet:
        late = registry.unassigned(assignments)
        notice = f"crs: the run begins without {shown_names(late)}"
        say(notice if late else "crs: every robot has a program: the run starts")
    return assignments


def _required_robots(
    world: WorldModel, options: ServeOptions, resumption: Resumption | None
) -> list[str]:
    """Return the robots whose hosts the run requires to start."""
    if resumption is not None:
        return [robot.id for robot in world.robots if robot.id not in resumption.absent]
    return [] if options.start == "now" else [robot.id for robot in world.robots]


def _late_joins(
    world: WorldModel, assignments: Sequence[Assignment], resumption: Resumption | None
) -> dict[str, float]:
    """Return the robots that join once their hosts have connected, with the earliest time [s]."""
    here = {name for assignment in assignments for name in assignment.names}
    if resumption is not None:
        here -= resumption.absent
    return {robot.id: robot.join_s for robot in world.robots if robot.id not in here}


def _programs(world: WorldModel, assignments: Sequence[Assignment]) -> list[Program]:
    """Return the program of each robot; those without a host will have that of the first."""
    found: dict[str, Program] = {}
    for assignment in assignments:
        assert assignment.program is not None
        found |= dict.fromkeys(assignment.names, assignment.program)
    first = assignments[0].program
    assert first is not None
    return [found.get(robot.id, first) for robot in world.robots]


def _loaded(
    options: ServeOptions, world: WorldModel, rows: Sequence[Program], files: dict[Path, bytes]
) -> Loaded:
    """Return world and programs as if they had been loaded here."""
    for program in {id(each): each for each in rows}.values():
        files |= {Path(name): content for name, content in program.contents.items()}
    executables = {id(each): Executable(each.name, each.command, b"", _unknown) for each in rows}
    arguments = [
        (each.command, *_arguments(each, robot))
        for each, robot in zip(rows, world.robots, strict=True)
    ]
    return Loaded(
        world,
        tuple(executables[id(each)] for each in rows),
        tuple(map(_paths, rows)),
        tuple(each.dialect or None for each in rows),  # type: ignore[misc]
        tuple(arguments),
        {name: path.read_bytes() for name, path in options.inputs_on_disk.items()},
        files,
        (),
    )


def _unknown() -> NoReturn:
    raise AssertionError("only the host knows the code of its program")


def _as_run(options: ServeOptions, world: WorldModel, programs: Sequence[Program]) -> ServeOptions:
    """Return the options of the same run on one machine.

    Raises:
        click.UsageError: it is to be recorded, and its programs are compiled in different ways.
    """
    first = programs[0]
    unnamed = [
        each for robot, each in zip(world.robots, programs, strict=True) if not robot.program
    ]
    if options.record is not None and len(set(map(_compile_options, programs))) > 1:
        text = "a run is recorded if all programs are compiled with the same options"
        raise click.UsageError(f"--record: {text}.")
    compiler = replace(
        options.compiler,
        include_paths=tuple(map(Path, first.include_paths)),
        defines=first.defines,
        undefines=first.undefines,
        standard=first.standard,
        dialect=first.dialect or None,  # type: ignore[arg-type]
    )
    run = replace(
        options,
        inputs=Inputs(_paths(unnamed[0]) if unnamed else (), options.inputs.world),
        arguments=unnamed[0].arguments if unnamed else (),
        compiler=compiler,
        checked=first.checked,
        trap_overflow=first.trap_overflow,
    )
    own = {}
    for robot, program in zip(world.robots, programs, strict=True):
        found = RobotProgram(_paths(program), _arguments(program, robot))
        expected = tuple(map(Path.absolute, program_of(robot, run)))
        if found != RobotProgram(expected, arguments_of(robot, run)):
            own[robot.id] = found
    return replace(run, programs=own)


def _arguments(program: Program, robot: Robot) -> tuple[str, ...]:
    """Return the arguments of a program: the host's own, else those in the world."""
    return program.arguments or robot.arguments


def _paths(program: Program) -> tuple[Path, ...]:
    """Return the C files of a program."""
    return tuple(map(Path, program.sources))


def _compile_options(program: Program) -> tuple[object, ...]:
    """Return the options for compiling a program."""
    folders, macros = program.include_paths, (program.defines, program.undefines)
    flags = program.checked, program.trap_overflow
    return folders, macros, program.standard, program.dialect, flags
