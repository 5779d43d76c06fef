"""The requests answered by a program's host computer: streams, files, arguments, exit.

Those about time are answered where programs are run, see `runtime.turns`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final, Literal

import numpy as np

from crs_cc.requests import CODES, DATA_SIZE, REQUESTS
from crs_cc.session.files import Disk

Client = Literal["nclient", "ndirect"]
"""The vendor's client libraries: for the simulator, and for a robot on a serial line."""

CLIENTS: Final[tuple[Client, ...]] = ("nclient", "ndirect")

Link = Literal["serial", "ideal"]
"""The line between host and robot: as its definition has it, or without delay."""

LINKS: Final[tuple[Link, ...]] = ("serial", "ideal")

Output = Callable[[int, int, bytes], None]
"""Receives a program's output: robot number, stream (1 or 2), bytes."""

Input = Callable[[int, int], bytes]
"""Returns a program's standard input: robot number, maximum number of bytes."""


Waiting = Callable[[int, float], tuple[int, float]]
"""Returns how much of the standard input can be read, and how long a read waits: robot number and
clock [s] to bytes and [s]."""


def discard(_robot: int, _stream: int, _content: bytes) -> None:
    """Discard a program's output."""


def no_input(_robot: int, _wanted: int) -> bytes:
    """Return the end of file."""
    return b""


def never_waits(_robot: int, _clock_s: float, _read: int = 0) -> tuple[int, float]:
    """Return that a read returns at once."""
    return 0, 0.0


CLIENT: Final = 3
"""The stream of what a program writes for a client outside of the run."""

HOST_CODES: Final = frozenset(code for code, row in REQUESTS.items() if row.server == "host")


@dataclass(frozen=True, slots=True)
class HostRequest:
    """One request to be answered in place.

    Attributes:
        robot: the robot's number.
        message: a view of its message, one element of dtype `MESSAGE`.
        clock_s: the program's clock [s].
    """

    robot: int
    message: Any
    clock_s: float = 0.0


class Host:
    """The host computers of all robots.

    Attributes:
        exit_status: by robot, its program's exit status; None while it runs.
        disks: by robot, its files.
        reply: receives what a robot's program writes for a client outside, see `net.vendor`; it is
            no output of the run.
    """

    def __init__(
        self,
        arguments: Sequence[Sequence[str]],
        output: Output,
        read: Input,
        files: Mapping[str, bytes] | None = None,
        client: Client = "nclient",
        *,
        waiting: Waiting = never_waits,
    ) -> None:
        """Create a host for each robot.

        Args:
            arguments: for each robot `argv`.
            output: receives the output of programs to their standard streams.
            read: returns their standard input.
            files: the initial contents of every program's disk, by file name.
            client: which of the vendor's client libraries to emulate.
            waiting: returns what can be read of the standard input.
        """
        self._waiting = waiting
        self._client = CLIENTS.index(client)
        self.exit_status: list[int | None] = []
        self.disks: list[Disk] = []
        self._files = files or {}
        self._arguments: list[list[bytes]] = []
        for row in arguments:
            self.add(row)
        self._output = output
        self.reply: Output = discard
        self._read = read

    def close(self) -> None:
        """Let go of the programs' output and input."""
        self._output, self.reply = discard, discard
        self._read, self._waiting = no_input, never_waits

    def add(self, arguments: Sequence[str]) -> None:
        """Add the host of another robot."""
        self.exit_status.append(None)
        self.disks.append(Disk(self._files))
        self._arguments.append([each.encode("utf-8", "surrogateescape") for each in arguments])

    def truncate(self, count: int) -> None:
        """Remove all hosts but the first `count`."""
        del self.exit_status[count:], self.disks[count:], self._arguments[count:]

    def serve(self, code: int, request: HostRequest) -> None:
        """Answer a request: -1 for an unknown code."""
        if code in FILE_SERVERS:
            self._file(FILE_SERVERS[code], request)
        elif code in HANDLERS:
            HANDLERS[code](self, request)
        else:
            request.message["result"] = -1

    def _exit(self, request: HostRequest) -> None:
        self.exit_status[request.robot] = int(request.message["i"][0]) & 0xFF

    def _write(self, request: HostRequest) -> None:
        message = request.message
        stream, size = int(message["i"][0]), int(message["size"])
        if stream not in (1, 2, CLIENT) or not 0 <= size <= DATA_SIZE:
            message["result"] = -1
        else:
            write = self.reply if stream == CLIENT else self._output
            write(request.robot, stream, message["data"][:size].tobytes())
            message["result"] = size

    def _read_stream(self, request: HostRequest) -> None:
        message = request.message
        stream, wanted = int(message["i"][0]), int(message["i"][1])
        if stream != 0 or wanted < 0:
            message["result"] = -1
        else:
            _reply_bytes(message, self._read(request.robot, min(wanted, DATA_SIZE)))
            message["result"] = message["size"]

    def _input(self, request: HostRequest) -> None:
        message = request.message
        message["result"], message["f"][0] = self._waiting(request.robot, request.clock_s)

    def _argument(self, request: HostRequest) -> None:
        message, arguments = request.message, self._arguments[request.robot]
        number, first = int(message["i"][0]), int(message["i"][1])
        if not 0 <= number < len(arguments) or first < 0:
            message["result"] = -1
        else:
            _reply_bytes(message, arguments[number][first : first + DATA_SIZE])
            message["result"] = len(arguments[number])

    def _unconnected(self, request: HostRequest) -> None:
        request.message["result"] = 0  # the session notes the call site

    def _which_client(self, request: HostRequest) -> None:
        request.message["result"] = self._client

    def _file(self, serve: FileServer, request: HostRequest) -> None:
        """Answer a file request with the result of the disk operation."""
        message = request.message
        size = min(max(int(message["size"]), 0), DATA_SIZE)
        first, second, third = message["i"][:3].tolist()
        data = message["data"][:size].tobytes()
        found = serve(self.disks[request.robot], first, second, third, data)
        if isinstance(found, bytes):
            _reply_bytes(message, found)
            found = len(found)
        message["result"] = found


FileServer = Callable[[Disk, int, int, int, bytes], int | bytes]

FILE_SERVERS: Final[dict[int, FileServer]] = {
    CODES["FILE_OPEN"]: lambda disk, flags, _1, _2, name: disk.open(name, flags),
    CODES["FILE_CLOSE"]: lambda disk, number, _1, _2, _data: disk.close(number),
    CODES["FILE_READ"]: lambda disk, number, offset, wanted, _data: disk.read(
        number, offset, min(wanted, DATA_SIZE)
    ),
    CODES["FILE_WRITE"]: lambda disk, number, offset, _, data: disk.write(number, offset, data),
    CODES["FILE_RESIZE"]: lambda disk, number, size, _, _data: disk.resize(number, size),
    CODES["FILE_REMOVE"]: lambda disk, _0, _1, _2, name: disk.remove(name),
    CODES["FILE_LIST"]: lambda disk, index, _1, _2, name: _fitting(disk.entry(name, index)),
    CODES["FILE_RENAME"]: lambda disk, size, _1, _2, names: disk.rename(
        names[: max(size, 0)], names[max(size, 0) :]
    ),
}
"""The disk operation of each file request, given `i[0]`, `i[1]`, `i[2]` and the data."""

HANDLERS: Final[dict[int, Callable[[Host, HostRequest], None]]] = {
    CODES["EXIT"]: Host._exit,
    CODES["WRITE"]: Host._write,
    CODES["READ"]: Host._read_stream,
    CODES["ARGUMENT"]: Host._argument,
    CODES["CLIENT"]: Host._which_client,
    CODES["UNCONNECTED"]: Host._unconnected,
    CODES["INPUT"]: Host._input,
}
"""The methods that answer all other requests; no bound ones, which would be a reference cycle."""


def _fitting(found: bytes | int) -> bytes | int:
    return found if isinstance(found, int) else found[:DATA_SIZE]


def _reply_bytes(message: Any, content: bytes) -> None:
    message["size"] = len(content)
    message["data"][: len(content)] = np.frombuffer(content, np.uint8)
