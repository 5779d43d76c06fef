"""The positions at which the operands of a past statement are evaluated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from crs_cc.debug.data.object_parts import Span, part_within
from crs_cc.debug.timeline.position import Position
from crs_cc.runtime.diagnosis.inspect import StackFrame

if TYPE_CHECKING:
    from crs_cc.debug.data.evaluate import Evaluator
    from crs_cc.debug.data.values import Value


@dataclass(frozen=True, slots=True)
class EvaluationPoint:
    """Where operands have their values: a position, and a frame at a location."""

    position: Position
    robot: int
    frame: StackFrame | None


@dataclass(frozen=True, slots=True)
class PassingCall:
    """The call that passed a value.

    Attributes:
        number: the number of its parameter.
        callee: the frame of the called function.
        caller: the frame of its caller.
        part: which bytes of the parameter the value is; None for all.
    """

    number: int
    callee: StackFrame
    caller: StackFrame
    part: Span | None = None


def passing_call(
    evaluator: Evaluator, stack: Sequence[StackFrame], owner: StackFrame | None, value: Value
) -> PassingCall | None:
    """Return the call that passed a value, if it is a parameter, or a part of one.

    Args:
        evaluator: evaluates the parameters.
        stack: the frames of the program, innermost first.
        owner: the frame that has the value; None if it is static.
        value: the value.
    """
    if owner is None:
        return None
    declared = evaluator.declared_at(owner.function, owner.location)
    places = {each.variable.name: each.variable.location for each in declared}
    own = [each for each in evaluator.variables(owner) if each.scope == "parameter"]
    own.sort(key=lambda each: places[each.name])
    for number, each in enumerate(own):
        first, size, at = each.value.address or 0, each.value.type.size, value.address or 0
        if first <= at < first + size:
            outer = stack[stack.index(owner) + 1 :]
            part = part_within(first, size, (at, value.type.size))
            return PassingCall(number, owner, outer[0], part) if outer else None
    return None
