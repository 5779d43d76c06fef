"""What lasers saw last, and what of it the program was told."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import Int32Array, Int64Array
from crs_cc.sim.model.sensors import NUM_LASER
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.last_measurement import Moments
from crs_cc.sim.state.paged_reply import Told

_USUAL_SEGMENTS: Final = (50, 4, 30)
"""What the vendor's header advises to give to `conf_sg`."""


@dataclass(slots=True)
class LaserState:
    """The lasers; arrays have a row for each robot that has one, n of them.

    Attributes:
        mode: what `conf_ls` set, (n,).
        wanted: how many points are looked for, (n,).
        averaged: how many pixels make an average, (n,).
        segments: threshold, fewest points and gap of segments, as `conf_sg` set them, (n, 3).
        points: how many points were seen last, (n,).
        seen: their x and y [0.1 in], ahead and left of the middle of the mount, (n, 964).
        ranges: how far away they were, from the right to the left [0.1 in], -1 for none, (n, 482).
        count: how often it looked, (n,).
        measured: when it looked last.
        told: what the last reply told of.
        predicted: what the last answer to PREDICT told of.
    """

    mode: Int32Array
    wanted: Int32Array
    averaged: Int32Array
    segments: Int32Array
    points: Int32Array
    seen: Int32Array
    ranges: Int32Array
    count: Int64Array
    measured: Moments
    told: Told
    predicted: Told

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return lasers that are as their definitions say, and have seen nothing."""
        found = [laser for robot in world.robots if (laser := robot.model.laser) is not None]
        count = len(found)
        return cls(
            mode=np.array([laser.mode for laser in found], dtype=np.int32),
            wanted=np.array([laser.points for laser in found], dtype=np.int32),
            averaged=np.ones(count, dtype=np.int32),
            segments=np.tile(np.array(_USUAL_SEGMENTS, dtype=np.int32), (count, 1)),
            points=np.zeros(count, dtype=np.int32),
            seen=np.zeros((count, 2 * NUM_LASER), dtype=np.int32),
            ranges=np.full((count, NUM_LASER), -1, dtype=np.int32),
            count=np.zeros(count, dtype=np.int64),
            measured=Moments.never(count),
            told=Told.nothing(count, 2 * NUM_LASER),
            predicted=Told.nothing(count, 2 * NUM_LASER),
        )
