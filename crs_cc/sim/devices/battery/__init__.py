"""The batteries: discharge, reported voltages, and the effect of an empty battery.

    energy used = power * time + work / efficiency + stall power * time held back
    work        = sum over the axes of  friction * |motion| + m / 2 * max(0, v1^2 - v0^2)

in joules: friction along the whole distance, and for each cycle in which an axis accelerates from
v0 to v1 the kinetic energy of the mass m that it moves: the robot's, or half of it for each of two
wheels. For an axis that turns, a synchro drive's steering and turret, distance and speed are those
of a point on the robot's shell. Braking recovers nothing. The voltage is that of the definition's
curve at the state of charge. On the line it is a byte n with

    volts = (2 + n * 3 / 255) * 12 / 5       for the computers' battery,
    volts = (2 + n * 3 / 255) * 12.85 / 5    for the motors' battery

(vendor source `Ndirect.c` 2.7), clipped to its range. According to the vendor, neither should drop
below 10.8 V, but not what happens then: here motors with less than the definition's cut-off have no
force, and the wheels roll out. An empty computer battery has no effect except on its voltage. All
numbers except those two formulas were chosen by us.

Some drivers read the charge from bits 2 and 3 of the motor status (ISR's driver of the Scout: 0
low, 1 medium, 2 high), where the vendor's header has the turret's motor; a definition can select
that. Degradation (`battery`) applies to the voltages; a dropped value is byte 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.core.distinct import distinct
from crs_cc.sim.devices.battery.state import motors_of
from crs_cc.sim.devices.battery.supplies import (
    CAPACITY,
    MIN_CHARGE,
    POWER,
    START,
    Voltages,
    byte,
    supply_table,
)
from crs_cc.sim.state.rows import simplest

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


_LEVELS: Final = 3  # low, medium, high


class Batteries:
    """The batteries of all robots of a world; kernels drain them, see `kernels/cycle.c`.

    Attributes:
        last: whether no motor battery is ever empty.
        are_in_status: whether any robot reports its charge in the status of its motors.
    """

    def __init__(self, world: WorldModel) -> None:
        models = [robot.model for robot in world.robots]
        kinds, self._kind = distinct(models)
        self._voltages = Voltages(kinds)
        self._supply = supply_table(kinds)
        motors = [model.device("motor_battery") for model in kinds]
        self.last = not any(motors)
        reports = [each is not None and each.is_in_status for each in motors]
        self._in_status = np.array(reports, dtype=np.bool_)[self._kind]
        self.are_in_status = bool(self._in_status.any())

    def byte_tables(self) -> tuple[Int32Array, IndexArray]:
        """Return bytes by state of charge, and where those of each robot begin, (robots, 2)."""
        return self._voltages.tables(self._kind)

    def empty(
        self, state: EnvState, constants: RobotConstants, rows: IndexArray, at_s: FloatArray
    ) -> BoolArray:
        """Return which robots' motor batteries are empty, shape (k,)."""
        if self.last:
            return np.zeros(len(rows), dtype=np.bool_)
        charge = self.left(state, constants, rows, at_s)
        return np.asarray(charge[:, 1] < self._supply[self._kind[rows], MIN_CHARGE])

    def left(
        self, state: EnvState, constants: RobotConstants, rows: IndexArray, at_s: FloatArray
    ) -> FloatArray:
        """Return the state of charge of computers' and motors' batteries, 0 to 1, (k, 2)."""
        for_s = at_s - state.presence.joined_s[rows]
        some = simplest(rows, len(self._kind))
        return state.rows.charges(some, for_s, constants.kinds)

    def charge(
        self, state: EnvState, constants: RobotConstants, robot: int, *, at_s: float, share: float
    ) -> None:
        """Set the state of charge of a robot's motor battery, 0 to 1.

        Raises:
            ValueError: the battery is unlimited.
        """
        supply = self._supply[self._kind[robot]]
        start, power_w, capacity_j = (float(supply[at + 1]) for at in (START, POWER, CAPACITY))
        if not np.isfinite(capacity_j):
            raise ValueError("the motor battery is unlimited")
        for_s = at_s - float(state.presence.joined_s[robot])
        used_j = (start - share) * capacity_j
        number = constants.numbers["motor_battery"][robot]
        motors_of(state).moved_j[number] = used_j - power_w * for_s

    def voltage_bytes(
        self,
        state: EnvState,
        constants: RobotConstants,
        rows: IndexArray,
        at_s: FloatArray,
        charge: FloatArray,
    ) -> Int32Array:
        """Return the bytes of the computers' and of the motors' battery, shape (k, 2).

        Args:
            state: has the memory of degradations.
            constants: the robots' constants.
            rows: the robots, k of them.
            at_s: the time of each, (k,).
            charge: the state of charge of both then, (k, 2).
        """
        kinds = self._kind.take(rows)
        if not constants.degradations.affects(state, "battery"):
            if self._voltages.full_bytes is not None:
                return np.asarray(self._voltages.full_bytes.take(kinds, axis=0))
            return self._voltages.bytes(kinds, charge)
        volts = self._voltages.volts(kinds, charge)
        volts = constants.degradations.alter(state, "battery", rows, volts, at_s)
        return byte(np.where(np.isnan(volts), 0.0, volts))

    def status(self, rows: IndexArray, charge: FloatArray) -> Int32Array | None:
        """Return bits 2 and 3 of the motors' status, None if no robot reports its charge there."""
        if not self.are_in_status:
            return None
        level = np.minimum((charge[:, 1] * _LEVELS).astype(np.int32), _LEVELS - 1)
        return np.asarray(np.where(self._in_status[rows], level << 2, 0))
