"""The compass.

    reading = direction of the mount + offset + (deviation * sin(direction) until it is calibrated)

The reading is in units of 0.1 degree, 0 to 3599 (vendor header `Nclient.h` 1.29). The direction is
that of the turret, or of the robot if it has none, in the world frame: counter-clockwise from the
world's x axis, like all angles of the robot; the offset of a definition selects a different north.
`conf_cp` switches the compass on and off: while it is off, the reading, initially 0, does not
change. `conf_cp(2)` calibrates it: the turret makes one turn, as slowly as the definition specifies
(about three minutes, vendor header). Meanwhile the program continues; it should wait and not move
the turret. Then the deviation, which is caused by iron on the robot, is removed. A robot without a
turret does not turn. All numbers except the format were chosen by us.

The compass measures when a reply contains its reading, at most ten times a second (vendor header),
or on its timer (`timers`). A normal deviate with the definition's noise is added. Degradation
(`compass`): if a value is dropped, the reading does not change.
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
)
from crs_cc.core.quantity import ANGLE, TIME
from crs_cc.core.units import rad_to_tenths_deg, tenths_deg_to_rad
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.installed import Installed, Timed
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.devices.vendor_state import KernelReply, configuration
from crs_cc.sim.kernels import exact
from crs_cc.sim.kernels.tables import COMPASS
from crs_cc.sim.model.attribute import Choice, attribute, period, rate
from crs_cc.sim.model.degradable import Degradable, elements_of
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.robot import devices_of
from crs_cc.sim.state.last_measurement import CONFIGURATION, LastMeasurement
from crs_cc.sim.state.random_streams import Noise

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


OFF: Final = 0
CALIBRATE: Final = 2
"""Modes of `conf_cp`; 1 switches it on (vendor header `Nclient.h` 1.29)."""

_TURN: Final = 2 * math.pi
_FULL_TURN: Final = 3600


@dataclass(frozen=True, slots=True)
class Compass:
    """A compass."""

    offset_rad: float = attribute(
        "offset", ANGLE, "0deg", "Reading when the robot points along the world's x axis.",
        signed=True,
    )  # fmt: skip
    deviation_rad: float = attribute(
        "deviation", ANGLE, "0deg",
        "Maximum error caused by iron on the robot, until the program calibrates the compass with"
        " conf_cp(2).",
    )  # fmt: skip
    calibration_s: float = attribute(
        "calibration", TIME, "180s",
        "Duration of the calibration, in which the turret makes one turn.",
        positive=True,
    )  # fmt: skip
    rate_hz: float = rate("10Hz")
    noise_rad: float = attribute("noise", ANGLE, "0deg", "Standard deviation of a reading.")
    is_on: bool = attribute(
        "on", Choice((("yes", True), ("no", False))), "no",
        "Whether the compass is on until the program changes this with conf_cp().",
    )  # fmt: skip
    period_s: float = period()


@dataclass(slots=True)
class CompassState:
    """The compasses; arrays have a row for each robot with a compass, n of them.

    Attributes:
        on: whether they are on, (n,).
        calibrated: whether they have been calibrated, (n,).
        reading: last reading [0.1 deg], (n,).
        count: number of measurements, (n,).
        measured: time and configuration of the last measurement.
    """

    on: BoolArray
    calibrated: BoolArray
    reading: Int32Array
    count: Int64Array
    measured: LastMeasurement


def compasses(state: EnvState) -> CompassState:
    """Return the state of all compasses."""
    return state.device("compass", CompassState)


def _at_start(models: Sequence[Compass]) -> CompassState:
    """Return compasses that have not measured yet."""
    count = len(models)
    return CompassState(
        np.array([compass.is_on for compass in models], dtype=np.bool_),
        np.zeros(count, dtype=np.bool_),
        np.zeros(count, dtype=np.int32),
        np.zeros(count, dtype=np.int64),
        LastMeasurement.never(count),
    )


class Compasses:
    """The compasses of all robots that have one.

    Attributes:
        is_noisy: whether any has random errors.
    """

    def __init__(self, row: Device, world: WorldModel, seed: int) -> None:
        models = devices_of([robot.model for robot in world.robots], row.name)
        found: list[Compass] = [model for model in models if model is not None]
        self._row = row
        self._interval_s = np.array([1.0 / compass.rate_hz for compass in found])
        self._offset_rad = np.array([compass.offset_rad for compass in found])
        self._deviation_rad = np.array([compass.deviation_rad for compass in found])
        self._calibration_s = np.array([compass.calibration_s for compass in found])
        self._noise_rad = np.array([compass.noise_rad for compass in found])
        self.is_noisy = bool(self._noise_rad.any())
        self._noise = Noise(seed, row.stream, 1, len(models) if self.is_noisy else 0)

    def installed(self) -> Installed:
        """Return the compasses with the handlers of their requests."""
        return Installed(
            handlers={"GET_CP": self.get_cp, "CONF_CP": self.conf_cp},
            timed=Timed(self.read, lambda state: compasses(state).measured.at_s, self._interval_s),
            device=self,
        )

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        _around: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
        *,
        kernel_reply: KernelReply | None = None,
    ) -> None:
        """Measure with the compasses that are on and may measure again.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rows: the robots, k of them.
            at_s: the time for each, (k,).
            kernel_reply: the results of the kernel that answered the request, if one did.
        """
        compass = compasses(state)
        mine = constants.numbers[self._row.name][rows]
        due = compass.measured.are_due(mine, at_s, self._interval_s) & compass.on[mine]
        if not due.any():
            return
        rows, mine = rows[due], mine[due]
        known = None if kernel_reply is None else kernel_reply.of(due)
        poses = mount_poses(state, constants, rows) if known is None else known.mounts
        angle_rad = poses[:, 2].copy()
        deviation_rad = np.where(compass.calibrated[mine], 0.0, self._deviation_rad[mine])
        angle_rad += self._offset_rad[mine] + deviation_rad * exact.sin(angle_rad)
        if self.is_noisy:
            deviates = self._noise.rows(rows, compass.count[mine])[:, 0]
            angle_rad += deviates * self._noise_rad[mine]
        angle_rad = constants.degradations.alter(
            state, self._row.name, rows, angle_rad[:, None], at_s[due]
        )[:, 0]
        reported = np.isfinite(angle_rad)
        tenths = np.rint(rad_to_tenths_deg(angle_rad[reported])).astype(np.int32)
        compass.reading[mine[reported]] = tenths % _FULL_TURN
        compass.count[mine] += 1
        if known is None:
            known = KernelReply(configuration(state, constants, rows), poses)
        compass.measured.note(mine, at_s[due], known.configuration)

    def draw(self, robots: IndexArray, numbers: Int64Array) -> FloatArray:
        """Return the deviate of one measurement of each of some robots' compasses, (k, 1)."""
        return self._noise.rows(robots, numbers)

    def table(self, state: EnvState) -> Records:
        """Return the input of the calm-time kernel for compasses, (n,) of dtype `COMPASS`."""
        compass = compasses(state)
        table = np.zeros(len(compass.on), COMPASS)
        table["interval_s"], table["noise"] = self._interval_s, self._noise_rad
        table["offset_rad"], table["on"] = self._offset_rad, compass.on
        table["deviation_rad"] = np.where(compass.calibrated, 0.0, self._deviation_rad)
        table["reading"], table["count"] = compass.reading, compass.count
        table["at_s"] = compass.measured.at_s
        table["configuration"][:, :CONFIGURATION] = compass.measured.configuration
        return table

    def load_measurements(self, state: EnvState, table: Records) -> None:
        """Take over from such a table what compasses have measured."""
        compass = compasses(state)
        compass.reading[:], compass.count[:] = table["reading"], table["count"]
        compass.measured.load_measurements(table)

    def get_cp(self, context: RequestContext) -> BoolArray:
        """Answer GET_CP: measure, for `State`; refuse robots without a compass."""
        has = np.asarray(context.constants.numbers[self._row.name][context.rows] >= 0)
        read_on_request(context, self.read, self._row.number, has)
        return has

    def conf_cp(self, context: RequestContext) -> BoolArray:
        """Switch compasses on or off; refuse unknown modes."""
        state, constants = context.state, context.constants
        mode, mine = context["mode"], constants.numbers[self._row.name][context.rows]
        good: BoolArray = (mine >= 0) & (mode >= OFF) & (mode <= CALIBRATE)
        rows, mode, mine = context.rows[good], mode[good], mine[good]
        compass = compasses(state)
        compass.on[mine] = mode != OFF
        calibrates = mode == CALIBRATE
        compass.calibrated[mine[calibrates]] = True
        turns = calibrates & constants.drives.turret[rows]
        if turns.any():
            rows, speed = rows[turns], _TURN / self._calibration_s[mine[turns]]
            drive.turn_turret(state, rows, _TURN, speed)
        return good


def inspect(state: EnvState, number: int) -> str:
    """Return the last reading of a compass, and whether it is off."""
    compass = compasses(state)
    off = "" if compass.on[number] else ", off"
    return f"{compass.reading[number] / 10:.1f} deg{off}"


def _reading(state: EnvState, _model: Compass, number: int) -> FloatArray:
    """Return the direction that a compass last read [rad], (1,)."""
    return tenths_deg_to_rad(compasses(state).reading[number : number + 1].astype(np.float64))


DEVICE = Device(
    name="compass",
    title="Compass",
    element="compass",
    summary="A compass, which turns with the turret.",
    model=Compass,
    state=_at_start,
    install=lambda row, world, seed, _log: Compasses(row, world, seed).installed(),
    degradables=(
        Degradable(
            "compass", "direction", ANGLE, elements_of("compass", lambda _model: ("0",)), 1,
            "the reading does not change",
        ),
    ),
    inspect=inspect,
    reading=_reading,
    number=5,
    stream=2,
    source=__file__,
)  # fmt: skip
