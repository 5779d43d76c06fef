"""All devices with random numbers, timers or constants of their own, of all robots.

A new device is created here; its requests are added to `handlers.handlers_of`, and one that can
have a timer to the timers.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, any_of
from crs_cc.sim.comms.messenger import Messenger
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.bumper import Bumpers
from crs_cc.sim.devices.fields import Fields
from crs_cc.sim.devices.foraging import Foraging
from crs_cc.sim.devices.gland import Glands
from crs_cc.sim.devices.handling import Handling
from crs_cc.sim.devices.installed import Installed, Timed
from crs_cc.sim.devices.sensor_board import SensorBoard
from crs_cc.sim.devices.sonar import SonarRing
from crs_cc.sim.devices.timers import Timers
from crs_cc.sim.model.registry import devices

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.geometry.rays import Fan
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


_REGISTERED: Final = devices()
"""Loaded with the engine, so that `REQUESTS` is complete wherever the engine is."""


class DeviceBoard:
    """The devices of all robots of a world.

    Attributes:
        sensor_board: the devices read by the vendor's sensor board.
        foraging: the sources and nests.
        handling: the grippers and arms.
        messenger: the communication between robots.
        fields: the pheromone fields.
        installed: the devices of the registry, by their names.
        timers: the timers of all sensors that can have one.
    """

    def __init__(self, world: WorldModel, seed: int, log: EventLog) -> None:
        """Create the devices."""
        self.log = log
        self.messenger = Messenger(world, seed)
        self.fields = Fields(world)
        self.installed: dict[str, Installed] = {
            row.name: row.install(row, world, seed, log) for row in _REGISTERED
        }
        self.sonars: SonarRing = self.installed["sonar"].device
        self.bumpers: Bumpers = self.installed["bumper"].device
        self.sensor_board = SensorBoard(world, self.installed)
        self._glands: Glands = self.installed["gland"].device
        self.foraging: Foraging = self.installed["carrier"].device.foraging
        self.handling = Handling(self.installed["gripper"].device, self.installed["arm"].device)
        self.timers = Timers(self._timed())

    def _timed(self) -> dict[int, tuple[str, Timed]]:
        """Return the sensors that can have a timer, by their numbers in `crs.h`."""
        found = {row: self.installed[row.name].timed for row in _REGISTERED}
        return {
            row.number: (row.name, timed)
            for row, timed in found.items()
            if row.number is not None and timed is not None
        }

    @property
    def fans(self) -> list[Fan]:
        """Return the beams of the devices that measure distances."""
        return [fan for each in self.installed.values() for fan in each.fans]

    @property
    def has_duties(self) -> bool:
        """Whether devices may have something to do at the end of a cycle in which none acts."""
        return bool(self.fields.names or self._glands.any_installed or len(self.handling.grippers))

    def begin(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        now_s: float,
    ) -> None:
        """Start the devices of some robots, between two cycles: timers start now.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: casts rays.
            rows: robots that are present from the start, or that join.
            now_s: the start of the current cycle.
        """
        self.sonars.begin(state, constants, rays, rows, now_s)
        state.timers.begin(rows, now_s)

    def advance(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        to_s: FloatArray,
    ) -> None:
        """Advance the devices with timers to a time in the current cycle.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: casts rays.
            rows: the robots, k of them.
            to_s: the time for each, (k,); the cycle's end belongs to the next cycle, when the
                bodies have moved.
        """
        to_s = np.minimum(to_s, constants.last_time_s(state.cycle))
        while True:
            due = state.timers.soonest_s[rows] <= to_s
            if not any_of(due):
                break
            firing = rows[due]
            at_s = state.timers.soonest_s[firing]
            self.sonars.advance(state, constants, rays, firing, at_s)
            drive.advance(state, constants, firing, np.maximum(at_s, state.drive.clock_s[firing]))
            self.timers.fire(state, constants, rays, firing)
        self.sonars.advance(state, constants, rays, rows, to_s)

    def end_cycle(
        self, state: EnvState, constants: RobotConstants, from_s: float, to_s: float
    ) -> None:
        """Do the devices' work at the end of a cycle.

        Args:
            state: changed in place; the bodies have moved.
            constants: the objects of the world.
            from_s: start of the cycle.
            to_s: its end.
        """
        self.messenger.end_cycle(state, constants, self.log, from_s=from_s, to_s=to_s)
        self._glands.end_cycle(state, constants, constants.last_time_s(state.cycle))
        self.fields.end_cycle(state)
