"""The trajectories of robots in a run that is known, and how far robots of two runs are apart.

Of runs whose timesteps were seen, a trajectory has each of them; of others, what their frames have.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.workbench.feed import Feed

MAX_FRAMES: Final = 50_000
"""Frames of a trajectory; of more, every second block and so on. Chosen by us."""

_STILL: Final = 1.5  # frames: a longer gap is one in which nothing moved
_MARGIN_S: Final = 1.0
_SLACK_S: Final = 1e-6
_PLACE: Final = slice(0, 2)
_TURN: Final = 2


@dataclass(frozen=True, slots=True)
class Trajectories:
    """Where robots were: times [s] and poses [m, rad], (times, 3, robots); NaN while absent.

    Attributes:
        frame_s: the time between two poses while anything moves [s].
    """

    times_s: FloatArray
    poses: FloatArray
    frame_s: float

    def interpolate(self, times_s: FloatArray) -> FloatArray:
        """Return the poses at times, between those that are known; NaN before and after them."""
        if not len(self.times_s):
            return np.full((len(times_s), *self.poses.shape[1:]), np.nan)
        before = np.searchsorted(self.times_s, times_s + _SLACK_S, side="right") - 1
        first = np.clip(before, 0, len(self.times_s) - 1)
        after = np.minimum(first + 1, len(self.times_s) - 1)
        begin_s, end_s = self.times_s[first], self.times_s[after]
        moved_s = np.minimum(end_s - begin_s, _STILL * self.frame_s)
        since_s = times_s - (end_s - moved_s)
        share = np.clip(since_s / np.where(moved_s > 0.0, moved_s, 1.0), 0.0, 1.0)
        share = np.where(after > first, share, 0.0)[:, None]
        found = self.poses[first].copy()
        step = self.poses[after] - found
        step[:, _TURN] = wrap_angles(step[:, _TURN])
        is_between = share[:, 0] > 0.0  # or else a robot that comes next is nowhere already
        found[is_between] += share[is_between, :, None] * step[is_between]
        is_known = (before >= 0) & (times_s <= self.times_s[-1] + _SLACK_S)
        found[~is_known] = np.nan
        return found


def wrap_angles(angle_rad: FloatArray) -> FloatArray:
    """Return angles from -pi to pi."""
    return angle_rad - 2.0 * math.pi * np.round(angle_rad / (2.0 * math.pi))


def robots_of(feed: Feed) -> tuple[str, ...]:
    """Return the robots of a run that is known."""
    rosters = feed.rosters()
    return rosters[-1][1] if rosters else ()


def trajectories(feed: Feed, names: Sequence[str], begin_s: float, end_s: float) -> Trajectories:
    """Return the trajectories of some robots between two times, and a little around."""
    rows = [robots_of(feed).index(name) for name in names]
    begin_s, end_s = begin_s - _MARGIN_S, end_s + _MARGIN_S
    times_s, motion = feed.trace.motion(begin_s, end_s)
    last_s = min(end_s, feed.end_s)
    is_traced = max(rows, default=0) < motion.shape[2] and bool(
        times_s[0] <= max(begin_s, 0.0) + _MARGIN_S and times_s[-1] >= last_s - _SLACK_S
    )
    if not is_traced:
        return _of_frames(feed, rows, begin_s, end_s)
    step_s = float(np.median(np.diff(times_s))) if len(times_s) > 1 else 0.0
    return Trajectories(times_s, motion[:, :, rows], step_s)


def _of_frames(feed: Feed, rows: Sequence[int], begin_s: float, end_s: float) -> Trajectories:
    stride = max(1, -(-feed.frames.frames_about // MAX_FRAMES))
    found = list(feed.frames.between(begin_s, end_s, stride))
    poses = np.full((len(found), 3, len(rows)), np.nan)
    counts = [(since_s, len(robots)) for since_s, robots, _ in feed.rosters()]
    wanted = np.array(rows, int)
    for pose, (time_s, frame) in zip(poses, found, strict=True):
        robots = max((count for since_s, count in counts if since_s <= time_s), default=0)
        is_there = wanted < min(robots, frame.shape[1])  # objects come after the robots
        pose[:, is_there] = frame[:3, wanted[is_there]]
    return Trajectories(np.array([time_s for time_s, _ in found]), poses, feed.frame_s * stride)


def common_times_s(one: Trajectories, other: Trajectories) -> tuple[FloatArray, bool]:
    """Return times at which both are known, and whether neither need be interpolated."""
    if not len(one.times_s) or not len(other.times_s):
        return np.zeros(0), True
    end_s = min(one.times_s[-1], other.times_s[-1]) + _SLACK_S
    first, second = (np.round(each.times_s, 6) for each in (one, other))
    both = np.intersect1d(first, second)
    are_alike = 2 * len(both) >= min((first <= end_s).sum(), (second <= end_s).sum())
    times_s = both if are_alike else np.union1d(first, second)
    begin_s = max(one.times_s[0], other.times_s[0]) - _SLACK_S
    return times_s[(times_s >= begin_s) & (times_s <= end_s)], are_alike


def distance_m(one: FloatArray, other: FloatArray) -> FloatArray:
    """Return the distances between poses, (times, robots)."""
    step = one[:, _PLACE] - other[:, _PLACE]
    return np.hypot(step[:, 0], step[:, 1])


def equal_or_absent(one: FloatArray, other: FloatArray, tolerance: float) -> BoolArray:
    """Return which numbers are the same, those that are not there included."""
    result: BoolArray = (np.abs(one - other) <= tolerance) | (np.isnan(one) & np.isnan(other))
    return result
