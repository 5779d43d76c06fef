"""The firings of a robot that has been at rest for a while, executed all at once.

At rest, the time and place of each firing is known, so that firings need not be executed in turn,
and most need not be executed at all: of each sonar only the last echo that was heard is known to
anybody. So the last firings are executed first, and earlier ones while a sonar has no echo.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int32Array, Int64Array
from crs_cc.sim.devices.sonar.model import MAX_SONARS
from crs_cc.sim.devices.sonar.state import SonarState

_ROUNDS: Final = 2  # executed at once: a firing per sonar is enough if each echo is heard in time


class Firings(NamedTuple):
    """Pings of some robots' sonars, (k,) each.

    Attributes:
        rows: the robots.
        number: the sonar's number.
        before: number of the robot's firings before it.
        at_s: its time.
    """

    rows: IndexArray
    number: IndexArray
    before: Int64Array
    at_s: FloatArray


class MissedFirings:
    """The firings of robots up to a time, to be executed from the last to the first."""

    def __init__(self, sonar: SonarState, rows: IndexArray, to_s: FloatArray) -> None:
        """Find the firings.

        Args:
            sonar: the state of the sonars, which has heard the echoes before the first firing.
            rows: the robots, each with at least one firing, k of them.
            to_s: the time of each, (k,).
        """
        self._sonar, self._rows = sonar, rows
        self._first = sonar.turn[rows]
        self._end = _turns(sonar, rows, to_s)
        self._rest = self._end  # those before this one are still to be executed
        self._known = np.ones((len(rows), MAX_SONARS), dtype=np.bool_)
        robot, turn = np.nonzero(np.arange(MAX_SONARS) < sonar.length[rows, None])
        self._known[robot, sonar.order[rows[robot], turn]] = False

    def take(self) -> tuple[IndexArray, IndexArray, Firings]:
        """Return the next firings, with the index of each robot and the turns; none at the end."""
        sonar, end = self._sonar, self._rest
        begin = np.maximum(end - _ROUNDS * sonar.length[self._rows], self._first)
        begin = np.where(self._known.all(axis=1), end, begin)
        self._rest = begin
        robot = np.repeat(np.arange(len(end)), end - begin)
        turn = np.arange(len(robot)) + np.repeat(end - np.cumsum(end - begin), end - begin)
        rows = self._rows[robot]
        number = sonar.order[rows, turn % sonar.length[rows]]
        before = sonar.count[rows] + turn - self._first[robot]
        return robot, turn, Firings(rows, number, before, self._at_s(rows, turn))

    def hear(
        self,
        which: tuple[IndexArray, IndexArray, Firings],
        heard_s: FloatArray,
        heard_m: FloatArray,
        places: Int32Array,
    ) -> None:
        """Record the echoes of firings.

        Args:
            which: what `take` returned, m firings.
            heard_s: when the echo is heard, (m,).
            heard_m: its distance, infinite for none, (m,).
            places: the configuration of each robot, (k, 7).
        """
        robot, turn, (rows, number, _, at_s) = which
        sonar, last = self._sonar, turn == self._end[robot] - 1
        # An echo that has not arrived at the next firing is lost; the last one may still arrive.
        kept = ~last & (heard_s <= self._at_s(rows, turn + 1)) & ~self._known[robot, number]
        place = rows[kept], number[kept]  # of equal places, the last one counts
        sonar.echo_m[place] = heard_m[kept]
        sonar.fired_s[place] = at_s[kept]
        sonar.fired_from[place] = places[robot[kept]]
        self._known[robot[kept], number[kept]] = True
        firing = rows[last]
        sonar.listening[firing] = number[last]
        sonar.sent_s[firing] = at_s[last]
        sonar.sent_from[firing] = places[robot[last]]
        sonar.heard_s[firing] = heard_s[last]
        sonar.heard_m[firing] = heard_m[last]

    def end(self) -> None:
        """Set the next firings."""
        sonar, rows = self._sonar, self._rows
        sonar.count[rows] += self._end - self._first
        sonar.turn[rows] = self._end
        sonar.next_s[rows] = self._at_s(rows, self._end)

    def _at_s(self, rows: IndexArray, turn: Int64Array) -> FloatArray:
        return self._sonar.start_s[rows] + turn * self._sonar.interval_s[rows]


def _turns(sonar: SonarState, rows: IndexArray, to_s: FloatArray) -> Int64Array:
    """Return the number of each robot's firings up to a time."""
    start_s, interval_s = sonar.start_s[rows], sonar.interval_s[rows]
    turn = np.maximum(((to_s - start_s) / interval_s).astype(np.int64) - 1, sonar.turn[rows])
    while (due := start_s + turn * interval_s <= to_s).any():
        turn += due
    return np.asarray(turn)
