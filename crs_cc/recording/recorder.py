"""Records a run while it is running.

Data is collected, for many timesteps at once where the session reports a passage, and written every
second of simulated time, see `recording_file`.
"""

from __future__ import annotations

import json
import math
import zlib
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Literal

import numpy as np

from crs_cc.recording import topics
from crs_cc.recording.content import as_fields
from crs_cc.recording.digest import digest
from crs_cc.recording.field_sketches import ChangedFields
from crs_cc.recording.frame_buffer import FrameBuffer, Shape
from crs_cc.recording.hashes import DIGEST_BITS, STATE_DIGITS, Hash
from crs_cc.recording.mcap_records import Channel, ns
from crs_cc.recording.recording_file import RecordingFile
from crs_cc.recording.step_events import events_of, marks_of, readings_of, traffic_of
from crs_cc.sim.engine.step import Served

if TYPE_CHECKING:
    from crs_cc.core.arrays import BoolArray
    from crs_cc.recording.foxglove.messages import FoxgloveView
    from crs_cc.recording.foxglove.sensors import FoxgloveSensors
    from crs_cc.session.result import RunResult
    from crs_cc.session.session import Session
    from crs_cc.sim.engine.passage import Passage
    from crs_cc.sim.engine.step import Step
    from crs_cc.sim.state.env_state import EnvState

Sensors = Literal["none", "read", "all"]

FULL_HASH_SECONDS: Final = 120
"""The period of the hash of all state: it takes 0.7 s for 10,000 robots, and 0.5 ms for one."""

FIRST_FULL_HASH_SECONDS: Final = 90
"""The time of the first one: many runs last whole minutes, and there is one at the end."""


@dataclass(frozen=True, slots=True)
class RecorderOptions:
    """What is recorded.

    Attributes:
        every_s: simulated time between two frames, at least a timestep.
        sensors: `State` vectors: `none`, those that programs `read`, or `all`, with each frame.
        foxglove: whether messages by Foxglove's schemas are added.
        foxglove_robots: the robots whose laser scans and pictures are among them.
        for_debugger: whether hashes are compared with those of debug builds.
    """

    every_s: float = 0.05
    sensors: Sensors = "read"
    foxglove: bool = False
    foxglove_robots: tuple[str, ...] = ()
    for_debugger: bool = False


class Recorder:
    """Writes the recording of one session.

    Attributes:
        needs_each: whether it must sample every timestep with motion.
    """

    def __init__(
        self,
        path: Path,
        options: RecorderOptions,
        run: Mapping[str, str],
        attachments: Mapping[str, bytes],
    ) -> None:
        """Create the file.

        Args:
            path: the file, which is overwritten.
            options: what to record.
            run: what is run, see `crs_cc.recording.run_description`.
            attachments: all files that the run depends on, by name.

        Raises:
            OSError: it cannot be written.
        """
        self._options = options
        self._file = RecordingFile(path, run, attachments)
        self._fields = ChangedFields()
        self._output_crc = 0
        self._foxglove: FoxgloveView | None = None
        self._foxglove_sensors: FoxgloveSensors | None = None
        self._rosters = 0
        self.needs_each = bool(options.foxglove or options.foxglove_robots) or (
            options.sensors == "all"
        )
        self._moved = True  # since the last frame
        self._stride = 1

    @property
    def failed(self) -> OSError | None:
        """The error that ended the recording, if any."""
        return self._file.failed

    @property
    def written_s(self) -> float:
        """The time up to which the run has been written [s]."""
        return self._file.written_s

    def begin(self, session: Session) -> None:
        """Start with a session before its first timestep."""
        self._session = session
        self._state, self._environment = session.state, session.environment
        self._timestep_s = session.environment.timestep_s
        self._per_second = max(1, round(1.0 / self._timestep_s))
        self._stride = max(1, round(self._options.every_s / self._timestep_s))
        self._last = self._sampled = session.timesteps
        self._next_hash = session.timesteps + self._per_second
        self._alive = session.state.alive.tobytes()
        self._has_fields = bool(session.environment.world.fields)
        self._hides_state = session.fleet.has_marks and not self._options.for_debugger
        if self._options.foxglove:
            from crs_cc.recording.foxglove.messages import FoxgloveView

            self._foxglove = FoxgloveView(session.environment.world)
        if self._options.foxglove_robots:
            from crs_cc.recording.foxglove.sensors import FoxgloveSensors

            robots = session.environment.world.robots
            self._foxglove_sensors = FoxgloveSensors(robots, self._options.foxglove_robots)
        self._names: tuple[str, ...] = ()
        self._note_roster()
        self._add_frame()
        self._add_fields()
        self._add_hash()

    # -- what happens in a timestep --------------------------------------------------------------

    def step(self, step: Step) -> None:
        """Record what happened in a timestep."""
        if self.failed is not None:
            return
        timesteps = self._state.timesteps
        if not self._moved:
            self._last = timesteps - 1  # nothing moved before that
            self._moved = True
        if len(step.contacts.robot) or step.events:
            for event in events_of(step):
                self._add_json(topics.EVENT, ns(event.pop("time_s")), event)
        if len(step.traffic):
            self._add_json(topics.MESSAGE, ns(step.time_s), traffic_of(step.traffic, step.posted))
        for served in step.served:
            if served.states is None:
                self._note_served(step, served)
        if self._options.sensors != "none":
            self._file.block.readings.add(step.served)
            self._limit()
        self._note_frame(timesteps)

    def passed(self, passage: Passage) -> None:
        """Record a passage of timesteps in which robots only moved and received answers."""
        if self.failed is not None:
            return
        if self._options.sensors != "none":
            readings = self._file.block.readings
            readings.add(passage.earlier)
            readings.add_passage(passage.logged)
            self._limit()
        first, stride = passage.first + 1, self._stride
        last = passage.first + passage.count
        if self.needs_each:
            self._moved, self._last = True, passage.first
            self._note_frame(last)
            return
        begin = -first % stride
        count = len(range(begin, passage.count, stride))
        if count:
            moved = passage.moved if stride == 1 else passage.frames[begin::stride].tobytes()
            when = first + begin, stride, count
            self._file.block.frames.add_passage(
                when, self._timestep_s, moved, self._environment.last_state
            )
        self._moved, self._last = last % stride != 0, last

    def _note_frame(self, timesteps: int) -> None:
        """Record a frame after a timestep, if there was motion and one is due."""
        if self._environment.names is not self._names:
            self._note_roster()
        if self._moved and timesteps // self._stride != self._last // self._stride:
            self._add_frame()
        self._last = timesteps

    def _note_served(self, step: Step, served: Served) -> None:
        """Record the effects of requests that do not reply `State`."""
        for event in marks_of(served):
            self._add_json(topics.EVENT, ns(event.pop("time_s")), event)
        if served.replies is not None and self._options.sensors != "none":
            reading = readings_of(served)
            if reading is not None:
                self._add_json(topics.READING, ns(step.time_s), reading)

    def write(self, robot: int, stream: int, content: bytes) -> None:
        """Record a piece of a program's output."""
        if self.failed is not None:
            return
        self._output_crc = zlib.crc32(content, self._output_crc)
        time_ns = self._time_ns(robot)
        self._file.block.add_output(time_ns, robot, stream, content)
        self._limit()
        if self._foxglove is not None:
            from crs_cc.recording.foxglove.messages import LOG, log_message

            name = self._robot_ids[robot]
            self._file.add(LOG, time_ns, log_message(time_ns, name, stream, content))

    def read(self, robot: int, content: bytes) -> None:
        """Record a piece of a program's standard input."""
        data = {"kind": "stdin", "robot": robot, **as_fields(content)}
        self._add_json(topics.INPUT, self._time_ns(robot), data)

    def waiting(self, robot: int, clock_s: float, answer: tuple[int, float]) -> None:
        """Record the reply to a program about available input."""
        ready, wait_s = answer
        data = {"kind": "waiting", "robot": robot, "clock_s": clock_s, "ready": ready}
        self._add_json(topics.INPUT, ns(clock_s), {**data, "wait_s": wait_s})

    def change(self, data: Mapping[str, Any]) -> None:
        """Record a change that the user has just made, as plain data."""
        self._moved = True
        if self.failed is None:
            self._add_json(topics.INPUT, ns(self._session.time_s), data)

    def seconds_left(self) -> float:
        """Return the maximum simulated time until the next call of `sample` [s]."""
        timesteps = self._session.timesteps
        left = self._next_hash - timesteps
        if self._moved:
            left = min(left, self._stride - timesteps % self._stride)
        return max(1, left) * self._timestep_s

    def sample(self) -> None:
        """Record the state after one or more timesteps, of which only the last had motion."""
        timesteps = self._state.timesteps
        if self.failed is not None or timesteps == self._sampled:
            return
        self._sampled = timesteps
        self._note_frame(timesteps)
        if self._foxglove_sensors is not None:
            state = self._environment.last_state
            for channel, time_ns, data in self._foxglove_sensors.messages(state):
                self._file.add(channel, time_ns, data)
        if timesteps >= self._next_hash:
            self._end_second()
        else:
            self._limit()

    def finish(self, result: RunResult) -> None:
        """Record the end, with the results."""
        if self.failed is None:
            if self._moved:
                self._add_frame()
            self._add_fields()
            self._add_hash(result.state_hash)
            self._file.complete(self._session.time_s)
            self._file.metadata(topics.RESULT, _result_values(result))
            self._file.finish()
        self._file.close()

    # -- frames and seconds ----------------------------------------------------------------------

    def _end_second(self) -> None:
        session, per_second = self._session, self._per_second
        seconds = self._state.timesteps // per_second
        self._next_hash = (seconds + 1) * per_second
        is_full = seconds % FULL_HASH_SECONDS == FIRST_FULL_HASH_SECONDS
        if self._has_fields:
            self._add_fields()
        self._add_hash(session.state_hash() if is_full else "")
        self._file.end_second(session.time_s, per_second * self._timestep_s)

    def _limit(self) -> None:
        if self._file.is_large:
            self._file.flush_early(self._session.time_s)

    def _add_frame(self) -> None:
        state = self._environment.last_state
        time_s = state.cycle * self._timestep_s
        self._file.block.frames.add(time_s, state)
        self._moved = False
        if self._foxglove is not None:
            self._add_scene(self._foxglove, time_s, state)
        if self._options.sensors == "all":
            self._file.block.readings.add([self._all_readings()])

    def _add_scene(self, view: FoxgloveView, time_s: float, state: EnvState) -> None:
        """Add a frame for Foxglove."""
        alone = FrameBuffer(self._file.block.shape)
        alone.add(time_s, state)
        names, time_ns = (self._robot_ids, self._object_names), ns(time_s)
        channel, data = view.frame(time_ns, alone.frames().poses[0], *names)
        self._file.add(channel, time_ns, data)

    def _add_fields(self) -> None:
        """Record the pheromone fields that differ from their recorded prediction."""
        session = self._session
        for entry in self._fields.entries(session.environment):
            self._file.block.add_entry(topics.FIELD, ns(session.time_s), entry)

    def _all_readings(self) -> Served:
        """Return the current readings of all sensors of all robots, without a request."""
        environment = self._session.environment
        robots = np.flatnonzero(environment.last_state.presence.present)
        return Served(
            code=0,
            robots=robots,
            clock_s=np.full(len(robots), environment.time_s),
            arguments=np.zeros((len(robots), 0), np.int32),
            results=np.ones(len(robots), np.int32),
            states=environment.last_readings(robots),
        )

    def _add_hash(self, state_hash: str = "") -> None:
        if self._state.alive.tobytes() != self._alive:
            self._note_ends()
        session = self._session
        state = "" if self._hides_state else state_hash[:STATE_DIGITS]
        output = self._output_crc & DIGEST_BITS
        found = Hash(self._state.timesteps, digest(session), output, state)
        self._file.block.add_hash(ns(session.time_s), found)

    def _note_ends(self) -> None:
        """Record which programs have ended since the last time."""
        session = self._session
        alive = session.state.alive
        before: BoolArray = np.zeros(len(alive), np.bool_)
        before[: len(self._alive)] = np.frombuffer(self._alive, np.bool_)
        for robot in np.flatnonzero(before & ~alive).tolist():
            result = session.state.robot_result(robot)
            text = f"program {result.outcome}"
            if result.exit_status is not None:
                text += f" with {result.exit_status}"
            if result.error is not None:
                text = f"{result.error.location}: {result.error.text}"
            data = {"kind": result.outcome, "robot": robot, "text": text}
            self._add_json(topics.EVENT, ns(result.time_s), data)
        self._alive = alive.tobytes()

    def _note_roster(self) -> None:
        """Record the roster from now on; a key frame follows."""
        if self._rosters:
            self._file.complete(self._session.time_s)
        environment = self._session.environment
        self._names = environment.names
        robots = environment.world.robots
        has_turret = any("turret" in robot.model.drive.axis_names for robot in robots)
        self._robot_ids = [robot.id for robot in robots]
        self._object_names = list(environment.pushables)
        shape = Shape(len(robots), len(self._object_names), has_turret)
        self._file.begin_block(environment.time_s, shape)
        self._rosters += 1
        values = {
            "time_ns": str(ns(environment.time_s)),
            "robots": json.dumps(self._robot_ids),
            "objects": json.dumps(self._object_names),
            "columns": "x y heading turret" if has_turret else "x y heading",
        }
        self._file.metadata(f"{topics.ROSTER}{self._rosters}", values)

    # -- messages --------------------------------------------------------------------------------

    def _add_json(self, channel: Channel, time_ns: int, data: Mapping[str, Any]) -> None:
        self._file.block.add_entry(channel, time_ns, data)
        self._limit()

    def _time_ns(self, robot: int) -> int:
        clock_s: float = self._state.clock_s.item(robot)
        return ns(clock_s if math.isfinite(clock_s) else self._session.time_s)


def _result_values(result: RunResult) -> dict[str, str]:
    """Return the results as named strings."""
    ends = [[robot.outcome, robot.exit_status] for robot in result.robots]
    values = {
        "timesteps": str(result.timesteps),
        "simulated_s": repr(result.simulated_s),
        "state_hash": result.state_hash,
        "robots": json.dumps(ends),
    }
    if result.goals:
        values["goals"] = json.dumps([asdict(goal) for goal in result.goals])
    for name, places in (("sources", result.sources), ("nests", result.nests)):
        if places:
            values[name] = json.dumps([asdict(place) for place in places])
    return values
