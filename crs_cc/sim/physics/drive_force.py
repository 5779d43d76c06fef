"""Drive forces of robots: traction limits and brakes.

The force that accelerates a robot to the velocity of its wheels is limited by its motors and by
traction; the brakes of a stationary robot hold it with its full traction. Limp wheels resist
sideways motion, but hardly motion along them. A stationary robot in contact is held by a joint with
a limited force: a force alone would let it creep.
"""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Self

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.physics.carrying import Load
from crs_cc.sim.physics.inclines import Incline
from crs_cc.sim.state.bodies import Bodies, Pull

if TYPE_CHECKING:
    import pymunk

    from crs_cc.sim.physics.space import Space

_BORNE: Final = "borne_kg", "mass_kg", "_grip_n", "_drive_n", "_roll_n"
_SAME_N: Final = 1e-9  # smaller forces need no limit


@dataclass(frozen=True, slots=True)
class Drawn:
    """The drive forces of a cycle.

    Attributes:
        pull: the motion of the drives.
        wanted_mps: the target velocities, (robots, 2).
        limit_n: the maximum forces, (robots,).
        jointed: the robots held by joints.
        incline: the slope under them, None in a flat world.
    """

    pull: Pull
    wanted_mps: FloatArray
    limit_n: FloatArray
    jointed: IndexArray
    incline: Incline | None


class DriveForce:
    """The drives of all robots.

    Attributes:
        borne_kg: the mass that presses on each robot's wheels, (robots,).
        mass_kg: the mass that its drive moves, (robots,).
    """

    def __init__(self, world: WorldModel) -> None:
        drives = [robot.model.drive for robot in world.robots]
        self._own_kg = np.array([robot.model.mass_kg for robot in world.robots])
        self._own_grip_n = np.array([drive.grip_n for drive in drives])
        self._force_n = np.array([drive.force_n for drive in drives])
        self._roll_out_mps2 = np.array([drive.roll_out_mps2 for drive in drives])
        self.set_loads(None)

    def set_loads(self, load: Load | None) -> None:
        """Update the masses on the wheels for the robots' loads."""
        self.borne_kg = self._own_kg + (load.weight_kg if load else 0.0)
        self.mass_kg = self._own_kg + (load.mass_kg if load else 0.0)
        self._grip_n = self._own_grip_n * (self.borne_kg / self._own_kg)
        self._drive_n = np.minimum(self._force_n, self._grip_n)
        self._roll_n = self.borne_kg * self._roll_out_mps2

    def part(self, robots: IndexArray) -> Self:
        """Return the drives of some robots, which are the only ones in a space."""
        some = copy(self)
        for name in _BORNE:
            setattr(some, name, getattr(self, name)[robots])
        return some

    def begin(
        self,
        space: Space,
        bodies: Bodies,
        pull: Pull,
        wanted_mps: FloatArray,
        incline: Incline | None,
    ) -> Drawn:
        """Return the drive forces of a cycle, and hold stationary robots with joints.

        Args:
            space: receives the joints.
            bodies: the bodies.
            pull: the motion of the drives.
            wanted_mps: the velocities of the wheels, (robots, 2).
            incline: the slope under the bodies.
        """
        stands = (wanted_mps[:, 0] == 0.0) & (wanted_mps[:, 1] == 0.0)
        limit_n = np.where(stands | pull.limp, self._grip_n, self._drive_n)
        jointed = np.flatnonzero(bodies.touching & (stands | pull.limp))
        limit_n[jointed] = np.where(pull.limp[jointed], self._roll_n[jointed], 0.0)
        # Created again in each cycle: the robot's position and its traction on a slope change, and
        # a joint that is kept would start with the impulse of the cycle before.
        space.hold([self._joint(space, bodies, pull, robot) for robot in jointed.tolist()])
        if incline is not None:
            for robot, joint in zip(jointed.tolist(), space.joints, strict=True):
                joint.max_force *= float(incline.hold[robot])
            space.scale_friction(incline.grip[space.robots :])
            roll_n = self._roll_n * np.sqrt(incline.grip[: space.robots])
            limit_n = np.where(pull.limp, roll_n, limit_n)
            rolls = pull.limp & (incline.sloping | bodies.slipping)
            wanted_mps = np.where(rolls[:, None], 0.0, wanted_mps)
        return Drawn(pull, wanted_mps, limit_n, jointed, incline)

    def write(
        self, force_n: FloatArray, drawn: Drawn, velocity_mps: FloatArray, substep_s: float
    ) -> bool:
        """Write the forces of the next substep; return whether there are any.

        Args:
            force_n: receives the forces, (bodies, 2), if there are any.
            drawn: the drive forces of the cycle.
            velocity_mps: the current velocities, (robots, 2).
            substep_s: duration of the forces.
        """
        lag_mps = drawn.wanted_mps - velocity_mps
        if drawn.incline is not None:
            self._write_sloping(force_n, drawn, drawn.incline, lag_mps, substep_s)
            return True
        if not np.count_nonzero(lag_mps):
            return False
        robots, pull = len(self.mass_kg), drawn.pull
        lagging = np.flatnonzero((lag_mps[:, 0] != 0.0) | (lag_mps[:, 1] != 0.0))
        mass_kg = self.mass_kg.take(lagging)
        needs_n = lag_mps.take(lagging, axis=0) * (mass_kg / substep_s)[:, None]
        if pull.limp.any():
            needs_n -= self._limp_n(pull, lagging, needs_n)
        size_n = exact.hypot(needs_n[:, 0], needs_n[:, 1])
        share = np.minimum(1.0, drawn.limit_n.take(lagging) / np.maximum(size_n, _SAME_N))
        force_n[:robots] = 0.0
        force_n[lagging] = needs_n * share[:, None]
        return True

    def _write_sloping(
        self,
        force_n: FloatArray,
        drawn: Drawn,
        incline: Incline,
        lag_mps: FloatArray,
        substep_s: float,
    ) -> None:
        """Write the forces on sloping ground, including the pull of gravity; see `write`."""
        robots = len(self.mass_kg)
        needs_n = lag_mps * (self.mass_kg / substep_s)[:, None]
        across = np.zeros(robots, dtype=np.bool_)
        across[drawn.jointed] = True
        force_n[: len(incline.pull_n)] = incline.pull_n
        force_n[:robots] += incline.drawn_n(needs_n, drawn.limit_n, self._grip_n, across)

    def _joint(self, space: Space, bodies: Bodies, pull: Pull, robot: int) -> pymunk.Constraint:
        """Return the joint that holds a robot by traction; a limp one only sideways."""
        import pymunk  # only when something may touch

        joint: pymunk.Constraint
        body = space.bodies[robot]
        if not pull.limp[robot]:
            joint = pymunk.PivotJoint(space.floor, body, (0.0, 0.0), (0.0, 0.0))
        else:
            x, y = bodies.position_m[robot].tolist()
            cos, sin = exact.cos(pull.facing_rad[robot]), exact.sin(pull.facing_rad[robot])
            ends = (x - cos, y - sin), (x + cos, y + sin)
            joint = pymunk.GrooveJoint(space.floor, body, *ends, (0.0, 0.0))
        joint.max_force, joint.max_bias = float(self._grip_n[robot]), 0.0
        return joint

    def _limp_n(self, pull: Pull, lagging: IndexArray, needs_n: FloatArray) -> FloatArray:
        """Return the force that limp wheels do not transmit along them, because they roll."""
        facing_rad, roll_n = pull.facing_rad.take(lagging), self._roll_n.take(lagging)
        ahead = np.column_stack([exact.cos(facing_rad), exact.sin(facing_rad)])
        along_n = (needs_n * ahead).sum(axis=1)
        lacks_n = along_n - np.clip(along_n, -roll_n, roll_n)
        lacks_n = np.where(pull.limp.take(lagging), lacks_n, 0.0)
        return np.asarray(lacks_n[:, None] * ahead)
