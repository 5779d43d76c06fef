"""Laser scans, and the scan that was last reported."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import Int32Array, Int64Array
from crs_cc.sim.model.sensors import NUM_LASER
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.last_measurement import LastMeasurement
from crs_cc.sim.state.paged_reply import PagedReply

_USUAL_SEGMENTS: Final = (50, 4, 30)
"""The vendor header's suggestion for `conf_sg`."""


@dataclass(slots=True)
class LaserState:
    """The lasers; arrays have a row for each robot with a laser, n of them.

    Attributes:
        mode: the mode set by `conf_ls`, (n,).
        wanted: number of points to measure, (n,).
        averaged: number of pixels that are averaged, (n,).
        segments: threshold, minimum number of points and gap, as set by `conf_sg`, (n, 3).
        points: number of points of the last scan, (n,).
        seen: their x and y [0.1 in], ahead and left of the mount's centre, (n, 964).
        ranges: their ranges, from right to left [0.1 in], -1 for none, (n, 482).
        count: number of scans, (n,).
        measured: time and configuration of the last scan.
        told: contents of the last reply.
        predicted: contents of the last reply to PREDICT.
    """

    mode: Int32Array
    wanted: Int32Array
    averaged: Int32Array
    segments: Int32Array
    points: Int32Array
    seen: Int32Array
    ranges: Int32Array
    count: Int64Array
    measured: LastMeasurement
    told: PagedReply
    predicted: PagedReply

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return lasers with the settings of their definitions, without a scan."""
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
            measured=LastMeasurement.never(count),
            told=PagedReply.nothing(count, 2 * NUM_LASER),
            predicted=PagedReply.nothing(count, 2 * NUM_LASER),
        )
