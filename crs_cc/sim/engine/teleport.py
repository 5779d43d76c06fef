"""Moving robots and objects to another pose during a run.

They are at rest there. The commands of a robot's wheels continue, as its motors received no other
ones; what it holds stays behind; what it touches next is a new contact.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.engine.roster import EDGE, obstructing_object
from crs_cc.sim.geometry.overlap import overlap_m
from crs_cc.sim.geometry.placement import TOLERANCE_M
from crs_cc.sim.geometry.scene import corners_m
from crs_cc.sim.model.world import Cylinder, Pose, Robot, Wall
from crs_cc.sim.physics.carrying import release

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import Solid, WorldObject
    from crs_cc.sim.state.env_state import EnvState


def put_robot(
    state: EnvState,
    constants: RobotConstants,
    robot: int,
    place: Pose,
    *,
    base_rad: float,
    turret_rad: float,
) -> None:
    """Put a robot down at a free place, without a change of its odometry.

    Args:
        state: changed in place.
        constants: the constants of all objects.
        robot: its number.
        place: its position, and the direction of its wheels.
        base_rad: the direction of its base.
        turret_rad: the direction of its turret, ignored if it has none.
    """
    drive = state.drive
    state.bodies.position_m[robot] = place.x_m, place.y_m
    state.bodies.stop(np.array([robot], dtype=np.intp))
    release(state, np.array([robot], dtype=np.intp))
    drive.hindered[robot] = False
    drive.moved_m[robot] = 0.0
    drive.facing_rad[robot] = state.heading_rad[robot] = place.heading_rad
    drive.turret_rad[robot] = turret_rad
    state.base_rad[robot] = base_rad
    state.mount_rad[robot] = turret_rad if constants.drives.turret[robot] else base_rad
    _part(state, constants, robot)


def teleport_robot(state: EnvState, constants: RobotConstants, robot: int, place: Pose) -> str:
    """Move a robot to a pose, turned as a whole, if the place is free.

    Returns:
        the name of what it would overlap; empty if it was moved.
    """
    radius_m = float(constants.radius_m[robot])
    if obj := obstructing_object(state, constants, place, radius_m, robot):
        return obj
    turn_rad = place.heading_rad - float(state.heading_rad[robot])
    base_rad = float(state.base_rad[robot]) + turn_rad
    turret_rad = float(state.drive.turret_rad[robot]) + turn_rad
    put_robot(state, constants, robot, place, base_rad=base_rad, turret_rad=turret_rad)
    return ""


def teleport_object(state: EnvState, constants: RobotConstants, body: int, place: Pose) -> str:
    """Move a pushable object to a pose, if the place is free.

    Returns:
        the name of what it would overlap; empty if it was moved.
    """
    obj = constants.scene.pushables[body - constants.scene.robots]
    if wrong := _obstacle(state, constants, body, replace(obj, pose=place)):
        return wrong
    bodies = state.bodies
    bodies.position_m[body] = place.x_m, place.y_m
    bodies.angle_rad[body] = place.heading_rad
    bodies.velocity_mps[body] = bodies.spin_radps[body] = 0.0
    bodies.settled[0] = False
    _part(state, constants, body)
    return ""


def _part(state: EnvState, constants: RobotConstants, body: int) -> None:
    """Forget the contacts of a body at its former pose."""
    robot, obj = np.divmod(state.contacts_before, len(constants.scene.names))
    state.contacts_before = state.contacts_before[(robot != body) & (obj != body)]


def _obstacle(state: EnvState, constants: RobotConstants, body: int, wanted: WorldObject) -> str:
    """Return the name of what an object would overlap; empty for nothing."""
    objects, area, scene = constants.shapes, constants.world.area, constants.scene
    low, high = _extent_m(wanted)
    if (low < np.array([area.x_min_m, area.y_min_m]) - TOLERANCE_M).any():
        return EDGE
    if (high > np.array([area.x_max_m, area.y_max_m]) + TOLERANCE_M).any():
        return EDGE
    poses = objects.poses(state.bodies)
    others = np.flatnonzero(np.arange(len(poses)) != body)
    x_m, y_m = np.full((2, len(others)), [[wanted.pose.x_m], [wanted.pose.y_m]])
    near = others[objects.distance_m(poses, others, x_m, y_m) < objects.reach_m[body]]
    for number in near.tolist():
        if number < scene.robots and not state.presence.present[number]:
            continue
        other = _standing(scene.objects[number], poses[number])
        if overlap_m(wanted, other) > TOLERANCE_M:
            return f"'{scene.names[number]}'"
    return ""


def _standing(obj: Robot | Solid, pose: FloatArray) -> Solid:
    """Return an object at its pose; for a robot its cylinder."""
    if isinstance(obj, Wall):
        return obj
    place = Pose(*pose.tolist())
    if isinstance(obj, Robot):
        return Cylinder(obj.id, place, obj.model.radius_m)
    return replace(obj, pose=place)


def _extent_m(obj: WorldObject) -> FloatArray:
    """Return the lower left and the upper right corner of an object's bounding box, (2, 2)."""
    if isinstance(obj, Cylinder):
        middle = np.array([obj.pose.x_m, obj.pose.y_m])
        return np.array([middle - obj.radius_m, middle + obj.radius_m])
    corners = corners_m(obj)
    return np.array([corners.min(axis=0), corners.max(axis=0)])
