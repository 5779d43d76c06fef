"""Whether there is room for a thing where it is: nothing else reaches there."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.sim.physics.shapes import overlap

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.bodies import Bodies


def has_room(constants: RobotConstants, bodies: Bodies, thing: int) -> bool:
    """Tells whether a thing that is lifted could stand where it is.

    Args:
        constants: the constants of all things.
        bodies: where they are.
        thing: its number among those that can be pushed.
    """
    things, scene = constants.shapes, constants.scene
    poses, own = things.poses(bodies), scene.robots + thing
    lifted = bodies.holds.in_hands()[1] + scene.robots
    away_m = np.hypot(poses[:, 0] - poses[own, 0], poses[:, 1] - poses[own, 1])
    near = away_m <= things.reach_m + things.reach_m[own]
    near[lifted] = False
    near[: scene.robots] &= scene.present
    return not any(overlap(scene, bodies, own, other) for other in np.flatnonzero(near).tolist())
