"""What the robots of a world are made of, as arrays: constants for the vectorised parts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Int64Array
from crs_cc.sim.devices.degradation.filter import Degradations
from crs_cc.sim.devices.drive.constants import Drives
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.shape_table import ShapeTable
from crs_cc.sim.model.registry import devices
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.sonar import MAX_SONARS
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.physics.inclines import Inclines


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotConstants:
    """Constants of all robots; arrays have shape (robots,), those of `shapes` apart.

    Attributes:
        timestep_s: the world's timestep [s].
        drives: the drives.
        vendor_model: the vendor's number of the model.
        least_interval_s: the shortest time from one sonar's firing to the next.
        sonars: which sonars each robot has, (robots, 16).
        sonar_modes: in how many modes the sonars can work, 0 for a robot without sonars.
        bumpers: whether it has bumpers.
        infrared: number of each robot among those that have an infrared ring, -1 for the others.
        compass: the same for compasses.
        laser: the same for lasers.
        sensors: the same for each device of `registry.devices()`, by its name.
        camera: the same for cameras.
        gripper: the same for grippers.
        arm: the same for arms.
        heat: the same for heat sensors.
        light: the same for rings of light sensors.
        sound: the same for microphones.
        brightest: how bright the lamp can shine, 0 where there is none.
        loudest: how loud the speaker can sound, 0 where there is none.
        laser_points: how many points a laser can tell.
        calibration_s: how long a compass turns around to be calibrated.
        heat_range_m: how far the heat sensor senses, 0 where there is none.
        tag_range_m: how far heat is taken away.
        radius_m: the radius of the body.
        degradations: what becomes of values on their way from and to devices.
        world: what stood where before the first cycle.
        scene: the outlines of all things, as they are now.
        shapes: their shapes.
        inclines: the slopes of the ground, None where it is flat.
    """

    timestep_s: float
    drives: Drives
    vendor_model: Int64Array
    least_interval_s: FloatArray
    sonars: BoolArray
    sonar_modes: Int64Array
    bumpers: BoolArray
    infrared: IndexArray
    compass: IndexArray
    laser: IndexArray
    sensors: Mapping[str, IndexArray]
    camera: IndexArray
    gripper: IndexArray
    arm: IndexArray
    heat: IndexArray
    light: IndexArray
    sound: IndexArray
    brightest: FloatArray
    loudest: FloatArray
    laser_points: Int32Array
    calibration_s: FloatArray
    heat_range_m: FloatArray
    tag_range_m: FloatArray
    radius_m: FloatArray
    degradations: Degradations
    world: WorldModel
    scene: Scene
    shapes: ShapeTable
    inclines: Inclines | None

    @classmethod
    def of(cls, world: WorldModel, seed: int = 0) -> Self:
        """Return the constants of a world's robots; the seed decides its degradations."""
        models = [robot.model for robot in world.robots]
        scene = Scene(world)
        return cls(
            timestep_s=world.timestep_s,
            drives=Drives.of(world),
            vendor_model=np.array([model.vendor_model for model in models], dtype=np.int64),
            least_interval_s=np.array([model.sonar_board.least_interval_s for model in models]),
            sonars=_sonars(models),
            sonar_modes=np.array(
                [len(model.sonar_modes) if model.sonars else 0 for model in models], np.int64
            ),
            bumpers=np.array([bool(model.bumpers) for model in models], dtype=np.bool_),
            infrared=_numbers([model.infrared is not None for model in models]),
            compass=_numbers([model.compass is not None for model in models]),
            laser=_numbers([model.laser is not None for model in models]),
            sensors={
                device.name: _numbers([model.device(device.name) is not None for model in models])
                for device in devices()
            },
            camera=_numbers([model.camera is not None for model in models]),
            gripper=_numbers([model.gripper is not None for model in models]),
            arm=_numbers([model.arm is not None for model in models]),
            heat=_numbers([model.heat.range_m > 0.0 for model in models]),
            light=_numbers([model.light_sensors is not None for model in models]),
            sound=_numbers([model.microphones is not None for model in models]),
            brightest=np.array([model.brightest for model in models]),
            loudest=np.array([model.loudest for model in models]),
            laser_points=np.array(
                [model.laser.points if model.laser else 0 for model in models], np.int32
            ),
            calibration_s=np.array(
                [model.compass.calibration_s if model.compass else 0.0 for model in models]
            ),
            heat_range_m=np.array([model.heat.range_m for model in models]),
            tag_range_m=np.array([model.heat.tag_range_m for model in models]),
            radius_m=np.array([model.radius_m for model in models]),
            degradations=Degradations(seed),
            world=world,
            scene=scene,
            shapes=ShapeTable.of(scene),
            inclines=None if world.surface.is_flat else Inclines(world, scene),
        )

    def last_instant_s(self, cycle: int) -> float:
        """Return the last instant of a cycle [s]: its end belongs to the next one."""
        return float(np.nextafter((cycle + 1) * self.timestep_s, 0.0))


def _sonars(models: Sequence[RobotModel]) -> BoolArray:
    """Tells which sonars robots have."""
    has = np.zeros((len(models), MAX_SONARS), dtype=np.bool_)
    for row, model in zip(has, models, strict=True):
        row[[sonar.id for sonar in model.sonars]] = True
    return has


def _numbers(has: list[bool]) -> IndexArray:
    """Numbers the robots that have something; the others get -1.

    >>> _numbers([False, True, True]).tolist()
    [-1, 0, 1]
    """
    return np.where(has, np.cumsum(has) - 1, -1).astype(np.intp)
