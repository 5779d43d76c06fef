"""The plot of a recorded run."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.cli.load import load_world_of
from crs_cc.cli.rerun import extracted_run
from crs_cc.cli.run_options import RunOptions
from crs_cc.cli.run_plot import MARKED, MARKS, in_world_m, max_distance_m
from crs_cc.core.quantity import round_length
from crs_cc.plot.picture import Picture, RobotPath
from crs_cc.plot.tracks import Tracks
from crs_cc.recording import topics
from crs_cc.recording.marks import at_time, drawn_marks
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import Pose

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from crs_cc.core.arrays import FloatArray
    from crs_cc.recording.recording import Frame, Recording
    from crs_cc.sim.model.world import Robot, WorldModel, WorldObject


def world_of(recording: Recording) -> WorldModel:
    """Return the world of a recorded run; raise CrsError if it is not valid."""
    with extracted_run(recording, RunOptions) as options:
        return load_world_of(options)


def recorded_picture(recording: Recording) -> Picture:
    """Return the contents of the plot of a recorded run.

    Raises:
        CrsError: the recording, or the world in it, is not valid.
    """
    world, roster = world_of(recording), recording.rosters[-1]
    paths = _Paths(world, recording)
    for frame in recording.frames():
        paths.add(frame)
    contacts = _contacts(recording, len(roster.robots))
    last = paths.last
    if last is None:
        raise recording.mcap.error("no frames: there is nothing to draw")
    names = dict.fromkeys(Path(source).name for source in recording.description.sources)
    where = Path(recording.description.world).name or "an empty world"
    count = contacts.collisions
    subtitle = f"{last.time_s:.2f} s recorded, seed {recording.description.seed}, "
    subtitle += f"{count} collision{'' if count == 1 else 's'}"
    title = f"{', '.join(names) or 'programs'} in {where}"
    pushed = [
        obj
        for obj, is_moved in movables_at(world, roster.objects, last, len(roster.robots))
        if is_moved
    ]
    drawings = at_time(drawn_marks(recording), math.inf)
    return Picture(title, subtitle, world, paths.paths(), contacts.contacts, pushed, drawings)


def movables_at(
    world: WorldModel, objects: Sequence[str], frame: Frame, robots: int
) -> Iterator[tuple[WorldObject, bool]]:
    """Yield the movable objects at their poses in a frame, and whether they were moved.

    Args:
        world: the world.
        objects: their names, in the order of the frame.
        frame: the frame.
        robots: how many robots it has, before the objects.
    """
    scene = Scene(world)
    known = {obj.id: obj for obj in scene.pushables}
    for row, name in enumerate(objects, robots):
        obj = known.get(name)
        if obj is None or row >= frame.values.shape[1] or np.isnan(frame.values[0, row]):
            continue
        x_m, y_m, angle_rad = frame.values[:3, row].tolist()
        is_moved = math.hypot(x_m - obj.pose.x_m, y_m - obj.pose.y_m) > 0.005
        yield replace(obj, pose=Pose(x_m, y_m, angle_rad)), is_moved


class _Paths:
    """The robots' paths, frame by frame.

    Attributes:
        last: the last frame.
    """

    def __init__(self, world: WorldModel, recording: Recording) -> None:
        self.last: Frame | None = None
        self._world, self._recording = world, recording
        self._names = recording.rosters[-1].robots
        self._true = Tracks()
        self._rows: FloatArray = np.zeros((2, 0))
        starts = {robot.id: robot.start for robot in world.robots}
        self._starts = [starts.get(name, Pose(np.nan, np.nan, 0.0)) for name in self._names]
        self._odometry = recording.frames(topic=topics.ODOMETRY.topic)
        self._ahead = next(self._odometry, None)
        self._there, self._believed = Tracks(), Tracks()  # when odometry was recorded
        self._marks: list[list[tuple[float, float, str]]] = [[] for _ in self._names[:MARKED]]
        self._every_s = round_length(max(recording.end_ns / 1e9 / MARKS, 1e-3))
        self._next_mark = 1

    def add(self, frame: Frame) -> None:
        """Add where the robots are."""
        count = len(self._recording.roster_at(frame.time_ns).robots)
        rows = _padded(frame.values[:2, :count], len(self._names))
        self._true.add(*rows)
        while self._ahead is not None and self._ahead.time_ns < frame.time_ns:
            self._ahead = next(self._odometry, None)
        if self._ahead is not None and self._ahead.time_ns == frame.time_ns:
            own = _padded(self._ahead.values[:2], len(self._names))
            self._there.add(*rows)
            self._believed.add(*in_world_m(self._starts, *own))
        self._mark(frame.time_s, rows)
        self.last, self._rows = frame, rows

    def _mark(self, time_s: float, rows: FloatArray) -> None:
        """Record the positions of the first robots at round times, also between frames."""
        while time_s >= (at_s := self._next_mark * self._every_s) - 1e-9:
            there = rows if time_s < at_s + 1e-9 or not self._rows.size else self._rows
            for robot, marks in enumerate(self._marks):
                x_m, y_m = there[:, robot].tolist()
                if math.isfinite(x_m):
                    marks.append((x_m, y_m, f"{at_s:g} s"))
            self._next_mark += 1

    def paths(self) -> list[RobotPath]:
        """Return the paths."""
        assert self.last is not None
        values = self.last.values
        self._true.end(*self._rows)
        return [self._robot_path(row, values) for row in range(len(self._names))]

    def _robot_path(self, row: int, values: FloatArray) -> RobotPath:
        path, believed = self._true.path(row), self._believed.path(row)
        is_gone = row >= values.shape[1] or bool(np.isnan(values[0, row]))
        return RobotPath(
            self._robot(self._names[row], path),
            path,
            0.0 if is_gone else float(values[2, row]),
            left=is_gone,
            odometry=believed,
            odometry_error_m=max_distance_m(self._there.path(row), believed),
            marks=self._marks[row] if row < len(self._marks) else (),
        )

    def _robot(self, name: str, path: FloatArray) -> Robot:
        """Return a robot of the world, or one like its first for a robot that joined later."""
        for robot in self._world.robots:
            if robot.id == name:
                return robot
        x_m, y_m = path[0].tolist() if len(path) else (0.0, 0.0)
        return replace(self._world.robots[0], id=name, start=Pose(x_m, y_m, 0.0))


def _padded(rows: FloatArray, robots: int) -> FloatArray:
    """Return positions of a number of robots, NaN for those that are not there."""
    padded = np.full((2, robots), np.nan)
    padded[:, : rows.shape[1]] = rows[:, :robots]
    return padded


def _contacts(recording: Recording, robots: int) -> Tracks:
    """Return where robots touched something."""
    tracks = Tracks()
    for _, data in recording.data(topics.EVENT.topic):
        if data.get("kind") == "collision":
            with recording.errors():
                robot, x_m, y_m = int(data["robot"]), float(data["x_m"]), float(data["y_m"])
            tracks.collisions += 1
            if 0 <= robot < robots:
                tracks.add_contact(robot, x_m, y_m)
    return tracks
