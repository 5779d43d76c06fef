"""How close robots came to other robots, walls and objects, from the frames that are known.

The distances are those of the engine's own shapes, at the instants of the frames.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import chain
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.shape_table import ShapeTable

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from crs_cc.core.arrays import FloatArray, IndexArray
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.workbench.feed import Feed

NEAR_M: Final = 0.5
"""Approaches to less than this are listed; chosen by us: a Scout's radius and a half."""

MAX_APPROACHES: Final = 200
MAX_DISTANCES: Final = 1_500_000
"""Distances that are computed for an answer, about a quarter of a second; of more frames or robots,
some are left out."""

MAX_NUMBERS: Final = 15_000_000
"""Numbers in the frames that are read for an answer, about half a second; of more, every second
block of frames is left out, or more of them."""

_AT_ONCE: Final = 50_000  # distances: their arrays fit into a processor's cache
_SLACK_S: Final = 1e-9

Approach = tuple[float, int, str, float, float, float]
"""Time [s], robot, what it came close to, the distance between both [m], and the place [m]."""


@dataclass(frozen=True, slots=True)
class Clearance:
    """The distance of a robot from the nearest object, over time.

    Attributes:
        times_s: the instants, (n,).
        gap_m: the distance between the outlines, negative where they overlap, NaN where there is
            no robot, (n,).
        nearest: the number of the nearest object, (n,).
        place_m: where the robot was, (n, 2).
    """

    times_s: FloatArray
    gap_m: FloatArray
    nearest: IndexArray
    place_m: FloatArray


class Clearances:
    """The distances between robots and surrounding objects in the known frames of a run.

    Attributes:
        names: of all objects, by number; the robots are the first.
        frames: how many frames there are.
    """

    def __init__(
        self, world: WorldModel, feed: Feed, begin_s: float = 0.0, end_s: float = math.inf
    ) -> None:
        """Read the frames of a span.

        Args:
            world: the world.
            feed: what is known of its run.
            begin_s: from when.
            end_s: until when.
        """
        scene = Scene(world)
        self.names = scene.names
        self._shapes = ShapeTable.of(scene)
        self._radius_m = np.array([robot.model.radius_m for robot in world.robots])
        number = {name: at for at, name in enumerate(scene.names)}
        self._times_s, self._poses = _poses(feed, number, self._shapes, (begin_s, end_s))
        self.frames = len(self._times_s)

    def of(self, robot: int) -> Clearance:
        """Return the clearance of a robot."""
        place_m, objects = self._poses[:, robot, :2], self._poses.shape[1]
        gap_m = np.full((self.frames, objects), np.inf)
        rows = max(1, _AT_ONCE // objects)
        for first in range(0, self.frames, rows):
            part = slice(first, first + rows)
            gap_m[part] = self._distances_m(place_m[part], self._poses[part])
        gap_m[:, robot] = np.inf
        nearest = gap_m.argmin(axis=1) if objects else np.zeros(self.frames, np.intp)
        least_m = gap_m[np.arange(self.frames), nearest] - self._radius_m[robot]
        least_m[np.isinf(least_m)] = np.nan
        return Clearance(self._times_s, least_m, nearest, place_m)

    def _distances_m(self, place_m: FloatArray, poses: FloatArray) -> FloatArray:
        """Return the distances from places to all objects, infinite for absent ones."""
        frames, objects = poses.shape[:2]
        away_m = place_m[:, np.newaxis] - poses[:, :, :2]
        cos, sin = np.cos(poses[:, :, 2]), np.sin(poses[:, :, 2])
        ahead_m = cos * away_m[:, :, 0] + sin * away_m[:, :, 1]
        left_m = cos * away_m[:, :, 1] - sin * away_m[:, :, 0]
        origin, which = np.zeros((objects, 3)), np.tile(np.arange(objects), frames)
        found = self._shapes.distance_m(origin, which, ahead_m.ravel(), left_m.ravel())
        return np.where(np.isnan(found), np.inf, found).reshape(frames, objects)

    def approaches(self, robots: Sequence[int]) -> list[Approach]:
        """Return the closest approaches of robots, the closest first.

        Of each time that a robot was within `NEAR_M` of the same object, the closest instant; of a
        robot that never was, the closest of all.
        """
        found = [each for robot in robots for each in self._approaches(robot)]
        return sorted(found, key=lambda each: each[3])[:MAX_APPROACHES]

    def _approaches(self, robot: int) -> Iterator[Approach]:
        clearance = self.of(robot)
        gap_m = clearance.gap_m
        known = np.flatnonzero(~np.isnan(gap_m))
        if not len(known):
            return
        near = known[gap_m[known] < NEAR_M]
        if not len(near):
            near = known[[gap_m[known].argmin()]]
        ends = np.flatnonzero((np.diff(near) > 1) | (np.diff(clearance.nearest[near]) != 0)) + 1
        for rows in np.split(near, ends):
            row = rows[gap_m[rows].argmin()]
            x_m, y_m = clearance.place_m[row].tolist()
            yield (
                round(float(clearance.times_s[row]), 6), robot, self.names[clearance.nearest[row]],
                round(float(gap_m[row]), 4), round(x_m, 3), round(y_m, 3),
            )  # fmt: skip


def _poses(
    feed: Feed, number: Mapping[str, int], shapes: ShapeTable, span_s: tuple[float, float]
) -> tuple[FloatArray, FloatArray]:
    """Return the times [s] of frames, and the poses of all objects, (n, objects, 3)."""
    rosters = feed.rosters()
    bodies = max((len(robots) + len(objects) for _, robots, objects in rosters), default=0)
    stride = 1 + feed.frames.frames_about * bodies * 3 // MAX_NUMBERS
    objects, step = len(shapes.margin_m), 1
    frames: list[tuple[float, FloatArray]] = []
    for read, each in enumerate(feed.frames.between(*span_s, stride)):
        if read % step == 0:
            frames.append(each)
            if len(frames) * objects > MAX_DISTANCES:
                del frames[1::2]
                step *= 2
    poses = np.full((len(frames), objects, 3), np.nan)
    poses[:, objects - len(shapes.fixed) :] = shapes.fixed
    for row, (time_s, frame) in enumerate(frames):
        names = next((each[1:] for each in reversed(rosters) if each[0] <= time_s + _SLACK_S), ())
        for at, name in enumerate(chain.from_iterable(names)):
            if name in number and at < frame.shape[1]:
                poses[row, number[name]] = frame[:3, at]
    return np.array([time_s for time_s, _ in frames]), poses


def closest(world: WorldModel, feed: Feed, selected: int) -> dict[str, Any]:
    """Return the closest approaches in the known part of a run, see `MAX_DISTANCES`.

    Args:
        world: the world.
        feed: what is known.
        selected: the robot that is looked at first.
    """
    clearances, count = Clearances(world, feed), len(world.robots)
    cost = max(1, clearances.frames * len(clearances.names))
    robots = [(selected + each) % count for each in range(min(count, MAX_DISTANCES // cost or 1))]
    return {"approaches": clearances.approaches(robots), "robots": len(robots)}
