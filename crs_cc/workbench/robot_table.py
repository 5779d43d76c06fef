"""The table of the robots: the activity of each, and its last sensor readings."""

from __future__ import annotations

import math
from pathlib import PurePath
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.arrays import BoolArray
from crs_cc.debug.world.robot_rows import activity
from crs_cc.ir.names import in_library, plain_name
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.sonar.model import sonars_of
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.model.degradation import described
from crs_cc.sim.state.degradation import ACTS, FADES, degradation_of
from crs_cc.workbench.devices_in_view import devices_in_view
from crs_cc.workbench.feed import rounded
from crs_cc.workbench.quantities import speeds

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.debug.timeline.recorded_run import RecordedRun
    from crs_cc.session.session import Session
    from crs_cc.sim.engine.environment import Environment

MAX_ROBOTS: Final = 200
"""Rows that are sent; of more robots those around the selected one. Chosen by us."""

MAX_PLAYING: Final = 24
"""Limit of the robots whose lines are looked up during the run, a fraction of a ms each."""


def status(
    session: Session, run: RecordedRun | None, selected: int, *, is_playing: bool
) -> dict[str, Any]:
    """Return the rows of the table around the selected robot.

    Args:
        session: the run.
        run: the run in the debugger; None if the programs' positions are unknown.
        selected: the robot.
        is_playing: whether it is running, so that time is short.
    """
    count = len(session.fleet)
    first = max(0, min(selected - MAX_ROBOTS // 2, count - MAX_ROBOTS))
    rows = range(first, min(first + MAX_ROBOTS, count))
    shown = MAX_PLAYING if is_playing else MAX_ROBOTS
    return {
        "t": session.time_s,
        "first": first,
        "robots": [
            _row(session, each) | (_place(run, each) if run and each - first < shown else {})
            for each in rows
        ],
        "sensors": _sensors(session, rows),
        "devices": devices_in_view(session.environment, rows, selected),
    }


def row(session: Session, run: RecordedRun, robot: int) -> dict[str, Any]:
    """Return the row of a robot, with the current line of its program."""
    return _row(session, robot) | _place(run, robot)


def _row(session: Session, robot: int) -> dict[str, Any]:
    environment = session.environment
    state, model = environment.state, environment.world.robots[robot].model
    speed_mps, turn_radps = speeds(environment, robot)
    x_m, y_m, heading_rad = (round(each, 4) for each in session.state.robot_result(robot).pose)
    charge = [
        value
        for name, value in zip(
            ("computer_battery", "motor_battery"), environment.charges(robot), strict=True
        )
        if model.device(name) is not None
    ]
    result = session.state.robot_result(robot)
    return {
        "id": result.id,
        "kind": model.name,
        "program": PurePath(result.program).name,
        "does": activity(session, robot),
        "outcome": result.outcome,
        "pose": [x_m, y_m, heading_rad],
        "speed": round(speed_mps, 4),
        "turn": round(turn_radps, 4),
        "battery": round(min(charge), 4) if charge else None,
        "present": bool(state.presence.present[robot]),
        "collisions": int(state.collisions[robot]),
        "bumper": int(bumper_state(state).pressed[robot]),
        "fails": _fails(environment, robot),
    }


def _fails(environment: Environment, robot: int) -> list[str]:
    """Return the degradations that act on a robot, in words."""
    table = environment.last_state.degradation.table
    if not len(table):
        return []
    mine: BoolArray = table["robot"] == robot
    acting = mine & np.isin(table["phase"], (ACTS, FADES))
    model = environment.world.robots[robot].model
    return [described(degradation_of(each, ""), model) for each in table[acting]]


def _place(run: RecordedRun, robot: int) -> dict[str, Any]:
    """Return the current line of a program in the user's own code."""
    if not run.session.state.alive[robot] and not run.has_failed(robot):
        return {}
    site = run.site(robot)
    if site is not None and not in_library(site.location):
        place, name = site.location, site.function
    else:
        own = (each for each in run.stopped(robot).stack if not in_library(each.location))
        frame = next(own, None)
        if frame is None:
            return {}
        place, name = frame.location, frame.function
    return {"file": PurePath(place.file).name, "line": place.line, "function": plain_name(name)}


def _sensors(session: Session, rows: Sequence[int]) -> dict[str, Any]:
    """Return the last echoes [m], the pressed bumpers, and the poses that odometry believes."""
    environment = session.environment
    state, robots = environment.state, environment.world.robots
    chosen = np.array(rows, np.intp)
    starts = [robots[each].start for each in rows]
    start = np.array([[each.x_m, each.y_m, each.heading_rad] for each in starts]).reshape(-1, 3)
    odometry = state.odometry
    x_m, y_m = odometry.x_m[chosen], odometry.y_m[chosen]
    cos, sin = np.cos(start[:, 2]), np.sin(start[:, 2])
    believed = np.column_stack(
        [
            start[:, 0] + x_m * cos - y_m * sin,
            start[:, 1] + x_m * sin + y_m * cos,
            start[:, 2] + odometry.heading_rad[chosen],
        ]
    )
    has_sonars = any(sonars_of(robots[each].model).sonars for each in rows)
    echoes = sonar_state(state).echo_m[chosen]
    fired = sonar_state(state).fired_s[chosen]
    return {
        "believed": rounded(believed, 3),
        "echoes": _echoes(echoes, fired) if has_sonars else [],
        "bumpers": bumper_state(state).pressed[chosen].tolist(),
    }


def _echoes(echo_m: Any, fired_s: Any) -> list[list[float | None]]:
    """Return each robot's echoes [m]: null before the first ping, -1 without an echo."""
    return [
        [
            None if not fired else round(echo, 3) if math.isfinite(echo) else -1.0
            for echo, fired in zip(row, when, strict=True)
        ]
        for row, when in zip(echo_m.tolist(), fired_s.tolist(), strict=True)
    ]
