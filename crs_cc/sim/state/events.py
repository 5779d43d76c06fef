"""Events in a world besides motion: recorded when they happen, reported in the cycle's `Step`.

>>> log = EventLog()
>>> log.say(0.05, "message", "lost: out of range", robot=2)
>>> log.take()
(Event(time_s=0.05, kind='message', text='lost: out of range', robot=2),)
>>> log.take()
()
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

KINDS: Final = {
    "message": "a message was sent, arrived or was lost; an outage began or ended",
    "degradation": (
        "a degradation was added, changed or removed, or it started, began to fade or ended"
    ),
    "join": "a robot joined, or had to wait because its place was occupied",
    "leave": "a robot left",
    "fall": "the ground under a robot dropped away",
    "grip": "a gripper or a hand took hold of an object",
    "release": "a gripper or a hand released an object",
    "lost": "an object was torn from a gripper",
    "item": "a robot took an item from a source, or brought one to a nest",
    "goal": "a goal was met or failed",
}
"""The kinds of events, with descriptions."""


@dataclass(frozen=True, slots=True)
class Event:
    """An event.

    Attributes:
        kind: one of `KINDS`.
        text: a description in the past tense.
        robot: the robot concerned, -1 for none.
    """

    time_s: float
    kind: str
    text: str
    robot: int = -1


class EventLog:
    """The events of the current cycle, in the order of recording."""

    def __init__(self) -> None:
        self._events: list[Event] = []

    def say(self, time_s: float, kind: str, text: str, robot: int = -1) -> None:
        """Record an event, see `Event`."""
        assert kind in KINDS, kind
        self._events.append(Event(float(time_s), kind, text, int(robot)))

    def take(self, until_s: float = math.inf) -> tuple[Event, ...]:
        """Return and remove the events up to a time."""
        events = tuple(event for event in self._events if event.time_s <= until_s)
        self._events[:] = [event for event in self._events if event.time_s > until_s]
        return events

    def snapshot(self) -> tuple[Event, ...]:
        """Return all events."""
        return tuple(self._events)

    def restore(self, events: tuple[Event, ...]) -> None:
        """Restore a snapshot."""
        self._events[:] = events
