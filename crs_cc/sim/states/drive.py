"""The motion of the wheels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
import numpy.typing as npt

from crs_cc.sim.hardware import Wheels
from crs_cc.sim.model import WorldModel

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
WholeArray = npt.NDArray[np.int64]


@dataclass(slots=True)
class DriveState:
    """The motion of the wheels; arrays have a row for each robot.

    Attributes:
        wheels: the wheels' profiles, shape (robots, 2) each.
        clock_s: the instant to which each robot's wheels have been turned.
        moved_m: where the wheels took each robot in this cycle, world frame, (robots, 2).
        facing_rad: the heading that this led to.
        slice_m: the way of each wheel in this cycle, (robots, 2): the slice so far.
        move_mps: speed of relative moves (`sp`), (robots, 2).
        ramp_mps2: acceleration (`ac`), (robots, 2).
        command: request code of the motion command that runs; 0 before the first.
        command_cycle: the cycle in which it came.
        timeout_s: the wheels stop when no command came for so long (`conf_tm`), infinite for never.
        deadline_s: when they will.
        waiting: the wheels that a `ws` waits for, (robots, 2).
        wait_until_s: when it gives up.
    """

    wheels: Wheels
    clock_s: FloatArray
    moved_m: FloatArray
    facing_rad: FloatArray
    slice_m: FloatArray
    move_mps: FloatArray
    ramp_mps2: FloatArray
    command: WholeArray
    command_cycle: WholeArray
    timeout_s: FloatArray
    deadline_s: FloatArray
    waiting: BoolArray
    wait_until_s: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Gives wheels that rest."""
        count = len(world.robots)
        drives = [robot.model.drive for robot in world.robots]
        return cls(
            wheels=Wheels.standing(count),
            clock_s=np.zeros(count),
            moved_m=np.zeros((count, 2)),
            facing_rad=np.array([robot.start.heading_rad for robot in world.robots]),
            slice_m=np.zeros((count, 2)),
            move_mps=_both([drive.speed_mps for drive in drives]),
            ramp_mps2=_both([drive.acceleration_mps2 for drive in drives]),
            command=np.zeros(count, dtype=np.int64),
            command_cycle=np.zeros(count, dtype=np.int64),
            timeout_s=np.array([drive.timeout_s or np.inf for drive in drives]),
            deadline_s=np.full(count, np.inf),
            waiting=np.zeros((count, 2), dtype=np.bool_),
            wait_until_s=np.full(count, np.inf),
        )


def _both(values: list[float]) -> FloatArray:
    """Gives the same value to both wheels of each robot."""
    return np.repeat(np.array(values, dtype=np.float64)[:, None], 2, axis=1)
