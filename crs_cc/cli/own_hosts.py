"""Hosts in the environment's own process, which replace lost ones.

They run what the lost hosts have sent when they came: their sources, compiled again here.
"""

from __future__ import annotations

import socket
import sys
import tempfile
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from crs_cc.cli.program_output import ProgramOutput, ProgressLine
from crs_cc.core.source import Diagnostics
from crs_cc.net.channel import Channel, ConnectionLostError, KeepAlive
from crs_cc.net.program_host import ProgramHost, Streams
from crs_cc.recording.source_tree import write_tree
from crs_cc.session.build import build_driver, build_executable
from crs_cc.session.host import never_waits, no_input

if TYPE_CHECKING:
    from crs_cc.core.arrays import IndexArray
    from crs_cc.net.handshake import Program
    from crs_cc.runtime.executable import Executable


class OwnHosts:
    """Starts hosts in threads of this process; they have no standard input."""

    def __init__(self, robots: Sequence[str], *, to_stderr: bool, threads: int | None) -> None:
        """Start none.

        Args:
            robots: the names of all robots of the run.
            to_stderr: whether programs write everything to standard error.
            threads: how many threads may run programs of a host, see `Fleet`.
        """
        out = sys.stderr.buffer if to_stderr else sys.stdout.buffer
        self._output = ProgramOutput(robots, out, sys.stderr.buffer, ProgressLine(None))
        self._writing = threading.Lock()
        self._threads = threads
        self._keep_alive: KeepAlive | None = None

    def start(self, program: Program, robots: IndexArray) -> Channel:
        """Return a connection to a new host that runs a program for some robots.

        Raises:
            CompileError: the program cannot be compiled here.
            ValueError: the names of its files are not valid.
            OSError: its files cannot be written, or there is no memory for it.
        """
        executable = _built(program)
        if self._keep_alive is None:
            self._keep_alive = KeepAlive()
            self._keep_alive.__enter__()
        here, there = map(Channel, socket.socketpair())
        for channel in (here, there):
            self._keep_alive.add(channel)

        def write(robot: int, stream: int, content: bytes) -> None:
            with self._writing:
                self._output.write(int(robots[robot]), stream, content)
                self._output.flush()

        streams = Streams(write, no_input, never_waits)
        host = ProgramHost(
            [executable] * len(robots), build_driver(), streams, threads=self._threads
        )
        threading.Thread(target=_serve, args=(host, there), name="crs-host", daemon=True).start()
        return here

    def close(self) -> None:
        """Print incomplete lines, and end the hosts."""
        self._output.close()
        if self._keep_alive is not None:
            self._keep_alive.__exit__()


def _serve(host: ProgramHost, channel: Channel) -> None:
    try:
        host.serve(channel)
    except ConnectionLostError:
        pass  # the run has ended
    finally:
        channel.close()


def _built(program: Program) -> Executable:
    """Return a program, compiled from the files that its host has sent."""
    with tempfile.TemporaryDirectory(prefix="crs-host-") as name:
        folder = Path(name)

        def below(path: str) -> Path:
            return folder / path.lstrip("/")

        contents = {path.lstrip("/"): content for path, content in program.contents.items()}
        write_tree(contents, folder)
        return build_executable(
            [below(path) for path in program.sources],
            Diagnostics(),
            include_paths=[below(path) for path in program.include_paths],
            defines=program.defines,
            undefines=program.undefines,
            standard=program.standard,
            root=folder,
            named_from=folder,
            checked=program.checked,
            trap_overflow=program.trap_overflow,
            dialect=program.dialect or None,  # type: ignore[arg-type]
        )
