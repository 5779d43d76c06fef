"""Places in a run as text, which pages keep and go back to."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from crs_cc.debug.errors import DebugError
from crs_cc.debug.past import Past
from crs_cc.debug.timeline.position import Position

if TYPE_CHECKING:
    from crs_cc.debug.engine import Debugger

_POSITION: Final = re.compile(r"(\d{1,12})\.(\d{1,12})\.(-1|\d{1,6})\.(\d{1,15})")


def position_text(at: Position) -> str:
    """Return a position as text.

    >>> position_text(Position(3, 0, 1, 40))
    '3.0.1.40'
    """
    return f"{at.timestep}.{at.round}.{at.robot}.{at.statements}"


def position_of(debugger: Debugger, text: str) -> Position:
    """Return the position that a page wants to go to.

    Raises:
        DebugError: it is invalid, or the run has not reached it.
    """
    found = _POSITION.fullmatch(text)
    if found is None:
        raise DebugError(f"'{text[:40]}' is not a position in the run")
    position = Position(*map(int, found.groups()))
    known = Past(debugger.view, debugger.stop_points).whole().end
    if position > known or position.robot >= len(debugger.names):
        raise DebugError("the run has not reached this position, or has changed since")
    return position
