"""The record of one cycle: for the session, for traces, for viewers.

`Step` holds arrays over robots; `describe_slice` returns one robot's part as plain values: which
command ran, which slice of it this was, how far the axes moved, and which requests were answered.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Int64Array, Records
from crs_cc.requests import CODES, REQUESTS, Field
from crs_cc.sim.devices.vendor_state import (
    BUMPER,
    COMPASS,
    CONF_X,
    IR_0,
    MOTOR_STATUS,
    SONAR_0,
    VEL_RIGHT,
)
from crs_cc.sim.engine.drawings import Drawing
from crs_cc.sim.state.bodies import Contacts
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.events import Event

_SONARS: Final = ("sonar_in", slice(SONAR_0, BUMPER))
_INFRARED: Final = ("infrared", slice(IR_0, SONAR_0))
_COMPASS: Final = ("compass", slice(COMPASS, COMPASS + 1))
_BUMPERS: Final = ("bumper", slice(BUMPER, BUMPER + 1))
_POSE: Final = ("pose", slice(CONF_X, CONF_X + 3))
_SPEEDS: Final = ("speed", slice(VEL_RIGHT, VEL_RIGHT + 2))
_MOTORS: Final = ("motors", slice(MOTOR_STATUS, MOTOR_STATUS + 1))
_MAX_CYCLES: Final = 2**53  # longer motions count as endless; doubles are exact up to here
_ANSWERS: Final = {
    CODES["GS"]: (_SONARS, _BUMPERS, _POSE, _SPEEDS, _MOTORS),
    CODES["GET_SN"]: (_SONARS,),
    CODES["GET_BP"]: (_BUMPERS,),
    CODES["GET_IR"]: (_INFRARED,),
    CODES["GET_CP"]: (_COMPASS,),
    CODES["GET_RC"]: (_POSE,),
    CODES["GET_RV"]: (_SPEEDS,),
}

_TEXT: Final = 40  # maximum length of a text that is shown


class Served(NamedTuple):
    """Requests of one kind that were answered together; arrays have a row for each robot.

    Attributes:
        code: the request's code.
        robots: the robots, in ascending order.
        clock_s: the time at which each program continued.
        arguments: the integer arguments, shape (k, 8).
        results: 0 refused, else 1 or what the request counts (results in `REQUESTS`), (k,).
        states: `State` as reported, shape (k, 45), for requests answered with it; else None.
        replies: the whole replies, of dtype `requests.MESSAGE`, for requests that are `traced`;
            else None.
    """

    code: int
    robots: IndexArray
    clock_s: FloatArray
    arguments: Int32Array
    results: Int32Array
    states: Int32Array | None
    replies: Records | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Slices:
    """The slice of its motion command that each robot ran in a cycle.

    Attributes:
        axes: the names of each robot's axes.
        command: code of the command, 0 when the axes were at rest, (robots,).
        number: which slice of the command it was, from 1, (robots,).
        count: number of all its slices, 0 for a command without an end, (robots,).
        motion: motion of each axis in this cycle [m or rad], (robots, 3).
        travelled: its motion since the command, (robots, 3).
        total: the commanded motion; NaN for a command without an end, (robots, 3).
        waiting: whether the robot waits (`ws`, `crs_receive`), (robots,).
        present: whether the robot was in the world, (robots,).
    """

    axes: tuple[tuple[str, ...], ...]
    command: Int64Array
    number: Int64Array
    count: Int64Array
    motion: FloatArray
    travelled: FloatArray
    total: FloatArray
    waiting: BoolArray
    present: BoolArray


_NOTHING: Final = np.zeros((0, 3))
_NOBODY: Final = np.zeros(0, np.int64)
NO_SLICES: Final = Slices(
    axes=(),
    command=_NOBODY,
    number=_NOBODY,
    count=_NOBODY,
    motion=_NOTHING,
    travelled=_NOTHING,
    total=_NOTHING,
    waiting=_NOBODY != 0,
    present=_NOBODY != 0,
)
"""The slices of no robots."""


class Step(NamedTuple):
    """One cycle that has ended.

    Attributes:
        cycle: its number, from 0.
        time_s: its start.
        robots: robots whose wait ends in the next cycle, in ascending order.
        at_s: the time at which it ends.
        messages: the replies, of dtype `requests.MESSAGE`.
        contacts: contacts that began in the cycle.
        pressed: the switches of bumpers that are pressed at its end and were not at its beginning,
            bit by bit as in `State[33]`, (robots,).
        released: those that were and are not any more, (robots,).
        names: names of what `contacts.other` refers to: robots, objects, walls.
        slices: the motion of the axes in the cycle; `NO_SLICES` if it is not needed.
        served: the requests that were answered in the cycle, in order.
        events: the other events in it, in order.
        traffic: the log of messages, by time, of dtype `state.messages.TRAFFIC`;
            `comms.message_log.events` describes it.
        posted: the messages that were posted in the cycle, of dtype `state.messages.PACKET`.
    """

    cycle: int
    time_s: float
    robots: IndexArray
    at_s: FloatArray
    messages: Records
    contacts: Contacts
    pressed: Int32Array
    released: Int32Array
    names: tuple[str, ...]
    slices: Slices
    served: tuple[Served, ...]
    events: tuple[Event, ...]
    traffic: Records
    posted: tuple[Records, ...] = ()

    @property
    def drawings(self) -> tuple[Drawing, ...]:
        """The marks that programs drew in the cycle, in order; erasures are in `served`."""
        return tuple(
            Drawing.of(robot, mark)
            for served in self.served
            if served.code == CODES["DRAW"]
            for robot, mark, result in zip(
                served.robots.tolist(), served.arguments.tolist(), served.results, strict=True
            )
            if result
        )


@dataclass(frozen=True, slots=True)
class Answer:
    """One request that was answered.

    Attributes:
        name: the request's name in `REQUESTS`.
        clock_s: the time at which the program continued.
        arguments: its integer arguments.
        result: 0 refused, else 1 or what the request counts (results in `REQUESTS`).
        values: the result of a sensor request, in the vendor's units: `sonar_in`, `infrared` (0 to
            15), `compass` (0.1 deg), `bumper`, `pose` (0.1 in, 0.1 in, 0.1 deg), `speed` (0.1 in/s
            right, left), `motors`; and `reply`, the results of all other requests, in the order
            of `REQUESTS`.
    """

    name: str
    clock_s: float
    arguments: tuple[int, ...]
    result: int
    values: dict[str, tuple[int | float | str, ...]]


@dataclass(frozen=True, slots=True)
class AxisSlice:
    """One axis' part of a cycle: in metres, or in radians for `steering` and `turret`.

    Attributes:
        name: name of the axis: `right`, `left`, `translation`, `steering`, `turret`.
        motion: its motion in this cycle.
        travelled: its motion since the command.
        total: the commanded motion; None when it has no end.
    """

    name: str
    motion: float
    travelled: float
    total: float | None


@dataclass(frozen=True, slots=True)
class RobotSlice:
    """One robot's part of a cycle.

    Attributes:
        command: name of the motion command that ran, empty for none.
        number: which slice of it this was, from 1.
        count: number of all its slices; None when it has no end.
        axes: the motion of each axis.
        waiting: whether the robot waits (`ws`, `crs_receive`).
        answers: the requests that were answered, by ascending time.
    """

    command: str
    number: int
    count: int | None
    axes: tuple[AxisSlice, ...]
    waiting: bool
    answers: tuple[Answer, ...]


def slices_of(state: EnvState, axes: tuple[tuple[str, ...], ...], timestep_s: float) -> Slices:
    """Return the slices of a cycle, complete when the axes have been turned to its end."""
    end_s = state.drive.axes.end_s()
    end_s = np.maximum(np.maximum(end_s[:, 0], end_s[:, 1]), end_s[:, 2])
    endless = end_s > _MAX_CYCLES * timestep_s
    last = np.ceil(np.where(endless, 0.0, end_s) / timestep_s - 1e-9).astype(np.int64)
    count = np.maximum(last - state.drive.command_cycle, 1)
    number = state.cycle - state.drive.command_cycle + 1
    runs = (state.drive.command != 0) & (endless | (number <= count))
    return Slices(
        axes=axes,
        command=np.where(runs, state.drive.command, 0),
        number=number,
        count=np.where(endless, 0, count),
        motion=state.drive.slice.copy(),
        travelled=state.drive.axes.travelled.copy(),
        total=state.drive.axes.total.copy(),
        waiting=state.waits.code != 0,
        present=state.presence.present,
    )


def describe_slice(step: Step, robot: int) -> RobotSlice:
    """Return one robot's part of a cycle as plain values."""
    return slice_of(step.slices, robot, _answers(step, robot))


def slice_of(slices: Slices, robot: int, answers: tuple[Answer, ...] = ()) -> RobotSlice:
    """Return the motion of one robot's axes as plain values, with the answered requests."""
    code, count = int(slices.command[robot]), int(slices.count[robot])
    rows = (slices.motion[robot], slices.travelled[robot], slices.total[robot])
    motions = zip(*(row.tolist() for row in rows), strict=True)
    return RobotSlice(
        command=REQUESTS[code].name if code else "",
        number=int(slices.number[robot]),
        count=count or None,
        axes=tuple(
            AxisSlice(name, motion, travelled, None if math.isnan(total) else total)
            for name, (motion, travelled, total) in zip(slices.axes[robot], motions, strict=False)
        ),
        waiting=bool(slices.waiting[robot]),
        answers=answers,
    )


def _answers(step: Step, robot: int) -> tuple[Answer, ...]:
    found = []
    for served in step.served:
        row = int(np.searchsorted(served.robots, robot))
        if row == len(served.robots) or served.robots[row] != robot:
            continue
        request = REQUESTS[served.code]
        used = sum(argument.place.startswith("i[") for argument in request.arguments)
        found.append(
            Answer(
                request.name,
                float(served.clock_s[row]),
                tuple(served.arguments[row, :used].tolist()),
                int(served.results[row]),
                _values(served, row),
            )
        )
    return tuple(sorted(found, key=lambda answer: answer.clock_s))


def _values(served: Served, row: int) -> dict[str, tuple[int | float | str, ...]]:
    """Return the results of a request of one robot."""
    if served.states is not None:
        state = served.states[row].tolist()
        return {name: tuple(state[part]) for name, part in _ANSWERS.get(served.code, ())}
    if served.replies is None or not served.results[row]:
        return {}
    return {"reply": reply_values(served, row)}


def reply_values(served: Served, row: int) -> tuple[int | float | str, ...]:
    """Return the results in the reply to a traced request of one robot, in the table's order."""
    assert served.replies is not None
    message, results = served.replies[row], REQUESTS[served.code].results
    positions = [result.position for result in results]
    numbers = (message[array][place].item() for array, place in positions if place >= 0)
    content = (field for field in results if field.place == "data")
    return (*numbers, *(value for field in content for value in _data(message, field)))


def _data(message: np.void, field: Field) -> tuple[int | str, ...]:
    """Return a reply's data: numbers or text, according to the table."""
    data = message["data"][: max(int(message["size"]), 0)]
    if field.data_type == "int32":
        return tuple(data[: len(data) // 4 * 4].view("<i4").tolist())
    return (repr(data[:_TEXT].tobytes())[1:],)
