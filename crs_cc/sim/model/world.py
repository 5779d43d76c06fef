"""World models: the constant data of a world.

A `WorldModel` has the initial state of everything: walls, boxes, cylinders, polygons, lights,
sounds, and robots, each with its `RobotModel`; the ground, the pheromone fields, the communication
channels, the degradations of devices, and the goals. `files.world_xml` reads it from a file; an
`engine.environment.Environment` is made from it and never changes it. All of it is frozen, compares
and hashes by content, and pickles.

Units: metres, seconds, kilograms, radians. World frame: x to the right, y up, angles
counter-clockwise from x. Robot frame: x ahead, y to the left, origin midway between the wheels.

>>> from crs_cc.sim.model.robot import Drive, RobotModel
>>> scout = RobotModel("scout", radius_m=0.2, drive=Drive(wheel_base_m=0.345))
>>> room = WorldModel(
...     "room",
...     area=Area(0.0, 0.0, 6.0, 5.0),
...     walls=(Wall("screen", 3.0, 0.0, 3.0, 2.0, thickness_m=0.1),),
...     robots=(Robot("robot0", scout, Pose(1.0, 1.0)),),
... )
>>> [wall.id for wall in room.edge_walls()]
['edge-south', 'edge-east', 'edge-north', 'edge-west']
>>> hash(room) == hash(WorldModel("room", room.area, room.walls, robots=room.robots))
True
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final, Literal, Self, TypeAlias

import numpy as np

from crs_cc.sim.kernels import exact
from crs_cc.sim.model.beacons import Light, Sound
from crs_cc.sim.model.communication import PLAIN_COMMUNICATION, Communication
from crs_cc.sim.model.degradation import Degradation
from crs_cc.sim.model.fields import Field
from crs_cc.sim.model.foraging import Nest, Source
from crs_cc.sim.model.goals import Goal
from crs_cc.sim.model.ground import FLAT, Ground
from crs_cc.sim.model.polygon import area_m2, centroid_m
from crs_cc.sim.model.robot import IDEAL_LINK, RobotModel

FIXED_KG: Final = math.inf
"""Mass of a fixed object."""

EVERYWHERE_M: Final = math.inf
"""Spread of heat that is the same everywhere."""

TALL_M: Final = math.inf
"""Height of an object that is visible at any height."""


@dataclass(frozen=True, slots=True)
class Pose:
    """A position and a heading in the world frame."""

    x_m: float = 0.0
    y_m: float = 0.0
    heading_rad: float = 0.0

    def within(self, frame: Pose) -> Pose:
        """Transform this pose from a frame, given by its pose in the world, to the world frame."""
        cos, sin = exact.cos(frame.heading_rad), exact.sin(frame.heading_rad)
        return Pose(
            frame.x_m + cos * self.x_m - sin * self.y_m,
            frame.y_m + sin * self.x_m + cos * self.y_m,
            frame.heading_rad + self.heading_rad,
        )


@dataclass(frozen=True, slots=True)
class Material:
    """The surface of an object.

    Attributes:
        colour: red, green and blue, 0 to 255, as cameras see it.
        sonar: its reflectance for sound, 0 to 1.
        infrared: its reflectance for infrared light, 0 to 1; None for the value that the sensor's
            definition assumes.
    """

    colour: tuple[int, int, int] = (128, 128, 128)
    sonar: float = 1.0
    infrared: float | None = None


PLAIN: Final = Material()
"""The default material."""


@dataclass(frozen=True, slots=True)
class Area:
    """The rectangular area of a world.

    Attributes:
        x_min_m: its left edge.
        y_min_m: its lower edge.
        length_m: its size along x.
        width_m: its size along y.
        edge_m: thickness of the walls around it, which are outside of it; 0 for no walls.
        material: the material of these walls.
    """

    x_min_m: float
    y_min_m: float
    length_m: float
    width_m: float
    edge_m: float = 0.1
    material: Material = PLAIN

    @property
    def x_max_m(self) -> float:
        """The right edge."""
        return self.x_min_m + self.length_m

    @property
    def y_max_m(self) -> float:
        """The upper edge."""
        return self.y_min_m + self.width_m


@dataclass(frozen=True, slots=True)
class Wall:
    """A fixed wall: a line segment with thickness and round ends; the rest as of a box."""

    id: str
    x1_m: float
    y1_m: float
    x2_m: float
    y2_m: float
    thickness_m: float = 0.1
    heat: float = 0.0
    material: Material = PLAIN
    height_m: float = TALL_M
    spread_m: float = EVERYWHERE_M


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangular object; `length_m` is along the heading of its pose, `width_m` across.

    `heat` is its initial heat and `spread_m` the distance over which it spreads, as `devices.heat`
    senses it; `height_m` is its height above the ground at its position. `part_of` is the name of
    the composite object of the world file that it belongs to, and empty for a single object.
    """

    id: str
    pose: Pose
    length_m: float
    width_m: float
    mass_kg: float = FIXED_KG
    heat: float = 0.0
    material: Material = PLAIN
    height_m: float = TALL_M
    spread_m: float = EVERYWHERE_M
    part_of: str = ""


@dataclass(frozen=True, slots=True)
class Cylinder:
    """A round object; the rest as of a box."""

    id: str
    pose: Pose
    radius_m: float
    mass_kg: float = FIXED_KG
    heat: float = 0.0
    material: Material = PLAIN
    height_m: float = TALL_M
    spread_m: float = EVERYWHERE_M
    part_of: str = ""


@dataclass(frozen=True, slots=True)
class Polygon:
    """An object with straight sides.

    Attributes:
        id: its name.
        pose: the centroid of its area, and its rotation.
        corners_m: x and y of each corner relative to the centroid, before rotation,
            counter-clockwise.
        heat: as of a box.
        material: as of a box.
        height_m: as of a box.
        spread_m: as of a box.
        part_of: as of a box.
    """

    id: str
    pose: Pose
    corners_m: tuple[tuple[float, float], ...]
    mass_kg: float = FIXED_KG
    heat: float = 0.0
    material: Material = PLAIN
    height_m: float = TALL_M
    spread_m: float = EVERYWHERE_M
    part_of: str = ""

    @classmethod
    def of(
        cls, name: str, corners_m: Sequence[tuple[float, float]], mass_kg: float = FIXED_KG
    ) -> Self:
        """Create a polygon from its corners in the world frame, in either order."""
        corners = np.array(corners_m)
        if area_m2(corners) < 0.0:
            corners = corners[::-1]
        x_m, y_m = centroid_m(corners).tolist()
        own = tuple((x - x_m, y - y_m) for x, y in corners.tolist())
        return cls(name, Pose(x_m, y_m), own, mass_kg)


WorldObject: TypeAlias = Box | Cylinder | Polygon
"""A movable object, if it has a mass."""

Solid: TypeAlias = Wall | WorldObject
"""An object that a robot can collide with, except other robots."""


def is_pushable(solid: Solid) -> bool:
    """Return whether a robot can push an object."""
    return not isinstance(solid, Wall) and solid.mass_kg < FIXED_KG


@dataclass(frozen=True, slots=True)
class Robot:
    """One robot of a world.

    Attributes:
        id: its name, unique in the world.
        model: its robot model.
        start: its initial pose.
        program: path of its C program; empty if the world does not set one.
        arguments: the program's arguments, without its name.
        heat: its initial heat, as of a box.
        dialect: the library that the program calls: the vendor's, `nomad`, or that of the CRS
            report, `report`; None if the world does not set one.
        material: the material of its shell.
        join_s: time at which it joins the world; 0 for the start.
        leave_s: time at which it leaves; infinite for never.
        spread_m: spread of its heat, as of a box.
    """

    id: str
    model: RobotModel
    start: Pose = Pose()
    program: str = ""
    arguments: tuple[str, ...] = ()
    heat: float = 0.0
    dialect: Literal["nomad", "report"] | None = None
    material: Material = PLAIN
    join_s: float = 0.0
    leave_s: float = math.inf
    spread_m: float = EVERYWHERE_M

    @property
    def height_m(self) -> float:
        """Its height, as of a box."""
        return self.model.height_m


@dataclass(frozen=True, slots=True)
class WorldModel:
    """A world; the order within each tuple is that of the file, and is significant.

    `duration_s` is the length of a run, and `seed` its random seed; None if the world does not set
    it.
    """

    name: str
    area: Area
    walls: tuple[Wall, ...] = ()
    boxes: tuple[Box, ...] = ()
    cylinders: tuple[Cylinder, ...] = ()
    polygons: tuple[Polygon, ...] = ()
    robots: tuple[Robot, ...] = ()
    timestep_s: float = 0.05
    duration_s: float | None = None
    seed: int | None = None
    surface: Ground = FLAT
    lights: tuple[Light, ...] = ()
    sounds: tuple[Sound, ...] = ()
    degradations: tuple[Degradation, ...] = ()
    communication: Communication = PLAIN_COMMUNICATION
    goals: tuple[Goal, ...] = ()
    fields: tuple[Field, ...] = ()
    sources: tuple[Source, ...] = ()
    nests: tuple[Nest, ...] = ()

    def with_ideal_link(self) -> WorldModel:
        """Return a copy in which commands have no delay on the link to the robot."""
        robots = tuple(
            replace(robot, model=replace(robot.model, link=IDEAL_LINK)) for robot in self.robots
        )
        return replace(self, robots=robots)

    def edge_walls(self) -> tuple[Wall, ...]:
        """Return the walls around the area; their inner sides are on its edges."""
        area, half_m = self.area, self.area.edge_m / 2
        if area.edge_m == 0.0:
            return ()
        form = (area.edge_m, 0.0, area.material)
        west, east = area.x_min_m - half_m, area.x_max_m + half_m
        south, north = area.y_min_m - half_m, area.y_max_m + half_m
        return (
            Wall("edge-south", west, south, east, south, *form),
            Wall("edge-east", east, south, east, north, *form),
            Wall("edge-north", east, north, west, north, *form),
            Wall("edge-west", west, north, west, south, *form),
        )

    def solids(self) -> tuple[Solid, ...]:
        """Return everything that a robot can collide with, except other robots."""
        return (
            *self.edge_walls(), *self.walls, *self.boxes, *self.cylinders, *self.polygons
        )  # fmt: skip
