"""All that robots handle things with: what it does at the end of a cycle, and to the physics."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.sim.devices.arm import Arms
from crs_cc.sim.devices.gripper import Grippers
from crs_cc.sim.devices.mount import mount_rad

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.bodies import Contacts, Pull
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


class Handling:
    """What the robots of a world handle things with.

    Attributes:
        grippers: their grippers.
        arms: their arms.
    """

    def __init__(self, world: WorldModel, log: EventLog) -> None:
        self.grippers = Grippers(world, log)
        self.arms = Arms(world, log)

    def pull(self, state: EnvState, constants: RobotConstants, pull: Pull, end_s: float) -> Pull:
        """Adds to what drives do in a cycle where mounts and hands get that hold something."""
        if not state.bodies.holds.any():
            return pull
        rows = np.arange(len(state.heading_rad))
        facing_rad, turret_rad = state.drive.facing_rad, state.drive.turret_rad
        mounts_rad = mount_rad(state, constants, rows, facing_rad, turret_rad)
        lifts = len(state.bodies.holds.in_hands()[0]) > 0
        hand = self.arms.poses(state, end_s) if lifts else None
        return replace(pull, mount_rad=mounts_rad, hand=hand)

    def end_cycle(
        self, state: EnvState, constants: RobotConstants, contacts: Contacts, end_s: float
    ) -> bool:
        """Lets grippers and hands take hold and let go; tells whether any did."""
        gripped = self.grippers.end_cycle(state, constants, contacts, end_s)
        return self.arms.end_cycle(state, constants, end_s) or gripped
