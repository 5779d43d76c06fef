"""The sensor board: its measurements for a reply with `State`, and its own entries.

Infrared ring, compass and laser measure on request: where a reply carries their readings, and the
mask that the program set (`ct`) has one of their bits; or by their timers. Every such reply has
the batteries' voltages and the time of the board.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Records, all_of
from crs_cc.requests import CODES, REQUESTS
from crs_cc.requests.request import ALL_SENSORS, INFRARED, LASER
from crs_cc.requests.request import COMPASS as COMPASS_KIND
from crs_cc.sim.devices import pos_data
from crs_cc.sim.devices.clock import BoardClock
from crs_cc.sim.devices.compass import Compasses, compasses
from crs_cc.sim.devices.infrared import MAX_INFRARED, InfraredRing, rings
from crs_cc.sim.devices.laser.model import laser_state
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.devices.vendor_state import (
    COMPASS,
    IR_0,
    MOTOR_STATUS,
    SONAR_0,
    VEL_RIGHT,
    KernelReply,
    correct_speeds,
)
from crs_cc.sim.devices.vendor_state import LASER as LASER_MODE
from crs_cc.sim.kernels.tables import REPLY
from crs_cc.sim.model import registry
from crs_cc.sim.state import mask
from crs_cc.sim.state.rows import ALL, Rows, simplest, take

if TYPE_CHECKING:
    from collections.abc import Mapping

    from crs_cc.sim.devices.battery import Batteries
    from crs_cc.sim.devices.installed import Installed
    from crs_cc.sim.devices.laser.lasers import Lasers
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


GROUPS: Final = {"infrared": mask.INFRARED, "compass": mask.COMPASS, "laser": mask.LASER}
"""The bits of masks that select a device of the registry."""

_KINDS: Final = {"infrared": INFRARED, "compass": COMPASS_KIND, "laser": LASER}
"""The kinds of sensors of requests that are about one of these."""

_PLACES: Final = {
    name: place for name, (_, place) in REQUESTS[CODES["GS"]].result_positions.items()
}
LASER_COUNT: Final = _PLACES["laser_count"]
BATTERIES: Final = slice(_PLACES["computer_battery"], _PLACES["motor_battery"] + 1)
BOARD_MS: Final = _PLACES["board_ms"]
"""Places in messages, the same in all replies with `State`."""
_STATE_BYTES: Final = REPLY["state"].itemsize


class SensorBoard:
    """The sensor boards of all robots of a world.

    Attributes:
        batteries: the robots' batteries.
        infrared: the infrared rings.
        compasses: the compasses.
    """

    def __init__(self, world: WorldModel, installed: Mapping[str, Installed]) -> None:
        """Make the boards.

        Args:
            world: the world.
            installed: the devices of the registry, by their names.
        """
        self.batteries: Batteries = installed["motor_battery"].device
        self._clock = BoardClock(world)
        self.infrared: InfraredRing = installed["infrared"].device
        self.compasses: Compasses = installed["compass"].device
        models = [robot.model for robot in world.robots]
        self._instruments = [
            (registry.device(name), timed.read, group)
            for name, group in GROUPS.items()
            if (timed := installed[name].timed) is not None
            and any(model.device(name) is not None for model in models)
        ]
        readers = {"infrared": self.infrared.read, "compass": self.compasses.read}
        self._simple = [
            (row, readers[row.name], group)
            for row, _, group in self._instruments
            if row.name in readers
        ]
        self._lasers: Lasers | None = None
        if any(model.device("laser") is not None for model in models):
            self._lasers = installed["laser"].device

    @property
    def is_simple(self) -> bool:
        """Whether it measures with nothing but infrared rings and compasses."""
        return self._lasers is None and not self.batteries.are_in_status

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
        replies = _replies(state, constants, rows, at_s)
        status = self.batteries.status(rows, replies["charge"])
        if status is not None:
            replies["state"][:, MOTOR_STATUS] |= status
        laser_count: Int32Array | int = 0
        if self._lasers is not None and request.sensors & LASER:
            masked = selects(context.state, context.rows, mask.LASER)
            laser_count = self._lasers.reply(context, masked)
        pos_data.keep(state, constants, self._clock, rows, request.sensors)
        self.write(state, constants, (rows, at_s), replies, context.messages)
        context["laser_count"] = laser_count
        return np.asarray(replies["state"])

    def measure_for_simple_requests(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        replied: tuple[IndexArray, FloatArray],
        code: int,
        *,
        kernel_reply: KernelReply,
    ) -> None:
        """Measure for requests of one kind, if the board is simple and these have been executed.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: casts rays.
            replied: the robots, k of them, and the time of each reply.
            code: the kind of requests; all robots have what it is about.
            kernel_reply: the results of the kernel that answered the request.
        """
        rows, at_s = replied
        about = REQUESTS[code].sensors
        for row, measure, group in self._simple:
            if about not in (ALL_SENSORS, _KINDS[row.name]):
                continue
            which = constants.numbers[row.name].take(rows) >= 0
            if about == ALL_SENSORS:
                which &= selects(state, rows, group)
            if row.number is not None:
                which &= state.timers.on_request(rows, row.number)
            if all_of(which):
                measure(state, constants, rays, rows, at_s, kernel_reply=kernel_reply)
            elif which.any():
                some = rows[which]
                measure(
                    state, constants, rays, some, at_s[which], kernel_reply=kernel_reply.of(which)
                )

    def write(
        self,
        state: EnvState,
        constants: RobotConstants,
        replied: tuple[IndexArray, FloatArray],
        replies: Records,
        messages: Records,
    ) -> None:
        """Write `State`, batteries and clock into messages.

        Args:
            state: has the memory of degradations.
            constants: the robots' constants.
            replied: the robots, k of them, and the time of each reply.
            replies: what kernels know of the robots, of dtype `REPLY`.
            messages: the messages, changed in place.
        """
        rows, at_s = replied
        charge, integers = replies["charge"], messages["i"]
        integers[:, LASER_COUNT] = 0
        integers[:, BATTERIES] = self.batteries.voltage_bytes(state, constants, rows, at_s, charge)
        messages["f"][:, BOARD_MS] = replies["board_ms"]
        content = replies.view(np.uint8).reshape(-1, REPLY.itemsize)
        messages["data"][:, :_STATE_BYTES] = content[:, :_STATE_BYTES]
        messages["size"] = _STATE_BYTES

    def _measure(self, context: RequestContext, good: BoolArray) -> None:
        """Measure with the instruments that the programs' masks select."""
        for row, measure, group in self._instruments:
            has = context.constants.numbers[row.name][context.rows] >= 0
            requested = good & has & selects(context.state, context.rows, group)
            read_on_request(context, measure, row.number, requested)

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
            look = self.infrared.look
            infrared[has] = look(state, constants, rays, rows[has], poses[has])
        counts = np.zeros(len(rows), dtype=np.int32)
        if self._lasers is not None:
            counts = self._lasers.predict(state, constants, rays, rows, poses)
        return infrared, counts


def state_vector(state: EnvState, constants: RobotConstants, rows: IndexArray) -> Int32Array:
    """Return `State` of robots at the time to which their axes were turned, shape (k, 45)."""
    states: Int32Array = _replies(state, constants, rows, state.drive.clock_s[rows])["state"]
    return states


def _replies(
    state: EnvState, constants: RobotConstants, rows: IndexArray, at_s: FloatArray
) -> Records:
    """Return `State`, charges and times of robots, (k,) of dtype `REPLY`."""
    kinds, for_s = constants.kinds, at_s - state.presence.joined_s[rows]
    replies = state.rows.replies(simplest(rows, len(kinds.kind)), for_s, kinds)
    correct_speeds(state, constants, rows, replies["state"][:, VEL_RIGHT:MOTOR_STATUS])
    write_readings(state, constants, rows, replies["state"])
    return replies


def write_readings(
    state: EnvState, constants: RobotConstants, rows: IndexArray, states: Int32Array
) -> None:
    """Write what instruments have measured last into `State` of robots, (k, 45)."""
    level, mode, reading = rings(state).level, laser_state(state).mode, compasses(state).reading
    if len(level):
        has, mine = _having(constants.numbers["infrared"], rows)
        states[has, IR_0:SONAR_0] = np.rint(take(level, mine))
    if len(mode):
        has, mine = _having(constants.numbers["laser"], rows)
        states[has, LASER_MODE] = mode[mine]
    if len(reading):
        has, mine = _having(constants.numbers["compass"], rows)
        states[has, COMPASS] = reading[mine]


def _having(numbers: IndexArray, rows: IndexArray) -> tuple[Rows, IndexArray]:
    """Return which of some robots have a device, and the numbers of these devices."""
    mine = numbers.take(rows)
    has = mine >= 0
    if all_of(has):
        return ALL, mine
    return np.flatnonzero(has), mine[has]


def selects(state: EnvState, rows: IndexArray, group: slice) -> BoolArray:
    """Return of which robots the programs' masks have any bit of a group, (k,)."""
    mask = np.ascontiguousarray(state.mask.take(rows, axis=0)[:, group]).view(np.int8) > 0
    return mask[:, 0] if all_of(mask) else np.asarray(mask.any(axis=1))
