"""The sensor board: what it measures for a reply with `State`, and what it adds to it.

Infrared ring, compass and laser measure on request: where a reply carries their readings, and the
mask that the program set (`ct`) has one of their bits; or by their timers. Every such reply has
the batteries' voltages and the time of the board.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.requests import CODES, NUM_STATE
from crs_cc.requests.request import ALL_SENSORS, LASER
from crs_cc.sim.devices import laser, pos_data
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.clock import BoardClock
from crs_cc.sim.devices.compass import compasses
from crs_cc.sim.devices.infrared import MAX_INFRARED, InfraredRing, rings
from crs_cc.sim.devices.installed import Timed
from crs_cc.sim.devices.laser import Lasers
from crs_cc.sim.devices.sonar.model import MAX_SONARS
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.devices.vendor_state import (
    BUMPER,
    COMPASS,
    CONF_X,
    IR_0,
    MOTOR_STATUS,
    SIM_SPEED,
    SONAR_0,
    VEL_TURRET,
    configuration,
)
from crs_cc.sim.devices.vendor_state import LASER as LASER_MODE
from crs_cc.sim.model import registry
from crs_cc.sim.state import mask, timers
from crs_cc.sim.state.rows import take

if TYPE_CHECKING:
    from collections.abc import Mapping

    from crs_cc.sim.devices.battery import Batteries
    from crs_cc.sim.devices.installed import Installed
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.geometry.rays import Fan
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


_LASER_WIDTHS: Final = {CODES["GET_LS"]: laser.POINTS, CODES["GET_SG"]: laser.SEGMENTS}
"""Numbers per reading in the replies with laser readings, in any mode."""

_GROUPS: Final = {"infrared": mask.INFRARED, "compass": mask.COMPASS}
"""The bits of masks that select a device of the registry."""

_BITS: Final = np.array([1, 2, 4])
_REAL_TIME: Final = 10


class SensorBoard:
    """The sensor boards of all robots of a world.

    Attributes:
        batteries: the robots' batteries.
        lasers: their lasers.
    """

    def __init__(self, world: WorldModel, seed: int, installed: Mapping[str, Installed]) -> None:
        """Make the boards.

        Args:
            world: the world.
            seed: decides the noise.
            installed: the devices of the registry, by their names.
        """
        self.batteries: Batteries = installed["motor_battery"].device
        self._clock = BoardClock(world)
        self._infrared: InfraredRing = installed["infrared"].device
        self.lasers = Lasers(world, seed)
        models = [robot.model for robot in world.robots]
        self._has_lasers = any(model.laser is not None for model in models)
        self._instruments = [
            (registry.device(name).number, timed.read, group)
            for name, group in _GROUPS.items()
            if (timed := installed[name].timed) is not None
            and any(model.device(name) is not None for model in models)
        ]

    @property
    def fans(self) -> list[Fan]:
        """Return the beams of the sensors that measure distances."""
        return self.lasers.fans

    @property
    def timed(self) -> dict[int, tuple[str, Timed]]:
        """Return the sensors that can have a timer, by their numbers in `crs.h`."""
        lasers = self.lasers
        return {
            timers.LASER: ("laser", Timed(
                lasers.read, lambda state: state.laser.measured.at_s, lasers.interval_s
            )),
        }  # fmt: skip

    def reply(self, context: RequestContext, good: BoolArray) -> Int32Array:
        """Write `State` into replies, with batteries, clock, laser readings and positions.

        Args:
            context: the requests, changed in place into the replies.
            good: which of them were good; only for these, sensors measure for the replies.

        Returns:
            `State` of each, shape (k, 45).
        """
        request, state, constants = context.request, context.state, context.constants
        rows, at_s = context.rows, context.at_s
        if request.sensors == ALL_SENSORS:
            self._measure(context, good)
        states = state_vector(state, constants, rows)
        status = self.batteries.status(state, rows, at_s)
        if status is not None:
            states[:, MOTOR_STATUS] |= status
        context["laser_count"] = 0
        if self._has_lasers and request.sensors & LASER:
            context["laser_count"] = _keep_laser(context)
        pos_data.keep(state, constants, self._clock, rows, request.sensors)
        computers, motors = self.batteries.voltage_bytes(state, constants, rows, at_s)
        context["computer_battery"], context["motor_battery"] = computers, motors
        context["board_ms"] = self._clock.ms(rows, at_s - state.presence.joined_s[rows])
        context.put_data(states)
        return states

    def _measure(self, context: RequestContext, good: BoolArray) -> None:
        """Measure with the instruments that the programs' masks select."""
        for has, read, sensor, group in (
            (self._has_lasers, self.lasers.read, timers.LASER, mask.LASER),
        ):
            if has:
                requested = good & _is_requested(context, group)
                read_on_request(context, read, sensor, requested)
        for number, measure, group in self._instruments:
            requested = good & _is_requested(context, group)
            read_on_request(context, measure, number, requested)

    def look(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        poses: FloatArray,
    ) -> tuple[Int32Array, Int32Array]:
        """Measure with the instruments without errors from other poses.

        Args:
            state: has the poses of all objects; stores what lasers see for the pages.
            constants: the robots' constants.
            rays: casts rays.
            rows: the robots, k of them.
            poses: x, y [m] and direction [rad] of each mount, shape (k, 3).

        Returns:
            the infrared readings, shape (k, 16), and the number of laser readings, (k,).
        """
        infrared = np.zeros((len(rows), MAX_INFRARED), dtype=np.int32)
        has = constants.numbers["infrared"][rows] >= 0
        if has.any():
            look = self._infrared.look
            infrared[has] = look(state, constants, rays, rows[has], poses[has])
        counts = np.zeros(len(rows), dtype=np.int32)
        has = constants.laser[rows] >= 0
        if has.any():
            mine, kept = constants.laser[rows[has]], state.laser
            points, seen, _ = self.lasers.look(state, constants, rays, rows[has], poses[has])
            points = np.where(laser.is_on(kept.mode[mine]), points, 0)
            width = laser.widths(kept.mode[mine])
            laser.keep(state, kept.predicted, mine, width, (points, seen))
            counts[has] = kept.predicted.count[mine]
        return infrared, counts


def state_vector(state: EnvState, constants: RobotConstants, rows: IndexArray) -> Int32Array:
    """Return `State` of robots at the time to which their axes were turned, shape (k, 45)."""
    vector = np.zeros((len(rows), NUM_STATE), dtype=np.int32)
    vector[:, SIM_SPEED] = _REAL_TIME
    vector[:, SONAR_0 : SONAR_0 + MAX_SONARS] = sonar_state(state).reading_in(rows)
    level = rings(state).level
    if len(level):
        numbers = constants.numbers["infrared"][rows]
        has = numbers >= 0
        vector[has, IR_0:SONAR_0] = np.rint(level[numbers[has]])
    if len(state.laser.mode):
        has = constants.laser[rows] >= 0
        vector[has, LASER_MODE] = state.laser.mode[constants.laser[rows[has]]]
    reading = compasses(state).reading
    if len(reading):
        numbers = constants.numbers["compass"][rows]
        has = numbers >= 0
        vector[has, COMPASS] = reading[numbers[has]]
    vector[:, BUMPER] = bumper_state(state).pressed[rows]
    vector[:, CONF_X : VEL_TURRET + 1] = configuration(state, constants, rows)
    works = state.drive.axes.end_s(rows) > state.drive.clock_s[rows, None]
    vector[:, MOTOR_STATUS] = (works & ~take(state.drive.limp, rows)) @ _BITS
    return vector


def _keep_laser(context: RequestContext) -> Int32Array:
    """Store the lasers' scans for the pages; return the number of readings of each, (k,)."""
    laser_state, mine = context.state.laser, context.constants.laser[context.rows]
    width = _LASER_WIDTHS.get(context.request.code)
    requested = mine >= 0
    if width is None:
        requested &= _is_requested(context, mask.LASER)
    mine = mine[requested]
    mode = laser_state.mode[mine]
    widths = laser.widths(mode) if width is None else np.full(len(mine), width, np.int32)
    points = np.where(laser.is_on(mode), laser_state.points[mine], 0)
    laser.keep(context.state, laser_state.told, mine, widths, (points, laser_state.seen[mine]))
    counts = np.zeros(len(context), dtype=np.int32)
    counts[requested] = laser_state.told.count[mine]
    return counts


def _is_requested(context: RequestContext, group: slice) -> BoolArray:
    """Return which programs' masks have any bit of a group, (k,)."""
    bits = context.state.mask[context.rows, group].view(np.int8)
    return np.asarray((bits > 0).any(axis=1))
