"""The positions at which the operands of a past statement are evaluated."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.debug.timeline.position import Position
from crs_cc.runtime.diagnosis.inspect import StackFrame


@dataclass(frozen=True, slots=True)
class EvaluationPlace:
    """Where operands have their values: a position, and a frame at a location."""

    position: Position
    robot: int
    frame: StackFrame | None


@dataclass(frozen=True, slots=True)
class PassingCall:
    """The call that passed a parameter: its number, and the frames."""

    number: int
    callee: StackFrame
    caller: StackFrame
