"""Serve a world: listen, wait for the robots' programs, and run."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import click

from crs_cc.cli.elsewhere import Elsewhere, shown_names
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.load import Loaded, arguments_of, load_world_of, program_of, users_files
from crs_cc.cli.messages import say
from crs_cc.cli.net_address import shown_address, token_left
from crs_cc.cli.program_options import RobotProgram
from crs_cc.cli.resumption import Resumption
from crs_cc.cli.simulate import run_loaded
from crs_cc.cli.view_address import announced
from crs_cc.core.input_files import logged
from crs_cc.core.loopback import LOOPBACK
from crs_cc.core.source import Diagnostics
from crs_cc.net import tls
from crs_cc.net.access import Access, parsed
from crs_cc.net.gate import Gate, bound, led_to
from crs_cc.net.roster import Roster
from crs_cc.runtime.executable import Executable
from crs_cc.workbench.clients import Role as PageRole
from crs_cc.workbench.server import Front

if TYPE_CHECKING:
    from crs_cc.cli.serve_options import ServeOptions
    from crs_cc.net.handshake import Program
    from crs_cc.net.roster import Seat
    from crs_cc.sim.model.world import Robot, WorldModel

_OWN_NAMES = ("127.0.0.1", "::1", "localhost")
_ANY_NAME = ("0.0.0.0", "::")  # noqa: S104 - to listen at, not to connect to


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
    access = _access(options.tokens)
    roster = Roster(world.robots)
    secure = _tls(options)
    with (
        _gate(options, access, roster, secure) as gate,
        _front(options, access, gate, is_secure=secure is not None) as front,
    ):
        _greet(options, access, gate.port, secure)
        try:
            seats = _seats(roster, options)
        except KeyboardInterrupt:
            say("crs: interrupted before the run began")
            return 130
        programs = _programs(world, seats)
        loaded = _loaded(options, world, programs, users_files(files_read))
        run = _as_run(options, world, programs)
        names = [robot.id for robot in world.robots]
        waits = options.on_loss == "wait"
        elsewhere = Elsewhere(
            roster,
            seats,
            names,
            loaded.executables,
            waits=waits,
            front=front,
            resumption=resumption,
        )
        return run_loaded(loaded, run, Diagnostics(), elsewhere)


def _access(file: Path | None) -> Access:
    if file is None:
        return Access.made()
    try:
        return parsed(file.read_text("utf-8"))
    except ValueError as error:
        raise click.UsageError(f"--tokens: {file}:{error}.") from None


@contextlib.contextmanager
def _gate(
    options: ServeOptions, access: Access, roster: Roster, secure: tls.Server | None
) -> Iterator[Gate]:
    host, port = options.listen
    if host not in _OWN_NAMES and not (secure or options.insecure):
        text = f"--listen {host} is open to other machines, which could read tokens and programs"
        raise click.UsageError(f"{text}: --tls, or --insecure if the network is yours alone.")
    listener = bound(host, port)
    with token_left(listener.getsockname()[1], access.token("robot")):
        gate = Gate(listener, access, roster, secure.secure if secure else lambda plain: plain)
        try:
            yield gate
        finally:
            gate.close()


def _tls(options: ServeOptions) -> tls.Server | None:
    """Return what encrypts connections, if that is wanted."""
    if options.tls_cert is None and options.tls_key is None:
        return tls.self_made() if options.tls else None
    if options.tls_cert is None or options.tls_key is None:
        raise click.UsageError("--tls-cert and --tls-key belong together.")
    try:
        return tls.Server(options.tls_cert, options.tls_key)
    except ValueError:
        raise click.UsageError(f"--tls-cert: {options.tls_cert} has no certificate.") from None


def _greet(options: ServeOptions, access: Access, port: int, secure: tls.Server | None) -> None:
    host = options.listen[0]
    address = shown_address((host, port))
    say(f"crs: serving {options.inputs.world} at {address}")
    if secure is not None:
        say(f"crs: fingerprint of the certificate: {secure.fingerprint}")
    elif host not in _OWN_NAMES:
        say("crs: warning: INSECURE: whoever sees the network reads tokens and programs")
    if options.tokens is None:
        say(f"crs: robots join by: crs join ROBOT HOST:{port} PROGRAM.c")
        say(f"crs: from other machines with: --token {access.token('robot')}")


@contextlib.contextmanager
def _front(
    options: ServeOptions, access: Access, gate: Gate, *, is_secure: bool
) -> Iterator[Front | None]:
    """Yield where pages connect, if they may; `crs view` finds it on this machine."""
    if options.view is None:
        yield None
        return
    tokens: dict[PageRole, tuple[str, ...]] = {
        "control": access.tokens["control"],
        "view": access.tokens["view"],
    }

    def open_to_pages(port: int) -> None:
        gate.visitor = led_to(port)

    host = options.listen[0]
    address = shown_address((LOOPBACK if host in _ANY_NAME else host, gate.port))
    place = f"{'https' if is_secure else 'http'}://{address}"
    with announced(gate.port, f"{place}/#token={access.token('control')}"):
        yield Front(place, gate.port, tokens, open_to_pages)


def _seats(roster: Roster, options: ServeOptions) -> list[Seat]:
    """Wait until all robots have programs; return their hosts."""
    told: list[str] = []
    while missing := roster.missing():
        if missing != told and not options.quiet:
            say(f"crs: waiting for {shown_names(missing)}")
        told = missing
        roster.wait()
    if not options.quiet:
        say("crs: every robot has its program: the run begins")
    return roster.begin()


def _programs(world: WorldModel, seats: Sequence[Seat]) -> list[Program]:
    """Return the program of each robot."""
    found: dict[str, Program] = {}
    for seat in seats:
        assert seat.program is not None
        found |= dict.fromkeys(seat.names, seat.program)
    return [found[robot.id] for robot in world.robots]


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
    if options.record is not None and len(set(map(_way, programs))) > 1:
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


def _way(program: Program) -> tuple[object, ...]:
    """Return how a program is compiled."""
    folders, macros = program.include_paths, (program.defines, program.undefines)
    flags = program.checked, program.trap_overflow
    return folders, macros, program.standard, program.dialect, flags
