"""The drives of all robots of a world, as arrays.

A drive is linear: the distance that the robot moves, and the angle by which it turns, are sums of
the motions of its axes, each with a weight. So differential and synchro drives share all formulas.

    differential:  forward = (right + left) / 2   turn = (right - left) / wheel base
    synchro:       forward = translation          turn = steering

>>> from crs_cc.sim.files.world_xml import empty_world
>>> scout = Drives.of(empty_world())
>>> scout.forward.tolist(), (1 / scout.turn[0, :2]).round(6).tolist()
([[0.5, 0.5, 0.0]], [0.345186, -0.345186])
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.core.distinct import distinct
from crs_cc.core.units import tenths_deg_to_rad, tenths_inch_to_m
from crs_cc.sim.model.axis import STILL
from crs_cc.sim.model.robot import Drive, Odometry, RobotModel
from crs_cc.sim.model.world import WorldModel

DRIVE_SIZE: Final = 19
"""Numbers in a row of `Drives.table`."""

_FINEST: Final = 1e-12  # resolution of an ideal encoder


@dataclass(frozen=True, slots=True)
class Drives:
    """Constants of all drives; arrays have shape (robots,), or (robots, 3) for three axes.

    Attributes:
        unit: size of the vendor's unit of each axis, 0.1 in [m] or 0.1 deg [rad]; 0 for a
            missing axis, so that every command to it means 0.
        speed_limit: maximum speed of an axis; 1 for a missing one.
        most_units: the same in the vendor's units; infinite for a missing one.
        ramp_limit: maximum acceleration of an axis; 1 for a missing one.
        forward: distance of the robot per unit of each axis' motion.
        turn: turn of the wheels' direction per unit of each axis' motion [rad].
        true_forward: the true distance per unit, with errors of the wheels, see `rolling`.
        true_turn: the true turn per unit.
        rolls: 1 for the axes whose wheels roll when the robot is moved along them, else 0.
        yields: whether the motors are weaker than the wheels' grip, so that they stall.
        roll_out_mps2: deceleration of limp wheels.
        step_m: maximum height of a step that the wheels can climb.
        give_up_s: time that the motors stall before they stop.
        waits_forever: whether `ws` with a timeout of 0 waits indefinitely.
        synchro: whether the robot has a synchro drive, whose base never turns.
        turret: whether it has a turret of its own.
        synchros: whether any robot has a synchro drive.
        turrets: whether any robot has a turret.
        table: what kernels need to know, see `kernels/robot.h`, (robots, `DRIVE_SIZE`).
        more: the rest of that, (robots, 5).
    """

    unit: FloatArray
    speed_limit: FloatArray
    most_units: FloatArray
    ramp_limit: FloatArray
    forward: FloatArray
    turn: FloatArray
    true_forward: FloatArray
    true_turn: FloatArray
    rolls: FloatArray
    yields: BoolArray
    roll_out_mps2: FloatArray
    step_m: FloatArray
    give_up_s: FloatArray
    waits_forever: BoolArray
    synchro: BoolArray
    turret: BoolArray
    synchros: bool
    turrets: bool
    table: FloatArray
    more: FloatArray

    @classmethod
    def of(cls, world: WorldModel) -> Self:
        """Return the drives of a world's robots."""
        models, kind = distinct([robot.model for robot in world.robots])
        few = cls._of(models)
        columns = {each.name: getattr(few, each.name) for each in fields(few)}
        for name, column in columns.items():
            if isinstance(column, np.ndarray):
                columns[name] = column[kind]
        return cls(**columns)

    @classmethod
    def _of(cls, models: Sequence[RobotModel]) -> Self:
        """Return the drives of some models of robots."""
        drives = [model.drive for model in models]
        errors = [model.odometry for model in models]
        both = list(zip(drives, errors, strict=True))
        axes = [[axis or STILL for axis in drive.axes] for drive in drives]
        turn = _rows([_turn(drive, Odometry()) for drive in drives])
        forward = _rows([_forward(drive, Odometry()) for drive in drives])
        true_turn = _rows([_turn(drive, wrong) for drive, wrong in both])
        true_forward = _rows([_forward(drive, wrong) for drive, wrong in both])
        count = _rows([_counts(drive, wrong) for drive, wrong in both])
        turret = _flags([drive.turret is not None for drive in drives])
        unit = _rows([_units(drive) for drive in drives])
        speed_limit = _rows([[axis.speed_limit for axis in three] for three in axes])
        synchro = _flags([drive.steering is not None for drive in drives])
        return cls(
            unit=unit,
            speed_limit=speed_limit,
            most_units=np.divide(
                speed_limit, unit, out=np.full_like(unit, np.inf), where=unit > 0.0
            ),
            ramp_limit=_rows([[axis.acceleration_limit for axis in three] for three in axes]),
            forward=forward,
            turn=turn,
            true_forward=true_forward,
            true_turn=true_turn,
            rolls=_rows([[1.0, float(drive.steering is None), 0.0] for drive in drives]),
            yields=_flags([drive.force_n < drive.grip_n for drive in drives]),
            roll_out_mps2=np.array([drive.roll_out_mps2 for drive in drives]),
            step_m=np.array([drive.step_m for drive in drives]),
            give_up_s=np.array([drive.give_up_s for drive in drives]),
            waits_forever=_flags([drive.waits_forever for drive in drives]),
            synchro=synchro,
            turret=turret,
            synchros=bool(synchro.any()),
            turrets=bool(turret.any()),
            table=np.column_stack([turn, forward, true_turn, true_forward, count, turret, unit]),
            more=np.column_stack([speed_limit, synchro, turret & synchro.any()]),
        )


def weighted(motions: FloatArray, weights: FloatArray) -> FloatArray:
    """Return the weighted sum of each row; both arguments of shape (k, n)."""
    # Column by column: fast, and bitwise equal for one robot and a thousand.
    total = motions[:, 0] * weights[:, 0]
    for column in range(1, motions.shape[1]):
        total += motions[:, column] * weights[:, column]
    return np.asarray(total)


def _units(drive: Drive) -> list[float]:
    length, angle = tenths_inch_to_m(1.0), tenths_deg_to_rad(1.0)
    units = [length, length, 0.0] if drive.steering is None else [length, angle, angle]
    return [unit if axis else 0.0 for unit, axis in zip(units, drive.axes, strict=True)]


def _forward(drive: Drive, wrong: Odometry) -> list[float]:
    if drive.steering is not None:
        return [wrong.scale, 0.0, 0.0]
    return [0.5 * wheel for wheel in _wheels(wrong)] + [0.0]


def _turn(drive: Drive, wrong: Odometry) -> list[float]:
    if drive.steering is not None:
        return [wrong.drift_radpm, 1.0, 0.0]
    wheel_base_m = drive.wheel_base_m * wrong.wheel_base
    right, left = _wheels(wrong)
    return [right / wheel_base_m, -left / wheel_base_m, 0.0]


def _wheels(wrong: Odometry) -> tuple[float, float]:
    """Return the factors by which the right and the left wheel are larger than nominal."""
    left = 2 / (wrong.diameters + 1)
    return wrong.scale * wrong.diameters * left, wrong.scale * left


def _counts(drive: Drive, wrong: Odometry) -> list[float]:
    length, angle = wrong.resolution_m or _FINEST, wrong.resolution_rad or _FINEST
    return [length, length, length] if drive.steering is None else [length, angle, angle]


def _rows(values: list[list[float]]) -> FloatArray:
    return np.array(values, dtype=np.float64).reshape(-1, 3)


def _flags(values: list[bool]) -> BoolArray:
    return np.array(values, dtype=np.bool_)
