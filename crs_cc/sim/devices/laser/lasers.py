"""Lasers: scans, and the readings derived from them."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.core.distinct import distinct
from crs_cc.core.units import m_to_tenths_inch
from crs_cc.requests import LARGEST
from crs_cc.sim.devices import range_scan
from crs_cc.sim.devices.laser.model import NUM_LASER, Laser, LaserState, laser_state
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.sensor import Measurement, Sensor
from crs_cc.sim.devices.vendor_state import configuration
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.split_and_merge import segments
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.robot import devices_of
from crs_cc.sim.state.last_measurement import CONFIGURATION
from crs_cc.sim.state.rows import simplest

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
        found = devices_of([robot.model for robot in world.robots], row.name)
        models: list[Laser] = [laser for laser in found if laser is not None]
        self._kinds, self._kind = distinct(models)
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
        fans = [self._fan(laser, laser.points) for laser in self._kinds]
        installed = self.sensor.installed(handlers, fans, lambda state: laser_state(state).reply)
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
        value = np.empty((len(numbers), NUM_LASER + 1 + CONFIGURATION))
        self._scan(now.state, now.rays, now.rows, numbers, poses,
                   range_m=value[:, :NUM_LASER])  # fmt: skip
        value[:, NUM_LASER] = laser_state(now.state).wanted[numbers]
        value[:, NUM_LASER + 1 :] = configuration(now.state, now.constants, now.rows)
        return value

    def _scan(
        self,
        state: EnvState,
        rays: RayCaster,
        rows: IndexArray,
        numbers: IndexArray,
        poses: FloatArray,
        *,
        range_m: FloatArray,
    ) -> None:
        """Write the ranges of robots' lasers at poses, infinite for none, (k, 482)."""
        for laser, points, some in self._alike(numbers, laser_state(state).wanted[numbers]):
            seen_m = rays.distances_m(state, self._fan(laser, points), poses[some], own=rows[some])
            which = simplest(some, len(range_m))
            range_m[which, :points], range_m[which, points:] = seen_m, np.inf

    def _alike(
        self, numbers: IndexArray, points: npt.NDArray[np.integer]
    ) -> Iterator[tuple[Laser, int, IndexArray]]:
        """Yield the places of lasers of one kind with the same number of points."""
        for key, some in range_scan.alike(self._kind[numbers] * (NUM_LASER + 1) + points):
            kind, wanted = divmod(key, NUM_LASER + 1)
            yield self._kinds[kind], wanted, some

    def get_laser(self, context: RequestContext) -> BoolArray:
        """Answer GET_LS and GET_SG: scan, for the pages; refuse robots without a laser.

        The reply has the number of readings, see `reply`.
        """
        return self.sensor.measure_on_request(context)[0]

    def get_ranges(self, context: RequestContext) -> BoolArray:
        """Answer LASER with the number of ranges, which are kept for READINGS.

        Refuse lasers that are off or missing.
        """
        has, numbers = self.sensor.measure_on_request(context)
        laser = laser_state(context.state)
        on = _is_on(laser.mode[numbers])
        has[has] = on
        numbers = numbers[on]
        wanted, value = laser.wanted[numbers], laser.readings.value
        range_m = value[numbers, : int(wanted.max(initial=0))]
        measured = np.arange(range_m.shape[1]) < value[numbers, NUM_LASER, None]
        seen = np.isfinite(range_m) & measured
        tenths = np.rint(m_to_tenths_inch(np.where(seen, range_m, 0.0)))
        tenths = np.where(seen, tenths, -1).astype(np.int32)
        laser.reply.keep(numbers, 1, wanted, tenths[:, :, None])
        context.put("count", wanted, has)
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
        value = laser.readings.value
        points = value[mine, NUM_LASER].astype(np.intp)
        range_m = value[mine, : int(points.max(initial=0))]
        self._keep(laser, laser.reply, mine, range_m, points, width=width)
        counts[requested] = laser.reply.count[mine]
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
        range_m = np.empty((len(mine), NUM_LASER))
        self._scan(state, rays, rows[has], mine, poses[has], range_m=range_m)
        self._keep(laser, laser.predicted, mine, range_m, laser.wanted[mine])
        counts[has] = laser.predicted.count[mine]
        return counts

    def _keep(
        self,
        laser: LaserState,
        reply: PagedReply,
        numbers: IndexArray,
        range_m: FloatArray,
        counts: npt.NDArray[np.number],
        *,
        width: int | None = None,
    ) -> None:
        """Store the readings of scans for the pages that the client will request.

        Args:
            laser: what the programs have set.
            reply: their storage, changed in place.
            numbers: which lasers, k of them.
            range_m: their ranges, (k, most).
            counts: number of ranges of each, (k,).
            width: what they report, `_POINT` or `_SEGMENT`; None for what the mode selects.
        """
        on, has_segments = _is_on(laser.mode[numbers]), np.isin(laser.mode[numbers], _SEGMENT_MODES)
        points, counts = self._points(numbers, range_m, np.where(on, counts, 0).astype(np.intp))
        if width is not None:
            has_segments[:] = width == _SEGMENT
        some = np.flatnonzero(~has_segments)
        reply.keep(numbers[some], _POINT, counts[some], points[some])
        for place in np.flatnonzero(has_segments).tolist():
            threshold, min_points, gap = laser.segments[numbers[place]].tolist()
            scan = points[place, : counts[place]].astype(np.float64)
            found = segments(scan, threshold, min_points, gap)
            count = np.array([len(found)])
            reply.keep(numbers[place, None], _SEGMENT, count, np.rint(found)[None])

    def _points(
        self, numbers: IndexArray, range_m: FloatArray, counts: IndexArray
    ) -> tuple[Int32Array, IndexArray]:
        """Return x and y of scans' points [0.1 in], ahead and left of the mount's centre.

        Args:
            numbers: which lasers, k of them.
            range_m: their ranges, (k, most).
            counts: number of ranges of each, (k,).

        Returns:
            the points, from right to left, (k, most, 2), and their numbers, (k,).
        """
        most = int(counts.max(initial=0))
        range_m = np.ascontiguousarray(range_m[:, :most])
        hit = np.isfinite(range_m) & (np.arange(most) < counts[:, None])
        kind, directions = np.zeros(len(numbers), dtype=np.intp), []
        for number, (laser, count, some) in enumerate(self._alike(numbers, counts)):
            kind[some] = number
            directions.append(np.pad(_directions(laser, count), (0, most - count)))
        direction, counts = np.concatenate([[], *directions]), hit.sum(axis=1)
        places, row = np.flatnonzero(hit), np.repeat(np.arange(len(numbers)), counts)
        seen_m = range_m.take(places)
        forward_m = self.sensor.settings["forward_m"][numbers].take(row)
        first = np.cumsum(counts) - counts
        begin = np.arange(len(numbers)) * most
        beam = places - (begin - kind * most).take(row)
        to = np.arange(len(row)) + (begin - first).take(row)
        points = np.zeros((*hit.shape, _POINT), dtype=np.int32)
        flat = points.reshape(-1, _POINT)
        x_m = forward_m + seen_m * exact.cos(direction).take(beam)
        flat[to, 0] = np.rint(m_to_tenths_inch(x_m))
        flat[to, 1] = np.rint(m_to_tenths_inch(seen_m * exact.sin(direction).take(beam)))
        return points, counts


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
    """Answer LASER_PAGE with a page of an announced reading; reject robots without a laser."""
    laser, mine = laser_state(context.state), context.constants.numbers["laser"][context.rows]
    first, predicted = context["first"].copy(), context["predicted"] != 0
    context.clear_data()
    for reply, is_predicted in ((laser.reply, False), (laser.predicted, True)):
        places = np.flatnonzero((mine >= 0) & (predicted == is_predicted))
        reply.page(mine[places], first[places], context.messages, places)
    return np.asarray(mine >= 0)


def conf_sg(context: RequestContext) -> BoolArray:
    """Set the parameters by which points become segments."""
    mine = context.constants.numbers["laser"][context.rows]
    good = np.asarray(mine >= 0)
    wanted = context.columns("threshold", "min_points", "gap")[good].view(np.uint32)
    laser_state(context.state).segments[mine[good]] = np.minimum(wanted, LARGEST)
    return good
