"""The sonars' schedules, the pings in the air, and the echoes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Self

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int32Array, Int64Array, any_of
from crs_cc.core.units import m_to_inch
from crs_cc.sim.devices.sonar.model import MAX_SONARS, NONE, Sonars
from crs_cc.sim.state.last_measurement import CONFIGURATION

if TYPE_CHECKING:
    from crs_cc.sim.state.env_state import EnvState

NO_ECHO: Final = 255
"""A sonar's reading in inches without an echo, the largest that the byte on the link can hold
(vendor source `Ndirect.c` 2.7)."""

_NONE: Final = -1


@dataclass(slots=True)
class SonarState:
    """The sonars of all robots; arrays have a row for each robot.

    Attributes:
        order: the firing order, of which `length` entries are used, (robots, 16).
        length: number of firings in a round; with 0 no sonar fires.
        start_s: time of the first firing of the order.
        interval_s: the time from one firing to the next.
        turn: number of firings of the order so far.
        next_s: time of the next firing, infinite for never.
        count: total number of firings.
        mode: the sonars' mode.
        listening: the sonar whose ping is in the air, -1 for none.
        sent_s: time of that ping.
        sent_from: the robot's configuration then, as in `State`, (robots, 7).
        heard_s: time of its echo, or of its timeout.
        heard_m: distance of its echo, infinite for none.
        echo_m: distance of each sonar's last echo [m], infinite for none, (robots, 16).
        fired_s: time of the ping of that echo; 0 before a sonar's first, (robots, 16).
        fired_from: the robot's configuration then, as in `State`, (robots, 16, 7).
    """

    order: IndexArray
    length: IndexArray
    start_s: FloatArray
    interval_s: FloatArray
    turn: Int64Array
    next_s: FloatArray
    count: Int64Array
    mode: IndexArray
    listening: IndexArray
    sent_s: FloatArray
    sent_from: Int32Array
    heard_s: FloatArray
    heard_m: FloatArray
    echo_m: FloatArray
    fired_s: FloatArray
    fired_from: Int32Array

    @classmethod
    def at_start(cls, models: Sequence[Sonars | None]) -> Self:
        """Return sonars without echoes; those in the order start at once."""
        boards = [(model or NONE).board for model in models]
        count = len(boards)
        order = np.zeros((count, MAX_SONARS), dtype=np.intp)
        for row, board in zip(order, boards, strict=True):
            row[: len(board.order)] = board.order
        length = np.array([len(board.order) for board in boards], dtype=np.intp)
        return cls(
            order=order,
            length=length,
            start_s=np.zeros(count),
            interval_s=np.array([board.interval_s for board in boards]),
            turn=np.zeros(count, dtype=np.int64),
            next_s=np.where(length > 0, 0.0, np.inf),
            count=np.zeros(count, dtype=np.int64),
            mode=np.zeros(count, dtype=np.intp),
            listening=np.full(count, _NONE, dtype=np.intp),
            sent_s=np.zeros(count),
            sent_from=np.zeros((count, CONFIGURATION), dtype=np.int32),
            heard_s=np.zeros(count),
            heard_m=np.zeros(count),
            echo_m=np.full((count, MAX_SONARS), np.inf),
            fired_s=np.zeros((count, MAX_SONARS)),
            fired_from=np.zeros((count, MAX_SONARS, CONFIGURATION), dtype=np.int32),
        )

    def hear(self, rows: IndexArray, to_s: FloatArray) -> None:
        """Record the echoes and timeouts up to a time of each robot."""
        heard = (self.listening[rows] != _NONE) & (self.heard_s[rows] <= to_s)
        if not any_of(heard):
            return
        rows = rows[heard]
        place = (rows, self.listening[rows])
        self.echo_m[place] = self.heard_m[rows]
        self.fired_s[place] = self.sent_s[rows]
        self.fired_from[place] = self.sent_from[rows]
        self.listening[rows] = _NONE

    def reorder(
        self, rows: IndexArray, order: IndexArray, length: IndexArray, now_s: FloatArray
    ) -> None:
        """Start new orders: the first sonar fires now, those in no order have no echo."""
        self.order[rows] = order
        self.length[rows] = length
        self.start_s[rows] = now_s
        self.turn[rows] = 0
        self.next_s[rows] = np.where(length > 0, now_s, np.inf)
        self.listening[rows] = _NONE
        silent = np.ones((len(rows), MAX_SONARS), dtype=np.bool_)
        robot, turn = np.nonzero(np.arange(MAX_SONARS) < length[:, None])
        silent[robot, order[robot, turn]] = False
        self.echo_m[rows] = np.where(silent, np.inf, self.echo_m[rows])


def sonar_state(state: EnvState) -> SonarState:
    """Return the sonars' part of the state."""
    return state.device("sonar", SonarState)


def inches(distance_m: FloatArray) -> Int32Array:
    """Return distances as sonars report them: whole inches, 0 to `NO_ECHO`."""
    whole = np.rint(m_to_inch(distance_m))
    return np.minimum(np.maximum(whole, 0), NO_ECHO).astype(np.int32)  # faster than `clip`
