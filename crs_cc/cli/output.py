r"""Where the output of the control programs goes, and the progress line that keeps out of its way.

One robot's bytes go on as they are. With several robots each line is prefixed by its robot's name:

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

import sys
import time
from collections.abc import Sequence
from typing import BinaryIO, Final, TextIO

_LONGEST_LINE: Final = 4096
_REDRAW_S: Final = 0.1
_ERASE_LINE: Final = "\r\x1b[2K"


class ProgressLine:
    """A line at the bottom of the terminal that is drawn again and again.

    Attributes:
        stream: the terminal; None for no progress line.
    """

    def __init__(self, stream: TextIO | None) -> None:
        self.stream = stream
        self._drawn = False
        self._line_is_free = True
        self._next_s = 0.0

    def is_due(self) -> bool:
        """Return whether it is time to draw again and nothing stands in the way."""
        return self.stream is not None and self._line_is_free and time.monotonic() >= self._next_s

    def draw(self, text: str) -> None:
        """Write the line over the one drawn before."""
        if self.stream is not None:
            self.stream.write(_ERASE_LINE + text)
            self.stream.flush()
            self._drawn = True
            self._next_s = time.monotonic() + _REDRAW_S

    def clear(self) -> None:
        """Takes the line away, so that something else can be written."""
        if self._drawn and self.stream is not None:
            self.stream.write(_ERASE_LINE)
            self.stream.flush()
        self._drawn = False

    def wrote(self, data: bytes) -> None:
        """Hears what others wrote to the terminal: an unfinished line must not be drawn over."""
        self._line_is_free = data.endswith(b"\n")


class ProgramOutput:
    """Writes what the control programs print.

    Attributes:
        robots: the robots' names.
        streams: where their standard output (1) and standard error (2) go.
    """

    def __init__(
        self, robots: Sequence[str], out: BinaryIO, err: BinaryIO, progress: ProgressLine
    ) -> None:
        self.robots = robots
        self.streams = {1: out, 2: err}
        self._progress = progress
        self._prefixes = [f"[{name}] ".encode() for name in robots]
        self._shared = {fd: stream.isatty() for fd, stream in self.streams.items()}
        self._begun: dict[tuple[int, int], bytes] = {}
        self._last_fd = 1

    def write(self, robot: int, fd: int, data: bytes) -> None:
        """Takes what a robot's program wrote to a stream (1 or 2)."""
        if len(self.robots) == 1:
            self._put(fd, data)
            return
        *lines, rest = (self._begun.get((robot, fd), b"") + data).split(b"\n")
        while len(rest) >= _LONGEST_LINE:
            lines.append(rest[:_LONGEST_LINE])
            rest = rest[_LONGEST_LINE:]
        self._begun[robot, fd] = rest
        self._put(fd, b"".join(self._prefixes[robot] + line + b"\n" for line in lines))

    def flush(self) -> None:
        """Bring everything written so far to the reader."""
        for stream in self.streams.values():
            stream.flush()

    def close(self) -> None:
        """End unfinished lines, in the robots' order, and flushes."""
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
            self.flush()  # keeps the order of the two where both go to the same place
            self._last_fd = fd
        self.streams[fd].write(data)
        if self._shared[fd]:
            self._progress.wrote(data)


def read_line(size: int) -> bytes:
    """Read from our stdin what a program wants: at most `size` bytes, at most one line.

    So the pieces depend on what is written to us and never on when.
    """
    if sys.stdin is None or sys.stdin.closed:
        return b""
    return sys.stdin.buffer.readline(size)
