"""All devices with random numbers, timers or constants of their own, of all robots.

A new device is created here; its requests are added to `handlers.handlers_of`, and one that can
have a timer to the timers.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.sim.comms.messenger import Messenger
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.bumper import Bumpers
from crs_cc.sim.devices.camera import Cameras
from crs_cc.sim.devices.handling import Handling
from crs_cc.sim.devices.installed import Installed, Timed
from crs_cc.sim.devices.sensor_board import SensorBoard
from crs_cc.sim.devices.sonar import SonarRing
from crs_cc.sim.devices.timers import Timers
from crs_cc.sim.model.registry import devices
from crs_cc.sim.state.timers import CAMERA, LASER

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
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
        sonars: the sonars.
        bumpers: the bumpers.
        sensor_board: the devices read by the vendor's sensor board.
        handling: the grippers and arms.
        messenger: the communication between robots.
        cameras: the cameras.
        installed: the devices of the registry, by their names.
        timers: the timers of all sensors that can have one.
    """

    def __init__(self, world: WorldModel, seed: int, log: EventLog) -> None:
        """Create the devices.

        Args:
            world: the world.
            seed: seed of their random errors.
            log: receives their events.
        """
        self.log = log
        self.cameras = Cameras(world, seed)
        self.messenger = Messenger(world, seed)
        self.installed: dict[str, Installed] = {
            row.name: row.install(row, world, seed, log) for row in _REGISTERED
        }
        self.sonars: SonarRing = self.installed["sonar"].device
        self.bumpers: Bumpers = self.installed["bumper"].device
        self.sensor_board = SensorBoard(world, seed, self.installed)
        self.handling = Handling(self.installed["gripper"].device, self.installed["arm"].device)
        self.timers = Timers(self._timed())

    def _timed(self) -> dict[int, tuple[str, Timed]]:
        """Return the sensors that can have a timer, by their numbers in `crs.h`."""
        timed = {
            CAMERA: ("camera", Timed(
                self.cameras.read, lambda state: state.camera.at_s, self.cameras.interval_s
            )),
            **self.sensor_board.timed,
        }  # fmt: skip
        for row in _REGISTERED:
            found = self.installed[row.name].timed
            if row.number is not None and found is not None:
                timed[row.number] = row.name, found
        return timed

    @property
    def fans(self) -> list[Fan]:
        """Return the beams of the devices that measure distances."""
        own = [*self.cameras.fans]
        for each in self.installed.values():
            own += each.fans
        return [*self.sensor_board.fans, *own]

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
        to_s = np.minimum(to_s, constants.last_instant_s(state.cycle))
        while True:
            due = state.timers.soonest_s[rows] <= to_s
            if not due.any():
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


def page(context: RequestContext) -> BoolArray:
    """Answer READINGS with a page of what an earlier reply announced; refuse other sensors."""
    state, constants = context.state, context.constants
    sensor, first = context["sensor"].copy(), context["first"].tolist()
    good = np.zeros(len(context), dtype=np.bool_)
    tables = (
        (CAMERA, state.camera.told, constants.camera),
        (LASER, state.laser.told, constants.laser),
    )
    for number, told, numbers in tables:
        mine = numbers[context.rows]
        for place in np.flatnonzero((sensor == number) & (mine >= 0)).tolist():
            told.page(mine[place], first[place], context.messages[place])
            good[place] = True
    return good
