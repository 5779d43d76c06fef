"""Positions and targets of arm joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray

if TYPE_CHECKING:
    from crs_cc.sim.devices.arm.model import Arm
    from crs_cc.sim.state.env_state import EnvState


@dataclass(slots=True)
class ArmState:
    """The arms; arrays have a row for each robot with an arm, n of them.

    What they hold is in `state.bodies`.

    Attributes:
        from_rad: angles of shoulder and elbow at the last command, (n, 2).
        to_rad: commanded angles, (n, 2).
        since_s: time of the last command, (n,).
        closed: commanded state of the hand: whether it is closed, (n,).
        acts: whether the hand has still to close or open, (n,).
    """

    from_rad: FloatArray
    to_rad: FloatArray
    since_s: FloatArray
    closed: BoolArray
    acts: BoolArray

    @classmethod
    def at_start(cls, arms: Sequence[Arm]) -> Self:
        """Return arms that are stretched out as far as their joints allow, with open hands."""
        limits_rad = np.array([
            [(arm.shoulder_least_rad, arm.elbow_least_rad),
             (arm.shoulder_most_rad, arm.elbow_most_rad)]
            for arm in arms
        ], dtype=np.float64).reshape(-1, 2, 2)  # fmt: skip
        start_rad = np.minimum(np.maximum(0.0, limits_rad[:, 0]), limits_rad[:, 1])
        no = np.zeros(len(arms), dtype=np.bool_)
        return cls(start_rad, start_rad.copy(), np.zeros(len(arms)), no, no.copy())


def arm_of(state: EnvState) -> ArmState:
    """Return the state of the arms."""
    return state.device("arm", ArmState)
