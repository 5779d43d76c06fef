"""What the sensor board reads when a reply tells it, and tells with each state.

Infrared ring, compass and laser measure on demand: where a reply carries their readings, and the
mask that the program set (`ct`) has one of their bits; or by their timers. Batteries and clock are
told with every state.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Records
from crs_cc.requests import CODES, STATE_REPLIES
from crs_cc.sim.devices import laser, pos_data
from crs_cc.sim.devices.battery import Batteries
from crs_cc.sim.devices.clock import BoardClock
from crs_cc.sim.devices.compass import Compasses
from crs_cc.sim.devices.infrared import InfraredRing
from crs_cc.sim.devices.laser import Lasers
from crs_cc.sim.devices.timers import Timed
from crs_cc.sim.devices.vendor_state import MOTOR_STATUS
from crs_cc.sim.model.sensors import MAX_INFRARED
from crs_cc.sim.state import timers
from crs_cc.sim.state.mask import COMPASS, INFRARED, LASER

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.geometry.rays import Fan
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


_OF_A_GROUP: Final = frozenset(
    CODES[name]
    for name in (
        "GET_SN", "GET_BP", "GET_RC", "GET_RV", "GET_RA", "GET_IR", "GET_CP", "GET_LS", "GET_SG",
    )
)  # fmt: skip
_LASER_CODES: Final = frozenset({CODES["GET_LS"], CODES["GET_SG"]})
_TELLS_ALL: Final = STATE_REPLIES - _OF_A_GROUP


class SensorBoard:
    """The instruments of all robots of a world.

    Attributes:
        batteries: the robots' batteries.
        lasers: their lasers.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        self.batteries = Batteries(world)
        self._clock = BoardClock(world)
        self._infrared = InfraredRing(world, seed)
        self._compasses = Compasses(world, seed)
        self.lasers = Lasers(world, seed)
        models = [robot.model for robot in world.robots]
        self._has_infrared = any(model.infrared is not None for model in models)
        self._has_lasers = any(model.laser is not None for model in models)
        self._has_compasses = any(model.compass is not None for model in models)

    @property
    def fans(self) -> list[Fan]:
        """Gives the beams of those that measure distances."""
        return [*self._infrared.fans, *self.lasers.fans]

    @property
    def timed(self) -> dict[int, Timed]:
        """Gives those that can have a timer, by their numbers in `crs.h`."""
        return {
            timers.LASER: Timed(
                self.lasers.read,
                lambda constants: constants.laser,
                lambda state: state.laser.measured.at_s,
                self.lasers.interval_s,
            ),
            timers.INFRARED: Timed(
                self._infrared.read,
                lambda constants: constants.infrared,
                lambda state: state.infrared.measured.at_s,
                self._infrared.interval_s,
            ),
            timers.COMPASS: Timed(
                self._compasses.read,
                lambda constants: constants.compass,
                lambda state: state.compass.measured.at_s,
                self._compasses.interval_s,
            ),
        }

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        *,
        code: int,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Lets the instruments measure whose readings a reply carries.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: what there is to see.
            code: the request's code.
            rows: which robots, k of them, whose axes were turned to `at_s`.
            at_s: when each reply is given, shape (k,).
        """
        if self._has_infrared and (code in _TELLS_ALL or code == CODES["GET_IR"]):
            asked = _asked(state, rows, INFRARED) | (code == CODES["GET_IR"])
            asked &= state.timers.on_request(rows, timers.INFRARED)
            self._infrared.read(state, constants, rays, rows[asked], at_s[asked])
        if self._has_compasses and (code in _TELLS_ALL or code == CODES["GET_CP"]):
            asked = _asked(state, rows, COMPASS) | (code == CODES["GET_CP"])
            asked &= state.timers.on_request(rows, timers.COMPASS)
            self._compasses.read(state, constants, rays, rows[asked], at_s[asked])
        if self._has_lasers and (code in _TELLS_ALL or code in _LASER_CODES):
            asked = _asked(state, rows, LASER) | (code in _LASER_CODES)
            asked &= state.timers.on_request(rows, timers.LASER)
            self.lasers.read(state, constants, rays, rows[asked], at_s[asked])

    def tell(
        self,
        state: EnvState,
        constants: RobotConstants,
        *,
        code: int,
        rows: IndexArray,
        messages: Records,
        at_s: FloatArray,
        states: Int32Array,
    ) -> None:
        """Tells batteries, clock, how many laser readings lie ready, and positions, with a state.

        Args:
            state: what is told of.
            constants: the robots' constants.
            code: the request's code.
            rows: which robots, k of them.
            messages: the replies, changed in place.
            at_s: when each is given, shape (k,).
            states: `State` of each, changed in place, shape (k, 45).
        """
        status = self.batteries.status(state, rows, at_s)
        if status is not None:
            states[:, MOTOR_STATUS] |= status
        messages["i"][:, 0] = 0
        if self._has_lasers and (code in _TELLS_ALL or code in _LASER_CODES):
            messages["i"][:, 0] = _tell_laser(state, constants, code, rows)
        kinds = pos_data.ALL_KINDS if code in _TELLS_ALL else pos_data.ONE_KIND.get(code, 0)
        pos_data.tell(state, constants, self._clock, rows, kinds)
        messages["i"][:, 1], messages["i"][:, 2] = self.batteries.told(state, constants, rows, at_s)
        messages["f"][:, 0] = self._clock.ms(rows, at_s - state.presence.joined_s[rows])

    def look(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        poses: FloatArray,
    ) -> tuple[Int32Array, Int32Array]:
        """Lets the instruments measure without any error from somewhere else.

        Args:
            state: tells where all things are; keeps what lasers see for the pages.
            constants: the robots' constants.
            rays: what there is to see.
            rows: which robots, k of them.
            poses: x, y [m] and direction [rad] of each mount, shape (k, 3).

        Returns:
            what infrared sensors tell, shape (k, 16), and how many laser readings there are, (k,).
        """
        infrared = np.zeros((len(rows), MAX_INFRARED), dtype=np.int32)
        has = constants.infrared[rows] >= 0
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


def _tell_laser(
    state: EnvState, constants: RobotConstants, code: int, rows: IndexArray
) -> Int32Array:
    """Keeps what lasers saw for the pages; gives how many readings each robot has, (k,)."""
    mine = constants.laser[rows]
    asked = (mine >= 0) & (_asked(state, rows, LASER) | (code in _LASER_CODES))
    mine, kept = mine[asked], state.laser
    width = laser.widths(kept.mode[mine])
    if code in _LASER_CODES:
        width[:] = laser.POINTS if code == CODES["GET_LS"] else laser.SEGMENTS
    points = np.where(laser.is_on(kept.mode[mine]), kept.points[mine], 0)
    laser.keep(state, kept.told, mine, width, (points, kept.seen[mine]))
    counts = np.zeros(len(rows), dtype=np.int32)
    counts[asked] = kept.told.count[mine]
    return counts


def _asked(state: EnvState, rows: IndexArray, group: slice) -> BoolArray:
    return np.asarray((state.mask[rows, group].view(np.int8) > 0).any(axis=1))
