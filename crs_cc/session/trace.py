"""Traces of each timestep, as text.

`Trace` shows the request queue: one line for each timestep and robot that is in the world.

A line shows the command that the hardware simulator was running, the slice executed in the
timestep, and the requests answered, each with the time at which the program resumed:

    0.200 robot0  VM 5/-  right 0.0049 m  left 0.0049 m  GET_RC() @0.237 pose=4,0,0

The robots' lines of a timestep are followed by its events, each with its time, the robot that it
concerns (- for none) and its kind:

    10.000 robot0  degradation: sonar 3, bias 0.5m (degradation0 began)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Final

from crs_cc.sim.comms.message_log import events
from crs_cc.sim.engine.step import Answer, AxisSlice, RobotSlice, Step, describe_slice
from crs_cc.sim.model.degradable import TURNING
from crs_cc.sim.state.events import Event

_MAX_VALUES: Final = 16  # a reply has up to 62


class Trace:
    """Writes a line for each robot in each timestep.

    Args:
        write: receives one line, without the end of line.
        names: the robots' names, in the world's order.
    """

    def __init__(self, write: Callable[[str], None], names: Sequence[str]) -> None:
        self._write = write
        self._names = tuple(names)
        self._width = max(map(len, self._names), default=0)

    def step(self, step: Step) -> None:
        """Write the lines of a timestep."""
        for robot, name in enumerate(self._names):
            if not step.slices.present[robot]:
                continue
            slice_ = describe_slice(step, robot)
            self._write(f"{step.time_s:.3f} {name:{self._width}}  {line(slice_)}")
        for event in sorted(step.events, key=lambda event: event.time_s):
            self._write(_event_line(event, self._names, self._width))


class MessageTrace:
    """Writes the life of messages between robots, a line for each event, by time.

    The format is that of the events in a `Trace`; outages and restorations of links are included,
    too:

        0.350 robot1  message: radio message 0 of robot0 to all, type 3, 1 bytes: delivered

    Args:
        write: receives one line, without the end of line.
        names: the robots' names, in the world's order.
        channels: the channels' names.
    """

    def __init__(
        self, write: Callable[[str], None], names: Sequence[str], channels: Sequence[str]
    ) -> None:
        self._write = write
        self._names = tuple(names)
        self._channels = tuple(channels)
        self._width = max(map(len, self._names), default=0)

    def step(self, step: Step) -> None:
        """Write the lines of a timestep."""
        said = [event for event in step.events if event.kind == "message"]
        said += events(step.traffic, self._channels, self._names)
        for event in sorted(said, key=lambda event: event.time_s):
            self._write(_event_line(event, self._names, self._width))


def _event_line(event: Event, names: Sequence[str], width: int) -> str:
    name = names[event.robot] if event.robot >= 0 else "-"
    return f"{event.time_s:.3f} {name:{width}}  {event.kind}: {_one_line(event.text)}"


def _one_line(text: str) -> str:
    """Return a text with control characters escaped."""
    return text if text.isprintable() else text.encode("unicode_escape").decode("ascii")


def line(slice_: RobotSlice) -> str:
    """Return one robot's timestep as text.

    >>> wheels = (AxisSlice(name, 0.0127, 0.0381, 0.254) for name in ("right", "left"))
    >>> line(RobotSlice("PR", 3, 21, tuple(wheels), True, ()))
    'PR 3/21  right 0.0127 m  left 0.0127 m  done 0.0381,0.0381 of 0.2540,0.2540 m  waits'
    >>> line(RobotSlice("VM", 1, None, (AxisSlice("turret", math.pi / 2, 9.0, None),), False, ()))
    'VM 1/-  turret 90.00 deg'
    """
    parts = [f"{slice_.command or '-'}{_count(slice_)}"]
    parts += [f"{axis.name} {_distance(axis, axis.motion)} {_unit(axis)}" for axis in slice_.axes]
    if slice_.command and all(axis.total is not None for axis in slice_.axes):
        done = ",".join(_distance(axis, axis.travelled) for axis in slice_.axes)
        total = ",".join(_distance(axis, axis.total or 0.0) for axis in slice_.axes)
        units = dict.fromkeys(_unit(axis) for axis in slice_.axes)
        parts.append(f"done {done} of {total} {','.join(units)}")
    if slice_.waiting:
        parts.append("waits")
    parts += [_answer(answer) for answer in slice_.answers]
    return "  ".join(parts)


def _unit(axis: AxisSlice) -> str:
    return "deg" if axis.name in TURNING else "m"


def _distance(axis: AxisSlice, distance: float) -> str:
    return f"{math.degrees(distance):.2f}" if axis.name in TURNING else f"{distance:.4f}"


def _count(slice_: RobotSlice) -> str:
    if not slice_.command:
        return ""
    return f" {slice_.number}/{'-' if slice_.count is None else slice_.count}"


def _answer(answer: Answer) -> str:
    arguments = ",".join(map(str, answer.arguments))
    text = f"{answer.name}({arguments}) @{answer.clock_s:.3f}"
    if not answer.result:
        text += " refused"
    for name, values in answer.values.items():
        text += f" {name}={','.join(map(str, values[:_MAX_VALUES]))}"
        if len(values) > _MAX_VALUES:
            text += f",... ({len(values)} in all)"
    return text
