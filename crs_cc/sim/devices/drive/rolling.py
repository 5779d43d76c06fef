"""Rolling: differences between the true motion of wheels and that assumed by odometry.

    true distance = sum of the axes' motions, each with its true weight (`drives`), + random part
    true turn     = the same with the weights of turning                            + random part

Systematic: the wheels of a differential drive differ (right over left diameter, the mean being what
it should be), their distance is not the nominal one, all wheels are larger or smaller than they
should be, a synchro drive turns a little with each metre. The first two are Ed and Eb of
J. Borenstein, L. Feng, "UMBmark: a method for measuring, comparing, and correcting dead-reckoning
errors in mobile robots", 1995.

Random: after the distance s and the turn t, the distance is off by a normal deviate of standard
deviation way_noise * sqrt(s), the direction by sqrt(turn_noise^2 * s + spin_noise^2 * t); s in
metres, t in full turns. Each timestep adds its own part, so both are random walks.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.sim.devices.drive.constants import weighted
from crs_cc.sim.kernels import exact
from crs_cc.sim.state.random_streams import ROLLING, Noise

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


_TURN: Final = 2 * math.pi


class RollingNoise:
    """Random errors of the motion of all robots of a world."""

    def __init__(self, world: WorldModel, seed: int) -> None:
        errors = [robot.model.odometry for robot in world.robots]
        noises = np.array([(e.way_noise_m, e.turn_noise_rad, e.spin_noise_rad) for e in errors])
        noises = noises.reshape(-1, 3)
        self._robots = np.flatnonzero(noises.any(axis=1))
        self._distance_noise_m, self._turn_rad, self._spin_rad = noises[self._robots].T
        self._noise = Noise(seed, ROLLING, 2, len(world.robots) if len(self._robots) else 0)

    @property
    def are_exact(self) -> bool:
        """Whether no robot has random errors."""
        return not len(self._robots)

    def add(self, state: EnvState, constants: RobotConstants) -> None:
        """Add a cycle's errors to the motion of robots whose axes were turned to its end."""
        robots = self._robots
        if not len(robots):
            return
        slice_ = state.drive.slice[robots]
        arc_m = np.abs(weighted(slice_, constants.drives.forward[robots]))
        turn_rad = np.abs(weighted(slice_, constants.drives.turn[robots]))
        along, turn = self._noise.rows(robots, np.full(len(robots), state.cycle)).T
        off_m = along * self._distance_noise_m * np.sqrt(arc_m)
        spin_rad = self._spin_rad * np.sqrt(turn_rad / _TURN)
        facing_rad = state.drive.facing_rad[robots]
        state.drive.moved_m[robots, 0] += off_m * exact.cos(facing_rad)
        state.drive.moved_m[robots, 1] += off_m * exact.sin(facing_rad)
        off_rad = turn * exact.hypot(self._turn_rad * np.sqrt(arc_m), spin_rad)
        state.drive.facing_rad[robots] = facing_rad + off_rad
