"""The motion of the axes."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array
from crs_cc.sim.model.axis import AXES, STILL
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.motion_profile import Axes


@dataclass(slots=True)
class DriveState:
    """The motion of the axes; arrays have a row for each robot, and a column for each axis.

    Attributes:
        axes: the axes' profiles, shape (robots, 3) each.
        clock_s: the time to which each robot's axes have been advanced.
        moved_m: displacement of each robot by its wheels in this cycle, world frame, (robots, 2).
        facing_rad: the resulting direction of the wheels.
        turret_rad: the resulting direction of the turret, if there is one.
        slice: distance of each axis in this cycle so far, (robots, 3).
        move_speed: speed of relative moves (`sp`), (robots, 3).
        ramp: acceleration (`ac`), (robots, 3).
        command: request code of the current motion command; 0 before the first.
        command_cycle: the cycle in which it was received.
        timeout_s: command timeout after which the axes stop (`conf_tm`), infinite for never.
        deadline_s: the time at which it expires.
        limp: axes with motors off, (robots, 3).
        hindered: whether a contact made the wheels turn otherwise than the motors would.
        forward_mps: the speed of these robots along their wheels.
        ahead_m: distance in this cycle that the motors would have added to that counted by the
            encoders.
        stalled_s: the time for which they have been stalled.
    """

    axes: Axes
    clock_s: FloatArray
    moved_m: FloatArray
    facing_rad: FloatArray
    turret_rad: FloatArray
    slice: FloatArray
    move_speed: FloatArray
    ramp: FloatArray
    command: Int64Array
    command_cycle: Int64Array
    timeout_s: FloatArray
    deadline_s: FloatArray
    limp: BoolArray
    hindered: BoolArray
    forward_mps: FloatArray
    ahead_m: FloatArray
    stalled_s: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return axes at rest."""
        count = len(world.robots)
        drives = [robot.model.drive for robot in world.robots]
        axes = [[axis or STILL for axis in drive.axes] for drive in drives]
        heading_rad = np.array([robot.start.heading_rad for robot in world.robots])
        return cls(
            axes=Axes.standing(count),
            clock_s=np.zeros(count),
            moved_m=np.zeros((count, 2)),
            facing_rad=heading_rad,
            turret_rad=heading_rad.copy(),
            slice=np.zeros((count, AXES)),
            move_speed=_rows([[axis.speed for axis in three] for three in axes]),
            ramp=_rows([[axis.acceleration for axis in three] for three in axes]),
            command=np.zeros(count, dtype=np.int64),
            command_cycle=np.zeros(count, dtype=np.int64),
            timeout_s=np.array([drive.timeout_s or np.inf for drive in drives]),
            deadline_s=np.full(count, np.inf),
            limp=np.zeros((count, AXES), dtype=np.bool_),
            hindered=np.zeros(count, dtype=np.bool_),
            forward_mps=np.zeros(count),
            ahead_m=np.zeros(count),
            stalled_s=np.zeros(count),
        )

    def stop(self, rows: IndexArray) -> None:
        """Stop axes immediately, without a command."""
        for part in fields(self.axes):
            getattr(self.axes, part.name)[rows] = 0.0
        self.moved_m[rows] = self.slice[rows] = 0.0
        self.forward_mps[rows] = self.ahead_m[rows] = self.stalled_s[rows] = 0.0
        self.hindered[rows] = False
        self.command[rows] = 0
        self.deadline_s[rows] = np.inf


def _rows(values: list[list[float]]) -> FloatArray:
    return np.array(values, dtype=np.float64).reshape(-1, AXES)
