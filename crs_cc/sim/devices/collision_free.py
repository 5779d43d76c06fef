"""Test whether the space at an object's position is free."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.sim.kernels import exact

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.bodies import Bodies


def is_space_free(constants: RobotConstants, bodies: Bodies, obj: int) -> bool:
    """Return whether a lifted object can be put down where it is without a collision.

    Args:
        constants: the constants of all objects.
        bodies: their poses.
        obj: the object's number among the pushable ones.
    """
    from crs_cc.sim.physics.shapes import overlap  # loads pymunk

    objects, scene = constants.shapes, constants.scene
    poses, own = objects.poses(bodies), scene.robots + obj
    lifted = bodies.holds.in_hands()[1] + scene.robots
    away_m = exact.hypot(poses[:, 0] - poses[own, 0], poses[:, 1] - poses[own, 1])
    near = away_m <= objects.reach_m + objects.reach_m[own]
    near[lifted] = False
    near[: scene.robots] &= scene.present
    return not any(overlap(scene, bodies, own, other) for other in np.flatnonzero(near).tolist())
