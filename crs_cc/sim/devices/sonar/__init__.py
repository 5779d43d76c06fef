"""The sonar ring: which sonar fires when, and when its echo is reported.

Sonars fire in the firing order, cyclically, whether or not a program reads them. Firing n occurs at
exactly

    start + n * max(rate * 4 ms, minimum interval)

(`conf_sn`, vendor header `Nclient.h` 1.29); firing times are not rounded to timesteps. `start` is
the time of `conf_sn`; at the start of a run the robot has already been on for a while, so that a
complete cycle of the definition's order has just been measured at its initial position. A reading
changes when the echo arrives,

    2 * distance / (speed of sound)

after the firing, or when the sonar stops listening. Because all sonars share one board, that is
when an echo from its maximum range would have arrived or when the next sonar fires, whichever is
earlier. Until then, the previous reading is reported. The vendor does not document the following
cases; crs defines them:

- a rate that would give an interval shorter than the minimum, rate 0 included, selects the minimum;
- `conf_sn` discards the pending ping, and its first sonar fires immediately;
- a sonar that is not in the order reads 255 (no echo); an empty order switches all sonars off.

A reading is the distance from the sensor, which is on the shell, to the nearest object in the beam
that returns an echo, in whole inches; 255 means no echo, because a reading is sent over the serial
line as one byte (vendor source `Ndirect.c` 2.7). The firing robot is taken to be at the position
that its wheels have reached at the time of the firing; all other objects, and a robot that is
blocked, are taken to be at their positions at the start of the timestep. The
attributes below set the errors. Degradation (`sonar`): the degraded distance is reported when an
echo from that distance would arrive; if that echo would arrive too late, the reading is "no echo".
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import (
    BoolArray,
    ComplexArray,
    FloatArray,
    IndexArray,
    Int32Array,
    Int64Array,
    any_of,
)
from crs_cc.core.quantity import LENGTH
from crs_cc.core.units import SOUND_MPS, m_to_tenths_inch
from crs_cc.requests import device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.sensor_order import orders
from crs_cc.sim.devices.sonar.beams import Beams, crosstalk_pings
from crs_cc.sim.devices.sonar.element import read
from crs_cc.sim.devices.sonar.errors import SonarErrors
from crs_cc.sim.devices.sonar.missed import Firings, MissedFirings
from crs_cc.sim.devices.sonar.model import (
    MAX_SONARS,
    SONAR_TICK_S,
    SonarMode,
    Sonars,
    sonars_of,
)
from crs_cc.sim.devices.sonar.simple_firings import KernelTables, SimpleFirings
from crs_cc.sim.devices.sonar.state import SonarState, inches, sonar_state
from crs_cc.sim.devices.sonar.writer import write
from crs_cc.sim.devices.vendor_state import configuration
from crs_cc.sim.geometry.echoes import first_echo
from crs_cc.sim.geometry.pings import Pings
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.degradable import Degradable, at_numbers, elements_of
from crs_cc.sim.model.device import Device

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.geometry.outline_query import ObstacleQuery
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


_ROBOTS_AT_ONCE: Final = 64  # robots per batch when all sonars are computed, which bounds memory
_RATES: Final = 256  # the rate is an unsigned char


class SonarRing:
    """The sonars of all robots of a world: constants and reproducible random numbers.

    Attributes:
        fans: the beams of each kind of robot.
    """

    def __init__(self, row: Device, world: WorldModel, seed: int) -> None:
        models = [robot.model for robot in world.robots]
        kinds = dict.fromkeys(models)
        self.fans = [_fan(mode) for model in kinds for mode in sonars_of(model).modes]
        self._beams = Beams(models)
        self._errors = SonarErrors(self._beams.boards, self._beams.first, seed, row.stream)
        self._simple = SimpleFirings(self._beams, self._errors)
        sonars = [sonars_of(model) for model in models]
        self._has = np.zeros((len(models), MAX_SONARS), dtype=np.bool_)
        for has, each in zip(self._has, sonars, strict=True):
            has[[sonar.id for sonar in each.sonars]] = True
        self._modes = np.array([len(each.modes) if each.sonars else 0 for each in sonars], np.int64)
        self._least_interval_s = np.array([each.board.least_interval_s for each in sonars])

    def begin(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        now_s: float,
    ) -> None:
        """Fire all sonars in the orders just before robots start."""
        sonar = sonar_state(state)
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
        if self._simple.advance(state, constants, rays, rows, to_s):
            return
        while True:
            due = sonar_state(state).next_s[rows] <= to_s
            if not any_of(due):
                break
            firing = rows[due]
            at_s = sonar_state(state).next_s[firing]
            drive.advance(state, constants, firing, np.maximum(at_s, state.drive.clock_s[firing]))
            sonar_state(state).hear(firing, at_s)
            self._fire(state, constants, rays, firing, at_s)
        sonar_state(state).hear(rows, to_s)

    def catch_up(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        to_s: FloatArray,
    ) -> None:
        """Do what `advance` does, in a world that has been at rest since the last firing.

        Only the firings whose echoes are still known are executed, all of them at once.
        """
        sonar = sonar_state(state)
        fires = sonar.next_s[rows] <= to_s
        if constants.degradations.affects(state, "sonar") or not fires.any():
            self.advance(state, constants, rays, rows, to_s)
            return
        firing, until_s = rows[fires], to_s[fires]
        sonar.hear(firing, sonar.next_s[firing])
        places = configuration(state, constants, firing)
        missed = MissedFirings(sonar, firing, until_s)
        while len((which := missed.take())[0]):
            missed.hear(which, *self._echoes(state, constants, rays, which[-1]), places)
        missed.end()
        sonar.hear(rows, to_s)

    def ranges_now_m(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> FloatArray:
        """Return the ranges that all sonars would report if they fired at `at_s` [m], (k, 16)."""
        distance_m = self._around(state, rays, rows, *self._ring_poses(state, constants, rows))
        reported_m = np.empty_like(distance_m)
        for number in range(MAX_SONARS):
            deviates = self._errors.draw(rows, sonar_state(state).count[rows])
            reported_m[:, number] = self._reported_m(
                state, constants, (rows, number, at_s), distance_m[:, number], deviates
            )
            sonar_state(state).count[rows] += 1
        return reported_m

    def is_simple(self, rays: RayCaster) -> bool:
        """Return whether kernels know all that echoes depend on, see `SimpleFirings`."""
        return self._simple.know(rays)

    def kernel_tables(self) -> KernelTables:
        """Return the input of the calm-time kernel."""
        return self._simple.tables()

    def draw(self, rows: IndexArray, numbers: Int64Array) -> FloatArray:
        """Return the deviates of one firing of each of some robots, (k, 3)."""
        return self._errors.draw(rows, numbers)

    def get_ranges(self, context: RequestContext) -> BoolArray:
        """Answer SONAR and SONAR_RANGES in 0.1 in, -1 for no echo; refuse robots without sonars."""
        state, constants, rows = context.state, context.constants, context.rows
        echo_m = sonar_state(state).echo_m[rows]
        has = np.asarray(self._has[rows].any(axis=1))
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
        return np.asarray(self._has[context.rows].any(axis=1))

    def conf_sn(self, context: RequestContext) -> BoolArray:
        """Set the firing order and rate; refuse an order with a missing sonar.

        The first one in the order fires at once.
        """
        state, constants = context.state, context.constants
        order, given, good = orders(context["count"], context["order"], MAX_SONARS)
        has = self._has[context.rows]
        known = np.take_along_axis(has, np.minimum(order, MAX_SONARS - 1), axis=1)
        good &= has.any(axis=1) & (known | ~given).all(axis=1)
        rows, order, given = context.rows[good], order[good], given[good]
        interval_s = context["rate"][good] % _RATES * SONAR_TICK_S
        sonar_state(state).interval_s[rows] = np.maximum(interval_s, self._least_interval_s[rows])
        sonar_state(state).reorder(
            rows, np.where(given, order, 0), given.sum(axis=1), state.drive.clock_s[rows]
        )
        until_s = np.minimum(context.at_s[good], constants.last_time_s(state.cycle))
        self.advance(state, constants, context.rays, rows, until_s)
        return good

    def set_mode(self, context: RequestContext) -> BoolArray:
        """Select a mode for the next pings of a robot's sonars; refuse unknown modes."""
        mode = context["mode"]
        good = np.asarray((mode >= 0) & (mode < self._modes[context.rows]))
        sonar_state(context.state).mode[context.rows[good]] = mode[good]
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
        return inches(self._around(state, rays, rows, place, exact.turn(poses[:, 2])))

    def _fire(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Send a ping from each of some robots."""
        sonar = sonar_state(state)
        number = sonar.order[rows, sonar.turn[rows] % sonar.length[rows]]
        firings = Firings(rows, number, sonar.count[rows], at_s)
        heard_s, heard_m = self._echoes(state, constants, rays, firings)
        sonar.listening[rows] = number
        sonar.sent_s[rows] = at_s
        sonar.sent_from[rows] = configuration(state, constants, rows)
        sonar.heard_s[rows] = heard_s
        sonar.heard_m[rows] = heard_m
        sonar.count[rows] += 1
        sonar.turn[rows] += 1
        sonar.next_s[rows] = sonar.start_s[rows] + sonar.turn[rows] * sonar.interval_s[rows]

    def _echoes(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        firings: Firings,
    ) -> tuple[FloatArray, FloatArray]:
        """Return when the echoes of firings are heard, and their distances [m], (k,) each.

        Without an echo, the time at which the sonar stops listening, and infinity.
        """
        rows, number, before, at_s = firings
        sonar = sonar_state(state)
        place, turn = self._ring_poses(state, constants, rows)
        pings = self._beams.pings(rows, number, place, turn, sonar.mode[rows])
        gives_up_s = np.minimum(2 * pings.range_m / SOUND_MPS, sonar.interval_s[rows])
        deviates = self._errors.draw(rows, before)
        affected = self._errors.affected_by_crosstalk(rows, sonar.mode[rows], deviates)
        crosstalk = None
        if len(affected):
            from_s, to_s = at_s[affected], (at_s + gives_up_s)[affected]
            crosstalk = crosstalk_pings(
                state, self._beams, pings, affected, from_s=from_s, to_s=to_s
            )
        shapes = self._shapes_hit(state, rays, pings, number)
        distance_m = first_echo(pings, shapes, crosstalk, rays.surfaces.echo_range)
        reported_m = self._reported_m(state, constants, (rows, number, at_s), distance_m, deviates)
        in_time = 2 * reported_m / SOUND_MPS <= gives_up_s
        heard_s = at_s + np.where(in_time, 2 * reported_m / SOUND_MPS, gives_up_s)
        return heard_s, np.where(in_time, reported_m, np.inf)

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
        reported_m = self._errors.reported_m(
            rows, sonar_state(state).mode[rows], distance_m, deviates
        )
        if not constants.degradations.affects(state, "sonar"):
            return reported_m
        elements = np.broadcast_to(number, rows.shape)
        reported_m = constants.degradations.alter(
            state, "sonar", rows, reported_m[:, None], at_s, elements=elements
        )[:, 0]
        return np.where(np.isnan(reported_m), np.inf, np.maximum(reported_m, 0.0))

    def _ring_poses(
        self, state: EnvState, constants: RobotConstants, rows: IndexArray
    ) -> tuple[ComplexArray, ComplexArray]:
        """Return positions of robots and directions of their rings' fronts."""
        x_m, y_m, angle_rad = mount_poses(state, constants, rows).T
        return x_m + 1j * y_m, exact.turn(angle_rad)

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
        mode = sonar_state(state).mode[rows[each]]
        pings = self._beams.pings(rows[each], number, place[each], turn[each], mode)
        shapes = self._shapes_hit(state, rays, pings, number)
        heard_m = first_echo(pings, shapes, echo_range=rays.surfaces.echo_range)
        return heard_m.reshape(-1, MAX_SONARS)

    def _shapes_hit(
        self, state: EnvState, rays: RayCaster, pings: Pings, number: IndexArray
    ) -> ObstacleQuery:
        """Return what pings of the sonars with these numbers can hit."""
        if rays.all_alike:
            return rays.obstacles(state)
        z_m = self._beams.z_m(pings.own, number)
        return rays.shapes_at_height(state, z_m, exact.tan(pings.half_rad))


@lru_cache(maxsize=64)
def _fan(model: SonarMode) -> Fan:
    return Fan.of(
        (sonar.x_m, sonar.y_m, sonar.direction_rad, sonar.half_angle_rad, sonar.range_m)
        for sonar in model.sonars
    )


def install(row: Device, world: WorldModel, seed: int, _log: EventLog) -> Installed:
    """Return the sonars of a world's robots."""
    ring = SonarRing(row, world, seed)
    handlers = {
        "CONF_SN": ring.conf_sn,
        "GET_SN": ring.get_sn,
        "SONAR": ring.get_ranges,
        "SONAR_MODE": ring.set_mode,
        "SONAR_RANGES": ring.get_ranges,
    }
    return Installed(handlers=handlers, fans=ring.fans, device=ring)


DEVICE = Device(
    name="sonar",
    title="Sonar",
    element="sonars",
    summary="Properties of all sonars.",
    model=Sonars,
    read=read,
    write=write,
    state=SonarState.at_start,
    dense=True,
    install=install,
    requests=(
        device_request(
            "SONAR_MODE", 207, "int crs_sonar_mode(int mode)", "selects a mode of the sonars",
            fields(("mode", "i[0]", "1", "the mode's number in the definition")),
        ),
        device_request(
            "SONAR_RANGES", 208, "int crs_sonar(int *ranges, int most)", "reads all sonars",
            fields(("fire", "i[0]", "1", "0 for the last echoes, else all fire now")),
            results=fields(
                ("ranges", "data", "0.1 in", "range of each sonar, -1 for no echo", "int32")
            ),
        ),
    ),
    functions=(
        Function(
            "int crs_sonar_mode(int mode)",
            "selects an operating mode of the sonars from the robot definition, effective from the"
            " next ping of each sonar",
            posts=("SONAR_MODE",), source=(OURS,),
        ),
        Function(
            "int crs_sonar(int *ranges, int most)",
            "copies the current readings of the sonars, -1 for no echo; returns the number of"
            " readings copied, at most `most`",
            units="0.1 in", posts=("SONAR_RANGES",), source=(OURS,),
        ),
    ),
    degradables=(
        Degradable(
            "sonar", "distance measured by a sonar", LENGTH,
            elements_of("sonar", lambda model: at_numbers([each.id for each in model.sonars])),
            MAX_SONARS, "there is no echo",
        ),
    ),
    reading=lambda state, _model, robot: sonar_state(state).echo_m[robot],
    stream=0,
    source=__file__,
)  # fmt: skip
