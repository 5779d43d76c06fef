"""What programs read: lines that the user types when they ask for them."""

from __future__ import annotations

from collections.abc import Callable
from queue import SimpleQueue


class ProgramInput:
    """Takes lines in the screen's thread, and gives them to programs in the debugger's.

    Attributes:
        asks: called when a program waits for a line, with the robot's number.
    """

    def __init__(self) -> None:
        self.asks: Callable[[int], None] = lambda _robot: self.give(b"")
        self._lines: SimpleQueue[bytes] = SimpleQueue()
        self._left: dict[int, bytes] = {}
        self._is_asking = False

    def read(self, robot: int, wanted: int) -> bytes:
        """Gives what a program reads, at most as much as it wants; waits for the user."""
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
        """Takes what the user has typed; nothing for the end of the input."""
        self._lines.put(content)

    def end(self) -> None:
        """Lets a program that waits find the end of its input."""
        if self._is_asking:
            self.give(b"")
