"""Positions and targets of gripper fingers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray

if TYPE_CHECKING:
    from crs_cc.sim.devices.gripper.model import Gripper
    from crs_cc.sim.state.env_state import EnvState


@dataclass(slots=True)
class GripperState:
    """The grippers; arrays have a row for each robot with a gripper, n of them.

    What they hold is in `state.bodies`.

    Attributes:
        from_m: distance between the fingers at the last command to open or close, (n,).
        since_s: time of that command, (n,).
        closing: whether it was to close, (n,).
        before_m: the distance at the end of the last cycle, (n,).
        width_m: the width of the held object; 0 for none, (n,).
    """

    from_m: FloatArray
    since_s: FloatArray
    closing: BoolArray
    before_m: FloatArray
    width_m: FloatArray

    @classmethod
    def at_start(cls, grippers: Sequence[Gripper]) -> Self:
        """Return open grippers."""
        open_m = np.array([gripper.opening_m for gripper in grippers], dtype=np.float64)
        nothing, no = np.zeros(len(grippers)), np.zeros(len(grippers), dtype=np.bool_)
        return cls(open_m, nothing, no, open_m.copy(), nothing.copy())


def gripper_of(state: EnvState) -> GripperState:
    """Return the state of the grippers."""
    return state.device("gripper", GripperState)
