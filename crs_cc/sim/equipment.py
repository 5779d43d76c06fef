"""What the robots of a world are made of, as arrays: constants for the vectorised parts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
import numpy.typing as npt

from crs_cc.sim.model import WorldModel
from crs_cc.sim.robot_model import STILL, Drive
from crs_cc.sim.scene import Scene
from crs_cc.sim.things import Things
from crs_cc.units import tenths_deg_to_rad, tenths_inch_to_m

FloatArray = npt.NDArray[np.float64]
IndexArray = npt.NDArray[np.intp]
BoolArray = npt.NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Equipment:
    """Constants of all robots; each array has shape (robots,) or (robots, 3) for three axes.

    Those of `things` apart.

    Attributes:
        timestep_s: the world's timestep [s].
        unit: size of the vendor's unit of each axis, 0.1 in [m] or 0.1 deg [rad]; 0 for an axis
            that is not there, so that every command to it means 0.
        speed_limit: the fastest that an axis can run; 1 for one that is not there.
        ramp_limit: the fastest that its speed can change; 1 for one that is not there.
        forward: way of the robot for each unit of each axis' way.
        turn: by how much the wheels' direction turns for each unit of each axis' way [rad].
        synchro: whether the robot has a synchro drive, whose base never turns.
        turret: whether it has a turret of its own.
        turrets: whether any robot has.
        vendor_model: the vendor's number of the model.
        least_interval_s: the shortest time from one sonar's firing to the next.
        infrared: number of each robot among those that have an infrared ring, -1 for the others.
        compass: the same for compasses.
        calibration_s: how long a compass turns around to be calibrated.
        heat_range_m: how far the heat sensor senses, 0 where there is none.
        tag_range_m: how far heat is taken away.
        radius_m: the radius of the body.
        world: what stood where before the first cycle.
        scene: the outlines of all things, as they are now.
        things: their shapes.
    """

    timestep_s: float
    unit: FloatArray
    speed_limit: FloatArray
    ramp_limit: FloatArray
    forward: FloatArray
    turn: FloatArray
    synchro: BoolArray
    turret: BoolArray
    turrets: bool
    vendor_model: npt.NDArray[np.int64]
    least_interval_s: FloatArray
    infrared: IndexArray
    compass: IndexArray
    calibration_s: FloatArray
    heat_range_m: FloatArray
    tag_range_m: FloatArray
    radius_m: FloatArray
    world: WorldModel
    scene: Scene
    things: Things

    @classmethod
    def of(cls, world: WorldModel) -> Self:
        """Gives the equipment of a world's robots."""
        models = [robot.model for robot in world.robots]
        drives = [model.drive for model in models]
        axes = [[axis or STILL for axis in drive.axes] for drive in drives]
        return cls(
            world.timestep_s,
            _rows([_units(drive) for drive in drives]),
            _rows([[axis.speed_limit for axis in three] for three in axes]),
            _rows([[axis.acceleration_limit for axis in three] for three in axes]),
            _rows([_forward(drive) for drive in drives]),
            _rows([_turn(drive) for drive in drives]),
            np.array([drive.steering is not None for drive in drives], dtype=np.bool_),
            np.array([drive.turret is not None for drive in drives], dtype=np.bool_),
            any(drive.turret is not None for drive in drives),
            np.array([model.vendor_model for model in models], dtype=np.int64),
            np.array([model.sonar_board.least_interval_s for model in models]),
            _numbers([model.infrared is not None for model in models]),
            _numbers([model.compass is not None for model in models]),
            np.array([model.compass.calibration_s if model.compass else 0.0 for model in models]),
            np.array([model.heat.range_m for model in models]),
            np.array([model.heat.tag_range_m for model in models]),
            np.array([model.radius_m for model in models]),
            world,
            Scene(world),
            Things.of(world),
        )


def _numbers(has: list[bool]) -> IndexArray:
    """Numbers the robots that have something; the others get -1.

    >>> _numbers([False, True, True]).tolist()
    [-1, 0, 1]
    """
    return np.where(has, np.cumsum(has) - 1, -1).astype(np.intp)


def _units(drive: Drive) -> list[float]:
    way, angle = tenths_inch_to_m(1.0), tenths_deg_to_rad(1.0)
    units = [way, way, 0.0] if drive.steering is None else [way, angle, angle]
    return [unit if axis else 0.0 for unit, axis in zip(units, drive.axes, strict=True)]


def _forward(drive: Drive) -> list[float]:
    """A differential drive goes the mean of its wheels' ways, a synchro drive that of axis 1."""
    return [0.5, 0.5, 0.0] if drive.steering is None else [1.0, 0.0, 0.0]


def _turn(drive: Drive) -> list[float]:
    """A differential drive turns by the wheels' difference over their distance."""
    if drive.steering is None:
        return [1 / drive.wheel_base_m, -1 / drive.wheel_base_m, 0.0]
    return [0.0, 1.0, 0.0]


def _rows(values: list[list[float]]) -> FloatArray:
    return np.array(values, dtype=np.float64).reshape(-1, 3)
