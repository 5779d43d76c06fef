"""A robot as rows: pose, odometry, command, sensors, and what its program is waiting for.

Positions are those at the start of the timestep, as everything in the environment. What the robot
has reported to its program is in `State[]`, see `state_rows`; these rows are the true state.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.units import m_to_inch
from crs_cc.debug.world.events import switches
from crs_cc.debug.world.rows import Row, angle, instant, length, pose_text
from crs_cc.requests import CODES, REQUESTS
from crs_cc.sim.devices.bumper.element import switches_of
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.sonar.model import sonars_of
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.engine.step import AxisSlice, slice_of, slices_of
from crs_cc.sim.model.degradation import described
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.state.messages import ARRIVED

if TYPE_CHECKING:
    from crs_cc.session.result import RobotResult
    from crs_cc.session.session import Session
    from crs_cc.sim.engine.environment import Environment

_TURNING: Final = frozenset({"steering", "turret"})

HEADINGS: Final = ("robot", "name", "program", "activity", "clock", "x", "y", "heading")
"""The columns of `summary`."""


def summary(session: Session, robot: int) -> tuple[str, ...]:
    """Return a robot in one row of a table, whose columns are `HEADINGS`."""
    result = session.state.robot_result(robot)
    x_m, y_m, heading_rad = result.pose
    place = (length(x_m), length(y_m), angle(heading_rad % math.tau))
    if not session.environment.state.presence.present[robot]:
        place = ("-", "-", "-")
    clock = instant(_clock_s(session, robot, result))
    return (str(robot), result.id, result.program, activity(session, robot), clock, *place)


def robot_rows(session: Session, robot: int) -> list[Row]:
    """Return the rows of a robot."""
    environment, result = session.environment, session.state.robot_result(robot)
    model = environment.world.robots[robot].model
    rows = [
        Row("robot", f"{result.id}, number {robot}, a {model.name}"),
        Row("program", f"{result.program}: {activity(session, robot, 'the robot ')}"),
        Row("clock", f"{instant(_clock_s(session, robot, result))}, {result.fuel:,} instructions"),
    ]
    if not environment.state.presence.present[robot]:
        return rows
    rows += [
        Row("connected", "yes" if environment.state.connected[robot] else "no"),
        Row("pose", pose_text(*result.pose)),
        _odometry(environment, robot, result),
        _command(environment, robot),
        Row("driven", f"{length(result.distance_m)}, {_counted(result.collisions, 'collision')}"),
        *_touches(environment, robot),
        *_bumpers(environment, robot, model),
        *_sonars(environment, robot),
        *_devices(environment, robot, model),
        *_degradations(environment, robot, model),
    ]
    return rows


def activity(session: Session, robot: int, mover: str = "") -> str:
    """Return the activity of a robot's program, or its outcome.

    Args:
        session: the session.
        robot: the robot.
        mover: what is said before how the robot moves, such as `the robot `.
    """
    result = session.state.robot_result(robot)
    if result.outcome == "exited":
        return f"exited with {result.exit_status}"
    if result.outcome == "failed":
        return "stopped by an error"
    if result.outcome != "running":
        return "left the world" if result.outcome == "left" else "has not joined"
    what = _pause(session, robot)
    return f"{mover}{_motion(session.environment, robot)} while {what}" if what else "runs"


def _pause(session: Session, robot: int) -> str:
    """Return what a running program waits for; empty if its processor runs."""
    on_link = session.state.request_on_link(robot)
    if on_link is not None:
        code, due_s = on_link
        return f"{_function(code)} waits for the link until {instant(due_s)}"
    clock_s = float(session.state.clock_s[robot])
    if math.isfinite(clock_s) and clock_s > session.time_s + session.environment.timestep_s:
        return f"its program sleeps until {instant(clock_s)}"
    return _waits(session.environment, robot)


def _motion(environment: Environment, robot: int) -> str:
    """Return the current motion of a robot's motors."""
    if not environment.state.presence.present[robot]:
        return "is absent"
    wheels = environment.state.drive.axes.speed[robot, :2]
    if not wheels.any():
        return "stands"
    is_turn = environment.world.robots[robot].model.drive.steering is None and not wheels.sum()
    return "turns" if is_turn else "drives"


def _clock_s(session: Session, robot: int, result: RobotResult) -> float:
    """Return a program's clock; that of a waiting program is the current time."""
    if result.outcome != "running":
        return result.time_s
    clock_s = session.now_s(robot)
    return clock_s if math.isfinite(clock_s) else session.time_s


def _waits(environment: Environment, robot: int) -> str:
    """Return what a robot waits for; empty for nothing."""
    waits = environment.state.waits
    code = int(waits.code[robot])
    if not code:
        return ""
    name, what = _function(code), "the axes to stop"
    if code == CODES["RECEIVE"]:
        what = "a message"
    else:
        axes = environment.world.robots[robot].model.drive.axis_names
        chosen = [axis for axis, on in zip(axes, waits.axes[robot], strict=False) if on]
        if chosen:
            what = f"{' and '.join(chosen)} to stop"
    until_s = float(waits.until_s[robot])
    most = f", at most until {instant(until_s)}" if math.isfinite(until_s) else ""
    return f"{name} waits for {what}{most}"


def _function(code: int) -> str:
    """Return the C function that posts a request, or the request's name."""
    if code not in REQUESTS:
        return f"request {code}"
    return REQUESTS[code].prototype.partition("(")[0].split()[-1].lstrip("*")


def _odometry(environment: Environment, robot: int, result: RobotResult) -> Row:
    """Return the odometry, and the turret's direction if there is one."""
    odometry = environment.state.odometry
    turret: tuple[Row, ...] = ()
    if environment.world.robots[robot].model.drive.turret is not None:
        turret = (Row("turret", angle(float(odometry.turret_rad[robot]) % math.tau)),)
    return Row("odometry", pose_text(*result.odometry), turret)


def _command(environment: Environment, robot: int) -> Row:
    """Return the current motion command, its slice, and the state of the axes."""
    state = environment.state
    axes = tuple(each.model.drive.axis_names for each in environment.world.robots)
    now = slice_of(slices_of(state, axes, environment.timestep_s), robot)
    speeds = state.drive.axes.speed[robot].tolist()
    was_told = bool(state.drive.command[robot])
    children = tuple(
        _axis(axis, speed, was_told=was_told, is_limp=bool(limp))
        for axis, speed, limp in zip(now.axes, speeds, state.drive.limp[robot], strict=False)
    )
    if not now.command:
        return Row("command", "none runs", children)
    count = ", unlimited" if now.count is None else f" of {now.count}"
    return Row("command", f"{now.command.lower()}, timestep {now.number}{count}", children)


def _counted(number: int, noun: str) -> str:
    """Return a number with its noun.

    >>> _counted(1, "collision"), _counted(2, "collision")
    ('1 collision', '2 collisions')
    """
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _axis(axis: AxisSlice, speed: float, *, was_told: bool, is_limp: bool) -> Row:
    show = angle if axis.name in _TURNING else length
    text = f"{show(speed)}/s"
    if was_told:
        text += f", {show(axis.travelled)} since the command"
    if was_told and axis.total is not None:
        text += f" of {show(axis.total)}"
    return Row(axis.name, text + (", limp" if is_limp else ""))


def _touches(environment: Environment, robot: int) -> Iterator[Row]:
    """Return the contacts of the robot in the previous timestep."""
    robots, objects = np.divmod(environment.state.contacts_before, len(environment.names))
    touched = [environment.names[obj] for obj in objects[robots == robot].tolist()]
    yield Row("touches", ", ".join(touched) or "nothing")


def _bumpers(environment: Environment, robot: int, model: RobotModel) -> Iterator[Row]:
    if switches_of(model):
        pressed = switches(int(bumper_state(environment.state).pressed[robot]), model)
        yield Row("bumpers", ", ".join(pressed) or "none pressed")


def _sonars(environment: Environment, robot: int) -> Iterator[Row]:
    """Return the last echo of each sonar, and which was the nearest."""
    sonar = sonar_state(environment.state)
    model = environment.world.robots[robot].model
    sonars = sonars_of(model).modes[int(sonar.mode[robot])].sonars
    if not sonars:
        return
    echo_m = sonar.echo_m[robot]
    nearest = min(sonars, key=lambda each: float(echo_m[each.id]))
    children = tuple(
        Row(f"{each.id} at {angle(each.direction_rad)}", _echo(float(echo_m[each.id])))
        for each in sonars
    )
    text = "no echo"
    if math.isfinite(echo_m[nearest.id]):
        text = f"nearest {_echo(float(echo_m[nearest.id]))}, sonar {nearest.id}"
    yield Row("sonar", text, children)


def _echo(echo_m: float) -> str:
    if not math.isfinite(echo_m):
        return "no echo"
    return f"{length(echo_m)} ({m_to_inch(echo_m):.1f} in)"


def _devices(environment: Environment, robot: int, model: RobotModel) -> Iterator[Row]:
    """Return the rows of only some robots: batteries, heat, grippers, messages."""
    state = environment.state
    batteries = ("computer_battery", "motor_battery")
    for name, charge in zip(batteries, environment.charges(robot), strict=True):
        if model.device(name) is not None:
            yield Row(name.replace("_", " "), f"{100 * charge:.1f}%")
    for title, text in environment.device_rows(robot):
        yield Row(title, text)
    if state.heat.left[robot]:
        yield Row("heat", f"{state.heat.left[robot]:g}")
    numbers = state.bodies.holds.object[robot]
    held = [environment.pushables[number] for number in numbers if number >= 0]
    if held:
        yield Row("holds", ", ".join(held))
    inbox = state.messages.receptions
    waiting = int(((inbox["receiver"] == robot) & (inbox["status"] == ARRIVED)).sum())
    if state.messages.sent[robot] or waiting:
        yield Row("messages", f"{state.messages.sent[robot]} sent, {waiting} in the inbox")


def _degradations(environment: Environment, robot: int, model: RobotModel) -> Iterator[Row]:
    name, control = environment.world.robots[robot].id, environment.degradations
    found = tuple(
        Row(each.id, f"{described(each, model)} ({control.phase(each.id)})")
        for each in control.all()
        if each.robot == name
    )
    if found:
        acting = sum(control.phase(row.name) == "acts" for row in found)
        yield Row("degradations", f"{acting} of {len(found)} active", found)
