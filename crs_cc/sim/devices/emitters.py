"""Sources of light or sound, including those of robots, and the lines of sight to them.

A source is in sight if nothing is on the straight line to it: no wall, no object, no robot except
the one that carries the source.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.geometry.cell_list import CellList
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.kernels import exact

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


_MIN_DISTANCE_M = 0.1
"""Nearer sources are sensed as if they were at this distance; chosen by us."""

_SLACK_M = 1e-6


@dataclass(frozen=True, slots=True)
class Sources:
    """Sources; arrays have a row for each.

    Attributes:
        place_m: their positions, (sources, 2).
        strength: their strength at a distance of 1 m, (sources,).
        owner: the robots that carry them, -1 for fixed ones, (sources,).
    """

    place_m: FloatArray
    strength: FloatArray
    owner: IndexArray

    @classmethod
    def fixed(cls, places_m: Sequence[tuple[float, float]], strengths: Sequence[float]) -> Self:
        """Return the sources that no robot carries, from positions and strengths."""
        return cls(
            np.array(places_m, dtype=np.float64).reshape(-1, 2),
            np.array(strengths, dtype=np.float64),
            np.full(len(strengths), -1, dtype=np.intp),
        )

    def with_robots(self, place_m: FloatArray, strength: FloatArray) -> Sources:
        """Return these and the robots' sources.

        Args:
            place_m: positions of all robots, (robots, 2).
            strength: their strengths, 0 for robots that are no source, (robots,).
        """
        rows = np.flatnonzero(strength > 0.0)
        return Sources(
            np.concatenate([self.place_m, place_m[rows]]),
            np.concatenate([self.strength, strength[rows]]),
            np.concatenate([self.owner, rows]),
        )


@dataclass(frozen=True, slots=True)
class Sensed:
    """Pairs of a robot and a source in its range; arrays have a row for each.

    Attributes:
        robot: the robot, as an index into the requested rows, in ascending order.
        distance_m: its distance, at least the minimum.
        bearing_rad: its bearing from the direction of the robot's mount.
        in_sight: whether nothing obstructs the line to it.
    """

    robot: IndexArray
    source: IndexArray
    distance_m: FloatArray
    bearing_rad: FloatArray
    in_sight: BoolArray


def line_of_sight(range_m: float) -> list[Fan]:
    """Return the beam that tests for obstructions, none for no range."""
    return [Fan.of([(0.0, 0.0, 0.0, 0.0, range_m)])] if range_m > 0.0 else []


def sense(
    state: EnvState,
    constants: RobotConstants,
    rays: RayCaster,
    rows: IndexArray,
    *,
    sources: Sources,
    range_m: FloatArray,
    fan: Fan,
) -> Sensed:
    """Return the sources in the range of robots, except their own ones."""
    mounts = mount_poses(state, constants, rows)
    places = sources.place_m
    cells = CellList(places[:, 0].copy(), places[:, 1].copy(), float(range_m.max(initial=0.0)))
    robot, source = cells.near(mounts[:, 0], mounts[:, 1])
    offset_m = places[source] - mounts[robot, :2]
    distance_m = exact.hypot(offset_m[:, 0], offset_m[:, 1])
    keep = (distance_m <= range_m[robot]) & (sources.owner[source] != rows[robot])
    robot, source = robot[keep], source[keep]
    offset_m, distance_m = offset_m[keep], distance_m[keep]
    direction_rad = exact.arctan2(offset_m[:, 1], offset_m[:, 0])
    poses = np.column_stack([mounts[robot, :2], direction_rad])
    hit_m, obj = rays.seen(state, fan, poses, rows[robot])
    in_sight = hit_m[:, 0] >= distance_m - _SLACK_M
    in_sight |= (sources.owner[source] >= 0) & (obj[:, 0] == sources.owner[source])
    return Sensed(
        robot,
        source,
        np.maximum(distance_m, _MIN_DISTANCE_M),
        direction_rad - mounts[robot, 2],
        in_sight,
    )


def of_all(
    state: EnvState, constants: RobotConstants, device: str, values: npt.NDArray[np.number]
) -> FloatArray:
    """Return a value of all robots' lamps or speakers, 0 for robots without one, (robots,).

    Args:
        state: has the robots that are in the world.
        constants: the robots' constants.
        device: the device.
        values: the value of each device.
    """
    numbers = constants.numbers[device]
    has = (numbers >= 0) & state.presence.present
    found = np.zeros(len(numbers))
    found[has] = values[numbers[has]]
    return found


def commanded(
    context: RequestContext,
    device: str,
    rows: IndexArray,
    requested: Int32Array,
    *,
    most: FloatArray,
) -> FloatArray:
    """Return the requested strengths after degradation and clipping, (k,).

    Args:
        context: the requests.
        device: the lamp or speaker.
        rows: the robots with one, k of them.
        requested: what their programs requested, (k,).
        most: the maximum of each, (k,).
    """
    wanted = np.clip(requested.astype(np.float64), 0.0, most)
    altered = context.constants.degradations.alter(
        context.state, device, rows, wanted[:, None], context.state.drive.clock_s[rows]
    )[:, 0]
    return np.clip(np.nan_to_num(altered, nan=0.0), 0.0, most)
