"""Causes of the positions of objects: commands, contacts, changes by hand, faults."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

import numpy as np

from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.recorded_run import RecordedRun
from crs_cc.debug.timeline.run_event import StopRequest
from crs_cc.debug.world.events import WorldEvent, is_of
from crs_cc.debug.world.rows import instant
from crs_cc.sim.model.degradation import described

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment

Concern = Literal["motion", "contacts", "messages", "battery", "sonar"]

CONCERNS: Final[dict[str, Concern]] = {
    **dict.fromkeys(("x", "y", "heading", "speed", "distance", "stalled", ""), "motion"),
    **dict.fromkeys(("odometry_x", "odometry_y", "odometry_heading"), "motion"),
    **dict.fromkeys(("touching", "collisions", "bumpers"), "contacts"),
    **dict.fromkeys(("sent", "messages", "inbox"), "messages"),
    **dict.fromkeys(("computer_battery", "motor_battery"), "battery"),
    "nearest": "sonar",
}  # fmt: skip
"""What the values of objects come from; "" is for all values of an object."""

EVENTS: Final[dict[Concern, tuple[str, ...]]] = {
    "motion": ("collision", "fall", "grip", "release", "lost", "join"),
    "contacts": ("collision", "bumper"),
    "messages": ("message",),
}
"""The kinds of the events that have to do with a value."""

_MAX_EVENTS: Final = 3
_TOUCHED: Final = re.compile(r" touched (?P<other>.*) at [^,]*, [^,]*$")
_AROUND: Final = 1  # timesteps


@dataclass(frozen=True, slots=True)
class Fact:
    """Something that happened to an object.

    Attributes:
        position: where to go to see it; None for nowhere.
        time_s: when it happened [s].
    """

    text: str
    position: Position | None = None
    time_s: float = 0.0


def command_statement(run: RecordedRun, robot: int) -> int | None:
    """Return the number of the statement with the current motion command of a robot, from 0.

    None if there is none, or if another program gave it. The run is off its timeline after that:
    `seek` must follow.
    """
    drive, end = run.session.environment.state.drive, run.position
    code, timestep = int(drive.command[robot]), int(drive.command_cycle[robot])
    if not code or robot >= len(run.programs):
        return None
    begin = run.history.before(Position(max(0, timestep - _AROUND), 0))[0]
    limit = min(end, Position(timestep + 1 + _AROUND, 0))
    found: int | None = None
    run.arm(StopRequest())
    for event in run.replay(begin, limit, needs_world=True):
        if (robot, code) in event.posted and run.position <= limit:
            found = run.sites_passed(robot) - 1
    return found


def pushing_robots(environment: Environment, number: int) -> list[int]:
    """Return the other robots that touched an object in the last timestep."""
    robots, objects = np.divmod(environment.state.contacts_before, len(environment.names))
    return list(dict.fromkeys(robots[(objects == number) & (robots != number)].tolist()))


def facts(run: RecordedRun, number: int, concern: Concern) -> Iterator[Fact]:
    """Return further causes of a value of an object at the current position."""
    environment = run.session.environment
    is_robot = number < len(environment.world.robots)
    if is_robot and concern == "motion":
        yield from _obstructions(environment, number)
    yield from _recent_events(run, number, concern)
    if is_robot and concern in {"motion", "battery"}:
        devices = {"drive"} if concern == "motion" else {"battery"}
        yield from _active_degradations(environment, number, devices)


def _obstructions(environment: Environment, robot: int) -> Iterator[Fact]:
    """Return the reason why a robot is stopped now."""
    drive, names = environment.state.drive, environment.names
    robots, objects = np.divmod(environment.state.contacts_before, len(names))
    touched = ", ".join(names[each] for each in objects[robots == robot].tolist())
    stalled_s = float(drive.stalled_s[robot])
    if touched:
        yield Fact(f"it touches {touched}" + ", which hinders it" * bool(drive.hindered[robot]))
    if stalled_s > 0.0:
        since_s = max(0.0, environment.time_s - stalled_s)
        yield Fact(f"its motors have been stalled since t = {instant(since_s)}")
    if bool(drive.limp[robot].all()):
        yield Fact("its motors are off")
    if float(drive.deadline_s[robot]) <= environment.time_s:
        yield Fact(f"its command has timed out at t = {instant(float(drive.deadline_s[robot]))}")


def _recent_events(run: RecordedRun, number: int, concern: Concern) -> Iterator[Fact]:
    """Return the last events that have to do with a value, and the last change by hand."""
    environment, here = run.session.environment, run.position
    name, kinds = environment.names[number], EVENTS.get(concern, ())
    found: list[tuple[int, WorldEvent]] = []
    for timestep, each in run.event_history.by_timestep():
        if Position(timestep + 1, 0) > here or not is_of(each.kind, kinds):
            continue
        touched = _TOUCHED.search(each.text)
        if each.robot == number or (touched is not None and touched["other"] == name):
            found.append((timestep, each))
    for timestep, each in reversed(found[-_MAX_EVENTS:]):
        yield Fact(each.text, Position(timestep + 1, 0), each.time_s)
    word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    for change in reversed(run.history.changes):
        if change.robot < 0 and change.position <= here and word.search(change.text):
            time_s = change.position.timestep * environment.timestep_s
            yield Fact(f"you changed it: {change.text}", change.position, time_s)
            return


def _active_degradations(environment: Environment, robot: int, devices: set[str]) -> Iterator[Fact]:
    control, own = environment.degradations, environment.world.robots[robot]
    for each in control.all():
        if each.robot == own.id and each.device in devices and control.phase(each.id) == "acts":
            yield Fact(f"bent by the degradation {each.id}: {described(each, own.model)}")
