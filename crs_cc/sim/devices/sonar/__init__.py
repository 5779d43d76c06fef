"""The sonar ring: which sonar fires when, and when its echo is reported.

Sonars fire in the firing order, cyclically, whether or not a program reads them. Firing n occurs at
exactly

    start + n * max(rate * 4 ms, minimum interval)

(`conf_sn`, vendor header `Nclient.h` 1.29); firing times are not rounded to timesteps. `start` is
the time of `conf_sn`; at the start of a run the robot has already been on for a while, so that a
complete cycle of the definition's order has just been measured at its initial position. A reading
changes when the echo arrives,

    2 * distance / (speed of sound)

after the firing, or when the sonar stops listening: when an echo from its maximum range would have
arrived, or when the next sonar fires, whichever is earlier, because all sonars share one board.
Until then, the previous reading is reported. The vendor does not document the following cases; crs
defines them:

- a rate that would give an interval shorter than the minimum, rate 0 included, selects the minimum;
- `conf_sn` discards the pending ping, and its first sonar fires immediately;
- a sonar that is not in the order reads 255, no echo; an empty order switches all of them off.

A reading is the distance from the sensor, which is on the shell, to the nearest object that returns
an echo into the beam (`geometry.echoes`), in whole inches; 255 means no echo, as the reading is one
byte on the line (vendor source `Ndirect.c` 2.7). The firing robot is at the position that its
wheels have reached at the time of the firing; all other objects, and a robot that is blocked, are
at their positions at the start of the timestep. Errors: see `errors`. Degradation (`sonar`): the
degraded distance is reported when an echo from that distance would arrive; if that echo would
arrive too late, the reading is "no echo".
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, ComplexArray, FloatArray, IndexArray, Int32Array
from crs_cc.core.units import SOUND_MPS, m_to_tenths_inch
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.sensor_order import orders
from crs_cc.sim.devices.sonar.beams import Beams, overheard
from crs_cc.sim.devices.sonar.errors import SonarErrors
from crs_cc.sim.devices.vendor_state import configuration
from crs_cc.sim.geometry.echoes import Pings, first_echo
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.model.sonar import MAX_SONARS, SONAR_TICK_S, SonarMode
from crs_cc.sim.state.sonar import inches

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.geometry.outline_query import Prospect
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


_ROBOTS_AT_ONCE: Final = 64  # robots per batch when all sonars are computed, which bounds memory
_RATES: Final = 256  # the rate is an unsigned char


class SonarRing:
    """The sonars of all robots of a world: constants and reproducible random numbers.

    Attributes:
        fans: the beams of each kind of robot.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        models = [robot.model for robot in world.robots]
        kinds = dict.fromkeys(models)
        self.fans = [_fan(mode) for model in kinds for mode in model.sonar_modes]
        self._beams = Beams(models)
        self._errors = SonarErrors(world, seed)

    def begin(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        now_s: float,
    ) -> None:
        """Fire all sonars in the orders just before robots start."""
        sonar = state.sonar
        heard_m = self.ranges_now_m(state, constants, rays, rows, np.full(len(rows), now_s))
        row, turn = np.nonzero(np.arange(MAX_SONARS) < sonar.length[rows, None])
        robot = rows[row]
        number = sonar.order[robot, turn]
        sonar.echo_m[robot, number] = heard_m[row, number]
        sonar.fired_from[rows] = configuration(state, constants, rows)[:, None, :]
        sonar.fired_s[rows] = sonar.start_s[rows] = now_s
        sonar.next_s[rows] = np.where(sonar.length[rows] > 0, now_s, np.inf)

    def advance(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        to_s: FloatArray,
    ) -> None:
        """Fire and read the sonars of robots up to a time.

        Args:
            state: changed in place; wheels are turned on to the last firing.
            constants: the robots' constants.
            rays: casts rays.
            rows: the robots, k of them.
            to_s: the time of each, shape (k,).
        """
        while True:
            due = state.sonar.next_s[rows] <= to_s
            if not due.any():
                break
            firing = rows[due]
            at_s = state.sonar.next_s[firing]
            drive.advance(state, constants, firing, np.maximum(at_s, state.drive.clock_s[firing]))
            state.sonar.hear(firing, at_s)
            self._fire(state, constants, rays, firing, at_s)
        state.sonar.hear(rows, to_s)

    def ranges_now_m(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> FloatArray:
        """Return the ranges that all sonars would report if they fired at `at_s` [m], (k, 16)."""
        distance_m = self._around(state, rays, rows, *self._stands(state, constants, rows))
        reported_m = np.empty_like(distance_m)
        for number in range(MAX_SONARS):
            deviates = self._errors.draw(rows, state.sonar.count[rows])
            reported_m[:, number] = self._reported_m(
                state, constants, (rows, number, at_s), distance_m[:, number], deviates
            )
            state.sonar.count[rows] += 1
        return reported_m

    def get_ranges(self, context: RequestContext) -> BoolArray:
        """Answer SONAR and SONAR_RANGES in 0.1 in, -1 for no echo; refuse robots without sonars."""
        state, constants, rows = context.state, context.constants, context.rows
        echo_m = state.sonar.echo_m[rows]
        has = np.asarray(constants.sonars[rows].any(axis=1))
        now = has & (context["fire"] != 0)
        if now.any():
            echo_m[now] = self.ranges_now_m(
                state, constants, context.rays, rows[now], context.at_s[now]
            )
        heard = np.isfinite(echo_m)
        tenths = np.rint(m_to_tenths_inch(np.where(heard, echo_m, 0.0)))
        context.put_data(np.where(heard, tenths, -1))
        return has

    def get_sn(self, context: RequestContext) -> BoolArray:
        """Answer GET_SN with the last readings, in `State`; refuse robots without sonars.

        Sonars fire by themselves: the readings are up to date at the time of the request.
        """
        return np.asarray(context.constants.sonars[context.rows].any(axis=1))

    def conf_sn(self, context: RequestContext) -> BoolArray:
        """Set the firing order and rate; refuse an order with a missing sonar.

        The first one in the order fires at once.
        """
        state, constants = context.state, context.constants
        order, given, good = orders(context["count"], context["order"], MAX_SONARS)
        has = constants.sonars[context.rows]
        known = np.take_along_axis(has, np.minimum(order, MAX_SONARS - 1), axis=1)
        good &= has.any(axis=1) & (known | ~given).all(axis=1)
        rows, order, given = context.rows[good], order[good], given[good]
        interval_s = context["rate"][good] % _RATES * SONAR_TICK_S
        state.sonar.interval_s[rows] = np.maximum(interval_s, constants.least_interval_s[rows])
        state.sonar.reorder(
            rows, np.where(given, order, 0), given.sum(axis=1), state.drive.clock_s[rows]
        )
        until_s = np.minimum(context.at_s[good], constants.last_instant_s(state.cycle))
        self.advance(state, constants, context.rays, rows, until_s)
        return good

    def look(
        self, state: EnvState, rays: RayCaster, rows: IndexArray, poses: FloatArray
    ) -> Int32Array:
        """Return the readings of sonars without errors if the robots were at other poses.

        Args:
            state: has the poses of all objects.
            rays: casts rays.
            rows: the robots, k of them.
            poses: x, y [m] and heading of the ring [rad] of each, shape (k, 3).

        Returns:
            readings [in], 255 for no echo, shape (k, 16).
        """
        place = poses[:, 0] + 1j * poses[:, 1]
        return inches(self._around(state, rays, rows, place, np.exp(1j * poses[:, 2])))

    def _fire(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Send a ping from each of some robots."""
        sonar = state.sonar
        number = sonar.order[rows, sonar.turn[rows] % sonar.length[rows]]
        place, turn = self._stands(state, constants, rows)
        pings = self._beams.pings(rows, number, place, turn, sonar.mode[rows])
        gives_up_s = np.minimum(2 * pings.range_m / SOUND_MPS, sonar.interval_s[rows])
        deviates = self._errors.draw(rows, sonar.count[rows])
        confused = np.flatnonzero(self._errors.confused(rows, sonar.mode[rows], deviates))
        voices = None
        if len(confused):
            from_s, to_s = at_s[confused], (at_s + gives_up_s)[confused]
            voices = overheard(state, self._beams, pings, confused, from_s=from_s, to_s=to_s)
        prospect = self._prospect(state, rays, pings, number)
        distance_m = first_echo(pings, prospect, voices, rays.surfaces.hushed)
        reported_m = self._reported_m(state, constants, (rows, number, at_s), distance_m, deviates)
        in_time = 2 * reported_m / SOUND_MPS <= gives_up_s
        sonar.listening[rows] = number
        sonar.sent_s[rows] = at_s
        sonar.sent_from[rows] = configuration(state, constants, rows)
        sonar.heard_s[rows] = at_s + np.where(in_time, 2 * reported_m / SOUND_MPS, gives_up_s)
        sonar.heard_m[rows] = np.where(in_time, reported_m, np.inf)
        sonar.count[rows] += 1
        sonar.turn[rows] += 1
        sonar.next_s[rows] = sonar.start_s[rows] + sonar.turn[rows] * sonar.interval_s[rows]

    def _reported_m(
        self,
        state: EnvState,
        constants: RobotConstants,
        pings: tuple[IndexArray, IndexArray | int, FloatArray],
        distance_m: FloatArray,
        deviates: FloatArray,
    ) -> FloatArray:
        """Return the range that a sonar reports for true distances [m], infinite for none, (k,).

        Args:
            state: has the memory of degradations.
            constants: the robots' constants.
            pings: robot, sonar and time of each firing, (k,) each.
            distance_m: the distances, (k,).
            deviates: of each firing, (k, 3).
        """
        rows, number, at_s = pings
        reported_m = self._errors.reported_m(rows, state.sonar.mode[rows], distance_m, deviates)
        if not constants.degradations.concern(state, "sonar"):
            return reported_m
        elements = np.broadcast_to(number, rows.shape)
        reported_m = constants.degradations.alter(
            state, "sonar", rows, reported_m[:, None], at_s, elements=elements
        )[:, 0]
        return np.where(np.isnan(reported_m), np.inf, np.maximum(reported_m, 0.0))

    def _stands(
        self, state: EnvState, constants: RobotConstants, rows: IndexArray
    ) -> tuple[ComplexArray, ComplexArray]:
        """Return positions of robots and directions of their rings' fronts."""
        x_m, y_m, angle_rad = mount_poses(state, constants, rows).T
        return x_m + 1j * y_m, np.exp(1j * angle_rad)

    def _around(
        self,
        state: EnvState,
        rays: RayCaster,
        rows: IndexArray,
        place: ComplexArray,
        turn: ComplexArray,
    ) -> FloatArray:
        """Return the true distances that all sonars of robots measure, shape (k, 16)."""
        parts = [np.zeros((0, MAX_SONARS))]
        for first in range(0, len(rows), _ROBOTS_AT_ONCE):
            part = slice(first, first + _ROBOTS_AT_ONCE)
            parts.append(self._around_few(state, rays, rows[part], place[part], turn[part]))
        return np.concatenate(parts)

    def _around_few(
        self,
        state: EnvState,
        rays: RayCaster,
        rows: IndexArray,
        place: ComplexArray,
        turn: ComplexArray,
    ) -> FloatArray:
        each = np.repeat(np.arange(len(rows)), MAX_SONARS)
        number = np.tile(np.arange(MAX_SONARS), len(rows))
        mode = state.sonar.mode[rows[each]]
        pings = self._beams.pings(rows[each], number, place[each], turn[each], mode)
        prospect = self._prospect(state, rays, pings, number)
        heard_m = first_echo(pings, prospect, hushed=rays.surfaces.hushed)
        return heard_m.reshape(-1, MAX_SONARS)

    def _prospect(
        self, state: EnvState, rays: RayCaster, pings: Pings, number: IndexArray
    ) -> Prospect:
        """Return what pings of the sonars with these numbers can hit."""
        z_m = self._beams.z_m(pings.own, number)
        return rays.prospect(state, z_m, np.tan(pings.half_rad))


def set_mode(context: RequestContext) -> BoolArray:
    """Select a mode for the next pings of a sonar; refuse unknown modes."""
    mode = context["mode"]
    good = np.asarray((mode >= 0) & (mode < context.constants.sonar_modes[context.rows]))
    context.state.sonar.mode[context.rows[good]] = mode[good]
    return good


def _fan(model: SonarMode) -> Fan:
    return Fan.of(
        (sonar.x_m, sonar.y_m, sonar.direction_rad, sonar.half_angle_rad, sonar.range_m)
        for sonar in model.sonars
    )
