"""What is recorded of a run: it can be played and looked at, at any instant."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.units import inch_to_m
from crs_cc.debug.errors import DebugError
from crs_cc.recording import topics
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.message_contents import MessageContents
from crs_cc.sim.comms.message_log import Fate
from crs_cc.workbench.feed import rounded
from crs_cc.workbench.message_log import recorded_rows
from crs_cc.workbench.recorded_content import (
    events_in,
    fields_in,
    frame_blocks,
    marks_in,
    output_in,
)
from crs_cc.workbench.robot_table import MAX_ROBOTS
from crs_cc.workbench.run import Halt

if TYPE_CHECKING:
    from crs_cc.recording.readings import Readings
    from crs_cc.recording.recording import Recording
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.workbench.feed import Feed

MAX_BYTES: Final = 256 * 2**20
"""Of frames that are kept in memory; chosen by us."""

_BACK_NS: Final = 2 * NS
_AHEAD_NS: Final = 5 * NS  # readings are decoded ahead: a message has up to half a minute of them
_SPEED_NS: Final = NS // 5
_SONARS, _BUMPERS = slice(17, 33), 33  # of `State` (vendor header Nclient.h 1.29)
_NO_ECHO: Final = 255


class Playback:
    """A recorded run.

    Attributes:
        timestep_s: the time between two frames.
        halt: why it is stopped, or was stopped last.
        end_s: when the recording ends [s].
        robot: the selected robot.
        world: its world.
    """

    def __init__(self, recording: Recording, world: WorldModel, feed: Feed) -> None:
        """Fill a feed with the recorded data.

        Raises:
            RecordingError: the recording is damaged, or has no frames.
        """
        self.halt = Halt("start", "ready to play")
        self.timestep_s = recording.description.frame_s
        self.time_s = 0.0
        self._recording, self.world = recording, world
        self._rows: list[Readings] = []
        self._read_ns = 0, -1  # what they were read for
        self.end_s = feed.end_s = recording.end_ns / NS
        self.robot = 0
        blocks, _ = frame_blocks(recording, MAX_BYTES)
        if not blocks:
            raise recording.mcap.error("no frames: there is nothing to show")
        for begin_s, end_s, content in blocks:
            feed.frames.add_packed(begin_s, end_s, content)
        for roster in recording.rosters:
            feed.roster(roster.time_ns / NS, roster.robots, roster.objects)
        fates = {fate.name.lower(): int(fate) for fate in Fate}
        contents = MessageContents()
        for _, data in recording.data(topics.MESSAGE.topic):
            with recording.errors():
                feed.messages.add(recorded_rows(data, fates, contents))
        radius_m = world.robots[0].model.radius_m if world.robots else 0.0
        feed.description["marks"] = marks_in(recording, radius_m)[0] or None
        feed.description["fields"] = fields_in(recording)[0] or None
        feed.fill(events_in(recording)[0], output_in(recording)[0])

    @property
    def is_inspectable(self) -> bool:
        """Return False: it has no programs."""
        return False

    def advance(self, timesteps: int) -> bool:
        """Advance by at most a number of timesteps; return whether it can continue."""
        if self.time_s >= self.end_s:
            self.time_s = 0.0
        self.seek(self.time_s + timesteps * self.timestep_s)
        return self.time_s < self.end_s

    def seek(self, time_s: float) -> None:
        """Go to a time."""
        self.time_s = min(self.end_s, time_s)
        is_over = self.time_s >= self.end_s
        self.halt = Halt("end", "end of the recording") if is_over else Halt()

    def select(self, robot: int) -> None:
        """Select a robot; raise DebugError if there is no such robot."""
        if not 0 <= robot < len(self._recording.rosters[-1].robots):
            raise DebugError(f"no robot {robot}")
        self.robot = robot

    def status(self, *, is_playing: bool) -> dict[str, Any]:  # noqa: ARG002 - it is quick
        """Return the table of the robots."""
        now_ns = round(self.time_s * NS)
        names = self._recording.roster_at(now_ns).robots
        first = max(0, min(self.robot - MAX_ROBOTS // 2, len(names) - MAX_ROBOTS))
        rows = range(first, min(first + MAX_ROBOTS, len(names)))
        speeds = self._speeds_mps(now_ns)
        states = self._states(now_ns)
        kinds = {robot.id: robot.model.name for robot in self.world.robots}
        return {
            "t": self.time_s,
            "first": first,
            "robots": [
                {
                    "id": names[row],
                    "kind": kinds.get(names[row], ""),
                    "program": "",
                    "does": "",
                    "outcome": "running",
                    "speed": round(speeds[row], 4) if row < len(speeds) else 0.0,
                    "turn": 0.0,
                    "battery": None,
                    "present": True,
                    "collisions": 0,
                }
                for row in rows
            ],
            "sensors": {
                "believed": [],
                "echoes": [_echoes(states.get(row)) for row in rows],
                "bumpers": [int(states[row][_BUMPERS]) if row in states else 0 for row in rows],
            },
        }

    def _speeds_mps(self, now_ns: int) -> list[float]:
        """Return the recent speeds of the robots."""
        frames = list(self._recording.frames(max(0, now_ns - _SPEED_NS), now_ns))
        if len(frames) < 2 or frames[0].values.shape != frames[-1].values.shape:
            return []
        way_m = np.hypot(*(frames[-1].values[:2] - frames[0].values[:2]))
        speeds = way_m / max(1e-9, (now_ns / NS) - frames[0].time_s)
        return [float(each or 0.0) for each in rounded(np.nan_to_num(speeds))]

    def _states(self, now_ns: int) -> dict[int, Any]:
        """Return the last `State` of each robot that was asked for lately."""
        found: dict[int, Any] = {}
        begin_ns, end_ns = self._read_ns
        if not begin_ns <= now_ns <= end_ns:
            self._read_ns = now_ns, now_ns + _AHEAD_NS
            since_ns = max(0, now_ns - _BACK_NS)
            self._rows = list(self._recording.readings(since_ns, now_ns + _AHEAD_NS))
        for rows in self._rows:
            is_due = (rows.clock_s * NS > now_ns - _BACK_NS) & (rows.clock_s * NS <= now_ns)
            found |= zip(rows.robots[is_due].tolist(), rows.states[is_due], strict=True)
        return found


def _echoes(state: Any) -> list[float | None]:
    """Return the echoes [m] in a `State`, -1 without an echo."""
    if state is None:
        return []
    return [
        -1.0 if reading >= _NO_ECHO else round(inch_to_m(reading), 3)
        for reading in state[_SONARS].tolist()
    ]
