"""What lasers do: scans, and the readings that are made of them."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.core.units import m_to_tenths_inch
from crs_cc.requests import LARGEST
from crs_cc.sim.devices import range_scan
from crs_cc.sim.devices.laser.model import NUM_LASER, Laser, LaserState, laser_state
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.sensor import Measurement, Sensor
from crs_cc.sim.devices.vendor_state import configuration
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.split_and_merge import segments

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.device import Device
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.paged_reply import PagedReply


_POINT: Final = 2
_SEGMENT: Final = 4
_WIDTHS: Final = {"GET_LS": _POINT, "GET_SG": _SEGMENT}
"""Numbers per reading; requests whose replies have one kind of reading in all modes."""

_ON: Final = 1
_POINT_MODES: Final = (19, 51)
_SEGMENT_MODES: Final = (1, 33)


class Lasers:
    """The lasers of all robots that have one.

    Attributes:
        sensor: what they have in common with other sensors.
        installed: what they do.
    """

    def __init__(self, row: Device, world: WorldModel, seed: int) -> None:
        found = [robot.model.device(row.name) for robot in world.robots]
        self._models: list[Laser] = [laser for laser in found if laser is not None]
        self._fans: dict[tuple[Laser, int], Fan] = {}
        self.sensor = Sensor(
            row, world, seed, self._measure, NUM_LASER, errors=_errors,
            is_on=lambda state: _is_on(laser_state(state).mode),
            readings=lambda state: laser_state(state).readings,
        )  # fmt: skip
        handlers = {
            "CONF_LS": self.conf_ls,
            "CONF_SG": conf_sg,
            "GET_LS": self.get_laser,
            "GET_SG": self.get_laser,
            "LASER_PAGE": page,
            "LASER": self.get_ranges,
        }
        fans = [self._fan(laser, laser.points) for laser in dict.fromkeys(self._models)]
        installed = self.sensor.installed(handlers, fans, lambda state: laser_state(state).told)
        self.installed = dataclasses.replace(installed, device=self)

    def _fan(self, laser: Laser, points: int) -> Fan:
        if (laser, points) not in self._fans:
            directions = _directions(laser, points).tolist()
            beams = ((laser.forward_m, 0.0, each, 0.0, laser.range_m) for each in directions)
            self._fans[laser, points] = Fan.of(beams, laser.z_m)
        return self._fans[laser, points]

    def _measure(self, now: Measurement) -> FloatArray:
        """Return the ranges [m], their number, and the configuration, (k, 490)."""
        numbers = now.constants.numbers["laser"][now.rows]
        poses = mount_poses(now.state, now.constants, now.rows)
        return np.column_stack(
            [
                self._ranges_m(now.state, now.rays, now.rows, numbers, poses),
                laser_state(now.state).wanted[numbers],
                configuration(now.state, now.constants, now.rows),
            ]
        )

    def _ranges_m(
        self,
        state: EnvState,
        rays: RayCaster,
        rows: IndexArray,
        numbers: IndexArray,
        poses: FloatArray,
    ) -> FloatArray:
        """Return what the lasers of robots see from poses, infinite for nothing, (k, 482)."""
        pairs = zip(numbers.tolist(), laser_state(state).wanted[numbers].tolist(), strict=True)
        fans = [self._fan(self._models[number], wanted) for number, wanted in pairs]
        range_m = np.full((len(rows), NUM_LASER), np.inf)
        for fan, some in range_scan.distinct(fans):
            seen_m = rays.distances_m(state, fan, poses[some], own=rows[some])
            range_m[some, : len(fan)] = seen_m
        return range_m

    def get_laser(self, context: RequestContext) -> BoolArray:
        """Answer GET_LS and GET_SG: scan, for the pages; refuse robots without a laser.

        The reply has the number of readings, see `reply`.
        """
        return self.sensor.asked(context)[0]

    def get_ranges(self, context: RequestContext) -> BoolArray:
        """Answer LASER with the number of ranges, which are kept for READINGS.

        Refuse lasers that are off or missing.
        """
        has, numbers = self.sensor.asked(context)
        laser = laser_state(context.state)
        on = _is_on(laser.mode[numbers])
        has[has] = on
        places = np.flatnonzero(has).tolist()
        for place, number in zip(places, numbers[on].tolist(), strict=True):
            wanted = int(laser.wanted[number])
            range_m = laser.readings.value[number, :wanted]
            measured = laser.readings.value[number, NUM_LASER]
            seen = np.isfinite(range_m) & (np.arange(wanted) < measured)
            tenths = np.rint(m_to_tenths_inch(np.where(seen, range_m, 0.0)))
            laser.told.keep(number, 1, np.where(seen, tenths, -1))
            context.put("count", wanted, place)
        return has

    def conf_ls(self, context: RequestContext) -> BoolArray:
        """Set the mode and the number of points; refuse modes that report pixels."""
        mode, numbers = context["mode"], context.constants.numbers["laser"][context.rows]
        known = ~_is_on(mode) | np.isin(mode, _POINT_MODES + _SEGMENT_MODES)
        good: BoolArray = (numbers >= 0) & known
        numbers, laser = numbers[good], laser_state(context.state)
        points = context["points"][good].view(np.uint32)
        most = self.sensor.settings["points"][numbers]
        laser.mode[numbers] = mode[good]
        laser.wanted[numbers] = np.where(points == 0, most, np.minimum(points, most))
        laser.averaged[numbers] = np.clip(context["averaged"][good].view(np.uint32), 1, NUM_LASER)
        laser.readings.at_s[numbers] = -np.inf  # the next scan has other directions
        return good

    def reply(self, context: RequestContext, masked: BoolArray) -> Int32Array:
        """Keep the last scans for the pages; return the number of readings of each, (k,).

        Args:
            context: the requests.
            masked: which programs' masks include the laser, (k,).
        """
        numbers = context.constants.numbers["laser"][context.rows]
        width = _WIDTHS.get(context.request.name)
        requested = (numbers >= 0) & (masked | (width is not None))
        laser, mine = laser_state(context.state), numbers[requested]
        counts = np.zeros(len(context), dtype=np.int32)
        value = laser.readings.value[mine]
        self._keep(laser, laser.told, mine, value[:, :NUM_LASER], value[:, NUM_LASER], width=width)
        counts[requested] = laser.told.count[mine]
        return counts

    def predict(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        poses: FloatArray,
    ) -> Int32Array:
        """Scan without errors from other poses, for the pages; return the numbers of readings.

        Args:
            state: has the poses of all objects, and what the programs have set; keeps the scans.
            constants: the robots' constants.
            rays: casts rays.
            rows: the robots, k of them.
            poses: x, y [m] and direction [rad] of each mount, shape (k, 3).
        """
        numbers = constants.numbers["laser"][rows]
        counts, has = np.zeros(len(rows), dtype=np.int32), numbers >= 0
        laser, mine = laser_state(state), numbers[has]
        range_m = self._ranges_m(state, rays, rows[has], mine, poses[has])
        self._keep(laser, laser.predicted, mine, range_m, laser.wanted[mine])
        counts[has] = laser.predicted.count[mine]
        return counts

    def _keep(
        self,
        laser: LaserState,
        told: PagedReply,
        numbers: IndexArray,
        range_m: FloatArray,
        counts: npt.NDArray[np.number],
        *,
        width: int | None = None,
    ) -> None:
        """Store the readings of scans for the pages that the client will request.

        Args:
            laser: what the programs have set.
            told: their storage, changed in place.
            numbers: which lasers, k of them.
            range_m: their ranges, (k, 482).
            counts: number of ranges of each, (k,).
            width: what they report, `_POINT` or `_SEGMENT`; None for what the mode selects.
        """
        counts = np.where(_is_on(laser.mode[numbers]), counts, 0)
        for place, number in enumerate(numbers.tolist()):
            points = _points(self._models[number], range_m[place, : int(counts[place])])
            has_segments = int(laser.mode[number]) in _SEGMENT_MODES
            if (width or (_SEGMENT if has_segments else _POINT)) == _POINT:
                told.keep(number, _POINT, points)
            else:
                threshold, min_points, gap = laser.segments[number].tolist()
                found = segments(points, threshold, min_points, gap)
                told.keep(number, _SEGMENT, np.rint(found))


def _points(laser: Laser, range_m: FloatArray) -> FloatArray:
    """Return x and y of a scan's points [0.1 in], ahead and left of the mount's centre, (n, 2)."""
    hit = np.isfinite(range_m)
    seen_m, direction = range_m[hit], _directions(laser, len(range_m))[hit]
    x_m, y_m = laser.forward_m + seen_m * np.cos(direction), seen_m * np.sin(direction)
    return np.asarray(np.rint(m_to_tenths_inch(np.column_stack([x_m, y_m]))))


def _directions(laser: Laser, points: int) -> FloatArray:
    """Return the directions of the points, from right to left [rad]."""
    places = np.arange(points) - (points - 1) / 2
    return np.asarray(places * (laser.field_of_view_rad / max(points, 1)))


def _errors(now: Measurement, range_m: FloatArray, deviates: FloatArray) -> FloatArray:
    """Return ranges with errors, less for more averaged pixels."""
    averaged = laser_state(now.state).averaged[now.constants.numbers["laser"][now.rows]]
    return range_scan.triangulated(now, range_m, deviates / np.sqrt(averaged)[:, None])


def _is_on(mode: npt.NDArray[np.integer]) -> BoolArray:
    """Return which modes are those of a laser that is on."""
    return np.asarray(mode & _ON != 0)


def page(context: RequestContext) -> BoolArray:
    """Answer LASER_PAGE with a page of what a reply announced; refuse robots without a laser."""
    laser, mine = laser_state(context.state), context.constants.numbers["laser"][context.rows]
    good = np.asarray(mine >= 0)
    first, predicted = context["first"].tolist(), context["predicted"].tolist()
    context.clear_data()
    for place in np.flatnonzero(good).tolist():
        told = laser.predicted if predicted[place] else laser.told
        told.page(mine[place], first[place], context.messages[place])
    return good


def conf_sg(context: RequestContext) -> BoolArray:
    """Set the parameters by which points become segments."""
    mine = context.constants.numbers["laser"][context.rows]
    good = np.asarray(mine >= 0)
    wanted = context.columns("threshold", "min_points", "gap")[good].view(np.uint32)
    laser_state(context.state).segments[mine[good]] = np.minimum(wanted, LARGEST)
    return good
