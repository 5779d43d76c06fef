"""What programs write to their standard streams, and what they read, in memory."""

from __future__ import annotations

from collections import defaultdict
from typing import Final

MAX_BYTES: Final = 2**20
"""What is kept of a stream of a robot; the rest is dropped."""


class Streams:
    """The standard streams of all robots.

    Attributes:
        written: how many bytes all programs have written, kept or not.

    >>> streams = Streams(b"hello")
    >>> streams.write(0, 1, b"hi")
    >>> streams.text(0, 1), streams.read(0, 3), streams.read(0, 3), streams.read(0, 3)
    ('hi', b'hel', b'lo', b'')
    """

    def __init__(self, stdin: bytes) -> None:
        self._stdin = stdin
        self._read: dict[int, int] = defaultdict(int)
        self._written: dict[tuple[int, int], bytearray] = defaultdict(bytearray)
        self.written = 0

    def write(self, robot: int, stream: int, content: bytes) -> None:
        """Store a program's output to a stream."""
        self.written += len(content)
        kept = self._written[robot, stream]
        kept += content[: MAX_BYTES - len(kept)]

    def read(self, robot: int, wanted: int) -> bytes:
        """Return the next bytes of a program's standard input, at most as many as wanted."""
        first = self._read[robot]
        found = self._stdin[first : first + wanted]
        self._read[robot] += len(found)
        return found

    def text(self, robot: int, stream: int) -> str:
        """Return a program's output to a stream, at most 1 MiB."""
        return self._written[robot, stream].decode(errors="replace")
