"""What a world is: constant data, apart from everything that changes while it runs.

A `WorldModel` says what stands where before the first timestep: walls, boxes, cylinders, polygons,
lights, sounds, and robots, each with the `RobotModel` that says what it is made of; what the ground
is like, by which channels messages go, and what is wrong with devices from when on. `world_xml`
reads it from a file, `environment.Environment` is made from it and never changes it. All of it is
frozen, compares and hashes by content, and pickles.

Units: metres, seconds, kilograms, radians. World frame: x to the right, y up, angles
counter-clockwise from x. Robot frame: x ahead, y to the left, origin midway between the wheels.

>>> from crs_cc.sim.model.robot import Drive, RobotModel, Sonar
>>> ahead = Sonar(0, x_m=0.2, y_m=0.0, direction_rad=0.0, range_m=6.477, radius_m=1.14)
>>> scout = RobotModel("scout", radius_m=0.2, drive=Drive(wheel_base_m=0.345), sonars=(ahead,))
>>> room = WorldModel(
...     "room",
...     area=Area(0.0, 0.0, 6.0, 5.0),
...     walls=(Wall("screen", 3.0, 0.0, 3.0, 2.0, thickness_m=0.1),),
...     robots=(Robot("robot0", scout, Pose(1.0, 1.0)),),
... )
>>> round(math.degrees(room.robots[0].model.sonars[0].half_angle_rad))
10
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

from crs_cc.sim.model.beacons import Light, Sound
from crs_cc.sim.model.communication import PLAIN_COMMUNICATION, Communication
from crs_cc.sim.model.degradation import Degradation
from crs_cc.sim.model.ground import FLAT, Ground
from crs_cc.sim.model.polygon import area_m2, centroid_m
from crs_cc.sim.model.robot import IDEAL_LINK, RobotModel

FIXED_KG: Final = math.inf
"""The mass of what cannot be pushed."""

EVERYWHERE_M: Final = math.inf
"""The spread of heat that is the same wherever it is sensed."""

TALL_M: Final = math.inf
"""The height of what is as high as anything that looks at it."""


@dataclass(frozen=True, slots=True)
class Pose:
    """A place and a heading in the world frame."""

    x_m: float = 0.0
    y_m: float = 0.0
    heading_rad: float = 0.0

    def within(self, frame: Pose) -> Pose:
        """Gives the pose in the world that is this one in a frame which has a pose there."""
        cos, sin = math.cos(frame.heading_rad), math.sin(frame.heading_rad)
        return Pose(
            frame.x_m + cos * self.x_m - sin * self.y_m,
            frame.y_m + sin * self.x_m + cos * self.y_m,
            frame.heading_rad + self.heading_rad,
        )


@dataclass(frozen=True, slots=True)
class Material:
    """What the surface of a thing is made of.

    Attributes:
        colour: red, green and blue, 0 to 255, as cameras see it.
        sonar: the share of sound that it reflects, 0 to 1.
        infrared: the share of infrared light that it reflects, 0 to 1; None for what the sensor's
            definition takes surfaces for.
    """

    colour: tuple[int, int, int] = (128, 128, 128)
    sonar: float = 1.0
    infrared: float | None = None


PLAIN: Final = Material()
"""What things are made of that say nothing else."""


@dataclass(frozen=True, slots=True)
class Area:
    """The rectangle that the world is about.

    Attributes:
        x_min_m: its left edge.
        y_min_m: its lower edge.
        length_m: its size along x.
        width_m: its size along y.
        edge_m: thickness of the walls around it, which stand outside of it; 0 when it is open.
        material: what these walls are made of.
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
    """A fixed wall: a line segment with thickness, round at both ends; the rest as of a box."""

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
    """A rectangular object; `length_m` lies along the heading of its pose, `width_m` across.

    How hot it is at the start is `heat`, and how far that spreads `spread_m`, as `sensors.heat`
    senses it; `height_m` is how far it rises above the ground that it stands on. `part_of` names
    the object of the world file that it is a part of, and is empty for what stands alone.
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
        pose: its place, the middle of its area, and how far it is turned.
        corners_m: x and y of each corner from there as it stands when it is not turned,
            counter-clockwise.
        mass_kg: its mass.
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
        """Makes a polygon of its corners in the world frame, in either order."""
        corners = np.array(corners_m)
        if area_m2(corners) < 0.0:
            corners = corners[::-1]
        x_m, y_m = centroid_m(corners).tolist()
        own = tuple((x - x_m, y - y_m) for x, y in corners.tolist())
        return cls(name, Pose(x_m, y_m), own, mass_kg)


Thing: TypeAlias = Box | Cylinder | Polygon
"""What can be pushed, if it has a mass."""

Solid: TypeAlias = Wall | Thing
"""What a robot can run into, other robots apart."""


def is_pushable(solid: Solid) -> bool:
    """Tells whether a robot can push a thing away."""
    return not isinstance(solid, Wall) and solid.mass_kg < FIXED_KG


@dataclass(frozen=True, slots=True)
class Robot:
    """One robot of a world.

    Attributes:
        id: its name, unique in the world.
        model: what it is made of.
        start: its pose at the start.
        program: the C file that it runs, as a path that can be opened; empty when the world
            does not say.
        arguments: what the program gets in `argv`, behind its own name.
        heat: how hot it is at the start, as of a box.
        dialect: whose functions the program calls: the vendor's, `nomad`, or those of the CRS
            report, `report`; None when the world does not say.
        material: what its shell is made of.
        join_s: when it comes into the world; 0 for one that is there from the start.
        leave_s: when it leaves, infinite for one that stays.
        spread_m: how far its heat spreads, as of a box.
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
        """How high it is, as of a box."""
        return self.model.height_m


@dataclass(frozen=True, slots=True)
class WorldModel:
    """A whole world; the order within each tuple is that of the file, and is part of it.

    `duration_s` is how long a run lasts, and `seed` where its random numbers start; None where
    whoever runs it has to say so.
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

    def with_ideal_link(self) -> WorldModel:
        """Gives the same world with commands that take no time on their way to the robot."""
        robots = tuple(
            replace(robot, model=replace(robot.model, link=IDEAL_LINK)) for robot in self.robots
        )
        return replace(self, robots=robots)

    def edge_walls(self) -> tuple[Wall, ...]:
        """Gives the walls around the area; their inner sides lie on its edges."""
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
        """Gives everything that a robot can run into, other robots apart."""
        return (
            *self.edge_walls(), *self.walls, *self.boxes, *self.cylinders, *self.polygons
        )  # fmt: skip
