"""Goals that no robot can reach, because walls or fixed objects are in the way.

The floor is filled from the start of each robot, on a grid, as far as its body has room. What could
just be passed counts as passable, and movable objects are in nobody's way: a warning is right, no
warning proves nothing.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from crs_cc.builder.addresses import ids
from crs_cc.builder.document import Document
from crs_cc.builder.extents import bounds_m
from crs_cc.core.source import Diagnostic, Location
from crs_cc.sim.geometry.placement import distance_from_m
from crs_cc.sim.model.goals import Approach, Goal, Place, Reach, Visit
from crs_cc.sim.model.world import Robot, Solid, WorldModel, is_pushable

MAX_CELLS: Final = 30_000
"""Cells of the grid; a floor for which they would be as large as robots is not examined."""

_CELLS_PER_RADIUS: Final = 4.0
_DIAGONAL: Final = math.sqrt(0.5)

Cells: TypeAlias = NDArray[np.bool_]


class _Floor:
    """The floor as a grid, and where robots of each size can go on it."""

    def __init__(self, world: WorldModel, cell_m: float) -> None:
        area = world.area
        self.cell_m = cell_m
        self.left_m, self.bottom_m = area.x_min_m + cell_m / 2, area.y_min_m + cell_m / 2
        columns = max(1, round(area.length_m / cell_m))
        rows = max(1, round(area.width_m / cell_m))
        xs = self.left_m + cell_m * np.arange(columns)
        ys = self.bottom_m + cell_m * np.arange(rows)
        self.x_m, self.y_m = np.meshgrid(xs, ys)
        self._solids = [each for each in world.solids() if not is_pushable(each)]
        self._free: dict[float, Cells] = {}

    def around(self, robot: Robot) -> Cells:
        """Return where the centre of a robot can go."""
        free = self._room(robot.model.radius_m)
        column, row = self._cell(robot.start.x_m, robot.start.y_m)
        return filled(free, row, column)

    def _room(self, radius_m: float) -> Cells:
        """Return where there is room for a body, or nearly."""
        if radius_m not in self._free:
            free = np.ones(self.x_m.shape, dtype=np.bool_)
            room_m = radius_m - self.cell_m * _DIAGONAL
            for solid in self._solids:
                where = self._window(solid, room_m)
                distances_m = distance_from_m(solid, self.x_m[where], self.y_m[where])
                free[where] &= distances_m >= room_m
            self._free[radius_m] = free
        return self._free[radius_m]

    def _window(self, solid: Solid, margin_m: float) -> tuple[slice, slice]:
        """Return the part of the grid within a distance of a solid."""
        left_m, bottom_m, right_m, top_m = bounds_m(solid)
        first = self._cell(left_m - margin_m, bottom_m - margin_m)
        last = self._cell(right_m + margin_m, top_m + margin_m)
        return slice(first[1], last[1] + 1), slice(first[0], last[0] + 1)

    def _cell(self, x_m: float, y_m: float) -> tuple[int, int]:
        rows, columns = self.x_m.shape
        column = round((x_m - self.left_m) / self.cell_m)
        row = round((y_m - self.bottom_m) / self.cell_m)
        return min(max(column, 0), columns - 1), min(max(row, 0), rows - 1)

    def in_place(self, place: Place) -> Cells:
        """Return the cells that are in a place, or touch it."""
        distances_m = np.hypot(self.x_m - place.x_m, self.y_m - place.y_m)
        return np.asarray(distances_m <= place.radius_m + self.cell_m * _DIAGONAL)

    def near(self, name: str, distance_m: float) -> Cells:
        """Return the cells near the surface of a fixed object, or of one of its parts."""
        reach_m = distance_m + self.cell_m * _DIAGONAL
        found = np.zeros(self.x_m.shape, dtype=np.bool_)
        for solid in self._solids:
            if solid.id == name or solid.id.startswith(f"{name}."):
                where = self._window(solid, reach_m)
                distances_m = distance_from_m(solid, self.x_m[where], self.y_m[where])
                found[where] |= distances_m <= reach_m
        return found


def filled(free: Cells, row: int, column: int) -> Cells:
    """Return the cells that are connected with one of them, which itself counts as free.

    >>> filled(np.array([[True, True, False, True]]), 0, 0).tolist()
    [[True, True, False, False]]
    """
    rows, columns = free.shape
    open_cells = bytearray(free.tobytes())
    start = row * columns + column
    open_cells[start] = 0
    found = bytearray(len(open_cells))
    work = [start]
    while work:
        cell = work.pop()
        found[cell] = 1
        at = cell % columns
        near = (cell - columns, cell + columns, cell - 1 if at else -1,
                cell + 1 if at + 1 < columns else -1)  # fmt: skip
        for other in near:
            if 0 <= other < rows * columns and open_cells[other]:
                open_cells[other] = 0
                work.append(other)
    return np.frombuffer(found, dtype=np.bool_).reshape(rows, columns)


def unreachable(document: Document, world: WorldModel) -> list[Diagnostic]:
    """Return warnings about goals whose places robots cannot reach.

    Args:
        document: the file, for the lines of its goals.
        world: what it describes.
    """
    goals = [each for each in world.goals if isinstance(each.condition, Reach | Visit | Approach)]
    floor = _floor(world) if goals and world.robots else None
    if floor is None:
        return []
    reached: dict[str, Cells] = {}
    nodes, found = ids(document.root), list[Diagnostic]()
    for goal in goals:
        robots = [each for each in world.robots if not goal.robots or each.id in goal.robots]
        for robot in robots:
            if robot.id not in reached:
                reached[robot.id] = floor.around(robot)
        text = _complaint(floor, goal, [(each.id, reached[each.id]) for each in robots])
        if text:
            line = nodes[goal.id].line if goal.id in nodes else 0
            hint = "a wall or a fixed object is in the way, or a passage is too narrow"
            found.append(Diagnostic("warning", Location(document.file, line), text, hint=hint))
    return found


def _floor(world: WorldModel) -> _Floor | None:
    area = world.area
    least_m = min(robot.model.radius_m for robot in world.robots)
    cell_m = max(least_m / _CELLS_PER_RADIUS, math.sqrt(area.length_m * area.width_m / MAX_CELLS))
    is_fine = cell_m < least_m and max(area.length_m, area.width_m) / cell_m < MAX_CELLS
    return _Floor(world, cell_m) if is_fine else None


def _targets(floor: _Floor, goal: Goal) -> Iterator[Cells]:
    """Yield the cells of each place that a goal is about; nothing for movable objects."""
    match goal.condition:
        case Reach(place):
            yield floor.in_place(place)
        case Visit(places):
            yield from map(floor.in_place, places)
        case Approach(thing, distance_m):
            cells = floor.near(thing, distance_m)
            if cells.any():
                yield cells


def _complaint(floor: _Floor, goal: Goal, robots: Sequence[tuple[str, Cells]]) -> str:
    """Return what is wrong with a goal; empty if nothing is known to be."""
    needs_all = bool(goal.robots) and not isinstance(goal.condition, Visit)
    for target in _targets(floor, goal):
        lost = [name for name, cells in robots if not (cells & target).any()]
        if lost and needs_all:
            return f"goal {goal.id!r}: robot {lost[0]!r} cannot get there"
        if len(lost) == len(robots):
            return f"goal {goal.id!r}: no robot can get there"
    return ""
