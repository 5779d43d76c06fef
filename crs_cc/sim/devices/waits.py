"""Requests that are answered later, at the end of a wait.

The end of a wait is known in advance: running axes stop, a message in transit arrives, or the wait
times out. A waiting robot receives no commands, so that its axes can be advanced to the end of its
wait as soon as that is in the current cycle.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import Handler
    from crs_cc.sim.state.env_state import EnvState


@dataclass(frozen=True, slots=True)
class Wait:
    """The wait of one kind of request.

    Attributes:
        ends_s: returns when the waits of robots end as far as is known now, infinite for never;
            not before the times that the robots have reached, shape (k,).
        finish: answers the requests when the waits have ended.
    """

    ends_s: Callable[[EnvState, IndexArray], FloatArray]
    finish: Handler


def when(waits: Mapping[int, Wait], state: EnvState, rows: IndexArray) -> FloatArray:
    """Return when the waits of robots will end, by current knowledge, shape (k,)."""
    ends_s, codes = np.full(len(rows), np.inf), state.waits.code[rows]
    for code in sorted(set(codes.tolist())):
        mine = codes == code
        ends_s[mine] = waits[code].ends_s(state, rows[mine])
    return ends_s
