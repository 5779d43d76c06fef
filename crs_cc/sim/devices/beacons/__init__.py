"""Lamps and speakers: how bright and how loud robots are, from the instant they are told to be.

What is told beyond what the lamp or speaker can is brought within. Who senses it is in
`sensors.light` and `sensors.sound`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Records
from crs_cc.sim.model.beacons import TONES

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


def light(
    state: EnvState, constants: RobotConstants, rows: IndexArray, messages: Records
) -> BoolArray:
    """Lets lamps shine; refuses robots that have none."""
    brightest = constants.brightest[rows]
    wanted = _within(state, constants, "lamp", rows, messages, most=brightest)
    state.beacons.brightness[rows] = wanted
    return np.asarray(brightest > 0.0)


def sound(
    state: EnvState, constants: RobotConstants, rows: IndexArray, messages: Records
) -> BoolArray:
    """Lets speakers sound; refuses robots that have none, and tones that are none."""
    tone = messages["i"][:, 1]
    good = (constants.loudest[rows] > 0.0) & (tone >= 0) & (tone < TONES)
    rows, messages = rows[good], messages[good]
    most = constants.loudest[rows]
    wanted = _within(state, constants, "speaker", rows, messages, most=most)
    state.beacons.level[rows], state.beacons.tone[rows] = wanted, tone[good]
    return np.asarray(good)


def _within(
    state: EnvState,
    constants: RobotConstants,
    device: str,
    rows: IndexArray,
    messages: Records,
    *,
    most: FloatArray,
) -> FloatArray:
    """Gives what becomes of the strength that is asked for."""
    wanted = np.clip(messages["i"][:, 0].astype(np.float64), 0.0, most)
    altered = constants.degradations.alter(
        state, device, rows, wanted[:, None], state.drive.clock_s[rows]
    )[:, 0]
    return np.clip(np.nan_to_num(altered, nan=0.0), 0.0, most)
