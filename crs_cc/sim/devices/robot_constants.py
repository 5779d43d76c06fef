"""The robots of a world as arrays: constants for the vectorised parts."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int64Array
from crs_cc.core.distinct import distinct
from crs_cc.sim.devices.battery.supplies import supply_table
from crs_cc.sim.devices.clock import clock_table
from crs_cc.sim.devices.degradation.filter import Degradations
from crs_cc.sim.devices.drive.constants import Drives
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.shape_table import ShapeTable
from crs_cc.sim.model.registry import devices
from crs_cc.sim.model.robot import RobotModel, devices_of
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.physics.inclines import Inclines
from crs_cc.sim.state.robot_kinds import RobotKinds


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotConstants:
    """Constants of all robots; arrays have shape (robots,), except those of `shapes`.

    Attributes:
        timestep_s: the world's timestep [s].
        vendor_model: the vendor's number of the model.
        numbers: the same for each device of `registry.devices()`, by its name.
        radius_m: the radius of the body.
        degradations: the filter of values from and to devices.
        world: the world before the first cycle.
        scene: the outlines of all objects, as they are now.
        inclines: the slopes of the ground, None where it is flat.
        kinds: what kernels know of robots.
    """

    timestep_s: float
    drives: Drives
    vendor_model: Int64Array
    numbers: Mapping[str, IndexArray]
    radius_m: FloatArray
    degradations: Degradations
    world: WorldModel
    scene: Scene
    shapes: ShapeTable
    inclines: Inclines | None
    kinds: RobotKinds

    @classmethod
    def of(cls, world: WorldModel, seed: int = 0) -> Self:
        """Return the constants of a world's robots; the seed decides its degradations."""
        models = [robot.model for robot in world.robots]
        scene, drives = Scene(world), Drives.of(world)
        numbers = {
            each.name: _numbers([found is not None for found in devices_of(models, each.name)])
            for each in devices()
        }
        return cls(
            timestep_s=world.timestep_s,
            drives=drives,
            vendor_model=np.array([model.vendor_model for model in models], dtype=np.int64),
            numbers=numbers,
            radius_m=np.array([model.radius_m for model in models]),
            degradations=Degradations(seed),
            world=world,
            scene=scene,
            shapes=ShapeTable.of(scene),
            inclines=None if world.surface.is_flat else Inclines(world, scene),
            kinds=_kinds(models, drives, numbers["motor_battery"]),
        )

    def last_time_s(self, cycle: int) -> float:
        """Return the last time in a cycle [s]: its end belongs to the next one."""
        return math.nextafter((cycle + 1) * self.timestep_s, 0.0)


def _kinds(models: Sequence[RobotModel], drives: Drives, battery: IndexArray) -> RobotKinds:
    kinds, kind = distinct(models)
    first = np.unique(kind, return_index=True)[1]
    parts = drives.table[first], drives.more[first], supply_table(kinds), clock_table(kinds)
    return RobotKinds(np.ascontiguousarray(np.column_stack(parts)), kind, battery)


def _numbers(has: list[bool]) -> IndexArray:
    """Return consecutive numbers for the robots that have a device, -1 for the others.

    >>> _numbers([False, True, True]).tolist()
    [-1, 0, 1]
    """
    return np.where(has, np.cumsum(has) - 1, -1).astype(np.intp)
