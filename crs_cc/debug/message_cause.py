"""Messages between robots as causes: where one was sent, and which were lost since."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.recorded_run import RecordedRun
from crs_cc.debug.timeline.run_event import StopRequest
from crs_cc.debug.world.events import WorldEvent
from crs_cc.requests import CODES

RECEIVES: Final = "crs_receive"
_SLACK_S: Final = 2e-3  # programs know times of messages in whole milliseconds
_AROUND: Final = 2  # timesteps


def sending(run: RecordedRun, sender: int, sent_s: float) -> int | None:
    """Return the number of the statement with which a robot sent a message, from 0.

    The run is off its timeline after that: `seek` must follow.

    Args:
        run: the run.
        sender: the robot.
        sent_s: when the message was sent, to a millisecond.
    """
    timestep = int(sent_s / run.session.environment.timestep_s)
    begin = run.history.before(Position(max(0, timestep - _AROUND), 0))[0]
    found: int | None = None
    run.arm(StopRequest())
    for event in run.replay(begin, Position(timestep + _AROUND, 0), needs_world=True):
        if (sender, CODES["SEND"]) in event.posted and run.time_s(sender) <= sent_s + _SLACK_S:
            found = run.statements_begun(sender) - 1
    return found


def lost_messages(
    run: RecordedRun, receiver: int, since_s: float, until_s: float
) -> Iterator[WorldEvent]:
    """Return the messages to a robot that were lost between two times."""
    for each in run.event_history.world_events():
        is_lost = each.kind == "message-lost" and each.robot == receiver
        if is_lost and since_s <= each.time_s <= until_s:
            yield each
