r"""The standard input of programs: that of crs, or lines typed at simulated times.

A script has a line for each time at which something is typed, in order. `\n` is the return key;
other escapes are those of C:

>>> typed = Script(parse_script("# the way out\n1s: go\\n\n2.5s: w\n", "keys.txt"))
>>> typed.waiting(0, 0.5), typed.waiting(0, 1.0)
((0, 0.5), (3, 0.0))
>>> typed.read(0, 80), typed.waiting(0, 1.0), typed.read(0, 80), typed.read(0, 80)
(b'go\n', (0, 1.5), b'w', b'')
"""

from __future__ import annotations

import re
import sys
from bisect import bisect_right
from collections.abc import Sequence
from itertools import accumulate
from pathlib import Path
from typing import Final

import click

from crs_cc.cli.messages import is_terminal
from crs_cc.cli.program_output import read_line
from crs_cc.core.host_system import is_input_waiting

TIMED_LINE: Final = re.compile(r"\s*(\d+(?:\.\d*)?|\.\d+)\s*s?\s*:[ \t]?(.*)")
_ESCAPE: Final = re.compile(rb"\\(?:x([0-9A-Fa-f]{1,2})|([0-7]{1,3})|(.))")
_LETTERS: Final = {
    b"n": b"\n", b"t": b"\t", b"r": b"\r", b"e": b"\x1b", b"b": b"\b", b"a": b"\a", b"f": b"\f",
    b"v": b"\v",
}  # fmt: skip

Typed = tuple[float, bytes]
"""When something is typed [s], and what."""


def parse_script(text: str, name: str) -> list[Typed]:
    """Return the lines that a script types.

    Args:
        text: the script.
        name: its file, for messages.

    Raises:
        click.UsageError: a line is invalid.
    """
    typed: list[Typed] = []
    for number, line in enumerate(text.splitlines(), start=1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        match = TIMED_LINE.match(line)
        if match is None:
            raise click.UsageError(
                f"{name}:{number}: expected a time and a text, as in '2.5s: go\\n'"
            )
        time_s = float(match[1])
        if typed and time_s < typed[-1][0]:
            raise click.UsageError(f"{name}:{number}: the time is before that of the previous line")
        typed.append((time_s, _unescaped(match[2].encode("utf-8", "surrogateescape"))))
    return typed


def read_script(path: Path) -> Script:
    """Return the script in a file.

    Raises:
        click.UsageError: a line is invalid.
        OSError: it cannot be read.
    """
    return Script(parse_script(path.read_text("utf-8", "surrogateescape"), str(path)))


def _unescaped(text: bytes) -> bytes:
    def character(match: re.Match[bytes]) -> bytes:
        if match[3] is not None:
            return _LETTERS.get(match[3], match[3])
        code = int(match[1], 16) if match[1] else int(match[2], 8)
        return bytes([code & 0xFF])

    return _ESCAPE.sub(character, text)


class Script:
    """Types the same at every robot."""

    def __init__(self, typed: Sequence[Typed]) -> None:
        self._typed = [each for each in typed if each[1]]
        self._ends = list(accumulate(len(text) for _, text in self._typed))
        self._read: dict[int, int] = {}

    def waiting(self, robot: int, clock_s: float, read: int | None = None) -> tuple[int, float]:
        """Return the number of unread typed bytes, and the time of the next ones [s].

        Args:
            robot: the robot's number.
            clock_s: the clock of its program [s].
            read: how many bytes it has read, for a program that has gone back; None for all that
                were given out.
        """
        number, done = self._place(self._read.get(robot, 0) if read is None else read)
        if number == len(self._typed):
            return 0, 0.0  # the end of the input
        ready = -done
        for time_s, text in self._typed[number:]:
            if time_s > clock_s:
                return max(ready, 0), 0.0 if ready > 0 else time_s - clock_s
            ready += len(text)
        return ready, 0.0

    def read(self, robot: int, size: int) -> bytes:
        """Return the next bytes, of one line and typed at one time."""
        read = self._read.get(robot, 0)
        number, done = self._place(read)
        if number == len(self._typed):
            return b""
        text = self._typed[number][1]
        end = min(text.find(b"\n", done) + 1 or len(text), done + size)
        self._read[robot] = read + end - done
        return text[done:end]

    def _place(self, read: int) -> tuple[int, int]:
        """Return the number of the first text that is not read wholly, and how much of it is."""
        number = bisect_right(self._ends, read)
        return number, read - (self._ends[number - 1] if number else 0)


class OwnInput:
    """Our standard input, which all robots share.

    A file or a pipe is always ready; a read may have to wait for the writer of the pipe.
    """

    def __init__(self) -> None:
        self._next = b""

    def waiting(self, _robot: int, _clock_s: float) -> tuple[int, float]:
        """Return the number of available bytes of the next line; inf if nothing has been typed."""
        if not self._next:
            if is_terminal(sys.stdin) and not is_input_waiting():
                return 0, float("inf")
            self._next = read_line(_MAX_LINE)
        return len(self._next), 0.0

    def read(self, _robot: int, size: int) -> bytes:
        """Return the next bytes, at most `size` of one line."""
        line = self._next or read_line(size)
        self._next = line[size:]
        return line[:size]


_MAX_LINE: Final = 256
"""The most bytes of a line that are known before they are read."""
