"""Drawing into the simulator's window, and erasing: `draw_line` and related functions.

There is one picture for all programs; `drawings` defines the marks. Chosen by us: a mark that is
combined by exclusive or disappears when the same program draws it again; beyond the limits
(`MAX_OWN`, `MAX_ALL`) the oldest marks are removed. Of the refresh functions two change the
picture: `refresh_all` and `refresh_client_graphics` erase all that programs have drawn. The others
erase traces or sensors, which viewers draw; they are notified (`Step.served`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, Int32Array
from crs_cc.sim.engine.drawings import is_mode, is_xor, marks_of
from crs_cc.sim.state.drawings import DrawingState

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext


MAX_OWN: Final = 10_000
"""Maximum number of marks of one program in the picture."""

MAX_ALL: Final = 50_000
"""Maximum number of marks of all programs together."""

_MARK: Final = ("shape", "x1", "y1", "x2", "y2", "angle1", "angle2", "mode")
_REFRESH_ALL: Final = 0
_REFRESH_CLIENT_GRAPHICS: Final = 9
ERASING: Final = (_REFRESH_ALL, _REFRESH_CLIENT_GRAPHICS)
"""The parts of the window which hold what programs have drawn."""


def draw(context: RequestContext) -> BoolArray:
    """Answer DRAW with a robot, a line or an arc; refuse unknown shapes and modes."""
    drawings = context.state.drawings
    good = np.zeros(len(context), dtype=np.bool_)
    for row, robot in enumerate(context.rows.tolist()):
        mark = context.columns(*_MARK)[row].tolist()
        good[row] = is_mode(mark[0], mark[-1])
        for each in marks_of(mark) if good[row] else ():
            _put(drawings, robot, np.array(each, np.int32), xor=is_xor(each[0], each[-1]))
    return good


def refresh(context: RequestContext) -> BoolArray:
    """Answer REFRESH: erase the requested marks of programs."""
    part = context["part"]
    if np.isin(part, ERASING).any():
        context.state.drawings = DrawingState.at_start()
    return np.asarray((part >= _REFRESH_ALL) & (part <= _REFRESH_CLIENT_GRAPHICS))


def _put(drawings: DrawingState, robot: int, mark: Int32Array, *, xor: bool) -> None:
    """Add a mark on top; an equal one below is removed, and with exclusive or both are."""
    own = drawings.robots == robot
    keep = ~(own & (drawings.marks == mark).all(axis=1))
    erases = xor and not keep.all()
    if not erases and keep.sum() >= MAX_ALL:
        keep[keep.argmax()] = False
    elif not erases and (own & keep).sum() >= MAX_OWN:
        keep[(own & keep).argmax()] = False
    drawings.marks, drawings.robots = drawings.marks[keep], drawings.robots[keep]
    if not erases:
        drawings.marks = np.concatenate([drawings.marks, mark[None]])
        drawings.robots = np.append(drawings.robots, robot)
