"""Firings that a kernel executes in one call, see `kernels/sonars.c`.

It knows all that echoes depend on if there are few shapes, all hard and high, if no sonar takes
another one's ping for its own this time, and if neither wheels nor sonars are degraded. All other
firings are left to `SonarRing`, which has the same echoes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.kernels.tables import ADVANCED, SENSOR_DUE
from crs_cc.sim.state.rows import simplest

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.devices.sonar.beams import Beams
    from crs_cc.sim.devices.sonar.errors import SonarErrors
    from crs_cc.sim.state.env_state import EnvState

_MAX_NUMBERS: Final = 10_000  # of beams that are copied for each call of the kernel


class KernelTables(NamedTuple):
    """The input of the calm-time kernel for sonars, see `kernels/calm.c`.

    Attributes:
        beams: the beams of each mode.
        modes: the first mode of each robot, (robots,).
        mistakes: by mode, the deviate below which a ping is mistaken for an echo.
        are_random: whether firings have random errors.
    """

    beams: FloatArray
    modes: FloatArray
    mistakes: FloatArray
    are_random: bool


class SimpleFirings:
    """What the kernel needs to know of all robots' sonars."""

    def __init__(self, beams: Beams, errors: SonarErrors) -> None:
        """Make the tables of the kernel.

        Args:
            beams: the beams of the sonars.
            errors: their errors.
        """
        table = beams.table(errors.limits)
        self._errors, self._beams, self._numbers = errors, table.tobytes(), table.size
        self._table = table
        self._modes = beams.first.astype(np.float64)
        self._are_few = table.size <= _MAX_NUMBERS

    def know(self, rays: RayCaster) -> bool:
        """Return whether all shapes are hard and high, and beams few."""
        return self._are_few and rays.all_alike and rays.surfaces.echo_range is None

    def tables(self) -> KernelTables:
        """Return the data for the kernel of calm time."""
        mistakes, are_random = self._errors.mistakes, self._errors.are_random
        return KernelTables(self._table, self._modes, mistakes, are_random)

    def advance(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        to_s: FloatArray,
    ) -> bool:
        """Fire and read the sonars of robots up to a time, if the kernel can.

        Args:
            state: changed in place; wheels are turned on to the last firing.
            constants: the robots' constants.
            rays: has the shapes.
            rows: the robots, k of them.
            to_s: the time of each, (k,).

        Returns:
            whether all is done; if not, some may have fired.
        """
        if not self.know(rays):
            return False
        if constants.degradations.affects(state, "sonar"):
            return False
        shapes = rays.few_shapes(state, len(rows))
        if shapes is None or not drive.moves_as_commanded(state, constants):
            return False
        segments, circles, _ = shapes.counts
        sizes, modes = (self._numbers, segments, circles), self._modes[rows].tobytes()
        content, some = self._beams + shapes.content, simplest(rows, len(self._modes))
        sonar = sonar_state(state)
        while True:
            deviates = self._errors.draw(rows, sonar.count[rows])
            if len(self._errors.affected_by_crosstalk(rows, sonar.mode[rows], deviates)):
                return False
            numbers = modes + deviates.tobytes() + content
            found = state.rows.fire(some, to_s, numbers, sizes, constants.kinds)
            if found != SENSOR_DUE:
                return found == ADVANCED
