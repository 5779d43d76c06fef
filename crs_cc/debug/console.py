"""What programs wrote and read, by how much of it: the run goes back, and this goes with it."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.session.host import Input, Output


@dataclass(frozen=True, slots=True)
class ConsolePlace:
    """A place in what was written and read: how many pieces of each."""

    written: int
    read: tuple[int, ...]


class Console:
    """The standard streams of all programs.

    Attributes:
        is_live: whether what programs write is shown.
    """

    def __init__(self, output: Output, read: Input) -> None:
        """Takes what shows the output, and what gives the input."""
        self.is_live = False
        self._show = output
        self._ask = read
        self._written: list[tuple[int, int, bytes]] = []
        self._at = 0
        self._reads: dict[int, list[bytes]] = {}
        self._read_at: dict[int, int] = {}

    def write(self, robot: int, stream: int, content: bytes) -> None:
        """Takes what a program writes."""
        if self._at == len(self._written):
            self._written.append((robot, stream, content))
        self._at += 1
        if self.is_live:
            self._show(robot, stream, content)

    def read(self, robot: int, wanted: int) -> bytes:
        """Gives what a program reads: the same again where it has been read before."""
        known = self._reads.setdefault(robot, [])
        at = self._read_at.get(robot, 0)
        if at == len(known):
            known.append(self._ask(robot, wanted))
        self._read_at[robot] = at + 1
        return known[at]

    def snapshot(self) -> ConsolePlace:
        """Gives the place."""
        most = max(self._reads, default=-1) + 1
        return ConsolePlace(self._at, tuple(self._read_at.get(each, 0) for each in range(most)))

    def restore(self, place: ConsolePlace) -> None:
        """Goes to a place that has been."""
        self._at = place.written
        self._read_at = dict(enumerate(place.read))

    def truncate(self) -> None:
        """Forgets what comes behind this place."""
        del self._written[self._at :]
        for robot, known in self._reads.items():
            del known[self._read_at.get(robot, 0) :]

    def text(self, robot: int | None = None) -> bytes:
        """Gives what was written so far, by one program or by all."""
        return b"".join(
            content
            for writer, _, content in self._written[: self._at]
            if robot is None or writer == robot
        )
