"""Frames as they are collected during a run: raw bytes, without computation.

A single timestep is copied from the environment's state. For a passage of many timesteps, the
session passes the robots' poses in each; other objects have not moved. The new data of a second can
be saved as it is, and loaded again.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

from crs_cc.recording.columns import Columns
from crs_cc.recording.mcap_records import ENDLESS_S, NS
from crs_cc.sim.kernels.calm import FRAME

if TYPE_CHECKING:
    from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array
    from crs_cc.sim.state.env_state import EnvState

_TIME: Final = struct.Struct("<d")
_HEAD: Final = struct.Struct("<qqqd")


_When = tuple[int, int, int]


class Shape(NamedTuple):
    """The robots and objects in a frame.

    Attributes:
        robots: the number of robots.
        objects: the number of movable objects.
        has_turret: whether turrets are recorded.
    """

    robots: int
    objects: int
    has_turret: bool


class Frames(NamedTuple):
    """Frames by time.

    Attributes:
        times_ns: the times, (k,).
        poses: x, y [m], heading and turret [rad], NaN for absent robots, (k, columns, rows).
        odometry: x, y [m], heading [rad], (k, 3, robots).
    """

    times_ns: Int64Array
    poses: FloatArray
    odometry: FloatArray

    def of(self, rows: IndexArray | slice) -> Frames:
        """Return some of the frames."""
        return Frames(self.times_ns[rows], self.poses[rows], self.odometry[rows])


class FrameBuffer:
    """The frames of one set of bodies.

    Attributes:
        single: the frames that were copied from states.
        heads: a row for each settled passage.
        passed: a row for each frame of such a passage.
    """

    def __init__(self, shape: Shape) -> None:
        """Create an empty buffer."""
        self._shape = shape
        self._single, self._head = _single(shape), _head(shape)
        self.single = Columns(self._single.itemsize)
        self.heads = Columns(self._head.itemsize)
        self.passed = Columns(max(1, shape.robots * FRAME * 8))
        self._unsettled: list[tuple[_When, float, bytes, bytes]] = []
        self._passage_frames = 0

    def __len__(self) -> int:
        """Return the number of frames."""
        return len(self.single) + len(self.passed) + self._passage_frames

    def add(self, time_s: float, state: EnvState) -> None:
        """Copy a frame from a state."""
        bodies, odometry = state.bodies, state.odometry
        (column,) = self.single.content()
        column += _TIME.pack(time_s)
        column += bodies.position_m.tobytes()
        column += bodies.angle_rad.tobytes()
        column += state.heading_rad.tobytes()
        if self._shape.has_turret:
            column += state.drive.turret_rad.tobytes()
        column += odometry.x_m.tobytes()
        column += odometry.y_m.tobytes()
        column += odometry.heading_rad.tobytes()
        column += state.presence.present.tobytes()

    def add_passage(self, when: _When, timestep_s: float, poses: bytes, state: EnvState) -> None:
        """Copy frames of a passage.

        Args:
            when: the timestep of the first frame, the number of timesteps between frames, and the
                number of frames.
            timestep_s: the length of a timestep.
            poses: the robots' true poses and odometry in each frame, `FRAME` each.
            state: a state in the passage.
        """
        others = state.presence.present.tobytes()
        if self._shape.objects:
            bodies, robots = state.bodies, self._shape.robots
            position, angle = bodies.position_m[robots:], bodies.angle_rad[robots:]
            others = position.tobytes() + angle.tobytes() + others
        self._unsettled.append((when, timestep_s, others, poses))
        self._passage_frames += when[2]

    def settle(self) -> None:
        """Move the passages to `heads` and `passed`."""
        if self._unsettled:
            heads = [_HEAD.pack(*when, each_s) + rest for when, each_s, rest, _ in self._unsettled]
            self.heads.append(b"".join(heads))
            self.passed.append(b"".join([poses for *_, poses in self._unsettled]))
            self._unsettled, self._passage_frames = [], 0

    def frames(self) -> Frames:
        """Return all frames; raise ValueError if they are not valid."""
        self.settle()
        if not len(self.heads):
            return self._singles()
        if not len(self.single):
            return self._passages()
        both = zip(self._singles(), self._passages(), strict=True)
        frames = Frames(*(np.concatenate(columns) for columns in both))
        return frames.of(np.argsort(frames.times_ns, kind="stable"))

    def _singles(self) -> Frames:
        rows = np.frombuffer(self.single.content()[0], self._single)
        robots = self._shape.robots
        poses = self._empty_poses(len(rows))
        poses[:, :2] = rows["position_m"].swapaxes(1, 2)
        poses[:, 2] = rows["angle_rad"]
        poses[:, 2, :robots] = rows["heading_rad"]
        if self._shape.has_turret:
            poses[:, 3, :robots] = rows["turret_rad"]
        _mark_absent(poses, rows["present"])
        return Frames(_times_ns(rows["time_s"]), poses, rows["odometry"].copy())

    def _passages(self) -> Frames:
        robots = self._shape.robots
        heads = np.frombuffer(self.heads.content()[0], self._head)
        rows = np.frombuffer(self.passed.content()[0], "<f8").reshape(-1, robots, FRAME)
        counts = heads["count"]
        if (counts < 0).any() or (counts > len(rows)).any() or counts.sum() != len(rows):
            raise ValueError("inconsistent number of frames")
        passage = np.repeat(np.arange(len(heads)), counts)
        number = np.arange(len(rows)) - np.repeat(np.cumsum(counts) - counts, counts)
        after = heads["first"][passage] + number * heads["step"][passage]
        poses = self._empty_poses(len(rows))
        poses[:, :, :robots] = rows[:, :, : poses.shape[1]].swapaxes(1, 2)
        poses[:, :2, robots:] = heads["position_m"][passage].swapaxes(1, 2)
        poses[:, 2, robots:] = heads["angle_rad"][passage]
        _mark_absent(poses, heads["present"][passage])
        times_ns = _times_ns(after * heads["timestep_s"][passage])
        return Frames(times_ns, poses, np.ascontiguousarray(rows[:, :, 4:].swapaxes(1, 2)))

    def _empty_poses(self, count: int) -> FloatArray:
        columns = 4 if self._shape.has_turret else 3
        return np.zeros((count, columns, self._shape.robots + self._shape.objects))


def _single(shape: Shape) -> np.dtype[np.void]:
    """Return the layout of a frame that was copied from a state."""
    robots, bodies = shape.robots, shape.robots + shape.objects
    return np.dtype(
        [
            ("time_s", "<f8"),
            ("position_m", "<f8", (bodies, 2)),
            ("angle_rad", "<f8", (bodies,)),
            ("heading_rad", "<f8", (robots,)),
            ("turret_rad", "<f8", (robots if shape.has_turret else 0,)),
            ("odometry", "<f8", (3, robots)),
            ("present", "?", (robots,)),
        ]
    )


def _head(shape: Shape) -> np.dtype[np.void]:
    """Return the layout of the data that is stored once for a passage."""
    return np.dtype(
        [
            ("first", "<i8"),
            ("step", "<i8"),
            ("count", "<i8"),
            ("timestep_s", "<f8"),
            ("position_m", "<f8", (shape.objects, 2)),
            ("angle_rad", "<f8", (shape.objects,)),
            ("present", "?", (shape.robots,)),
        ]
    )


def _mark_absent(poses: FloatArray, present: BoolArray) -> None:
    """Make the poses of robots that are not in the world NaN."""
    if not present.all():
        poses.swapaxes(1, 2)[:, : present.shape[1]][~present] = np.nan


def _times_ns(times_s: FloatArray) -> Int64Array:
    """Return times in the unit of recordings, see `mcap_records.ns`; raise ValueError if wrong."""
    if not ((times_s >= 0.0) & (times_s < ENDLESS_S)).all():
        raise ValueError("the time of a frame is not valid")
    return np.rint(times_s * NS).astype(np.int64)
