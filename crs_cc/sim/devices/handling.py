"""Grippers and arms together: their work at the end of a cycle, and their effect on the physics."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.sim.devices.mount import mount_rad

if TYPE_CHECKING:
    from crs_cc.sim.devices.arm import Arms
    from crs_cc.sim.devices.gripper import Grippers
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.bodies import Contacts, Pull
    from crs_cc.sim.state.env_state import EnvState


class Handling:
    """The grippers and arms of a world's robots."""

    def __init__(self, grippers: Grippers, arms: Arms) -> None:
        self.grippers, self.arms = grippers, arms

    def is_idle(self, state: EnvState) -> bool:
        """Return whether no hand acts, and there is no gripper, whose fingers might move."""
        return not (len(self.grippers) or self.arms.act(state))

    def pull(self, state: EnvState, constants: RobotConstants, pull: Pull, end_s: float) -> Pull:
        """Add the final poses of mounts and hands that hold something to the drives' action."""
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
        """Make grippers and hands grasp and release; return whether any did."""
        gripped = self.grippers.end_cycle(state, constants, contacts, end_s)
        return self.arms.end_cycle(state, constants, end_s) or gripped
