"""The user's interventions in a run: changes and typed lines, and how they are undone.

Both are in the order of the run. To take one back is to go to where it was done, and to forget it
with all that was done later: the program asks again for a line.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.stop import Stop
from crs_cc.debug.timeline.position import Position

_MAX_TEXT: Final = 60
"""Longer lines are truncated to this length [characters]."""


@dataclass(frozen=True, slots=True)
class Intervention:
    """Something that the user has done to a run.

    Attributes:
        place: where in the run, or of a typed line, a position shortly before.
        robot: the robot whose program is concerned; -1 for none.
        text: a description.
        change: its number among the changes of the history, from 0; None for a typed line.
    """

    place: Position
    robot: int
    text: str
    change: int | None = None


def interventions(debugger: Debugger) -> list[Intervention]:
    """Return all interventions of the user, in order."""
    made = [
        Intervention(each.position, each.robot, each.text, number)
        for number, each in enumerate(debugger.run.history.changes)
    ]
    typed = [
        Intervention(place, robot, _described(piece))
        for place, robot, piece in debugger.run.console.typed_input()
    ]
    return sorted([*made, *typed], key=lambda each: each.place)


def _described(piece: bytes) -> str:
    if not piece:
        return "typed the end of input"
    text = piece.decode(errors="replace").rstrip("\n")
    return f'typed "{text[:_MAX_TEXT]}"' + "..." * (len(text) > _MAX_TEXT)


def revert(debugger: Debugger, number: int) -> Stop:
    """Undo an intervention and all later ones.

    Args:
        debugger: the debugger.
        number: its number among the interventions, from 0.

    Raises:
        DebugError: there is none with that number.
    """
    done = interventions(debugger)
    if not 0 <= number < len(done):
        raise DebugError(f"no change {number}")
    one, run = done[number], debugger.run
    if one.change is not None:
        stop = debugger.revert(one.change)
    else:
        earlier = [each.change for each in done[:number] if each.change is not None]
        stop = debugger.rewind_to(one.place, earlier)
    run.console.discard_typed(one.place)
    return stop
