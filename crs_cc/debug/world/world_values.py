"""The values of the world that expressions can use: `$world.robot0.x`, `$world.distance(a, b)`.

Positions are those at the start of the timestep, as everything in the environment. Each value is
one row here; `docs/debugger.md` has them as a table.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

import numpy as np

from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError
from crs_cc.ir.types import DOUBLE, INT, CType
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.model.world import Robot, Wall
from crs_cc.sim.state.messages import ARRIVED, IN_TRANSIT

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment

Frame = Literal["", "world", "odometry"]
"""The frame of reference: of the world file, or where the robot's odometry was zero last."""


@dataclass(frozen=True, slots=True)
class WorldValue:
    """A value of the world.

    Attributes:
        name: its name in expressions.
        unit: its unit; empty for a count or a flag.
        frame: the frame of reference of a position or direction.
        meaning: what it is, in a few words.
        read: returns it, in its unit, given the number of the object.
        type: its C type.
    """

    name: str
    unit: str
    frame: Frame
    meaning: str
    read: Callable[[Environment, int], float]
    type: CType = DOUBLE


def _degrees(angle_rad: float) -> float:
    """Return a direction from 0 to 360 degrees."""
    return math.degrees(angle_rad) % 360.0


def _in_transit(environment: Environment) -> int:
    """Return the number of messages in flight, counted once per receiver."""
    return int((environment.state.messages.receptions["status"] == IN_TRANSIT).sum())


def _receptions(environment: Environment, robot: int, status: int) -> int:
    """Return the number of messages to a robot with a status."""
    found = environment.state.messages.receptions
    return int(((found["receiver"] == robot) & (found["status"] == status)).sum())


def _nearest_m(environment: Environment, robot: int) -> float:
    """Return the last echo that was the nearest [m]; infinite for none."""
    echo_m = sonar_state(environment.state).echo_m[robot]
    return float(np.nanmin(echo_m, initial=math.inf))


def _touching(environment: Environment, robot: int) -> int:
    """Return the number of objects that a robot touched in the previous timestep."""
    touching = environment.state.contacts_before // len(environment.names) == robot
    return int(touching.sum())


WORLD_VALUES: Final[tuple[WorldValue, ...]] = (
    WorldValue("time", "s", "", "the start of the current timestep", lambda env, _: env.time_s),
    WorldValue("timestep", "", "", "the number of the current timestep",
               lambda env, _: env.state.cycle, INT),
    WorldValue("messages", "", "", "messages in flight, counted once per receiver",
               lambda env, _: _in_transit(env), INT),
    WorldValue("queued", "", "", "messages waiting for their channel",
               lambda env, _: len(env.state.messages.outbox), INT),
)  # fmt: skip
"""The values `$world.NAME`."""

OBJECT_VALUES: Final[tuple[WorldValue, ...]] = (
    WorldValue("x", "m", "world", "the true position", lambda env, at: _place_m(env, at)[0]),
    WorldValue("y", "m", "world", "the true position", lambda env, at: _place_m(env, at)[1]),
    WorldValue("heat", "", "", "heat, in the unit of the world file",
               lambda env, at: env.state.heat.left[at]),
)  # fmt: skip
"""The values `$world.OBJECT.NAME` of robots and all other objects, by their number."""

ROBOT_VALUES: Final[tuple[WorldValue, ...]] = (
    *OBJECT_VALUES,
    WorldValue("heading", "deg", "world", "the true direction, 0 to 360",
               lambda env, at: _degrees(env.state.heading_rad[at])),
    WorldValue("odometry_x", "m", "odometry", "the position according to odometry",
               lambda env, at: env.state.odometry.x_m[at]),
    WorldValue("odometry_y", "m", "odometry", "the position according to odometry",
               lambda env, at: env.state.odometry.y_m[at]),
    WorldValue("odometry_heading", "deg", "odometry", "the direction according to odometry",
               lambda env, at: _degrees(env.state.odometry.heading_rad[at])),
    WorldValue("speed", "m/s", "", "the true speed",
               lambda env, at: math.hypot(*env.state.bodies.velocity_mps[at].tolist())),
    WorldValue("distance", "m", "", "the true distance driven so far",
               lambda env, at: env.state.distance_m[at]),
    WorldValue("stalled", "", "", "1 if its motors cannot turn its wheels, else 0",
               lambda env, at: env.state.drive.stalled_s[at] > 0.0, INT),
    WorldValue("touching", "", "", "the number of objects touched in the last timestep",
               _touching, INT),
    WorldValue("collisions", "", "", "collisions so far",
               lambda env, at: env.state.collisions[at], INT),
    WorldValue("bumpers", "", "", "the pressed bumpers, as a bit mask, as in State[33]",
               lambda env, at: bumper_state(env.state).pressed[at], INT),
    WorldValue("nearest", "m", "",
               "the shortest distance among the latest sonar echoes; inf if there are none",
               _nearest_m),
    WorldValue("computer_battery", "%", "", "the charge of the computer's battery",
               lambda env, at: 100.0 * env.charges(at)[0]),
    WorldValue("motor_battery", "%", "", "the charge of the motors' battery",
               lambda env, at: 100.0 * env.charges(at)[1]),
    WorldValue("sent", "", "", "messages sent so far",
               lambda env, at: env.state.messages.sent[at], INT),
    WorldValue("messages", "", "", "messages in flight to it",
               lambda env, at: _receptions(env, at, IN_TRANSIT), INT),
    WorldValue("inbox", "", "", "messages that have arrived and are unread",
               lambda env, at: _receptions(env, at, ARRIVED), INT),
    WorldValue("present", "", "", "1 while the robot is in the world, else 0",
               lambda env, at: env.state.presence.present[at], INT),
)  # fmt: skip
"""The values `$world.ROBOT.NAME`, by the robot's number."""


def values_of(environment: Environment, number: int) -> tuple[WorldValue, ...]:
    """Return the values of an object, by its number among `Environment.names`."""
    return ROBOT_VALUES if number < len(environment.world.robots) else OBJECT_VALUES


def object_number(environment: Environment, name: str) -> int:
    """Return the number of an object; raise DebugError if it does not exist."""
    names = environment.names[: len(environment.objects)]  # the ground has no position
    if name not in names:
        raise DebugError(unknown("robot or object", name, names))
    return names.index(name)


def distance_m(environment: Environment, one: str, other: str) -> float:
    """Return the true distance of the centres of two objects [m]."""
    places = [_place_m(environment, object_number(environment, each)) for each in (one, other)]
    return math.dist(*places)


def _place_m(environment: Environment, number: int) -> tuple[float, float]:
    """Return the position of an object [m]: the middle of one that never moves."""
    positions_m = environment.state.bodies.position_m
    if number < len(positions_m):
        x_m, y_m = positions_m[number].tolist()
        return x_m, y_m
    obj = environment.objects[number]
    if isinstance(obj, Wall):
        return (obj.x1_m + obj.x2_m) / 2.0, (obj.y1_m + obj.y2_m) / 2.0
    pose = obj.start if isinstance(obj, Robot) else obj.pose
    return pose.x_m, pose.y_m
