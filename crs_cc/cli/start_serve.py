"""Serve a world: listen, wait for the robots' programs, and run."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import click

from crs_cc.cli.elsewhere import Elsewhere
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.load import Loaded, load_world_of, users_files
from crs_cc.cli.messages import say
from crs_cc.cli.net_address import shown_address, token_left
from crs_cc.cli.simulate import run_loaded
from crs_cc.core.input_files import logged
from crs_cc.core.source import Diagnostics
from crs_cc.net.access import Access, parsed
from crs_cc.net.gate import Gate, bound
from crs_cc.net.roster import Roster
from crs_cc.runtime.executable import Executable

if TYPE_CHECKING:
    from crs_cc.cli.serve_options import ServeOptions
    from crs_cc.net.handshake import Program
    from crs_cc.net.roster import Seat
    from crs_cc.sim.model.world import WorldModel

_OWN_NAMES = ("127.0.0.1", "::1", "localhost")


def start_serve(options: ServeOptions) -> int:
    """Wait for the programs of a world's robots, run them, and return the exit status.

    Raises:
        CrsError: the world is not valid.
        click.UsageError: the options do not go together.
        OSError: the port is in use.
    """
    with logged() as files_read:
        world = load_world_of(options)
    access = _access(options.tokens)
    roster = Roster(world.robots)
    with _gate(options, access, roster) as gate:
        _greet(options, access, gate.port)
        try:
            seats = _seats(roster, options)
        except KeyboardInterrupt:
            say("crs: interrupted before the run began")
            return 130
        loaded = _loaded(options, world, seats, users_files(files_read))
        names = [robot.id for robot in world.robots]
        waits = options.on_loss == "wait"
        elsewhere = Elsewhere(roster, seats, names, loaded.executables, waits=waits)
        return run_loaded(loaded, _as_run(options, seats), Diagnostics(), elsewhere)


def _access(file: Path | None) -> Access:
    if file is None:
        return Access.made()
    try:
        return parsed(file.read_text("utf-8"))
    except ValueError as error:
        raise click.UsageError(f"--tokens: {file}:{error}.") from None


@contextlib.contextmanager
def _gate(options: ServeOptions, access: Access, roster: Roster) -> Iterator[Gate]:
    host, port = options.listen
    if host not in _OWN_NAMES and not options.insecure:
        text = f"--listen {host} is open to other machines, which could read tokens and programs"
        raise click.UsageError(f"{text}: --insecure if the network is yours alone.")
    listener = bound(host, port)
    with token_left(listener.getsockname()[1], access.token("robot")):
        gate = Gate(listener, access, roster)
        try:
            yield gate
        finally:
            gate.close()


def _greet(options: ServeOptions, access: Access, port: int) -> None:
    host = options.listen[0]
    address = shown_address((host, port))
    say(f"crs: serving {options.inputs.world} at {address}")
    if options.insecure and host not in _OWN_NAMES:
        say("crs: warning: INSECURE: whoever sees the network reads tokens and programs")
    if options.tokens is None:
        say(f"crs: robots join by: crs join ROBOT HOST:{port} PROGRAM.c")
        say(f"crs: from other machines with: --token {access.token('robot')}")


def _seats(roster: Roster, options: ServeOptions) -> list[Seat]:
    """Wait until all robots have programs; return their hosts."""
    told: list[str] = []
    while missing := roster.missing():
        if missing != told and not options.quiet:
            shown = ", ".join(missing[:5]) + (", ..." if len(missing) > 5 else "")
            say(f"crs: waiting for {shown}")
        told = missing
        roster.wait()
    if not options.quiet:
        say("crs: every robot has its program: the run begins")
    return roster.begin()


def _loaded(
    options: ServeOptions, world: WorldModel, seats: Sequence[Seat], files: dict[Path, bytes]
) -> Loaded:
    """Return world and programs as if they had been loaded here."""
    programs: dict[str, Program] = {}
    for seat in seats:
        assert seat.program is not None
        programs |= dict.fromkeys(seat.names, seat.program)
        files |= {Path(name): content for name, content in seat.program.contents.items()}
    rows = [programs[robot.id] for robot in world.robots]
    executables = {id(each): Executable(each.name, each.command, b"", _unknown) for each in rows}
    arguments = [
        (each.command, *(each.arguments or robot.arguments))
        for each, robot in zip(rows, world.robots, strict=True)
    ]
    return Loaded(
        world,
        tuple(executables[id(each)] for each in rows),
        tuple(tuple(map(Path, each.sources)) for each in rows),
        tuple(each.dialect or None for each in rows),  # type: ignore[misc]
        tuple(arguments),
        {name: path.read_bytes() for name, path in options.inputs_on_disk.items()},
        files,
        (),
    )


def _unknown() -> NoReturn:
    raise AssertionError("only the host knows the code of its program")


def _as_run(options: ServeOptions, seats: Sequence[Seat]) -> ServeOptions:
    """Return the options of the same run on one machine."""
    program = seats[0].program
    assert program is not None
    compiler = replace(
        options.compiler,
        include_paths=tuple(map(Path, program.include_paths)),
        defines=program.defines,
        undefines=program.undefines,
        standard=program.standard,
        dialect=program.dialect or None,  # type: ignore[arg-type]
    )
    return replace(
        options,
        inputs=Inputs(tuple(map(Path, program.sources)), options.inputs.world),
        arguments=program.arguments,
        compiler=compiler,
        checked=program.checked,
        trap_overflow=program.trap_overflow,
    )
