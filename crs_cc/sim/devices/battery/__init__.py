"""The batteries: discharge, reported voltages, and the effect of an empty battery.

    energy used = power * time + work / efficiency + stall power * time held back
    work        = sum over the axes of  friction * |way| + m / 2 * max(0, v1^2 - v0^2)

in joules: friction along the whole distance, and for each cycle in which an axis accelerates from
v0 to v1 the kinetic energy of the mass m that it moves: the robot's, or half of it for each of two
wheels. For an axis that turns, a synchro drive's steering and turret, distance and speed are those
of a point on the robot's shell. Braking recovers nothing. The voltage is that of the definition's
curve at the state of charge. On the line it is a byte n with

    volts = (2 + n * 3 / 255) * 12 / 5       for the computers' battery,
    volts = (2 + n * 3 / 255) * 12.85 / 5    for the motors' battery

(vendor source `Ndirect.c` 2.7), clipped to its range. The vendor says that neither should drop
below 10.8 V, but not what happens then: here motors with less than the definition's cut-off have no
force, and the wheels roll out. An empty computer battery has no effect except on its voltage. All
numbers except those two formulas were chosen by us.

Some drivers read the charge from bits 2 and 3 of the motor status (ISR's driver of the Scout: 0
low, 1 medium, 2 high), where the vendor's header has the turret's motor; a definition can select
that. Degradation (`battery`) applies to the voltages; a dropped value is byte 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, any_of
from crs_cc.sim.devices.battery.model import ENDLESS, ENDLESS_MOTORS, Battery, MotorBattery
from crs_cc.sim.devices.battery.state import motors_of
from crs_cc.sim.state.rows import ALL, Rows, take

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.robot import RobotModel
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


COMPUTERS: Final = 12.0 / 5
MOTORS: Final = 12.85 / 5
"""Factors of the voltages on the sensor board (vendor source `Ndirect.c` 2.7)."""

_FACTORS: Final = COMPUTERS, MOTORS
_BOTH: Final = np.arange(2)
_NOBODY: Final = np.zeros(0, dtype=np.intp)
_STEPS: Final = 1_000  # of charge, in the tables
_LEVELS: Final = 3  # low, medium, high


class Batteries:
    """The batteries of all robots of a world."""

    def __init__(self, world: WorldModel) -> None:
        models = [robot.model for robot in world.robots]
        kinds = list(dict.fromkeys(models))
        self._kind = np.array([kinds.index(model) for model in models], dtype=np.intp)
        computers = [model.device("computer_battery") or ENDLESS for model in kinds]
        motors: list[MotorBattery] = [
            model.device("motor_battery") or ENDLESS_MOTORS for model in kinds
        ]
        self._supplies = _Supplies(computers, motors)
        least = np.array([_least_charge(battery) for battery in motors])
        self._least_charge = least[self._kind]
        self._in_status = np.array([battery.is_in_status for battery in motors])[self._kind]
        self._are_in_status = bool(self._in_status.any())
        has = np.array([model.device("motor_battery") is not None for model in models])
        self._number, self._robots = np.cumsum(has) - 1, np.flatnonzero(has)
        self._rows: Rows = ALL if has.all() else self._robots
        owners = [(models[robot], motors[self._kind[robot]]) for robot in self._robots.tolist()]
        self._friction_n = np.array([battery.friction_n for _, battery in owners])[:, None]
        self._lever = np.array([_levers(model) for model, _ in owners])
        self._mass_kg = np.array([_moved_kg(model) for model, _ in owners])[:, None]
        self._per_work = np.array([1.0 / battery.efficiency for _, battery in owners])
        self._stall_w = np.array([battery.stall_w for _, battery in owners])
        self._lasts = not owners

    def drain(self, state: EnvState, timestep_s: float) -> IndexArray:
        """Drain motor batteries by a cycle, turned to its end; return whose motors were working."""
        held_back = state.bodies.slipping
        if self._lasts or not (state.drive.slice.any() or any_of(held_back)):
            return _NOBODY
        held_back = held_back[self._rows]
        way_m = take(state.drive.slice, self._rows) * self._lever
        speed_mps = take(state.drive.axes.speed, self._rows) * self._lever
        battery = motors_of(state)
        faster = np.maximum(speed_mps * speed_mps - battery.speed_mps * battery.speed_mps, 0.0)
        work_j = self._friction_n * np.abs(way_m) + self._mass_kg * (faster / 2)
        battery.moved_j += work_j.sum(axis=1) * self._per_work
        battery.moved_j += self._stall_w * (timestep_s * held_back)
        battery.speed_mps = speed_mps
        return np.asarray(self._robots[way_m.any(axis=1) | held_back])

    def empty(self, state: EnvState, rows: IndexArray, at_s: FloatArray | float) -> BoolArray:
        """Return which robots' motor batteries are empty, shape (k,)."""
        if self._lasts:
            return np.zeros(len(rows), dtype=np.bool_)
        return np.asarray(self.left(state, rows, at_s)[:, 1] < self._least_charge[rows])

    def left(self, state: EnvState, rows: IndexArray, at_s: FloatArray | float) -> FloatArray:
        """Return the state of charge of computers' and motors' batteries, 0 to 1, (k, 2)."""
        for_s = at_s - state.presence.joined_s[rows]
        return self._supplies.charge(self._kind[rows], for_s, self._moved_j(state, rows))

    def charge(self, state: EnvState, robot: int, at_s: float, share: float) -> None:
        """Set the state of charge of a robot's motor battery, 0 to 1.

        Raises:
            ValueError: the battery is unlimited.
        """
        supplies, motor = self._supplies, (self._kind[robot], 1)
        if not np.isfinite(supplies.capacity_j[motor]):
            raise ValueError("the motor battery is unlimited")
        for_s = at_s - float(state.presence.joined_s[robot])
        used_j = (supplies.start[motor] - share) * supplies.capacity_j[motor]
        motors_of(state).moved_j[self._number[robot]] = used_j - supplies.power_w[motor] * for_s

    def voltage_bytes(
        self, state: EnvState, constants: RobotConstants, rows: IndexArray, at_s: FloatArray
    ) -> tuple[Int32Array, Int32Array]:
        """Return the bytes of the computers' and of the motors' battery, shape (k,) each."""
        kinds, degrades = self._kind[rows], constants.degradations.concern(state, "battery")
        if self._supplies.full_bytes is not None and not degrades:
            found = self._supplies.full_bytes[kinds]
            return found[:, 0], found[:, 1]
        charge = self.left(state, rows, at_s)
        if not degrades:
            found = self._supplies.bytes(kinds, charge)
        else:
            volts = self._supplies.volts(kinds, charge)
            volts = constants.degradations.alter(state, "battery", rows, volts, at_s)
            found = _byte(np.where(np.isnan(volts), 0.0, volts), _FACTORS)
        return found[:, 0], found[:, 1]

    def status(self, state: EnvState, rows: IndexArray, at_s: FloatArray) -> Int32Array | None:
        """Return bits 2 and 3 of the motors' status, None if no robot reports its charge there."""
        if not self._are_in_status:
            return None
        asks = self._in_status[rows]
        charge = self.left(state, rows, at_s)[:, 1]
        level = np.minimum((charge * _LEVELS).astype(np.int32), _LEVELS - 1)
        return np.asarray(np.where(asks, level << 2, 0))

    def _moved_j(self, state: EnvState, rows: IndexArray) -> FloatArray | float:
        """Return the energy used for moving; any number for robots without a battery."""
        return 0.0 if self._lasts else motors_of(state).moved_j[self._number[rows]]


def _levers(model: RobotModel) -> tuple[float, float, float]:
    """Return the distance [m] per unit of each axis' motion."""
    turns = model.drive.steering is not None
    return (1.0, model.radius_m, model.radius_m) if turns else (1.0, 1.0, 0.0)


def _moved_kg(model: RobotModel) -> float:
    """Return the mass that an axis moves."""
    return model.mass_kg if model.drive.steering is not None else model.mass_kg / 2


class _Supplies:
    """The batteries of each kind of robot: arrays have a column for the computers' and the motors'.

    Attributes:
        start: charge at the start, 0 to 1.
        power_w: power that is used all the time.
        capacity_j: energy in a full battery.
        full_bytes: the bytes that are sent if all are unlimited, else None.
    """

    def __init__(self, computers: Sequence[Battery], motors: Sequence[Battery]) -> None:
        every = [each for pair in zip(computers, motors, strict=True) for each in pair]
        self.start = np.array([each.charge for each in every]).reshape(-1, 2)
        self.power_w = np.array([each.power_w for each in every]).reshape(-1, 2)
        self.capacity_j = np.array([each.capacity_j for each in every]).reshape(-1, 2)
        curves_v = [each.curve_v for each in every]
        self._curves_v = list(zip(curves_v[::2], curves_v[1::2], strict=True))
        tables = [_bytes(curve_v, _FACTORS[place % 2]) for place, curve_v in enumerate(curves_v)]
        self._bytes = np.array(tables, np.int32).reshape(-1, 2, _STEPS + 1)
        self.full_bytes: Int32Array | None = None
        if np.isinf(self.capacity_j).all():
            self.full_bytes = self.bytes(np.arange(len(computers)), self.start)

    def charge(
        self, kinds: IndexArray, for_s: FloatArray, moved_j: FloatArray | float
    ) -> FloatArray:
        """Return the states of charge after some time in use, 0 to 1, shape (k, 2)."""
        used_j = self.power_w.take(kinds, axis=0) * for_s[:, None]
        used_j[:, 1] += moved_j
        left = self.start.take(kinds, axis=0) - used_j / self.capacity_j.take(kinds, axis=0)
        return np.asarray(np.maximum(left, 0.0))

    def bytes(self, kinds: IndexArray, charge: FloatArray) -> Int32Array:
        """Return the bytes that are sent for states of charge."""
        steps = (charge * _STEPS + 0.5).astype(np.intp)
        return np.asarray(self._bytes[kinds[:, None], _BOTH, steps])

    def volts(self, kinds: IndexArray, charge: FloatArray) -> FloatArray:
        """Return the voltages at states of charge."""
        found = np.empty((len(kinds), 2))
        for place, kind in enumerate(kinds.tolist()):
            for supply, curve_v in enumerate(self._curves_v[kind]):
                found[place, supply] = _volts(curve_v, charge[place, supply])
        return found


def _volts(curve_v: tuple[float, ...], charge: FloatArray) -> FloatArray:
    """Return the voltages at states of charge, from a curve at equal distances."""
    curve = np.array([*curve_v, curve_v[-1]])
    place = charge * (len(curve_v) - 1)
    before = np.floor(place).astype(np.intp)
    share = place - before
    return np.asarray((1.0 - share) * curve[before] + share * curve[before + 1])


def _byte(volts: FloatArray, factor: float | tuple[float, ...]) -> Int32Array:
    return np.clip(np.rint((volts / factor - 2) * (255 / 3)), 0, 255).astype(np.int32)


def _bytes(curve_v: tuple[float, ...], factor: float) -> Int32Array:
    """Return the byte for each step of charge from empty to full.

    >>> _bytes((12.0, 13.0), COMPUTERS)[[0, 500]].tolist(), round((2 + 234 * 3 / 255) * MOTORS, 1)
    ([255, 255], 12.2)
    """
    charges = np.arange(_STEPS + 1) / _STEPS
    return _byte(_volts(curve_v, charges), factor)


def _least_charge(battery: MotorBattery) -> float:
    """Return the smallest charge whose voltage is not below the cut-off; above 1 for none.

    >>> _least_charge(MotorBattery(capacity_j=1.0, curve_v=(10.0, 12.0), cutoff_v=10.5))
    0.25
    """
    charges = np.arange(_STEPS + 1) / _STEPS
    curve_v = battery.curve_v
    volts = _volts(curve_v, charges)
    enough = volts >= battery.cutoff_v
    return float(charges[np.argmax(enough)]) if enough.any() else 2.0
