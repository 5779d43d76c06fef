"""What programs write while they run, and what they read: lines that the user types.

Both go from one thread to the other: the debugger's and the screen's.
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
        asks: called when a program waits for a line, with the robot's number.
    """

    def __init__(self) -> None:
        self.asks: Callable[[int], None] = lambda _robot: self.give(b"")
        self._lines: SimpleQueue[bytes] = SimpleQueue()
        self._left: dict[int, bytes] = {}
        self._is_asking = False
        self._written: deque[Piece] = deque(maxlen=_MAX)

    def write(self, robot: int, stream: int, content: bytes) -> None:
        """Write output of a program."""
        self._written.append((robot, stream, content))

    def take(self) -> list[Piece]:
        """Return what has been written since this was last asked for."""
        taken = []
        while self._written:
            taken.append(self._written.popleft())
        return taken

    def read(self, robot: int, wanted: int) -> bytes:
        """Return what a program reads, at most as much as it wants; waits for the user."""
        left = self._left.pop(robot, b"")
        if not left:
            self._is_asking = True
            self.asks(robot)
            left = self._lines.get()
            self._is_asking = False
        if len(left) > wanted:
            self._left[robot] = left[wanted:]
        return left[:wanted]

    def give(self, content: bytes) -> None:
        """Take what the user has typed; nothing for the end of the input."""
        self._lines.put(content)

    def end(self) -> None:
        """Let a program that waits find the end of its input."""
        if self._is_asking:
            self.give(b"")
