"""What happens in a world besides motion: said by whoever does it, heard with the cycle's `Step`.

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
    "message": "one was sent, arrived or was lost; an outage began or ended",
    "degradation": "one was added, changed or removed; it began, began to fade or ended",
    "join": "a robot joined, or had to wait because its place was occupied",
    "leave": "a robot left",
    "fall": "the ground under a robot dropped away",
    "grip": "a gripper or a hand took hold of an object",
    "release": "a gripper or a hand released an object",
    "lost": "an object was torn from a gripper",
}
"""The kinds of events, and what they tell."""


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happened at an instant.

    Attributes:
        time_s: when.
        kind: one of `KINDS`.
        text: what happened, for people, in the past tense.
        robot: whom it happened to, -1 for none.
    """

    time_s: float
    kind: str
    text: str
    robot: int = -1


class EventLog:
    """The events of the current cycle, in the order in which they were said."""

    def __init__(self) -> None:
        self._events: list[Event] = []

    def say(self, time_s: float, kind: str, text: str, robot: int = -1) -> None:
        """Add an event, see `Event`."""
        assert kind in KINDS, kind
        self._events.append(Event(float(time_s), kind, text, int(robot)))

    def take(self, until_s: float = math.inf) -> tuple[Event, ...]:
        """Return the events up to an instant, and forgets them."""
        events = tuple(event for event in self._events if event.time_s <= until_s)
        self._events[:] = [event for event in self._events if event.time_s > until_s]
        return events

    def snapshot(self) -> tuple[Event, ...]:
        """Return all events."""
        return tuple(self._events)

    def restore(self, events: tuple[Event, ...]) -> None:
        """Goes back to a snapshot."""
        self._events[:] = events
