"""Collection of what the plot of a run shows: paths, contacts, pushed objects."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Final, TypeAlias

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.core.quantity import round_length
from crs_cc.plot.picture import Picture, RobotPath
from crs_cc.plot.tracks import Tracks
from crs_cc.sim.engine.drawings import drawings_in
from crs_cc.sim.engine.sensor_overlay import sights
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import Pose, WorldModel, WorldObject

if TYPE_CHECKING:
    from crs_cc.cli.summary import Run
    from crs_cc.session.session import Session
    from crs_cc.sim.engine.passage import Passage
    from crs_cc.sim.engine.step import Step

_Points: TypeAlias = tuple[FloatArray, FloatArray]  # x and y

_MOVED_M: Final = 0.005
MARKED: Final = 3
"""Robots whose times are marked."""

MARKS: Final = 10
"""How many times are marked, about."""


class RunPlot:
    """The plot of a run, timestep by timestep."""

    def __init__(self) -> None:
        self._tracks = Tracks()
        self._believed = Tracks()
        self._next = 0  # timestep

    def add_contacts(self, step: Step, robots: int) -> None:
        """Add the contacts that began in a timestep of a world with a number of robots."""
        contacts = step.contacts
        for robot, x_m, y_m in zip(contacts.robot, contacts.x_m, contacts.y_m, strict=True):
            self._tracks.add_contact(int(robot), float(x_m), float(y_m))
        # A contact of two robots is listed for each of them.
        once = (contacts.other >= robots) | (contacts.robot < contacts.other)
        self._tracks.collisions += int(once.sum())

    def sample(self, session: Session) -> None:
        """Add the current positions, and that nothing has moved in timesteps that were left out."""
        if session.timesteps >= self._next:
            self._add(session.timesteps, _positions_m(session), _believed_m(session))

    def add_passage(self, session: Session, passage: Passage) -> None:
        """Add the positions of a passage of timesteps."""
        state, robots = session.environment.state, session.environment.world.robots
        frames = np.where(state.presence.present[:, None], passage.frames, np.nan)
        x_m, y_m, _, _, own_x_m, own_y_m, _ = np.moveaxis(frames, 2, 0)
        believed_m = in_world_m([robot.start for robot in robots], own_x_m, own_y_m)
        rows = zip(x_m, y_m, *believed_m, strict=True)
        for timestep, (*true, own_x, own_y) in enumerate(rows, passage.first + 1):
            self._add(timestep, tuple(true), (own_x, own_y))

    def _add(self, timestep: int, true_m: _Points, believed_m: _Points) -> None:
        for tracks, points in ((self._tracks, true_m), (self._believed, believed_m)):
            tracks.repeat_last(timestep - self._next)
            tracks.add(*points)
        self._next = timestep + 1

    def picture(
        self, session: Session, run: Run, programs: Sequence[str], *, sensors: bool
    ) -> bytes:
        """Return the plot of the finished run as SVG."""
        state, world = session.environment.state, session.environment.world_now
        self._tracks.end(*_positions_m(session))
        self._believed.end(*_believed_m(session))
        gone = np.isfinite(state.presence.left_s)
        pairs = [(self._tracks.path(n), self._believed.path(n)) for n in range(len(world.robots))]
        paths = [
            RobotPath(
                robot,
                pairs[n][0],
                float(state.heading_rad[n]),
                left=bool(gone[n]),
                odometry=pairs[n][1],
                odometry_error_m=max_distance_m(*pairs[n]),
                marks=time_marks(self._tracks, n, session.timesteps, world.timestep_s),
            )
            for n, robot in enumerate(world.robots)
        ]
        where = Path(run.world).name if run.world else "an empty world"
        title = f"{', '.join(dict.fromkeys(programs))} in {where}"
        collisions = self._tracks.collisions
        subtitle = f"{run.result.simulated_s:.2f} s simulated, seed {run.seed}, "
        subtitle += f"{collisions} collision{'' if collisions == 1 else 's'}"
        return Picture(
            title,
            subtitle,
            world,
            paths,
            self._tracks.contacts,
            _pushed(session, world),
            drawings_in(state.drawings),
            sights(state, world, session.time_s) if sensors else [],
        ).render()


def time_marks(
    tracks: Tracks, robot: int, timesteps: int, timestep_s: float
) -> list[tuple[float, float, str]]:
    """Return where one of the first robots was at round times, about ten of them."""
    if robot >= MARKED or timesteps < MARKS:
        return []
    every = max(1, round(round_length(timesteps * timestep_s / MARKS) / timestep_s))
    places = tracks.places_at(robot, every)
    return [(x_m, y_m, f"{at * timestep_s:g} s") for at, x_m, y_m in places]


def _believed_m(session: Session) -> _Points:
    """Return x and y by odometry [m] in the world frame, NaN as for `_positions_m`."""
    state, robots = session.environment.state, session.environment.world.robots
    own, present = state.odometry, state.presence.present
    x_m, y_m = in_world_m([robot.start for robot in robots], own.x_m, own.y_m)
    return np.where(present, x_m, np.nan), np.where(present, y_m, np.nan)


def in_world_m(
    starts: Sequence[Pose], own_x_m: FloatArray, own_y_m: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return where robots are by their odometry, in the world frame.

    Args:
        starts: where each had the odometry 0, 0.
        own_x_m: x by its odometry.
        own_y_m: y by its odometry.
    """
    turn_rad = np.array([start.heading_rad for start in starts])
    cos, sin = np.cos(turn_rad), np.sin(turn_rad)
    x_m = np.array([start.x_m for start in starts]) + own_x_m * cos - own_y_m * sin
    y_m = np.array([start.y_m for start in starts]) + own_x_m * sin + own_y_m * cos
    return x_m, y_m


def max_distance_m(path: FloatArray, believed: FloatArray) -> float:
    """Return the greatest distance between two paths of the same instants, along an axis."""
    if len(path) != len(believed) or not len(path):
        return 0.0
    return float(np.abs(believed - path).max())


def _positions_m(session: Session) -> _Points:
    """Return x and y of all robots [m], NaN for those that are not in the world."""
    state = session.environment.state
    present = state.presence.present
    return np.where(present, state.x_m, np.nan), np.where(present, state.y_m, np.nan)


def _pushed(session: Session, world: WorldModel) -> list[WorldObject]:
    """Return the objects that were pushed, at their current poses."""
    bodies, scene, pushed = session.environment.state.bodies, Scene(world), []
    for body, obj in enumerate(scene.pushables, scene.robots):
        (x_m, y_m), angle_rad = bodies.position_m[body], bodies.angle_rad[body]
        if math.hypot(x_m - obj.pose.x_m, y_m - obj.pose.y_m) > _MOVED_M:
            pushed.append(replace(obj, pose=Pose(float(x_m), float(y_m), float(angle_rad))))
    return pushed
