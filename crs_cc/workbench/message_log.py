"""The messages of a run as pages list them: what became of each, and what it said."""

from __future__ import annotations

import copy
import threading
from typing import TYPE_CHECKING, Any, Final

from crs_cc.recording.message_contents import MessageContents, shown
from crs_cc.sim.comms.message_log import MEANINGS, Fate

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from crs_cc.core.arrays import Records
    from crs_cc.sim.engine.step import Step

MAX_ROWS: Final = 20_000
"""Fates of messages that are kept; the older half goes when there are more. Chosen by us."""

MAX_SENT: Final = 2_000
"""Rows that a page gets at once."""

_MAX_CONTENTS: Final = 20_000
_SLACK_S: Final = 1e-9

Row = list[Any]
"""Time [s], fate, channel, sender, receiver (-1 for all), group (-1 for none), type, size, number
of the message among those of its sender, content (None where it is not known)."""


class MessageLog:
    """The fates of messages, in the order in which they were reported; thread-safe."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._rows: list[Row] = []
        self._gone = 0  # rows before the first one that is kept
        self._contents: dict[tuple[int, int], str] = {}

    def step(self, step: Step) -> None:
        """Record the messages of a timestep."""
        for packets in step.posted:
            self._keep(packets)
        if len(step.traffic):
            self.add(_rows(step.traffic, self._contents))

    def add(self, rows: Iterable[Row]) -> None:
        """Record the fates of messages."""
        with self._lock:
            self._rows += rows
            if len(self._rows) > MAX_ROWS:
                self._gone += MAX_ROWS // 2
                del self._rows[: MAX_ROWS // 2]

    def truncate(self, time_s: float) -> None:
        """Discard entries after a time."""
        with self._lock:
            while self._rows and self._rows[-1][0] > time_s + _SLACK_S:
                self._rows.pop()

    def fork(self) -> MessageLog:
        """Return an independent copy."""
        with self._lock:
            other = copy.copy(self)
            other._lock = threading.Lock()
            other._rows, other._contents = self._rows[:], dict(self._contents)
        return other

    def since(self, number: int) -> dict[str, Any]:
        """Return the rows from a number on, the number of the first, and what fates mean."""
        with self._lock:
            first = max(number, self._gone)
            rows = self._rows[first - self._gone :][:MAX_SENT]
            end = self._gone + len(self._rows)
        fates = [[fate.name.lower(), MEANINGS[fate]] for fate in Fate]
        return {"first": first, "rows": rows, "end": end, "fates": fates}

    def _keep(self, packets: Records) -> None:
        for packet in packets:
            key = int(packet["sender"]), int(packet["number"])
            self._contents[key] = shown(packet["data"][: packet["size"]].tobytes())
        while len(self._contents) > _MAX_CONTENTS:
            del self._contents[next(iter(self._contents))]


def _rows(traffic: Records, contents: dict[tuple[int, int], str]) -> list[Row]:
    rows: list[Row] = []
    for row in traffic.tolist():
        time_s, fate, channel, sender, receiver, group, kind, size, number = row
        content = contents.get((sender, number))
        rows.append(
            [round(time_s, 6), fate, channel, sender, receiver, group, kind, size, number, content]
        )
    return rows


def recorded_rows(
    entry: Mapping[str, Sequence[Any]], fates: dict[str, int], contents: MessageContents
) -> list[Row]:
    """Return the rows of an entry of a recording."""
    names = ("time_s", "fate", "channel", "sender", "receiver", "group", "type", "bytes", "number")
    said = [None if each is None else shown(each) for each in contents.of(entry)]
    table = zip(*(entry[name] for name in names), said, strict=True)
    return [
        [float(time_s), fates.get(str(fate), int(Fate.LOSS)), *map(int, rest), content]
        for time_s, fate, *rest, content in table
    ]
