"""Requests that a kernel answers in one call: those for `State`, and `vm`.

Most requests of most programs are of these kinds, and most robots can answer them at once: nothing
is due before, no motion is degraded. Infrared rings and compasses measure for the replies then. All
others are left to the handlers, which give the same answers.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int32Array, Records
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.sensor_board import write_readings
from crs_cc.sim.devices.vendor_state import KernelReply
from crs_cc.sim.kernels.tables import ADVANCED, SENSOR_DUE
from crs_cc.sim.state.rows import simplest

if TYPE_CHECKING:
    from crs_cc.sim.engine.world_data import WorldData


def answer_simple_requests(
    data: WorldData, code: int, rows: IndexArray, messages: Records, clock_s: FloatArray
) -> tuple[FloatArray, Int32Array] | None:
    """Answer requests of one kind, if they are simple.

    Args:
        data: the world; nothing is changed unless they are, but that its sensors measure.
        code: the kind.
        rows: the robots, in ascending order, k of them.
        messages: their requests, changed in place into the replies.
        clock_s: when each arrives.

    Returns:
        the time of each reply, and `State` as reported, (k, 45); None if the handlers have to
        answer.
    """
    command = data.simple.get(code)
    if command is None or (command and data.is_weary) or not _is_simple(data):
        return None
    state, constants, cycle = data.state, data.constants, data.state.cycle
    some = simplest(rows, len(state.connected))
    service = data.end_s, constants.last_time_s(cycle), command, cycle
    asked = clock_s, state.presence.joined_s[some], messages["i"]
    found, at_s, mounts, replies = state.rows.serve(some, service, asked, constants.kinds)
    if found == SENSOR_DUE:
        now_s = np.minimum(np.maximum(clock_s, state.drive.clock_s[some]), data.end_s)
        data.devices.advance(state, constants, data.rays, rows, now_s)
        found, at_s, mounts, replies = state.rows.serve(some, service, asked, constants.kinds)
    if found != ADVANCED:
        return None
    board = data.devices.sensor_board
    kernel_reply = KernelReply.by(replies["state"], mounts)
    board.measure_for_simple_requests(
        state, constants, data.rays, (rows, at_s), code, kernel_reply=kernel_reply
    )
    write_readings(state, constants, rows, replies["state"])
    board.write(state, constants, (rows, at_s), replies, messages)
    messages["result"] = 1
    return at_s, replies["state"]


def _is_simple(data: WorldData) -> bool:
    """Return whether kernels know all that replies depend on."""
    state, constants = data.state, data.constants
    return (
        drive.moves_as_commanded(state, constants)
        and not len(state.pos_data.reported)
        and not constants.degradations.affects(state, "battery")
    )
