"""All devices of all robots that measure by themselves, or answer in a form of their own.

A new one is made here, and entered into `answers`; one with a timer is also told by `advance` how
far time has come.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.requests import CODES
from crs_cc.sim.comms.messenger import Messenger
from crs_cc.sim.devices import drive, heat
from crs_cc.sim.devices.camera import Cameras
from crs_cc.sim.devices.gps import GpsReceivers
from crs_cc.sim.devices.handling import Handling
from crs_cc.sim.devices.light import LightRings
from crs_cc.sim.devices.sensor_board import SensorBoard
from crs_cc.sim.devices.sonar import SonarRing
from crs_cc.sim.devices.sound import Microphones
from crs_cc.sim.devices.tilt import Inclinometers
from crs_cc.sim.devices.timers import Timed, Timers
from crs_cc.sim.engine.server.prediction import predict
from crs_cc.sim.state.timers import CAMERA, GPS, HEAT, LASER, LIGHT, SOUND, TILT

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import Answer, RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.geometry.rays import Fan
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


class DeviceBoard:
    """The devices of all robots of a world.

    Attributes:
        sonars: the sonars.
        instruments: what the vendor's sensor board reads.
        handling: what takes hold of things.
        messenger: what carries messages from robot to robot.
        answers: who answers the requests that are not answered with `State`, by code.
    """

    def __init__(self, world: WorldModel, seed: int, log: EventLog) -> None:
        """Makes the devices.

        Args:
            world: the world.
            seed: decides their errors.
            log: takes what happens to them.
        """
        self.log = log
        self.sonars = SonarRing(world, seed)
        self.instruments = SensorBoard(world, seed)
        self._cameras = Cameras(world, seed)
        self.handling = Handling(world, log)
        self._lights = LightRings(world, seed)
        self._microphones = Microphones(world, seed)
        self.messenger = Messenger(world, seed)
        receivers = GpsReceivers(world, seed)
        inclinometers = Inclinometers(world, seed)
        self._timers = Timers(
            {
                GPS: Timed(
                    receivers.read,
                    lambda constants: constants.gps,
                    lambda state: state.gps.at_s,
                    receivers.interval_s,
                ),
                CAMERA: Timed(
                    self._cameras.read,
                    lambda constants: constants.camera,
                    lambda state: state.camera.at_s,
                    self._cameras.interval_s,
                ),
                HEAT: Timed(
                    heat.read,
                    lambda constants: constants.heat,
                    lambda state: state.heat_sensor.at_s,
                    np.zeros(len(world.robots)),
                ),
                TILT: Timed(
                    inclinometers.read,
                    lambda constants: constants.inclinometer,
                    lambda state: state.tilt.at_s,
                    inclinometers.interval_s,
                ),
                LIGHT: Timed(
                    self._lights.read,
                    lambda constants: constants.light,
                    lambda state: state.light.at_s,
                    np.zeros(len(world.robots)),
                ),
                SOUND: Timed(
                    self._microphones.read,
                    lambda constants: constants.sound,
                    lambda state: state.sound.at_s,
                    np.zeros(len(world.robots)),
                ),
                **self.instruments.timed,
            }
        )
        self.answers: dict[int, Answer] = {
            CODES["SONAR"]: self.sonars.tell,
            CODES["PREDICT"]: partial(predict, sensors=(self.sonars, self.instruments)),
            CODES["TILT"]: inclinometers.tell,
            CODES["HEAT"]: heat.tell,
            CODES["GPS"]: receivers.tell,
            CODES["CAMERA"]: self._cameras.tell,
            CODES["READINGS"]: tell_page,
            CODES["SENSE_HEAT"]: heat.tell,
            CODES["SONAR_RANGES"]: self.sonars.tell,
            CODES["LASER"]: self.instruments.lasers.tell,
            CODES["PERIOD"]: self._timers.set_period,
            CODES["AGE"]: self._timers.tell_age,
            CODES["GRIPPER"]: self.handling.grippers.command,
            CODES["GET_GRIPPER"]: self.handling.grippers.tell,
            CODES["ARM"]: self.handling.arms.move,
            CODES["GET_ARM"]: self.handling.arms.tell,
            CODES["HAND"]: self.handling.arms.hand,
            CODES["GET_LIGHT"]: self._lights.tell,
            CODES["GET_SOUND"]: self._microphones.tell,
            **self.messenger.answers,
        }

    @property
    def fans(self) -> list[Fan]:
        """Gives the beams of those that measure distances."""
        own = [*self._cameras.fans, *self.handling.grippers.fans]
        own += [*self._lights.fans, *self._microphones.fans]
        return [*self.sonars.fans, *self.instruments.fans, *own]

    def begin(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        now_s: float,
    ) -> None:
        """Lets those of some robots begin, between two cycles: timers start now.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: what there is to see.
            rows: whose: robots that are there from the start, or that join.
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
        """Lets those with timers work until an instant of the current cycle.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: what there is to see.
            rows: whose, k of them.
            to_s: until when, for each, (k,).
        """
        while True:
            due = state.timers.soonest_s[rows] <= to_s
            if not due.any():
                break
            firing = rows[due]
            at_s = state.timers.soonest_s[firing]
            self.sonars.advance(state, constants, rays, firing, at_s)
            drive.advance(state, constants, firing, np.maximum(at_s, state.drive.clock_s[firing]))
            self._timers.fire(state, constants, rays, firing)
        self.sonars.advance(state, constants, rays, rows, to_s)

    def end_cycle(
        self, state: EnvState, constants: RobotConstants, from_s: float, to_s: float
    ) -> None:
        """Lets those work that do so once in a cycle, at its end.

        Args:
            state: changed in place; the bodies are where they got to.
            constants: what stands where.
            from_s: when the cycle began.
            to_s: when it ends.
        """
        self.messenger.end_cycle(state, constants, self.log, from_s=from_s, to_s=to_s)


def tell_page(asked: RequestContext) -> BoolArray:
    """Answers READINGS with a page of what a reply before told of; refuses other devices."""
    state, constants = asked.state, asked.constants
    device = asked.messages["i"][:, 0].copy()
    good = np.zeros(len(device), dtype=np.bool_)
    tables = (
        (CAMERA, state.camera.told, constants.camera),
        (LASER, state.laser.told, constants.laser),
    )
    for number, told, numbers in tables:
        mine = numbers[asked.rows]
        for place in np.flatnonzero((device == number) & (mine >= 0)).tolist():
            message = asked.messages[place]
            told.page(mine[place], int(message["i"][1]), message)
            good[place] = True
    return good
