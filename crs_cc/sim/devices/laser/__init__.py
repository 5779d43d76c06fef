"""The laser: a plane of light observed by a camera on the turret.

    point n = distance along direction n from the sensor, for n from 0 to points - 1
    direction n = (n - (points - 1) / 2) * field of view / points       (0 for a single point)

Directions are counter-clockwise, from right to left, centred on the front of the turret; a
direction without an object in range has no point. Points are x and y in 0.1 inch, forward and left
of the centre of the turret (vendor header `Nclient.h` 1.29; that the frame is that of the turret,
which carries the sensor, was chosen by us). `conf_ls` can request fewer points than the 482 of the
vendor's array. Modes are the vendor's: bit 0 on, bit 1 points instead of segments; the rest of its
client (`Nclient.c` 2.7) accepts 19 and 51 for points, and 1 and 33 for segments. The other modes
return pixels, which the vendor's simulator did not support, and are rejected. Brightness and width
of the line (`threshold`, `width`) are ignored.

Segments are computed from the points by split and merge (`segments`), with the parameters of
`conf_sg`. `get_ls` returns points and `get_sg` segments in every mode; states contain what the mode
selects, unless the mask excludes the laser. A laser that is off returns nothing. The returned
readings are kept for the pages (LASER_PAGE) that the client requests.

It measures when a reply contains its readings, at most thirty times a second (vendor header), or on
its timer (`timers`). Noise: a normal deviate is added to each distance; its standard deviation is
the definition's noise at 1 m and grows with the square of the distance, as for triangulation;
averaging p pixels divides it by sqrt(p). Degradation (`laser`) applies to the distances; a dropped
distance has no point.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.core.random_streams import LASER, Noise
from crs_cc.core.units import m_to_tenths_inch
from crs_cc.requests import LARGEST
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.devices.vendor_state import configuration
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.split_and_merge import segments
from crs_cc.sim.model.sensors import NUM_LASER
from crs_cc.sim.state import timers
from crs_cc.sim.state.paged_reply import PagedReply

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.sensors import Laser
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


POINTS: Final = 2
SEGMENTS: Final = 4
"""Numbers per reading."""

_ON: Final = 1
_POINT_MODES: Final = (19, 51)
_SEGMENT_MODES: Final = (1, 33)


class Lasers:
    """The lasers of all robots that have one.

    Attributes:
        fans: the beams of each kind of laser, with all its points.
        interval_s: minimum time between two scans of each.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        found = [laser for robot in world.robots if (laser := robot.model.laser) is not None]
        self._models = found
        self.interval_s = np.array([1.0 / laser.rate_hz for laser in found])
        self._noise_per_m = np.array([laser.noise_m for laser in found])
        self._noise = Noise(
            seed, LASER, NUM_LASER, len(world.robots) if self._noise_per_m.any() else 0
        )
        self._cut: dict[tuple[Laser, int], Fan] = {}
        self.fans = [self._fan(laser, laser.points) for laser in dict.fromkeys(found)]

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Scan with the lasers that are on and may scan again.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: casts rays.
            rows: the robots, k of them, whose axes were turned to `at_s`.
            at_s: the time of each, shape (k,).
        """
        laser = state.laser
        mine = constants.laser[rows]
        due = laser.measured.are_due(mine, at_s, self.interval_s) & is_on(laser.mode[mine])
        if not due.any():
            return
        rows, mine = rows[due], mine[due]
        laser.points[mine], laser.seen[mine], laser.ranges[mine] = self.look(
            state, constants, rays, rows, mount_poses(state, constants, rows), at_s=at_s[due]
        )
        laser.count[mine] += 1
        laser.measured.note(mine, at_s[due], configuration(state, constants, rows))

    def look(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        poses: FloatArray,
        *,
        at_s: FloatArray | None = None,
    ) -> tuple[Int32Array, Int32Array, Int32Array]:
        """Return the points that the lasers of robots see from poses.

        Args:
            state: has what the programs have set.
            constants: the robots' constants.
            rays: casts rays.
            rows: robots with a laser, k of them.
            poses: x, y [m] and direction [rad] of each mount, shape (k, 3).
            at_s: the time of each, shape (k,); None for a scan without errors.

        Returns:
            the number of points of each, shape (k,); their x and y [0.1 in], shape (k, 964); and
            the range in each direction [0.1 in], -1 for none, shape (k, 482).
        """
        mine = constants.laser[rows]
        counts = np.zeros(len(rows), dtype=np.int32)
        numbers = np.zeros((len(rows), 2 * NUM_LASER), dtype=np.int32)
        ranges = np.full((len(rows), NUM_LASER), -1, dtype=np.int32)
        kinds = [(self._models[number], int(state.laser.wanted[number])) for number in mine]
        for kind in dict.fromkeys(kinds):
            some = np.array([place for place, each in enumerate(kinds) if each == kind])
            distance_m = rays.distances_m(state, self._fan(*kind), poses[some], own=rows[some])
            if at_s is not None:
                distance_m += self._errors_m(state, rows[some], mine[some], distance_m)
                distance_m = constants.degradations.alter(
                    state, "laser", rows[some], distance_m, at_s[some]
                )
            directions = _directions(*kind)
            for place, seen_m in zip(some, distance_m, strict=True):
                hit = np.isfinite(seen_m)
                x_m = kind[0].forward_m + seen_m[hit] * np.cos(directions[hit])
                y_m = seen_m[hit] * np.sin(directions[hit])
                points = np.rint(m_to_tenths_inch(np.column_stack([x_m, y_m])))
                counts[place] = len(points)
                numbers[place, : points.size] = points.ravel()
                ranges[place, np.flatnonzero(hit)] = np.rint(m_to_tenths_inch(seen_m[hit]))
        return counts, numbers, ranges

    def get_laser(self, context: RequestContext) -> BoolArray:
        """Answer GET_LS and GET_SG: scan, for the pages; refuse robots without a laser.

        The reply has the number of readings, see `SensorBoard`.
        """
        has = np.asarray(context.constants.laser[context.rows] >= 0)
        read_on_request(context, self.read, timers.LASER, has)
        return has

    def get_ranges(self, context: RequestContext) -> BoolArray:
        """Answer LASER with the number of ranges, which are kept for READINGS.

        Refuse lasers that are off or missing.
        """
        laser = context.state.laser
        mine = context.constants.laser[context.rows]
        good = np.asarray(mine >= 0)
        good[good] = is_on(laser.mode[mine[good]])
        read_on_request(context, self.read, timers.LASER, good)
        for place in np.flatnonzero(good).tolist():
            number = mine[place]
            wanted = int(laser.wanted[number])
            laser.told.keep(number, 1, laser.ranges[number, :wanted])
            context.put("count", wanted, place)
        return good

    def _fan(self, laser: Laser, points: int) -> Fan:
        if (laser, points) not in self._cut:
            directions = _directions(laser, points).tolist()
            beams = ((laser.forward_m, 0.0, each, 0.0, laser.range_m) for each in directions)
            self._cut[laser, points] = Fan.of(beams, laser.z_m)
        return self._cut[laser, points]

    def _errors_m(
        self, state: EnvState, rows: IndexArray, mine: IndexArray, distance_m: FloatArray
    ) -> FloatArray:
        if not self._noise_per_m.any():
            return np.zeros(1)
        spread = self._noise_per_m[mine] / np.sqrt(state.laser.averaged[mine])
        deviates = self._noise.rows(rows, state.laser.count[mine])[:, : distance_m.shape[1]]
        seen_m = np.where(np.isfinite(distance_m), distance_m, 0.0)
        return np.asarray(deviates * spread[:, None] * seen_m * seen_m)


def is_on(mode: npt.NDArray[np.integer]) -> BoolArray:
    """Return which modes are those of a laser that is on."""
    return np.asarray(mode & _ON != 0)


def widths(mode: npt.NDArray[np.integer]) -> Int32Array:
    """Return the number of values per reading that replies report in a mode."""
    return np.where(np.isin(mode, _SEGMENT_MODES), SEGMENTS, POINTS).astype(np.int32)


def keep(
    state: EnvState, told: PagedReply, mine: IndexArray, width: Int32Array,
    seen: tuple[Int32Array, Int32Array],
) -> None:  # fmt: skip
    """Store readings for the pages that the client will request.

    Args:
        state: has the parameters of segments.
        told: their storage, changed in place.
        mine: which lasers, k of them.
        width: what they report, `POINTS` or `SEGMENTS`, shape (k,).
        seen: the scan, as returned by `look`.
    """
    counts, numbers = seen
    told.width[mine], told.count[mine], told.numbers[mine] = width, counts, numbers
    for place in np.flatnonzero(width == SEGMENTS):
        number = mine[place]
        points = numbers[place, : 2 * counts[place]].reshape(-1, 2).astype(np.float64)
        threshold, min_points, gap = state.laser.segments[number].tolist()
        found = np.rint(segments(points, threshold, min_points, gap)).astype(np.int32)
        found = found[: told.numbers.shape[1] // SEGMENTS]
        told.count[number] = len(found)
        told.numbers[number, : found.size] = found.ravel()


def page(context: RequestContext) -> BoolArray:
    """Answer LASER_PAGE with readings announced by the last reply, or that of PREDICT."""
    laser, mine = context.state.laser, context.constants.laser[context.rows]
    good = np.asarray(mine >= 0)
    first, predicted = context["first"].tolist(), context["predicted"].tolist()
    context.clear_data()
    for place in np.flatnonzero(good).tolist():
        told = laser.predicted if predicted[place] else laser.told
        told.page(mine[place], first[place], context.messages[place])
    return good


def conf_ls(context: RequestContext) -> BoolArray:
    """Set the mode and the number of points; refuse modes that report pixels."""
    mode, mine = context["mode"], context.constants.laser[context.rows]
    known = ~is_on(mode) | np.isin(mode, _POINT_MODES + _SEGMENT_MODES)
    good: BoolArray = (mine >= 0) & known
    mine, laser = mine[good], context.state.laser
    points = context["points"][good].view(np.uint32)
    most = context.constants.laser_points[context.rows[good]]
    laser.mode[mine] = mode[good]
    laser.wanted[mine] = np.where(points == 0, most, np.minimum(points, most))
    laser.averaged[mine] = np.clip(context["averaged"][good].view(np.uint32), 1, NUM_LASER)
    laser.measured.at_s[mine] = -np.inf  # the next scan has other directions
    return good


def conf_sg(context: RequestContext) -> BoolArray:
    """Set the parameters by which points become segments."""
    mine = context.constants.laser[context.rows]
    good = np.asarray(mine >= 0)
    wanted = context.columns("threshold", "min_points", "gap")[good].view(np.uint32)
    context.state.laser.segments[mine[good]] = np.minimum(wanted, LARGEST)
    return good


def _directions(laser: Laser, points: int) -> FloatArray:
    """Return the directions of the points, from right to left [rad]."""
    places = np.arange(points) - (points - 1) / 2
    return np.asarray(places * (laser.field_of_view_rad / points))
