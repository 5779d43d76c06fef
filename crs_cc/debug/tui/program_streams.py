"""The standard streams of programs under the full screen.

They connect the debugger's thread and the screen's.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from queue import SimpleQueue
from typing import Final

_MAX: Final = 1000
"""So many pieces of output are kept for the screen, the newest; it shows no more at once."""

Piece = tuple[int, int, bytes]
"""A robot, a stream, and what its program has written there."""


class ProgramStreams:
    """The standard streams of the programs.

    Attributes:
        on_input_request: called when a program waits for a line, with the robot's number.
    """

    def __init__(self) -> None:
        self.on_input_request: Callable[[int], None] = lambda _robot: self.send_input(b"")
        self._lines: SimpleQueue[bytes] = SimpleQueue()
        self._left: dict[int, bytes] = {}
        self._is_asking = False
        self._written: deque[Piece] = deque(maxlen=_MAX)

    def write(self, robot: int, stream: int, content: bytes) -> None:
        """Write output of a program."""
        self._written.append((robot, stream, content))

    def take_output(self) -> list[Piece]:
        """Return the output since the last call."""
        taken = []
        while self._written:
            taken.append(self._written.popleft())
        return taken

    def read(self, robot: int, wanted: int) -> bytes:
        """Return input for a program, at most `wanted` bytes; wait for the user."""
        left = self._left.pop(robot, b"")
        if not left:
            self._is_asking = True
            self.on_input_request(robot)
            left = self._lines.get()
            self._is_asking = False
        if len(left) > wanted:
            self._left[robot] = left[wanted:]
        return left[:wanted]

    def send_input(self, content: bytes) -> None:
        """Pass on a typed line; None for the end of the input."""
        self._lines.put(content)

    def end(self) -> None:
        """End the input of a waiting program."""
        if self._is_asking:
            self.send_input(b"")
