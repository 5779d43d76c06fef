"""Run the programs of robots for a remote environment, until the run has ended."""

from __future__ import annotations

import os
import secrets
import socket
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from crs_cc.cli.compiler_options import gathered
from crs_cc.cli.load import build_program, compiled_files
from crs_cc.cli.messages import is_coloured, say, show_before_run
from crs_cc.cli.net_address import shown_address, token_for
from crs_cc.cli.program_output import ProgramOutput, ProgressLine
from crs_cc.cli.remote_hosts import shown_names
from crs_cc.cli.report import render_report
from crs_cc.cli.typed_input import OwnInput
from crs_cc.core.errors import ProgramError
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.regular_file import read_regular_file
from crs_cc.net.channel import ConnectionLostError, KeepAlive
from crs_cc.net.environment_connection import EnvironmentConnection, connect
from crs_cc.net.handshake import Hello, Program, RefusedError, as_text, devices_digest
from crs_cc.net.program_host import ProgramHost, Streams
from crs_cc.net.tls import Client, Connection
from crs_cc.session.build import build_driver

if TYPE_CHECKING:
    from crs_cc.cli.serve_options import JoinOptions
    from crs_cc.runtime.executable import Executable

_MIN_PAUSE_S, _MAX_PAUSE_S = 0.1, 1.0
_LOST: Final = 1
_REFUSED: Final = 2


def run_host(options: JoinOptions) -> int:
    """Compile a program, run it for robots elsewhere, and return the exit status.

    Raises:
        CompileError: the program is not valid.
    """
    diagnostics = Diagnostics()
    with gathered(diagnostics, options.compiler.warnings, quiet=options.quiet):
        executable = build_program(
            options.inputs.sources, options.compiler.dialect, options, diagnostics
        )
    if not options.quiet:
        show_before_run(diagnostics.messages)
    program = _program(options, executable, compiled_files(diagnostics))
    try:
        return _Host(options, executable, program).run()
    except RefusedError as error:
        say(f"crs: {shown_address(options.address)}: refused: {error}")
        return _REFUSED
    except ConnectionLostError as error:
        say(f"crs: {shown_address(options.address)}: {error}")
        return _LOST


def _program(options: JoinOptions, executable: Executable, files: Sequence[Path]) -> Program:
    """Return the parts of the program that a recording of the run needs."""
    compiler = options.compiler
    contents = {path: read_regular_file(path) for path in files}
    return Program(
        name=executable.name,
        command=executable.command,
        arguments=options.arguments,
        sources=tuple(map(_absolute, options.inputs.sources)),
        files={
            _absolute(path): as_text(content)
            for path, content in contents.items()
            if isinstance(content, bytes)
        },
        include_paths=tuple(map(_absolute, compiler.include_paths)),
        defines=compiler.defines,
        undefines=compiler.undefines,
        standard=compiler.standard,
        dialect=compiler.dialect or "",
        checked=options.checked,
        trap_overflow=options.trap_overflow,
    )


def _absolute(path: Path) -> str:
    """Return a path from the root on, as it is written on all systems; links stay."""
    return f"/{Path(os.path.abspath(path)).as_posix().lstrip('/')}"  # noqa: PTH100


def _secure(options: JoinOptions) -> Callable[[socket.socket], Connection]:
    """Return the function that encrypts a connection, if requested."""
    if not (options.tls or options.fingerprint):
        return lambda connection: connection
    return Client(options.address[0], options.fingerprint).secure


class _Host:
    """Robots' programs, over as many connections as it takes."""

    def __init__(self, options: JoinOptions, executable: Executable, program: Program) -> None:
        self._options, self._executable = options, executable
        self._program = program.content()
        self._hello = Hello(
            "",
            secrets.token_hex(16),
            options.robots,
            program.digest,
            options.definition,
            devices_digest(),
        )
        self._secure = _secure(options)
        self._input = OwnInput()
        self._output: ProgramOutput | None = None
        self._shown = 0

    def run(self) -> int:
        """Run the programs to their end, and return the exit status.

        Raises:
            RefusedError: the environment does not take this host.
            ConnectionLostError: it cannot be reached.
        """
        with KeepAlive() as keep_alive:
            while True:
                found = self._connect(keep_alive)
                try:
                    return self._serve(found)
                except ConnectionLostError as error:
                    if not self._options.quiet:
                        say(f"crs: connection to the environment lost ({error}); reconnecting")
                finally:
                    found.channel.close()

    def _connect(self, keep_alive: KeepAlive) -> EnvironmentConnection:
        """Connect to the environment, as often as it takes for some time."""
        end_s, pause_s = time.monotonic() + self._options.retry_s, _MIN_PAUSE_S
        is_reported = self._options.quiet
        while True:
            address = self._options.address
            token = token_for(self._options.token, address[1])
            hello = replace(self._hello, token=token)
            try:
                return connect(address, hello, self._program, keep_alive, self._secure)
            except ConnectionLostError as error:
                if time.monotonic() + pause_s > end_s:
                    raise
                if not is_reported:
                    shown, retry_s = shown_address(address), self._options.retry_s
                    say(f"crs: {shown}: {error}; trying again for {retry_s:g} s")
                    is_reported = True
            time.sleep(pause_s)
            pause_s = min(2.0 * pause_s, _MAX_PAUSE_S)

    def _serve(self, found: EnvironmentConnection) -> int:
        robots = found.robots
        if self._output is None:
            if not self._options.quiet:
                say(f"crs: {', '.join(robots)} at {shown_address(self._options.address)}")
                if found.awaited:
                    say(f"crs: waiting for {shown_names(found.awaited)} to join")
            line = ProgressLine(None)
            self._output = ProgramOutput(robots, sys.stdout.buffer, sys.stderr.buffer, line)
        elif not self._options.quiet:
            say(f"crs: {shown_address(self._options.address)} is reached again")
        streams = Streams(self._write, self._input.read, self._input.waiting)
        executables = [self._executable] * len(robots)
        host = ProgramHost(executables, build_driver(), streams, self._shown, self._options.threads)
        try:
            ended = host.serve(found.channel)
        finally:
            self._shown = host.shown
            self._output.flush()
        self._output.close()
        return self._status(host, robots, ended)

    def _write(self, robot: int, stream: int, content: bytes) -> None:
        assert self._output is not None
        self._output.write(robot, stream, content)
        self._output.flush()

    def _status(self, host: ProgramHost, robots: Sequence[str], ended: Any) -> int:
        """Report the results of the programs, and return the exit status."""
        statuses, running = list[int](), list[str]()
        for robot, (name, outcome) in enumerate(zip(robots, ended, strict=True)):
            if outcome["failed"]:
                report = host.fleet.report(robot)
                shown = name if len(robots) > 1 else ""
                say(render_report(report, shown, coloured=is_coloured(sys.stderr)))
                statuses.append(ProgramError.exit_status)
            else:
                statuses.append(outcome["exit_status"] or 0)
                if outcome["exit_status"] is None:
                    running.append(name)
        if running and not self._options.quiet:
            say(f"crs: the run has ended, and with it the program of {shown_names(running)}")
        return int(statuses[0]) if len(statuses) == 1 else int(any(statuses))
