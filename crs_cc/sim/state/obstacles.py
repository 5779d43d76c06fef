"""Objects that programs added to the world, and objects that they removed."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import compress
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, IndexArray, Int32Array, Int64Array
from crs_cc.core.suggest import unknown
from crs_cc.core.units import tenths_inch_to_m
from crs_cc.sim.model.world import Polygon, Solid, WorldModel

Corners = Int32Array

MAX_VERTICES: Final = 10
"""Maximum number of corners of a polygon in the vendor's interface (`MAX_VERTICES`)."""

_ADDED: Final = "obstacle-"


@dataclass(slots=True)
class ObstacleState:
    """The polygons that programs added, in the order of their numbers, and the removed objects.

    Arrays are never changed in place.

    Attributes:
        corners: x and y of each corner in the world frame [0.1 in], counter-clockwise, then zeros;
            shape (added, 10, 2).
        sizes: number of corners of each, (added,).
        numbers: the number in the name of each, (added,).
        owners: the robot whose program added it, (added,).
        made: number of polygons ever added.
        standing: whether each object of the world file is still present: walls, boxes, cylinders,
            polygons, (objects,).
    """

    corners: Corners
    sizes: Int64Array
    numbers: Int64Array
    owners: Int64Array
    made: int
    standing: BoolArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return the obstacles of a world that no program has changed."""
        none = np.zeros(0, dtype=np.int64)
        objects = np.ones(len(world_objects(world)), dtype=np.bool_)
        return cls(np.zeros((0, MAX_VERTICES, 2), np.int32), none, none, none, 0, objects)

    def of(self, added: int) -> Corners:
        """Return the corners of an added polygon, shape (corners, 2)."""
        return self.corners[added, : self.sizes[added]]

    def take(self, rows: IndexArray) -> Self:
        """Return a copy with a selection of the added polygons."""
        return replace(
            self,
            corners=self.corners[rows],
            sizes=self.sizes[rows],
            numbers=self.numbers[rows],
            owners=self.owners[rows],
        )

    def same_as(self, other: ObstacleState) -> bool:
        """Return whether the same objects are present."""
        return (
            np.array_equal(self.numbers, other.numbers)
            and np.array_equal(self.corners, other.corners)
            and np.array_equal(self.sizes, other.sizes)
            and np.array_equal(self.standing, other.standing)
        )

    def world_now(self, world: WorldModel) -> WorldModel:
        """Return a world with the added objects, and without the removed ones."""
        left = iter(self.standing.tolist())
        added = [polygon_of(number, self.of(n)) for n, number in enumerate(self.numbers.tolist())]
        return replace(
            world,
            walls=tuple(compress(world.walls, left)),
            boxes=tuple(compress(world.boxes, left)),
            cylinders=tuple(compress(world.cylinders, left)),
            polygons=(*compress(world.polygons, left), *added),
        )


def without(obstacles: ObstacleState, world: WorldModel, name: str) -> ObstacleState:
    """Return the obstacles without an object of the world file or one added by a program.

    Raises:
        ValueError: there is no such object.
    """
    added = [f"{_ADDED}{number}" for number in obstacles.numbers.tolist()]
    if name in added:
        return obstacles.take(np.delete(np.arange(len(added)), added.index(name)))
    names = [obj.id for obj in world_objects(world)]
    there = list(compress(names, obstacles.standing.tolist()))
    if name not in there:
        raise ValueError(unknown("object", name, (*there, *added)))
    standing = obstacles.standing & (np.arange(len(names)) != names.index(name))
    return replace(obstacles, standing=standing)


def world_objects(world: WorldModel) -> tuple[Solid, ...]:
    """Return all objects of a world file, except its edge and its robots."""
    return (*world.walls, *world.boxes, *world.cylinders, *world.polygons)


def polygon_of(number: int, corners: Corners) -> Polygon:
    """Return the polygon that a program adds.

    Args:
        number: the number in its name.
        corners: its corners [0.1 in], shape (corners, 2).
    """
    return _polygon(number, tuple(map(tuple, corners.tolist())))


@lru_cache(maxsize=4096)  # the world is rebuilt whenever an obstacle is added or removed
def _polygon(number: int, corners: tuple[tuple[int, int], ...]) -> Polygon:
    places = [(tenths_inch_to_m(float(x)), tenths_inch_to_m(float(y))) for x, y in corners]
    return Polygon.of(f"{_ADDED}{number}", places)
