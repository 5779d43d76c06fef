"""The infrared ring: sixteen sensors that measure the reflection of their own light.

    seen    = distance / sqrt(reflectance)
    new     = min(seen / step, 15)
    level   = share * previous level + (1 - share) * new
    reading = round(level)

The reflected light is proportional to the surface's reflectance and to the inverse square of its
distance, so a surface that reflects a quarter appears twice as far away. A reading is sent as four
bits, so the largest is 15 (vendor source `Ndirect.c` 2.7); this is also the reading if nothing is
in range. Programs interpret readings as inches (as does MissionLab's driver for the Nomad 200), so
the included definitions use a step of one inch. `conf_ir` sets the share of the previous level, in
tenths (vendor header `Nclient.h` 1.29), and which sensors measure; the others read 15. Sensor n of
the ring points 22.5 n degrees counter-clockwise from the front, like the sonars. A beam is a cone,
and the distance to the nearest object in it is measured. The reflectance is that of the object's
surface, or the default of the definition. All other numbers were chosen by us.

The ring is on the turret. All sensors measure when a reply contains their readings, but no more
often than the rate in the definition allows, or on their own timer. A normal deviate, whose
standard deviation is the `noise` of the definition, is added to each distance. Degradation
(`infrared`) applies to the distances; a dropped distance reads as nothing in range.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import (
    BoolArray,
    FloatArray,
    IndexArray,
    Int32Array,
    Int64Array,
    Records,
    all_of,
    any_of,
)
from crs_cc.core.distinct import distinct
from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.sim.devices import range_scan
from crs_cc.sim.devices.installed import Installed, Timed
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.sensor_order import orders
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.devices.vendor_state import KernelReply, configuration
from crs_cc.sim.files.device_elements import read_attributes
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.kernels import exact
from crs_cc.sim.kernels.tables import RING
from crs_cc.sim.model.attribute import SHARE, Count, Numbers, attribute, period, rate
from crs_cc.sim.model.degradable import Degradable, elements_of, numbered
from crs_cc.sim.model.device import Device
from crs_cc.sim.state.last_measurement import CONFIGURATION, LastMeasurement
from crs_cc.sim.state.random_streams import Noise

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.files.document import Element, Reader
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


MAX_INFRARED: Final = 16
"""Number of readings in the vendor's `State` array (vendor header `Nclient.h` 1.29)."""

FARTHEST: Final = 15
"""The largest reading, four bits on the link (vendor source `Ndirect.c` 2.7): nothing is near."""

_TURN: Final = 2 * math.pi
_TENTHS: Final = 10
_ALL: Final = " ".join(map(str, range(MAX_INFRARED)))


@dataclass(frozen=True, slots=True)
class Infrared:
    """Sixteen infrared sensors around the mount, on the robot's shell."""

    step_m: float = attribute(
        "step", LENGTH, None,
        "Distance to a white surface that corresponds to one unit of the reading; the maximum "
        "reading is 15.",
        positive=True,
    )  # fmt: skip
    half_angle_rad: float = attribute("half-angle", ANGLE, "0deg", "Half-angle of the beams.")
    reflectance: float = attribute("reflectance", SHARE, "1", "Default reflectance of surfaces.")
    rate_hz: float = rate("20Hz")
    noise_m: float = attribute("noise", LENGTH, "0m", "Standard deviation of a distance.")
    history: int = attribute(
        "history", Count(0, _TENTHS), "0",
        "Weight of the previous reading in the next one, in tenths, 0 to 10, until the program"
        " changes it with conf_ir().",
    )  # fmt: skip
    order: tuple[int, ...] = attribute(
        "order", Numbers(MAX_INFRARED), _ALL,
        "Active sensors until the program changes them with conf_ir().",
    )  # fmt: skip
    z_m: float = range_scan.height("20cm")
    period_s: float = period()


def read(root: Element, reader: Reader) -> Infrared | None:
    """Return the infrared ring of a robot definition, None for a robot without one."""
    element = root.find_child("infrared")
    if element is None:
        return None
    ring: Infrared = read_attributes(Infrared, element, reader)
    if ring.half_angle_rad >= math.pi / 2:
        reader.refuse(element, "half-angle: must be less than 90deg")
    for number in ring.order:
        if number >= MAX_INFRARED:
            reader.error(element, f"order: unknown sensor {number} (maximum: {MAX_INFRARED - 1})")
    return ring


@dataclass(slots=True)
class InfraredState:
    """The infrared rings; arrays have a row for each robot with a ring, n of them.

    Attributes:
        on: the active sensors, (n, 16).
        share: weight of the previous reading in the next one, 0 to 1, (n,).
        level: each reading before rounding, 0 to 15, (n, 16).
        count: number of measurements, (n,).
        measured: time and configuration of the last measurement.
    """

    on: BoolArray
    share: FloatArray
    level: FloatArray
    count: Int64Array
    measured: LastMeasurement


def rings(state: EnvState) -> InfraredState:
    """Return the state of all infrared rings."""
    return state.device("infrared", InfraredState)


def _at_start(models: Sequence[Infrared]) -> InfraredState:
    """Return sensors that have not measured yet."""
    on = np.zeros((len(models), MAX_INFRARED), dtype=np.bool_)
    for row, ring in zip(on, models, strict=True):
        row[list(ring.order)] = True
    return InfraredState(
        on,
        np.array([ring.history / _TENTHS for ring in models], dtype=np.float64),
        np.full((len(models), MAX_INFRARED), float(FARTHEST)),
        np.zeros(len(models), dtype=np.int64),
        LastMeasurement.never(len(models)),
    )


class InfraredRing:
    """The infrared rings of all robots that have one.

    Attributes:
        fans: the beams of each kind of ring.
        is_noisy: whether any has random errors.
    """

    def __init__(self, row: Device, world: WorldModel, seed: int) -> None:
        pairs: list[tuple[Infrared, float]] = [
            (ring, robot.model.radius_m)
            for robot in world.robots
            if (ring := robot.model.device(row.name)) is not None
        ]
        brightest, found = _brightest(world), [ring for ring, _ in pairs]
        kinds, self._kind = distinct(pairs)
        self._row = row
        self.fans = [_fan(*pair, brightest) for pair in kinds]
        self._interval_s = np.array([1.0 / ring.rate_hz for ring in found])
        self._step_m = np.array([ring.step_m for ring in found])[:, None]
        self._reflectance = np.array([ring.reflectance for ring in found])[:, None]
        self._noise_m = np.array([ring.noise_m for ring in found])[:, None]
        self.is_noisy = bool(self._noise_m.any())
        robots = len(world.robots) if self.is_noisy else 0
        self._noise = Noise(seed, row.stream, MAX_INFRARED, robots)
        shine = np.sqrt(np.tile(self._reflectance, MAX_INFRARED))
        self._shining_m = self._step_m * shine  # where no surface has a reflectance of its own

    def installed(self) -> Installed:
        """Return the rings with the handlers of their requests."""
        return Installed(
            handlers={"GET_IR": self.get_ir, "CONF_IR": self.conf_ir},
            timed=Timed(self.read, lambda state: rings(state).measured.at_s, self._interval_s),
            fans=self.fans,
            device=self,
        )

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
        *,
        kernel_reply: KernelReply | None = None,
    ) -> None:
        """Measure with the rings that may measure again.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: casts rays.
            rows: the robots, k of them.
            at_s: the time for each, (k,).
            kernel_reply: the results of the kernel that answered the request, if one did.
        """
        ring = rings(state)
        mine = constants.numbers[self._row.name].take(rows)
        due = ring.measured.are_due(mine, at_s, self._interval_s)
        if not any_of(due):
            return
        if not all_of(due):
            rows, mine, at_s = rows[due], mine[due], at_s[due]
            kernel_reply = None if kernel_reply is None else kernel_reply.of(due)
        poses = mount_poses(state, constants, rows) if kernel_reply is None else kernel_reply.mounts
        distance_m, step_m = self._see(state, constants, rays, rows, poses)
        if self.is_noisy:
            distance_m += self._noise.rows(rows, ring.count[mine]) * self._noise_m[mine]
        if constants.degradations.affects(state, self._row.name):
            distance_m = constants.degradations.alter(state, self._row.name, rows, distance_m, at_s)
            distance_m = np.where(np.isnan(distance_m), np.inf, distance_m)
        level = _steps(distance_m, step_m)
        np.minimum(np.maximum(level, 0.0, out=level), FARTHEST, out=level)
        share, on = ring.share.take(mine)[:, None], ring.on.take(mine, axis=0)
        if np.count_nonzero(share):
            level = share * ring.level.take(mine, axis=0) + (1.0 - share) * level
        else:
            level += 0.0  # as the sum would be: there is no -0
        if not all_of(on):
            level = np.where(on, level, FARTHEST)
        ring.level[mine] = level
        ring.count[mine] += 1
        if kernel_reply is None:
            kernel_reply = KernelReply(configuration(state, constants, rows), poses)
        ring.measured.note(mine, at_s, kernel_reply.configuration)

    def get_ir(self, context: RequestContext) -> BoolArray:
        """Answer GET_IR: measure, for `State`; refuse robots without infrared sensors."""
        has = np.asarray(context.constants.numbers[self._row.name][context.rows] >= 0)
        read_on_request(context, self.read, self._row.number, has)
        return has

    def conf_ir(self, context: RequestContext) -> BoolArray:
        """Set the share of the previous level and the active sensors; refuse unknown sensors."""
        rows, ring = context.rows, rings(context.state)
        order, given, good = orders(context["count"], context["order"], MAX_INFRARED)
        mine = context.constants.numbers[self._row.name][rows]
        good &= mine >= 0
        on = np.zeros((len(rows), MAX_INFRARED), dtype=np.bool_)
        robot, element = np.nonzero(given & good[:, None])
        on[robot, order[robot, element]] = True
        mine = mine[good]
        ring.on[mine] = on[good]
        ring.level[mine] = np.where(on[good], ring.level[mine], FARTHEST)
        ring.share[mine] = np.clip(context["share"][good], 0, _TENTHS) / _TENTHS
        return good

    def look(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        poses: FloatArray,
    ) -> Int32Array:
        """Return the errorless readings, (k, 16), of rings whose mounts were at other poses."""
        steps = _steps(*self._see(state, constants, rays, rows, poses))
        return np.asarray(np.rint(np.clip(steps, 0.0, FARTHEST)), dtype=np.int32)

    def is_simple(self, rays: RayCaster) -> bool:
        """Return whether kernels know all that readings depend on: no surface is darker."""
        return rays.surfaces.infrared is None

    def draw(self, robots: IndexArray, numbers: Int64Array) -> FloatArray:
        """Return the deviates of one measurement of each of some robots' rings, (k, 16)."""
        return self._noise.rows(robots, numbers)

    def table(self, state: EnvState) -> Records:
        """Return the input of the calm-time kernel for rings, (n,) of dtype `RING`.

        Where the beams of each kind lie is counted from those of the first one.
        """
        ring, sizes = rings(state), [fan.table.size for fan in self.fans]
        table = np.zeros(len(ring.share), RING)
        table["interval_s"], table["noise"] = self._interval_s, self._noise_m[:, 0]
        table["step_m"] = self._shining_m[:, 0]
        table["fan"] = np.concatenate([[0], np.cumsum(sizes)])[self._kind]
        table["share"], table["on"], table["level"] = ring.share, ring.on, ring.level
        table["at_s"], table["count"] = ring.measured.at_s, ring.count
        table["configuration"][:, :CONFIGURATION] = ring.measured.configuration
        return table

    def load_measurements(self, state: EnvState, table: Records) -> None:
        """Take over from such a table what rings have measured."""
        ring = rings(state)
        ring.level[:], ring.count[:] = table["level"], table["count"]
        ring.measured.load_measurements(table)

    def _see(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        poses: FloatArray,
    ) -> tuple[FloatArray, FloatArray]:
        """Return the distances that the sensors see from poses.

        Returns:
            the distances, and the distance of such a surface that changes the reading by 1, both
            of shape (k, 16).
        """
        mine = constants.numbers[self._row.name].take(rows)
        own = rays.surfaces.infrared
        if own is None and len(self.fans) == 1:
            distance_m = rays.distances_m(state, self.fans[0], poses, own=rows)
            return distance_m, self._shining_m.take(mine, axis=0)
        distance_m = np.empty((len(rows), MAX_INFRARED))
        shine = np.tile(self._reflectance[mine], MAX_INFRARED)
        for kind, some in range_scan.alike(self._kind[mine]):
            fan = self.fans[kind]
            if own is None:
                distance_m[some] = rays.distances_m(state, fan, poses[some], own=rows[some])
            else:
                distance_m[some], obj = rays.seen(state, fan, poses[some], own=rows[some])
                shine[some] = np.where(np.isnan(own[obj]), shine[some], own[obj])
        return distance_m, self._step_m[mine] * np.sqrt(shine)


def _steps(distance_m: FloatArray, step_m: FloatArray) -> FloatArray:
    """Return readings; a black object reads as nothing, unless the sensor touches it."""
    if all_of(step_m > 0.0):
        return np.asarray(distance_m / step_m)
    none = np.where(distance_m > 0.0, np.inf, 0.0)
    return np.divide(distance_m, step_m, out=none, where=step_m > 0.0)


def _brightest(world: WorldModel) -> float:
    """Return the largest reflectance of any surface of a world."""
    objects = (*world.solids(), *world.robots)
    return max((obj.material.infrared or 0.0 for obj in objects), default=0.0)


def _fan(ring: Infrared, radius_m: float, brightest: float) -> Fan:
    """Return beams that start on the shell and reach as far as a reading below the largest."""
    range_m = FARTHEST * ring.step_m * math.sqrt(max(ring.reflectance, brightest))
    directions = [number * _TURN / MAX_INFRARED for number in range(MAX_INFRARED)]
    beams = (
        (
            radius_m * exact.cos(direction),
            radius_m * exact.sin(direction),
            direction,
            ring.half_angle_rad,
            range_m,
        )
        for direction in directions
    )
    return Fan.of(beams, ring.z_m)


def inspect(state: EnvState, number: int) -> str:
    """Return the readings of a ring."""
    return " ".join(f"{level:.0f}" for level in rings(state).level[number].tolist())


DEVICE = Device(
    name="infrared",
    title="Infrared ring",
    element="infrared",
    summary="Sixteen infrared sensors on the shell of the turret (or the body), 22.5 degrees apart,"
    " numbered counter-clockwise from 0 at the front.",
    model=Infrared,
    read=read,
    state=_at_start,
    install=lambda row, world, seed, _log: InfraredRing(row, world, seed).installed(),
    degradables=(
        Degradable(
            "infrared", "distance measured by an infrared sensor", LENGTH,
            elements_of("infrared", lambda _model: numbered(MAX_INFRARED)), MAX_INFRARED,
            "the reading is 15 (nothing in range)",
        ),
    ),
    inspect=inspect,
    reading=lambda state, _model, number: rings(state).level[number],
    number=4,
    stream=1,
    source=__file__,
)  # fmt: skip
