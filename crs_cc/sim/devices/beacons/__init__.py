"""Lamps and speakers: brightness and level of robots, effective at the time of the command.

Values beyond the limits of the lamp or speaker are clipped. They are sensed by `light` and `sound`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.sim.model.beacons import TONES

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext


def light(context: RequestContext) -> BoolArray:
    """Set the brightness of lamps; refuse robots without one."""
    rows, brightest = context.rows, context.constants.brightest[context.rows]
    wanted = _within(context, "lamp", rows, context["brightness"], most=brightest)
    context.state.beacons.brightness[rows] = wanted
    return np.asarray(brightest > 0.0)


def sound(context: RequestContext) -> BoolArray:
    """Set level and tone of speakers; refuse robots without one, and unknown tones."""
    tone, beacons = context["tone"], context.state.beacons
    good = (context.constants.loudest[context.rows] > 0.0) & (tone >= 0) & (tone < TONES)
    rows, tone = context.rows[good], tone[good]
    most = context.constants.loudest[rows]
    wanted = _within(context, "speaker", rows, context["level"][good], most=most)
    beacons.level[rows], beacons.tone[rows] = wanted, tone
    return np.asarray(good)


def _within(
    context: RequestContext,
    device: str,
    rows: IndexArray,
    requested: Int32Array,
    *,
    most: FloatArray,
) -> FloatArray:
    """Return the requested strengths after degradation and clipping, (k,)."""
    wanted = np.clip(requested.astype(np.float64), 0.0, most)
    altered = context.constants.degradations.alter(
        context.state, device, rows, wanted[:, None], context.state.drive.clock_s[rows]
    )[:, 0]
    return np.clip(np.nan_to_num(altered, nan=0.0), 0.0, most)
