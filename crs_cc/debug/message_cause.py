"""Messages between robots as causes: where they were sent, and which were lost since."""

from __future__ import annotations

import contextlib
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.debug.data.object_parts import Span, address_of
from crs_cc.debug.data.statement_text import arguments
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.recorded_run import RecordedRun
from crs_cc.debug.timeline.run_event import StopRequest
from crs_cc.debug.world.events import WorldEvent
from crs_cc.requests import CODES

if TYPE_CHECKING:
    from crs_cc.debug.data.evaluate import Evaluator
    from crs_cc.runtime.diagnosis.inspect import StackFrame

RECEIVES: Final = "crs_receive"
_SENDS: Final = re.compile(r"\bcrs_(?:send|broadcast|multicast)\s*\(")
_LAST: Final = 3  # arguments
_SLACK_S: Final = 2e-3  # programs know times of messages in whole milliseconds
_AROUND: Final = 2  # timesteps


@dataclass(frozen=True, slots=True)
class ReceivedMessage:
    """A message that a program has received.

    Attributes:
        sender: the robot that sent it.
        sent_s: when [s].
        type: its type, as given by the sender.
        content: its bytes.
        part: the bytes of it that matter: the first one, and how many; None for all.
    """

    sender: int
    sent_s: float
    type: int
    content: bytes
    part: Span | None


def received(evaluator: Evaluator, message: str, frame: StackFrame, span: Span) -> ReceivedMessage:
    """Return the contents of a `struct crs_message`.

    Args:
        evaluator: evaluates it, in the program that has received it.
        message: a pointer to it.
        frame: the frame in whose scope that is.
        span: the bytes that matter: their address, and how many.
    """
    sender, sent_ms, size, kind = (
        int(evaluator.evaluate(f"{message}->{name}", frame).value.number or 0)
        for name in ("from", "sent", "size", "type")
    )
    data = address_of(evaluator, f"{message}->data", frame) or 0
    content = evaluator.inspector().read(data, size)
    first = span[0] - data
    part = (first, span[1]) if 0 <= first <= first + span[1] <= size else None
    return ReceivedMessage(sender, sent_ms / 1000.0, kind, content, part)


def sending_statements(run: RecordedRun, sender: int, sent_s: float) -> list[int]:
    """Return the numbers of the statements that may have sent a message, the last one first.

    The run is off its timeline after that: `seek` must follow.

    Args:
        run: the run.
        sender: the robot.
        sent_s: when the message was sent, to a millisecond.
    """
    timestep = int(sent_s / run.session.environment.timestep_s)
    begin = run.history.before(Position(max(0, timestep - _AROUND), 0))[0]
    found: list[int] = []
    last_s = -math.inf
    run.arm(StopRequest())
    for event in run.replay(begin, Position(timestep + _AROUND, 0), needs_world=True):
        now_s = run.time_s(sender)
        if (sender, CODES["SEND"]) not in event.posted or now_s > sent_s + _SLACK_S:
            continue
        if now_s < sent_s - _SLACK_S and found and last_s < now_s:
            found.clear()
        last_s = now_s
        found.append(run.sites_passed(sender) - 1)
    return found[::-1]


def sent_arguments(text: str) -> list[str]:
    """Return the arguments with which a statement sends a message; empty if it sends none.

    The last three are its type, its data and their size.
    """
    call = _SENDS.search(text)
    return [] if call is None else arguments(text[call.start() :])


def is_sent(
    evaluator: Evaluator, text: str, frame: StackFrame | None, message: ReceivedMessage
) -> bool:
    """Return whether a statement would send a message, by its type and its bytes.

    Args:
        evaluator: evaluates its arguments, in the sender's program before the call.
        text: the statement.
        frame: the frame of the caller.
        message: the message.
    """
    passed = sent_arguments(text)
    if len(passed) < _LAST:
        return False
    with contextlib.suppress(DebugError):
        kind, size = (evaluator.evaluate(passed[at], frame).value.number for at in (-3, -1))
        evaluator.undo()
        data = address_of(evaluator, passed[-2], frame)
        if data is not None and (kind, size) == (message.type, len(message.content)):
            return evaluator.inspector().read(data, len(message.content)) == message.content
    return False


def lost_messages(
    run: RecordedRun, receiver: int, since_s: float, until_s: float
) -> Iterator[WorldEvent]:
    """Return the messages to a robot that were lost between two times."""
    for each in run.event_history.world_events():
        is_lost = each.kind == "message-lost" and each.robot == receiver
        if is_lost and since_s <= each.time_s <= until_s:
            yield each
