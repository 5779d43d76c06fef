"""Goals that cannot be met because walls or fixed objects are in the way.

The floor is filled from the start of each robot, on a grid, as far as its body has room. What could
just be passed counts as passable, and movable objects are ignored: a warning is right, no
warning proves nothing.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np

from crs_cc.builder.addresses import ids
from crs_cc.builder.document import Document
from crs_cc.builder.floor_grid import DIAGONAL, Cells, FloorGrid, edge_of
from crs_cc.core.source import Diagnostic, Location
from crs_cc.sim.engine.goal_floor import Floor
from crs_cc.sim.model.goals import Approach, Bring, Cover, Follow, Goal, Reach, Visit
from crs_cc.sim.model.world import Box, Cylinder, Robot, Wall, WorldModel, WorldObject, is_pushable

MAX_CELLS: Final = 30_000
"""Cells of the grid; a floor for which they would be as large as robots is not examined."""

MAX_EDGE: Final = 4000
"""Cells at the edge of what is reached, for goals that compare distances from it."""

_EXAMINED: Final = Reach | Visit | Approach | Bring | Follow | Cover
_CELLS_PER_RADIUS: Final = 4.0


class _Reachability:
    """What the robots and the movable objects of a world can reach."""

    def __init__(self, world: WorldModel, floor: FloorGrid) -> None:
        self.world = world
        self.floor = floor
        self._by_robot: dict[str, Cells] = {}
        self._objects = {each.id: each for each in world.solids() if not isinstance(each, Wall)}

    def by(self, robot: Robot) -> Cells:
        """Return where the centre of a robot can go."""
        if robot.id not in self._by_robot:
            start = robot.start
            found = self.floor.around(start.x_m, start.y_m, robot.model.radius_m)
            self._by_robot[robot.id] = found
        return self._by_robot[robot.id]

    def of_movable(self, name: str) -> Cells | None:
        """Return where the centre of a movable object can go; None if nothing is known of it."""
        obj = self._objects.get(name)
        if obj is None or obj.part_of or not is_pushable(obj):
            return None
        return self.floor.around(obj.pose.x_m, obj.pose.y_m, _inner_radius_m(obj))

    def may_be_touched(self, name: str) -> bool:
        """Return whether robots can get at a movable object, or push others against it.

        Whatever gets there does not fit through a gap half as wide as the smallest body.
        """
        radii_m = [robot.model.radius_m for robot in self.world.robots]
        radii_m += [_inner_radius_m(each) for each in self._objects.values() if is_pushable(each)]
        radius_m = min(radii_m) / 2
        if radius_m < self.floor.cell_m:
            return True  # it is not known
        pose = self._objects[name].pose
        around = self.floor.around(pose.x_m, pose.y_m, radius_m)
        return any((self.by(robot) & around).any() for robot in self.world.robots)


def _inner_radius_m(obj: WorldObject) -> float:
    """Return the radius of a disc around the centre of an object that is inside of it."""
    if isinstance(obj, Box):
        return min(obj.length_m, obj.width_m) / 2
    return obj.radius_m if isinstance(obj, Cylinder) else 0.0


def unreachable(document: Document, world: WorldModel) -> list[Diagnostic]:
    """Return warnings about goals that cannot be met.

    Args:
        document: the file, for the lines of its goals.
        world: what it describes.
    """
    goals = [each for each in world.goals if isinstance(each.condition, _EXAMINED)]
    floor = _floor(world) if goals and world.robots else None
    if floor is None:
        return []
    reached = _Reachability(world, floor)
    nodes, found = ids(document.root), list[Diagnostic]()
    for goal in goals:
        text = _goal_warning(reached, goal)
        if text:
            line = nodes[goal.id].line if goal.id in nodes else 0
            hint = "a wall or a fixed object is in the way, or a passage is too narrow"
            place = Location(document.file, line)
            found.append(Diagnostic("warning", place, f"goal {goal.id!r}: {text}", hint=hint))
    return found


def _floor(world: WorldModel) -> FloorGrid | None:
    area = world.area
    least_m = min(robot.model.radius_m for robot in world.robots)
    cell_m = max(least_m / _CELLS_PER_RADIUS, math.sqrt(area.length_m * area.width_m / MAX_CELLS))
    is_fine = cell_m < least_m and max(area.length_m, area.width_m) / cell_m < MAX_CELLS
    return FloorGrid(world, cell_m) if is_fine else None


def _goal_warning(reached: _Reachability, goal: Goal) -> str:
    """Return a warning about a goal; empty if there is none."""
    robots = [each for each in reached.world.robots if not goal.robots or each.id in goal.robots]
    match goal.condition:
        case Bring():
            return _not_brought(reached, goal.condition)
        case Cover():
            return _not_covered(reached, goal.condition, robots)
        case Follow():
            return _not_followed(reached, goal, goal.condition, robots)
    return _not_reached(reached, goal, robots)


def _targets(floor: FloorGrid, goal: Goal) -> Iterator[Cells]:
    """Yield the cells of each place that robots must get to; nothing for movable objects."""
    match goal.condition:
        case Reach(place):
            yield floor.in_place(place)
        case Visit(places):
            yield from map(floor.in_place, places)
        case Approach(obj, distance_m):
            cells = floor.near(obj, distance_m)
            if cells.any():
                yield cells


def _not_reached(reached: _Reachability, goal: Goal, robots: Sequence[Robot]) -> str:
    needs_all = bool(goal.robots) and not isinstance(goal.condition, Visit)
    for target in _targets(reached.floor, goal):
        lost = [each.id for each in robots if not (reached.by(each) & target).any()]
        if lost and needs_all:
            return f"robot {lost[0]!r} cannot get there"
        if len(lost) == len(robots):
            return "no robot can get there"
    return ""


def _not_brought(reached: _Reachability, goal: Bring) -> str:
    """Return which object cannot be brought; those with parts are not examined."""
    if any(robot.model.device("arm") for robot in reached.world.robots):
        return ""  # it may lift them over what is in the way
    target = reached.floor.in_place(goal.place)
    for name in goal.objects:
        cells = reached.of_movable(name)
        if cells is None:
            continue
        if not (cells & target).any():
            return f"object {name!r} cannot get there"
        if not reached.may_be_touched(name):
            return f"no robot can get at object {name!r}"
    return ""


def _not_followed(
    reached: _Reachability, goal: Goal, follow: Follow, robots: Sequence[Robot]
) -> str:
    """Return the robots that can never come near enough for a goal."""
    target = next((each for each in reached.world.robots if each.id == follow.target), None)
    cells = reached.of_movable(follow.target) if target is None else reached.by(target)
    others = [each for each in robots if each is not target]
    if cells is None or not follow.share:
        return ""
    most_m = follow.most_m + 2 * DIAGONAL * reached.floor.cell_m
    lost = [each.id for each in others if _is_apart(reached, reached.by(each), cells, most_m)]
    if lost and goal.robots:
        return f"robot {lost[0]!r} cannot get near {follow.target!r}"
    return f"no robot can get near {follow.target!r}" if lost and len(lost) == len(others) else ""


def _is_apart(reached: _Reachability, one: Cells, other: Cells, most_m: float) -> bool:
    """Return whether some cells are farther than a distance from others, if that is known."""
    if (one & other).any():
        return False
    edges = edge_of(one), edge_of(other)
    if max(int(edge.sum()) for edge in edges) > MAX_EDGE:
        return False
    floor = reached.floor
    x_m, y_m = floor.x_m[edges[1]], floor.y_m[edges[1]]
    here = zip(floor.x_m[edges[0]].tolist(), floor.y_m[edges[0]].tolist(), strict=True)
    return all(float(np.hypot(x_m - x, y_m - y).min()) > most_m for x, y in here)


def _not_covered(reached: _Reachability, goal: Cover, robots: Sequence[Robot]) -> str:
    """Return the share of the floor that robots can reach, if it is less than a goal requires."""
    floor, cells = reached.floor, Floor(reached.world)
    free = cells.free(goal.cell_m)
    covered = np.zeros(free.shape, dtype=np.bool_)
    for robot in robots:
        edge = edge_of(reached.by(robot))
        if int(edge.sum()) > MAX_EDGE:
            return ""
        covered |= floor.holds(reached.by(robot), *cells.centres_m(goal.cell_m))
        margin_m = 2 * DIAGONAL * floor.cell_m
        radii_m = np.full(int(edge.sum()), robot.model.radius_m + margin_m)
        cells.cover(goal.cell_m, covered, floor.x_m[edge], floor.y_m[edge], radii_m)
    share = float((covered & free).sum() / max(1, free.sum()))
    if share >= goal.share:
        return ""
    return f"robots can get to {share:.0%} of the floor only, not {goal.share:.0%}"
