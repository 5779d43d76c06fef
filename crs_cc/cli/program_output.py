r"""The output of the control programs, and the progress line below it.

One robot's bytes are passed through. With several robots each line is prefixed by the robot's name:

>>> import io
>>> out, err = io.BytesIO(), io.BytesIO()
>>> output = ProgramOutput(["robot0", "robot1"], out, err, ProgressLine(None))
>>> for robot, piece in ((0, b"going "), (1, b"bump\n"), (0, b"home\nthe e"), (0, b"nd")):
...     output.write(robot, 1, piece)
>>> output.close()
>>> print(out.getvalue().decode(), end="")
[robot1] bump
[robot0] going home
[robot0] the end
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Sequence
from typing import BinaryIO, Final, TextIO

_MAX_LINE: Final = 4096
_REDRAW_S: Final = 0.1
_ERASE_LINE: Final = "\r\x1b[2K"


class ProgressLine:
    """A status line at the bottom of the terminal.

    Attributes:
        stream: the terminal; None for no progress line.
    """

    def __init__(self, stream: TextIO | None) -> None:
        self.stream = stream
        self._drawn = False
        self._line_is_free = True
        self._next_s = 0.0

    def is_due(self) -> bool:
        """Return whether the line is due to be redrawn and the cursor is at the start of a line."""
        return self.stream is not None and self._line_is_free and time.monotonic() >= self._next_s

    def draw(self, text: str) -> None:
        """Redraw the line, cut off where the terminal ends: a second line would stay."""
        if self.stream is not None:
            self.stream.write(_ERASE_LINE + text[: _columns(self.stream) - 1])
            self.stream.flush()
            self._drawn = True
            self._next_s = time.monotonic() + _REDRAW_S

    def clear(self) -> None:
        """Erase the line, so that something else can be written."""
        if self._drawn and self.stream is not None:
            self.stream.write(_ERASE_LINE)
            self.stream.flush()
        self._drawn = False

    def wrote(self, data: bytes) -> None:
        """Record other output to the terminal: an unfinished line must not be overwritten."""
        self._line_is_free = data.endswith(b"\n")


def _columns(terminal: TextIO) -> int:
    """Return the width of a terminal; 80 if it does not say."""
    try:
        return os.get_terminal_size(terminal.fileno()).columns or 80
    except (OSError, ValueError):
        return 80


class ProgramOutput:
    """Writes the output of the control programs.

    Attributes:
        robots: the robots' names.
        streams: where their standard output (1) and standard error (2) go.
    """

    def __init__(
        self, robots: Sequence[str], out: BinaryIO, err: BinaryIO, progress: ProgressLine
    ) -> None:
        self.robots = list(robots)
        self.streams = {1: out, 2: err}
        self._progress = progress
        self._prefixes = [f"[{name}] ".encode() for name in robots]
        self._shared = {fd: stream.isatty() for fd, stream in self.streams.items()}
        self._begun: dict[tuple[int, int], bytes] = {}
        self._last_fd = 1

    def add(self, robot: str) -> None:
        """Add a robot that has joined."""
        self.robots.append(robot)
        self._prefixes.append(f"[{robot}] ".encode())

    def write(self, robot: int, fd: int, data: bytes) -> None:
        """Write the output of a robot's program to a stream (1 or 2)."""
        if len(self.robots) == 1:
            self._put(fd, data)
            return
        *lines, rest = (self._begun.get((robot, fd), b"") + data).split(b"\n")
        while len(rest) >= _MAX_LINE:
            lines.append(rest[:_MAX_LINE])
            rest = rest[_MAX_LINE:]
        self._begun[robot, fd] = rest
        self._put(fd, b"".join(self._prefixes[robot] + line + b"\n" for line in lines))

    def flush(self) -> None:
        """Flush both streams."""
        for stream in self.streams.values():
            stream.flush()

    def close(self) -> None:
        """End unfinished lines, in the robots' order, and flush."""
        for (robot, fd), rest in sorted(self._begun.items()):
            if rest:
                self._put(fd, self._prefixes[robot] + rest + b"\n")
        self._begun.clear()
        self.flush()

    def _put(self, fd: int, data: bytes) -> None:
        if not data:
            return
        if self._shared[fd]:
            self._progress.clear()
        if fd != self._last_fd:
            self.flush()  # keeps the order if both are the same file
            self._last_fd = fd
        self.streams[fd].write(data)
        if self._shared[fd]:
            self._progress.wrote(data)


def read_line(size: int) -> bytes:
    """Read at most `size` bytes and at most one line from standard input.

    So the pieces depend on the input and never on its timing.
    """
    if sys.stdin is None or sys.stdin.closed:
        return b""
    return sys.stdin.buffer.readline(size)
