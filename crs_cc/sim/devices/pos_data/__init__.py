"""Positions attached to readings: where the robot was, and when, as each sensor was read.

    PosData = State[34] to State[40] at the instant of the reading, the time of that, the time of
              the reading

in the units of `State` and in ms of the sensor board (vendor header `Nclient.h` 1.29); both times
are equal here. A program requests them by the bits of `Smask[0]` for kinds of sensors; replies with
readings of these then contain them: for sonars at the ping of each reading, for bumpers at the last
hit, for the others at the last measurement. Entries of missing devices, and of those without a
reading yet, are 0. A copy of the last reply is kept, as the client requests it in pages.

No degradation.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int32Array
from crs_cc.requests.request import BUMPER, INFRARED, LASER, SONAR
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.compass import compasses
from crs_cc.sim.devices.infrared import rings
from crs_cc.sim.devices.laser.model import last_scan
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.state.mask import POS_DATA
from crs_cc.sim.state.pos_data import NUMBERS, PLACES

if TYPE_CHECKING:
    from crs_cc.sim.devices.clock import BoardClock
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.last_measurement import LastMeasurement


_PAGE: Final = 6


def keep(
    state: EnvState, constants: RobotConstants, clock: BoardClock, rows: IndexArray, kinds: int
) -> None:
    """Store the data of a reply, for the pages.

    Args:
        state: changed in place.
        constants: the robots' constants.
        clock: the sensor boards' clocks.
        rows: the robots, k of them.
        kinds: the kinds of sensors whose readings the reply carries, as the vendor's bits.
    """
    if not len(state.pos_data.reported):
        return
    wanted = state.mask[rows, POS_DATA] & kinds
    if not np.count_nonzero(wanted):
        return
    for kind, places in PLACES.items():
        robots = rows[wanted & kind != 0]
        if len(robots):
            at_s, configuration = _read(state, constants, robots, kind)
            _copy(state, clock, robots, places, (at_s, configuration))


def page(context: RequestContext) -> None:
    """Answer POS_DATA with a page of the last reply's data of one kind of sensor."""
    kept, kinds, first = context.state.pos_data, context["kind"], context["first"]
    context["count"] = 0
    context.clear_data()
    pages = zip(kept.row[context.rows].tolist(), kinds.tolist(), first.tolist(), strict=True)
    for place, (row, kind, start) in enumerate(pages):
        if row < 0 or kind not in PLACES or start < 0:
            continue
        part = kept.reported[row, PLACES[kind]][start : start + _PAGE]
        context.put("count", len(part), place)
        context.put_data(part.ravel(), place)


def _read(
    state: EnvState, constants: RobotConstants, robots: IndexArray, kind: int
) -> tuple[FloatArray, Int32Array]:
    """Return the times of sensors' readings, (k, s), below 0 for never, and poses, (k, s, 7)."""
    if kind == SONAR:
        sonar = sonar_state(state)
        return sonar.fired_s[robots], sonar.fired_from[robots]
    if kind == BUMPER:
        return _last(bumper_state(state).hit, robots)
    if kind == INFRARED:
        return _last(rings(state).measured, constants.numbers["infrared"][robots])
    if kind == LASER:
        return _last(last_scan(state), constants.numbers["laser"][robots])
    return _last(compasses(state).measured, constants.numbers["compass"][robots])


def _last(moments: LastMeasurement, numbers: IndexArray) -> tuple[FloatArray, Int32Array]:
    """Return the last measurement of each robot, number -1 where the sensor is missing."""
    at_s = np.full((len(numbers), 1), -1.0)
    configuration = np.zeros((len(numbers), 1, moments.configuration.shape[1]), dtype=np.int32)
    has = numbers >= 0
    at_s[has, 0] = moments.at_s[numbers[has]]
    configuration[has, 0] = moments.configuration[numbers[has]]
    return at_s, configuration


def _copy(
    state: EnvState,
    clock: BoardClock,
    robots: IndexArray,
    places: slice,
    read: tuple[FloatArray, Int32Array],
) -> None:
    at_s, configuration = read
    once = at_s >= 0.0
    since_s = np.where(once, at_s - state.presence.joined_s[robots, None], 0.0)
    ms = clock.ms(robots[:, None], since_s).astype(np.uint32).view(np.int32)
    reported = np.zeros((*at_s.shape, NUMBERS), dtype=np.int32)
    reported[..., : NUMBERS - 2] = configuration
    reported[..., NUMBERS - 2 :] = ms[..., None]
    reported[~once] = 0
    state.pos_data.reported[state.pos_data.row[robots], places] = reported
