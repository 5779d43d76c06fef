"""The constants of all robots' batteries, and their voltages by the state of charge."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int32Array
from crs_cc.sim.devices.battery.model import ENDLESS, ENDLESS_MOTORS, MotorBattery

if TYPE_CHECKING:
    from crs_cc.sim.model.robot import RobotModel

COMPUTERS: Final = 12.0 / 5
MOTORS: Final = 12.85 / 5
"""Factors of the voltages on the sensor board (vendor source `Ndirect.c` 2.7)."""

_FACTORS: Final = COMPUTERS, MOTORS
_STEPS: Final = 1_000  # of charge, in the tables
_SIZE: Final = _STEPS + 1

START, POWER, CAPACITY, MIN_CHARGE = 0, 2, 4, 6
"""Positions in a row of `supply_table`: of values for computers and motors; minimum charge."""


def supply_table(kinds: Sequence[RobotModel]) -> FloatArray:
    """Return the battery parameters of kinds of robots for kernels, (kinds, 14)."""
    rows = [_row(model) for model in kinds]
    return np.array(rows, dtype=np.float64).reshape(-1, 14)


def _row(model: RobotModel) -> list[float]:
    computers = model.device("computer_battery") or ENDLESS
    motors: MotorBattery = model.device("motor_battery") or ENDLESS_MOTORS
    both = computers, motors
    return [
        *(each.charge for each in both),
        *(each.power_w for each in both),
        *(each.capacity_j for each in both),
        _least_charge(motors),
        *_levers(model),
        motors.friction_n,
        _moved_kg(model),
        1.0 / motors.efficiency,
        motors.stall_w,
    ]


class Voltages:
    """The voltages of each kind of robot's batteries.

    Attributes:
        full_bytes: the bytes that are sent if all are unlimited, else None.
    """

    def __init__(self, models: Sequence[RobotModel]) -> None:
        computers = [model.device("computer_battery") or ENDLESS for model in models]
        motors: list[MotorBattery] = [
            model.device("motor_battery") or ENDLESS_MOTORS for model in models
        ]
        every = [each for pair in zip(computers, motors, strict=True) for each in pair]
        curves_v = [each.curve_v for each in every]
        self._curves_v = list(zip(curves_v[::2], curves_v[1::2], strict=True))
        tables = [_bytes(curve_v, _FACTORS[place % 2]) for place, curve_v in enumerate(curves_v)]
        self._bytes = np.array(tables, np.int32).ravel()
        self._first = np.arange(2 * len(models)).reshape(-1, 2) * _SIZE  # in that table
        self.full_bytes: Int32Array | None = None
        if all(np.isinf(each.capacity_j) for each in every):
            start = np.array([each.charge for each in every]).reshape(-1, 2)
            self.full_bytes = self.bytes(np.arange(len(models)), start)

    def bytes(self, kinds: IndexArray, charge: FloatArray) -> Int32Array:
        """Return the bytes that are sent for states of charge."""
        steps = (charge * _STEPS + 0.5).astype(np.intp)
        places = steps + self._first.take(kinds, axis=0)
        return np.asarray(self._bytes.take(places))

    def tables(self, kinds: IndexArray) -> tuple[Int32Array, IndexArray]:
        """Return the bytes for each step of charge, and where those of some kinds begin, (k, 2)."""
        return self._bytes, self._first[kinds]

    def volts(self, kinds: IndexArray, charge: FloatArray) -> FloatArray:
        """Return the voltages at states of charge."""
        found = np.empty((len(kinds), 2))
        for place, kind in enumerate(kinds.tolist()):
            for supply, curve_v in enumerate(self._curves_v[kind]):
                found[place, supply] = _volts(curve_v, charge[place, supply])
        return found


def byte(volts: FloatArray, factor: float | tuple[float, ...] = _FACTORS) -> Int32Array:
    """Return the bytes that are sent for voltages."""
    return np.clip(np.rint((volts / factor - 2) * (255 / 3)), 0, 255).astype(np.int32)


def _levers(model: RobotModel) -> tuple[float, float, float]:
    """Return the distance [m] per unit of each axis' motion."""
    turns = model.drive.steering is not None
    return (1.0, model.radius_m, model.radius_m) if turns else (1.0, 1.0, 0.0)


def _moved_kg(model: RobotModel) -> float:
    """Return the mass that an axis moves."""
    return model.mass_kg if model.drive.steering is not None else model.mass_kg / 2


def _volts(curve_v: tuple[float, ...], charge: FloatArray) -> FloatArray:
    """Return the voltages at states of charge, from a curve at equal distances."""
    curve = np.array([*curve_v, curve_v[-1]])
    place = charge * (len(curve_v) - 1)
    before = np.floor(place).astype(np.intp)
    share = place - before
    return np.asarray((1.0 - share) * curve[before] + share * curve[before + 1])


def _bytes(curve_v: tuple[float, ...], factor: float) -> Int32Array:
    """Return the byte for each step of charge from empty to full.

    >>> _bytes((12.0, 13.0), COMPUTERS)[[0, 500]].tolist(), round((2 + 234 * 3 / 255) * MOTORS, 1)
    ([255, 255], 12.2)
    """
    charges = np.arange(_STEPS + 1) / _STEPS
    return byte(_volts(curve_v, charges), factor)


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
