"""The plot of a recorded run."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.cli.load import load_world_of
from crs_cc.cli.rerun import unpacked
from crs_cc.cli.run_options import RunOptions
from crs_cc.plot.picture import Picture, Trip
from crs_cc.plot.tracks import Tracks
from crs_cc.recording import topics
from crs_cc.sim.model.world import Pose

if TYPE_CHECKING:
    from crs_cc.recording.recording import Frame, Recording
    from crs_cc.sim.model.world import Robot, WorldModel


def world_of(recording: Recording) -> WorldModel:
    """Return the world of a recorded run; raise CrsError if it is not valid."""
    with unpacked(recording, RunOptions) as options:
        return load_world_of(options)


def recording_plot(recording: Recording) -> bytes:
    """Return the plot of a recorded run as SVG.

    Raises:
        CrsError: the recording, or the world in it, is not valid.
    """
    world, roster = world_of(recording), recording.rosters[-1]
    robots, tracks = len(roster.robots), Tracks()
    first: Frame | None = None
    last: Frame | None = None
    for frame in recording.frames():
        rows = np.full((2, robots), np.nan)
        shown = min(robots, len(recording.roster_at(frame.time_ns).robots), frame.values.shape[1])
        rows[:, :shown] = frame.values[:2, :shown]
        tracks.add(*rows)
        tracks_end = rows
        first, last = first or frame, frame
    for _, data in recording.data(topics.EVENT.topic):
        if data.get("kind") == "collision":
            with recording.errors():
                robot, x_m, y_m = int(data["robot"]), float(data["x_m"]), float(data["y_m"])
            tracks.collisions += 1
            if 0 <= robot < robots:
                tracks.add_contact(robot, x_m, y_m)
    if first is None or last is None:
        raise recording.mcap.error("no frames: there is nothing to draw")
    tracks.end(*tracks_end)
    trips = [
        Trip(
            _robot(world, roster.robots[row], tracks, row),
            tracks.path(row),
            float(np.nan_to_num(last.values[2, row])) if row < last.values.shape[1] else 0.0,
            left=row >= last.values.shape[1] or bool(np.isnan(last.values[0, row])),
        )
        for row in range(robots)
    ]
    names = dict.fromkeys(Path(source).name for source in recording.description.sources)
    where = Path(recording.description.world).name or "an empty world"
    count = tracks.collisions
    subtitle = f"{last.time_s:.2f} s recorded, seed {recording.description.seed}, "
    subtitle += f"{count} collision{'' if count == 1 else 's'}"
    title = f"{', '.join(names) or 'programs'} in {where}"
    return Picture(title, subtitle, world, trips, tracks.contacts).render()


def _robot(world: WorldModel, name: str, tracks: Tracks, row: int) -> Robot:
    """Return a robot of the world, or one like its first for a robot that joined later."""
    for robot in world.robots:
        if robot.id == name:
            return robot
    path = tracks.path(row)
    x_m, y_m = path[0].tolist() if len(path) else (0.0, 0.0)
    return replace(world.robots[0], id=name, start=Pose(x_m, y_m, 0.0))
