"""The events of a timestep, for catchpoints and timelines.

All of it follows from the timestep's `Step` and the world's constants, so it is the same whenever
the timestep is replayed. Events are selected by kind, and subkinds
are included: `message` catches `message-lost`.

>>> from crs_cc.sim.engine.environment import Environment
>>> from crs_cc.sim.files.world_xml import empty_world
>>> environment = Environment(empty_world(), seed=1)
>>> step = environment.step()
>>> [each.text for each in world_events(step, environment.world, ["tick", "collision"])]
['timestep 0 ended']
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError
from crs_cc.sim.comms import message_log
from crs_cc.sim.comms.message_log import Fate
from crs_cc.sim.devices.bumper.element import switches_of
from crs_cc.sim.engine.step import Step
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state import events

KINDS: Final = {
    "tick": "a timestep ended",
    "collision": "a robot came into contact with an object",
    "bumper": "a bumper switch was pressed or released",
    "bumper-pressed": "a bumper switch was pressed",
    "bumper-released": "a bumper switch was released",
    "message": "a message was sent, delivered or lost; a link was blocked or unblocked",
    "message-sent": "a program sent a message",
    "message-arrived": "a message was delivered intact",
    "message-corrupted": "a message was delivered corrupted",
    "message-lost": "a message was lost",
    "message-way": "a link was blocked or unblocked",
    **{kind: text for kind, text in events.KINDS.items() if kind != "message"},
}
"""The event kinds with their meanings; the names of catchpoints."""

_FATES: Final = {
    Fate.SENT: "message-sent",
    Fate.DELIVERED: "message-arrived",
    Fate.CORRUPTED: "message-corrupted",
}


@dataclass(frozen=True, slots=True)
class WorldEvent:
    """An event in the world.

    Attributes:
        time_s: its time [s].
        kind: one of `KINDS`.
        robot: the number of its robot, -1 for none.
        text: its description, with the robot's name.
        place: its position [m], if it has one.
    """

    time_s: float
    kind: str
    robot: int
    text: str
    place: tuple[float, float] | None = None


def check_event_kind(name: str) -> str:
    """Return an event kind if it is valid; raise DebugError if there is no such kind."""
    if name not in KINDS:
        raise DebugError(unknown("event kind", name, ("exit", *KINDS)))
    return name


def is_of(kind: str, wanted: Iterable[str]) -> bool:
    """Return whether a kind is one of some kinds, or a subkind.

    >>> is_of("message-lost", ["message"]), is_of("message-lost", ["message-sent"])
    (True, False)
    """
    return any(kind == each or kind.startswith(f"{each}-") for each in wanted)


def world_events(step: Step, world: WorldModel, wanted: Sequence[str]) -> list[WorldEvent]:
    """Return the events of a timestep, by time.

    Args:
        step: the timestep, which has ended.
        world: the constants of the world it was a step of.
        wanted: the kinds to return.
    """
    if not wanted:
        return []
    groups = {kind.partition("-")[0] for kind in wanted}
    found = [
        each
        for group, source in _SOURCES
        if group in groups or not group
        for each in source(step, world)
        if is_of(each.kind, wanted)
    ]
    return sorted(found, key=lambda each: each.time_s)


def _collisions(step: Step, world: WorldModel) -> Iterator[WorldEvent]:
    """Return the contacts that started in the timestep; they are reported at its end."""
    contacts, end_s = step.contacts, step.time_s + world.timestep_s
    rows = (contacts.robot, contacts.other, contacts.x_m, contacts.y_m)
    for robot, other, x_m, y_m in zip(*(row.tolist() for row in rows), strict=True):
        text = f"{step.names[robot]} touched {step.names[other]} at {x_m:z.3f}, {y_m:z.3f} m"
        yield WorldEvent(end_s, "collision", robot, text, (x_m, y_m))


def _bumpers(step: Step, world: WorldModel) -> Iterator[WorldEvent]:
    end_s = step.time_s + world.timestep_s
    changes = (("pressed", step.pressed), ("released", step.released))
    for word, bits in changes:
        for robot in np.flatnonzero(bits).tolist():
            for switch in switches(int(bits[robot]), world.robots[robot].model):
                text = f"{step.names[robot]}'s {switch} was {word}"
                yield WorldEvent(end_s, f"bumper-{word}", robot, text)


def switches(bits: int, model: RobotModel) -> Iterator[str]:
    """Return the names of switches of a robot, from the bits of `State[33]`."""
    for switch in switches_of(model):
        if bits >> switch.bit & 1:
            yield f"bumper {switch.bit} ({side(switch.bearing_rad)})"


def side(bearing_rad: float) -> str:
    """Return the name of a direction as seen from a robot.

    >>> [side(math.radians(angle)) for angle in (0, 90, 45, 180, -90, 315)]
    ['ahead', 'left', 'ahead left', 'behind', 'right', 'ahead right']
    """
    octant = round(bearing_rad / (math.pi / 4)) % 8
    return (
        "ahead", "ahead left", "left", "behind left",
        "behind", "behind right", "right", "ahead right",
    )[octant]  # fmt: skip


def _messages(step: Step, world: WorldModel) -> Iterator[WorldEvent]:
    if not len(step.traffic):
        return
    channels = [channel.name for channel in world.communication.channels]
    robots = [robot.id for robot in world.robots]
    fates = step.traffic["fate"].tolist()
    for fate, event in zip(fates, message_log.events(step.traffic, channels, robots), strict=True):
        kind = _FATES.get(Fate(fate), "message-lost")
        yield WorldEvent(event.time_s, kind, event.robot, event.text)


def _events(step: Step, _world: WorldModel) -> Iterator[WorldEvent]:
    for event in step.events:
        kind = "message-way" if event.kind == "message" else event.kind
        text = f"{step.names[event.robot]} {event.text}" if event.robot >= 0 else event.text
        if kind == "degradation":  # the text begins with a device
            text = f"{step.names[event.robot]}: {event.text}"
        yield WorldEvent(event.time_s, kind, event.robot, text)


def _ticks(step: Step, world: WorldModel) -> Iterator[WorldEvent]:
    end_s = step.time_s + world.timestep_s
    yield WorldEvent(end_s, "tick", -1, f"timestep {step.cycle} ended")


_SOURCES: Final[tuple[tuple[str, Callable[[Step, WorldModel], Iterator[WorldEvent]]], ...]] = (
    ("", _events),  # of all kinds that are not below, and ways of messages
    ("message", _messages),
    ("collision", _collisions),
    ("bumper", _bumpers),
    ("tick", _ticks),
)
"""The sources of events by kind; simultaneous events come in this order."""
