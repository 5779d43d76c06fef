"""Robots that join and leave while the world runs.

They join and leave between two cycles, before the first one that begins at or after the time given
by the world file (or the call of `Environment.add_robot` and `remove_robot`): robots leave first,
then others join, in the order of the world. A robot joins as it would start a run: switched on at
that time, at rest at its start, its odometry at 0, all sonars having fired just before. If its
place is occupied it waits, and tries again each cycle.

Before it joins and after it has left, a robot keeps only its row in all arrays: it has no body,
nothing sees or hears it, and its row does not change. Other robots' readings and motion never
depend on it, nor does noise: each robot's comes from streams of its own number.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, IndexArray
from crs_cc.core.quantity import ANGLE, HEAT
from crs_cc.core.time_grid import ROUNDING_S
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.files import object_ids
from crs_cc.sim.geometry.placement import TOLERANCE_M
from crs_cc.sim.physics.carrying import release

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import Pose, Robot, WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog
    from crs_cc.sim.state.presence import PresenceState


EDGE: Final = "the edge of the world"


class Timetable:
    """The times at which the robots of a world join and leave."""

    def __init__(self, world: WorldModel) -> None:
        self._robots = world.robots
        self._timestep_s = world.timestep_s
        self._join_s = np.array([robot.join_s for robot in world.robots])
        self._leave_s = np.array([robot.leave_s for robot in world.robots])

    def due_s(self, presence: PresenceState) -> float:
        """Return the time of the next join or leave, infinite for never."""
        join_s = self._join_s[_expected(presence)].min(initial=np.inf)
        return float(self._leave_s[np.isinf(presence.left_s)].min(initial=join_s))

    def has_pending_joins(self, presence: PresenceState, after_s: float) -> bool:
        """Return whether any robot is to join after a time."""
        return bool((self._join_s[_expected(presence)] > after_s + ROUNDING_S).any())

    def leave(self, state: EnvState, now_s: float, log: EventLog) -> IndexArray:
        """Remove the robots whose time to leave has come; return which."""
        over = (self._leave_s <= now_s + ROUNDING_S) & np.isinf(state.presence.left_s)
        rows = np.flatnonzero(over)
        leave(state, rows, now_s, log)
        return rows

    def join(
        self, state: EnvState, constants: RobotConstants, now_s: float, log: EventLog
    ) -> IndexArray:
        """Add the robots whose time to join has come and whose place is free; return which."""
        due = (self._join_s <= now_s + ROUNDING_S) & _expected(state.presence)
        joined = []
        for robot in np.flatnonzero(due).tolist():
            wanted = self._robots[robot]
            obj = obstructing_object(state, constants, wanted.start, wanted.model.radius_m)
            if not obj:
                join(state, constants, robot, now_s, log)
                joined.append(robot)
            elif now_s - self._join_s[robot] < self._timestep_s - ROUNDING_S:
                log.say(now_s, "join", f"had to wait: place occupied by {obj}", robot)
        return np.array(joined, dtype=np.intp)


def join(
    state: EnvState, constants: RobotConstants, robot: int, now_s: float, log: EventLog
) -> None:
    """Put a robot into the world; its devices are started later, with the world's new scene."""
    presence, here = state.presence, np.arange(len(state.presence.present)) == robot
    presence.present = presence.present | here
    presence.joined_s = np.where(here, now_s, presence.joined_s)
    state.drive.clock_s[robot] = now_s
    state.heat.left[robot] = constants.world.robots[robot].heat
    log.say(now_s, "join", "joined", robot)


def leave(state: EnvState, rows: IndexArray, now_s: float, log: EventLog) -> None:
    """Remove robots from the world: their motion stops and their waits never end."""
    presence, gone = state.presence, np.zeros(len(state.presence.present), dtype=np.bool_)
    gone[rows] = True
    presence.present = presence.present & ~gone
    presence.left_s = np.where(gone, now_s, presence.left_s)
    state.drive.stop(rows)
    state.bodies.stop(rows)
    bumper_state(state).pressed[rows] = 0
    state.heat.left[rows] = 0.0
    state.connected[rows] = False
    state.waits.end(rows)
    release(state, rows)
    for robot in rows.tolist():
        never = np.isinf(presence.joined_s[robot])
        log.say(now_s, "leave", "left without having joined" if never else "left", robot)


def obstructing_object(
    state: EnvState, constants: RobotConstants, place: Pose, radius_m: float, robot: int = -1
) -> str:
    """Return the name of the object that a robot would overlap at a position; empty for none.

    Args:
        state: has the poses of all objects.
        constants: the shapes of all objects.
        place: its pose there.
        radius_m: its radius.
        robot: its number, if it is elsewhere in this world already.
    """
    area, reach_m = constants.world.area, radius_m - TOLERANCE_M
    if not (
        area.x_min_m + reach_m <= place.x_m <= area.x_max_m - reach_m
        and area.y_min_m + reach_m <= place.y_m <= area.y_max_m - reach_m
    ):
        return EDGE
    objects, robots = constants.shapes, len(state.presence.present)
    there = np.ones(len(objects.margin_m), dtype=np.bool_)
    there[:robots] = state.presence.present
    there[robot if robot >= 0 else slice(0)] = False
    others = np.flatnonzero(there)
    x_m, y_m = np.full((2, len(others)), [[place.x_m], [place.y_m]])
    distance_m = objects.distance_m(objects.poses(state.bodies), others, x_m, y_m)
    near = others[distance_m < reach_m]
    return f"'{constants.scene.names[near[0]]}'" if len(near) else ""


def validation_error(robot: Robot, names: Sequence[str], now_s: float) -> str:
    """Return why a robot cannot be added to a world, overlaps aside; empty if it can.

    Args:
        robot: the robot.
        names: the names of all objects in the world.
        now_s: the time.
    """
    start = robot.start
    if wrong := object_ids.validation_error(robot.id):
        return f"its id: {wrong}"
    if robot.id in names:
        return "its id is in use"
    if not all(map(math.isfinite, (start.x_m, start.y_m, start.heading_rad, robot.join_s))):
        return "its start or join time is not finite"
    if abs(start.heading_rad) > ANGLE.limit:
        return "its heading is too large"
    if not (0.0 <= robot.heat <= HEAT.limit and robot.spread_m > 0.0):
        return f"its heat must be 0 to {HEAT.limit:g}, and its spread above 0"
    if not robot.leave_s > max(robot.join_s, now_s):
        return "it leaves before it joins"
    return ""


def _expected(presence: PresenceState) -> BoolArray:
    """Return which robots have not joined yet and still may."""
    return np.asarray(np.isinf(presence.joined_s) & np.isinf(presence.left_s))
