"""Recorded standard streams, which are rewound with the run.

All output of the run is one text, and the run is at a position in it. When a part of the run is
replayed, the same pieces are written again and are not recorded twice.
Input is recorded as well: a run that goes back reads the same again, and asks for more only
after all that it has ever read.

>>> from crs_cc.session.host import no_input
>>> console = ReplayConsole(lambda robot, stream, content: print(robot, content.decode()), no_input)
>>> start = console.snapshot()
>>> console.is_live = True
>>> console.write(0, 1, b"hello")
0 hello
>>> console.restore(start)
>>> console.text()
b''
>>> console.write(0, 1, b"hello")
0 hello
>>> console.text()
b'hello'
"""

from __future__ import annotations

import copy
from array import array
from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from crs_cc.core.errors import InternalError
from crs_cc.core.source import Location
from crs_cc.debug.timeline.position import BEGINNING, Position
from crs_cc.session.host import Input, Output, never_waits

WaitingAfter = Callable[[int, float, int], tuple[int, float]]
"""As `Waiting`, with the number of bytes that the program has read."""

_STREAMS: Final = 4
"""More than any stream's number: a robot and a stream are kept as one number."""


@dataclass(frozen=True, slots=True)
class ConsolePosition:
    """A position in output and input: the number of pieces of each, the latter by robot."""

    written: int
    read: tuple[int, ...]


class ReplayConsole:
    """The standard streams of all programs.

    Attributes:
        is_live: whether output is shown, new or replayed.
        shows_new: whether new output is shown in any case.
        is_typed: whether input is typed by the user, who can be asked for it again.
    """

    def __init__(self, output: Output, read: Input, waiting: WaitingAfter = never_waits) -> None:
        """Store the functions that show output, read input and know when there is some."""
        self.is_live = self.shows_new = self.is_typed = False
        self._show = output
        self._ask = read
        self._waiting = waiting
        self._content = bytearray()
        self._ends = array("q", [0])  # the ends of pieces, preceded by 0
        self._writers = array("q")  # of each piece
        self._at = 0
        self._reads: dict[int, list[bytes]] = {}
        self._read_at: dict[int, int] = {}
        self._asked_at: dict[int, list[Position]] = {}  # of each piece of input

    @property
    def piece_count(self) -> int:
        """Return the number of pieces written so far."""
        return self._at

    def write(self, robot: int, stream: int, content: bytes) -> None:
        """Write output of a program.

        Raises:
            InternalError: the run was here before and wrote something else.
        """
        writer, at = robot * _STREAMS + stream, self._at
        is_new = at == len(self._writers)
        if is_new:
            self._writers.append(writer)
            self._content += content
            self._ends.append(len(self._content))
        elif (writer, content) != (self._writers[at], self._piece(at)):
            text = f"the run did not repeat itself: robot {robot} wrote {content!r} this time"
            raise InternalError.at(Location("debugger"), text)
        self._at += 1
        if self.is_live or (is_new and self.shows_new):
            self._show(robot, stream, content)

    def insert(self, robot: int, pieces: Sequence[tuple[int, bytes]]) -> None:
        """Write output on the user's behalf, which replaces what has followed."""
        if pieces:
            self.truncate()
        for stream, content in pieces:
            self.write(robot, stream, content)

    def read(self, robot: int, wanted: int, place: Position = BEGINNING) -> bytes:
        """Return input for a program: recorded input first.

        Args:
            robot: the robot.
            wanted: how much it can be at most [bytes].
            place: a position before the program has asked for it, in the same round.
        """
        known, at = self._reads.setdefault(robot, []), self._read_at.get(robot, 0)
        asked_at = self._asked_at.setdefault(robot, [])
        if at == len(known):
            known.append(self._ask(robot, wanted))
        if len(known[at]) > wanted:  # the user has changed something since
            known[at : at + 1] = known[at][:wanted], known[at][wanted:]
        asked_at[at:] = [place, *asked_at[at + 1 :]]
        asked_at += [place] * (len(known) - len(asked_at))
        self._read_at[robot] = at + 1
        return known[at]

    def typed_input(self) -> Iterator[tuple[Position, int, bytes]]:
        """Yield the pieces of typed input, each with the position and robot that requested it.

        Those that a run reads again after now are among them.
        """
        for robot, known in sorted(self._reads.items()) if self.is_typed else ():
            for place, piece in zip(self._asked_at[robot], known, strict=True):
                yield place, robot, piece

    def discard_typed(self, place: Position) -> None:
        """Discard lines typed from a position on, so that programs wait for them again."""
        for robot, asked_at in self._asked_at.items() if self.is_typed else ():
            count = next((at for at, each in enumerate(asked_at) if each >= place), len(asked_at))
            del asked_at[count:], self._reads[robot][count:]

    def waiting(self, robot: int, clock_s: float) -> tuple[int, float]:
        """Return the available input of a program, and how long a read waits [s], see `Session`."""
        known = self._reads.get(robot, [])[: self._read_at.get(robot, 0)]
        return self._waiting(robot, clock_s, sum(map(len, known)))

    def consumed_input(self) -> dict[int, list[bytes]]:
        """Return the pieces of input that each robot's program has read up to here."""
        return {robot: self._reads[robot][:at] for robot, at in self._read_at.items()}

    def snapshot(self) -> ConsolePosition:
        """Return the current position."""
        robots = range(max(self._read_at, default=-1) + 1)
        return ConsolePosition(self._at, tuple(self._read_at.get(robot, 0) for robot in robots))

    def restore(self, place: ConsolePosition) -> None:
        """Go to a recorded position."""
        self._at = place.written
        self._read_at = dict(enumerate(place.read))

    def truncate(self) -> None:
        """Discard the output after this position.

        The input stays: it does not depend on what the programs do.
        """
        del self._content[self._ends[self._at] :]
        del self._ends[self._at + 1 :], self._writers[self._at :]

    def fork(self) -> ReplayConsole:
        """Return an independent copy up to this position."""
        other = copy.copy(self)
        other._content, other._ends = self._content[:], self._ends[:]
        other._writers, other._read_at = self._writers[:], dict(self._read_at)
        other._reads = {robot: known[:] for robot, known in self._reads.items()}
        other._asked_at = {robot: places[:] for robot, places in self._asked_at.items()}
        other.truncate()
        return other

    def text(self, robot: int | None = None, since: int = 0) -> bytes:
        """Return the output up to here, of one program or of all.

        Args:
            robot: the robot; None for all.
            since: the first piece, see `piece_count`.
        """
        if robot is None:
            return bytes(self._content[self._ends[since] : self._ends[self._at]])
        return b"".join(piece for writer, _, piece in self.pieces(since) if writer == robot)

    def lines_before(self, piece: int) -> int:
        """Return the number of complete lines before a piece of output, see `piece_count`."""
        return self._content.count(b"\n", 0, self._ends[piece])

    def pieces(self, since: int = 0) -> Iterator[tuple[int, int, bytes]]:
        """Return robot, stream and bytes of each piece of output up to here."""
        for at in range(since, self._at):
            yield *divmod(self._writers[at], _STREAMS), self._piece(at)

    def origin(self, line: int) -> tuple[int, int]:
        """Return the robot that printed a line and the piece of output in which the line starts.

        Args:
            line: its number in all output that was ever recorded, from 1.

        Raises:
            IndexError: there is no such line.
        """
        start = 0
        for _ in range(line - 1):
            end = self._content.find(b"\n", start)
            if end < 0:
                raise IndexError(line)
            start = end + 1
        if line < 1 or start >= len(self._content):
            raise IndexError(line)
        piece = bisect_right(self._ends, start) - 1
        return self._writers[piece] // _STREAMS, piece

    def _piece(self, at: int) -> bytes:
        return bytes(self._content[self._ends[at] : self._ends[at + 1]])


class CurrentConsole:
    """The standard streams of a session whose run changes to other branches and their consoles.

    Attributes:
        console: that of the branch that the run is in now.
        place: the start of the round that the programs are in.
    """

    def __init__(self, console: ReplayConsole) -> None:
        """Store the first console."""
        self.console = console
        self.place = BEGINNING

    def write(self, robot: int, stream: int, content: bytes) -> None:
        """Write output of a program, see `ReplayConsole.write`."""
        self.console.write(robot, stream, content)

    def read(self, robot: int, wanted: int) -> bytes:
        """Return input for a program, see `ReplayConsole.read`."""
        return self.console.read(robot, wanted, self.place)

    def waiting(self, robot: int, clock_s: float) -> tuple[int, float]:
        """Return the available input of a program, see `ReplayConsole.waiting`."""
        return self.console.waiting(robot, clock_s)
