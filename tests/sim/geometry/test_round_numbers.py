"""Sensors in worlds on whole decimetres, where beams run along sides and through corners.

There the result is decided by rounding. So a robot must read what it reads when it is moved or
turned very slightly: one of the readings there, if these differ.
"""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from crs_cc.sim.devices.ray_caster import RayCaster
from crs_cc.sim.geometry.echoes import first_echo
from crs_cc.sim.geometry.line_of_sight import Sight
from crs_cc.sim.geometry.pings import ANY_ANGLE, Pings
from crs_cc.sim.geometry.placement import misplaced
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.shape_table import ShapeTable
from crs_cc.sim.model.robot import Drive, RobotModel
from crs_cc.sim.model.world import (
    Area,
    Box,
    Cylinder,
    Material,
    Polygon,
    Pose,
    Robot,
    Wall,
    WorldModel,
)
from crs_cc.sim.state.env_state import EnvState

RADIUS_M = 0.2
HAIR = 1e-6  # [m] and [rad]
SAME_M = 4e-3  # a beam that grazes a circle moves by the root of a hair
SIDE = 6  # of the world
ROBOT = RobotModel("round", RADIUS_M, Drive(0.3))
AROUND = [math.radians(22.5) * number for number in range(16)]
SHAPES = [
    ((0, 0), (1, 0), (0, 1)),
    ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)),
    ((0, 0), (1, 1), (0, 2), (-1, 1)),
]
FANS = {
    "infrared": Fan.of(
        (RADIUS_M * math.cos(at), RADIUS_M * math.sin(at), at, math.radians(15), 0.9)
        for at in AROUND
    ),
    "laser": Fan.of((0.1, 0.0, math.radians(at), 0.0, 6.0) for at in range(-90, 91, 5)),
    "camera": Fan.of((0.0, 0.0, math.radians(at + 0.5), 0.0, 12.0) for at in range(-30, 30)),
}
SONARS = {  # half angle, lobe, critical angle
    "cone": (12.5, 0.0, ANY_ANGLE),
    "lobe": (20.0, math.radians(7.5), ANY_ANGLE),
    "smooth": (15.0, 0.0, math.radians(30)),
    "thin": (1e-6, 0.0, ANY_ANGLE),
}


def round_world(seed: int) -> WorldModel | None:
    """Return a world of round numbers, None if its robot would overlap an object."""
    chance = random.Random(seed)
    finest = chance.choice([1, 2, 10])

    def place() -> tuple[float, float]:
        most = SIDE * finest
        return chance.randint(0, most) / finest, chance.randint(0, most) / finest

    def pose() -> Pose:
        return Pose(*place(), math.radians(chance.choice([0, 0, 22.5, 45, 90, 135, 180, 270])))

    def box(number: int) -> Box:
        sides = chance.choice([0.2, 0.5, 1, 2]), chance.choice([0.2, 0.5, 1])
        soft = Material(sonar=chance.choice([1.0, 0.3]))
        return Box(f"box{number}", pose(), *sides, chance.choice([math.inf, 1.0]), material=soft)

    def wall(number: int) -> Wall:
        (x, y), (along_x, along_y) = place(), chance.choice([(1, 0), (0, 2), (1, 1), (-1, 1)])
        return Wall(f"wall{number}", x, y, x + along_x, y + along_y, chance.choice([0.1, 0.2]))

    def polygon(number: int) -> Polygon:
        x, y = place()
        return Polygon.of(f"p{number}", tuple((x + a, y + b) for a, b in chance.choice(SHAPES)))

    world = WorldModel(
        "round",
        Area(0, 0, SIDE, SIDE, chance.choice([0, 0.1])),
        walls=tuple(wall(number) for number in range(chance.randint(0, 2))),
        boxes=tuple(box(number) for number in range(chance.randint(1, 4))),
        cylinders=(Cylinder("pillar", pose(), chance.choice([0.1, 0.2, 0.5])),),
        polygons=tuple(polygon(number) for number in range(chance.randint(0, 2))),
        robots=(Robot("robot0", ROBOT, pose()),),
    )
    return None if misplaced(world, 1) else world


class Watcher:
    """All measurements of a robot in a world, from any pose."""

    def __init__(self, world: WorldModel) -> None:
        scene = Scene(world)
        self.state = EnvState.at_start(world)
        self.ahead = Fan.of([(0.0, 0.0, 0.0, 0.0, 2.0 * SIDE)])
        self.around = RayCaster(scene, [*FANS.values(), self.ahead])
        self.sight, self.shapes = Sight(scene), ShapeTable.of(scene)
        self.poses = self.shapes.poses(self.state.bodies)
        grid = np.stack(np.meshgrid(np.arange(0.5, SIDE), np.arange(0.5, SIDE)), axis=-1)
        self.lights = np.array(
            [at for at in grid.reshape(-1, 2) if self.room_m(*at)[1:].min() > 0.01]
        )

    def room_m(self, x_m: float, y_m: float) -> np.ndarray:
        """Return the distances of all objects from a point, as for the heat sensor."""
        count = len(self.poses)
        places = np.full(count, x_m), np.full(count, y_m)
        return self.shapes.distance_m(self.poses, np.arange(count), *places)

    def read(self, x_m: float, y_m: float, heading_rad: float) -> dict[str, np.ndarray]:
        """Return the readings of all kinds."""
        pose, own = np.array([(x_m, y_m, heading_rad)]), np.array([0])
        found = {
            name: self.around.distances_m(self.state, fan, pose, own)[0]
            for name, fan in FANS.items()
        }
        found["heat"] = self.room_m(x_m, y_m)[1:]
        place, echo_range = complex(x_m, y_m), self.around.surfaces.echo_range
        beams = [(place, place + RADIUS_M * np.exp(1j * (at + heading_rad)), at + heading_rad)
                 for at in AROUND]  # fmt: skip
        for name, (half_deg, lobe_rad, critical_rad) in SONARS.items():
            pings = Pings.of(beams, math.radians(half_deg), 6.5, lobe_rad, critical_rad)
            pings = replace(pings, own=np.zeros(len(pings), dtype=np.intp))
            obstacles = self.around.obstacles(self.state)
            found[name], found[f"soft {name}"] = (
                first_echo(pings, obstacles, echo_range=soft) for soft in (None, echo_range)
            )
        if not len(self.lights):
            return found
        way = self.lights - (x_m, y_m)
        poses = np.tile(pose, (len(way), 1))
        poses[:, 2] = np.arctan2(way[:, 1], way[:, 0])
        hit_m = self.around.distances_m(self.state, self.ahead, poses, np.zeros(len(way), np.intp))
        found["light and sound"] = hit_m[:, 0] >= np.hypot(*way.T)
        bodies, ends = self.state.bodies, self.lights @ [1, 1j]
        found["messages"] = self.sight.between(
            bodies.position_m, bodies.angle_rad, np.full(len(ends), place), ends
        )
        return found


@pytest.mark.parametrize("first", range(0, 60, 10))
def test_readings_at_round_numbers_match_those_slightly_aside(first):
    aside = [HAIR * np.exp(1j * (0.1 + math.pi / 4 * part)) for part in range(8)]
    for world in filter(None, map(round_world, range(first, first + 10))):
        watcher, start = Watcher(world), world.robots[0].start
        readings = watcher.read(start.x_m, start.y_m, start.heading_rad)
        others = [
            watcher.read(start.x_m + by.real, start.y_m + by.imag, start.heading_rad + turn)
            for by in aside
            for turn in (-1.3 * HAIR, 1.7 * HAIR)
        ]
        for name, reading in readings.items():
            near = [np.isclose(reading, other[name], rtol=0.0, atol=SAME_M) for other in others]
            wrong = np.flatnonzero(~np.any(near, axis=0))
            assert not len(wrong), (world, name, wrong, reading[wrong])
