"""The marks that programs drew in a recorded run, and when each was visible."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from crs_cc.recording import topics
from crs_cc.recording.mcap_records import NS
from crs_cc.sim.engine.drawings import Drawing, is_mode, is_xor, marks_of
from crs_cc.sim.engine.server.drawing import MAX_ALL, MAX_OWN

if TYPE_CHECKING:
    from crs_cc.recording.recording import Recording

MAX_ERASED: Final = 50_000
"""Limit of the stored erased marks."""

_INT32: Final = range(-(2**31), 2**31)
_FIELDS: Final = 8

Mark = tuple[int, ...]
_Key = tuple[int, Mark]


@dataclass(frozen=True, slots=True)
class DrawnMark:
    """A mark, and when it was visible.

    Attributes:
        since_s: when it was drawn [s].
        until_s: when it was erased [s]; infinity if it was not.
        drawing: the mark.
    """

    since_s: float
    until_s: float
    drawing: Drawing


def drawn_marks(recording: Recording) -> list[DrawnMark]:
    """Return all marks by the time at which they were drawn.

    Raises:
        RecordingError: one is not valid.
    """
    picture, robots = _Picture(), len(recording.rosters[-1].robots)
    for time_ns, data in recording.data(topics.EVENT.topic):
        if data.get("kind") == "erasing":
            picture.erase_all(time_ns / NS)
        elif data.get("kind") == "drawing":
            with recording.errors():
                robot, mark = int(data["robot"]), _mark(data["mark"])
                if not 0 <= robot < robots:
                    raise ValueError("a mark of an unknown robot")
            for each in marks_of(mark):
                picture.put(time_ns / NS, robot, each)
    return picture.found()


def _mark(numbers: Any) -> Mark:
    """Return a mark; raise ValueError if it is invalid."""
    is_list = isinstance(numbers, list) and len(numbers) == _FIELDS
    if not is_list or not all(type(each) is int and each in _INT32 for each in numbers):
        raise ValueError("a mark is not valid")
    if not is_mode(numbers[0], numbers[-1]):
        raise ValueError("a mark has an unknown shape or mode")
    return tuple(numbers)


class _Picture:
    """The visible marks, as in `sim.engine.server.drawing`, and when they were drawn."""

    def __init__(self) -> None:
        self._since_s: dict[_Key, float] = {}  # the oldest first
        self._own: dict[int, dict[_Key, None]] = {}
        self._erased: list[DrawnMark] = []

    def put(self, time_s: float, robot: int, mark: Mark) -> None:
        """Add a mark on top; an equal one is removed, and in exclusive-or mode both are."""
        key, own = (robot, mark), self._own.setdefault(robot, {})
        if key in own:
            if is_xor(mark[0], mark[-1]):
                self._erase(key, time_s)
            else:
                self._since_s[key] = self._since_s.pop(key)
                own[key] = own.pop(key)
            return
        if len(self._since_s) >= MAX_ALL:
            self._erase(next(iter(self._since_s)), time_s)
        elif len(own) >= MAX_OWN:
            self._erase(next(iter(own)), time_s)
        self._since_s[key] = time_s
        own[key] = None

    def erase_all(self, time_s: float) -> None:
        """Remove all marks."""
        for key in list(self._since_s):
            self._erase(key, time_s)

    def found(self) -> list[DrawnMark]:
        """Return all marks."""
        there = [
            DrawnMark(since_s, math.inf, _drawing(key)) for key, since_s in self._since_s.items()
        ]
        return sorted([*self._erased, *there], key=lambda each: each.since_s)

    def _erase(self, key: _Key, time_s: float) -> None:
        since_s = self._since_s.pop(key)
        del self._own[key[0]][key]
        if len(self._erased) < MAX_ERASED and since_s < time_s:
            self._erased.append(DrawnMark(since_s, time_s, _drawing(key)))


def _drawing(key: _Key) -> Drawing:
    robot, mark = key
    return Drawing.of(robot, mark)


def at_time(marked: Sequence[DrawnMark], time_s: float) -> list[Drawing]:
    """Return the visible marks at a time; infinity means the end."""
    return [
        each.drawing
        for each in marked
        if each.since_s <= time_s and (time_s < each.until_s or each.until_s == math.inf)
    ]
