"""What a robot's instruments show: `State[]`, readings, and any expression, now or over time.

An expression is one of the robot's program, in C, or a quantity of the robot itself: one of
`quantities`, or a reading by device and element, `sonar.3`.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.state_rows import vendor_state_rows
from crs_cc.sim.model.degradation import degradables
from crs_cc.sim.model.registry import devices
from crs_cc.workbench.clearances import Clearances, closest
from crs_cc.workbench.comparing import distance_to_run
from crs_cc.workbench.quantities import (
    APART,
    CLEARANCE,
    QUANTITIES,
    reading_of,
    reading_unit,
    unit_of,
)
from crs_cc.workbench.robot_table import row
from crs_cc.workbench.trace import thinned

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.debug.engine import Debugger
    from crs_cc.sim.engine.environment import Environment
    from crs_cc.workbench.context import Context
    from crs_cc.workbench.trace import Samples

MAX_EXPRESSIONS: Final = 40
MAX_SAMPLES: Final = 2000
MAX_ROWS: Final = 100
MAX_ELEMENTS: Final = 32
"""Of a reading that is shown; a laser has more."""

_MAX_TEXT: Final = 120  # characters of a value

_LATEST_S: Final = 1.0  # frames are more frequent while anything moves

NO_ECHO: Final = "no echo"
NOT_ASKED: Final = "values of programs are available only in runs of crs view"

Value = float | str
"""A number, or the reason why it is missing."""


def rows(screen: Context, robots: str) -> dict[str, Any]:
    """Return the rows of the table of robots, by their numbers with commas between."""
    if not screen.run.is_inspectable:  # a recording: its status has what is known
        return {"t": screen.run.time_s, "robots": []}
    debugger = screen.run.debugger()
    count = len(debugger.names)
    wanted = [int(each) for each in robots.split(",") if each.isdecimal() and len(each) < 8]
    chosen = [each for each in wanted[:MAX_ROWS] if each < count]
    found = [row(debugger.session, debugger.run, each) | {"number": each} for each in chosen]
    return {"t": screen.run.time_s, "robots": found}


def inspect(screen: Context, robot: int, expressions: str) -> dict[str, Any]:
    """Return `State[]`, the readings and the values of expressions of a robot, as they are now.

    Of runs that are not debugged, programs are not asked: there is no `State[]`.
    """
    run, wanted = screen.run, _listed(expressions)
    debugger = _debugger(screen, robot) if run.is_inspectable else None
    if debugger is None and "debug" in run.can:
        raise DebugError("the programs are not at the displayed time")
    environment = run.session().environment
    if not 0 <= robot < len(environment.world.robots):
        raise DebugError(f"no robot {robot}")
    seen: list[tuple[Value, str | None]] = []
    for each in wanted:
        known = _recorded_value(screen, robot, each)
        seen.append(value(environment, debugger, robot, each) if known is None else (known, None))
    return {
        "t": run.time_s,
        "robot": robot,
        "state": [] if debugger is None else _state(debugger, robot),
        "sensors": readings(environment, robot),
        "values": [number for number, _ in seen],
        "texts": [text for _, text in seen],
        "units": [unit_of(environment, robot, each) for each in wanted],
    }


def _state(debugger: Debugger, robot: int) -> list[list[str]]:
    try:
        return [[each.name, each.text] for each in vendor_state_rows(debugger.view, robot)]
    except DebugError:  # before the program has any
        return []


def history(
    screen: Context, *, robot: int, expressions: str, begin_s: float, end_s: float, count: int
) -> dict[str, Any]:
    """Return the known values of a robot's expressions over time; null for those of its program."""
    if not 1 <= count <= MAX_SAMPLES:
        raise DebugError(f"at most {MAX_SAMPLES} times")
    found: list[Samples | None] = []
    for each in _listed(expressions):
        if each.startswith(APART):
            found.append(
                _distance_to_run(screen, robot, each, begin_s=begin_s, end_s=end_s, most=count)
            )
        elif each == CLEARANCE:
            clearance = Clearances(screen.run.world, screen.feed, begin_s, end_s).of(robot)
            found.append(thinned(clearance.times_s.tolist(), clearance.gap_m, count))
        else:
            found.append(screen.feed.trace.samples(robot, each, begin_s, end_s, count))
    return {"t": screen.run.time_s, "end": screen.feed.end_s, "series": found}


def _distance_to_run(screen: Context, robot: int, expression: str, **span: Any) -> Samples:
    """Return the distance between the positions of a robot in two runs; empty if one is closed."""
    try:
        return distance_to_run(screen, robot, expression.removeprefix(APART), **span)
    except DebugError:
        return [], []


def _recorded_value(screen: Context, robot: int, expression: str) -> Value | None:
    """Return the latest value of a quantity in frames; None for another expression."""
    now_s = screen.run.time_s
    if expression == CLEARANCE:
        found = Clearances(screen.run.world, screen.feed, now_s - _LATEST_S, now_s).of(robot).gap_m
        known = found[~np.isnan(found)]
        return float(known[-1]) if len(known) else "not known"
    if not expression.startswith(APART):
        return None
    span = {"begin_s": now_s - _LATEST_S, "end_s": now_s, "most": MAX_SAMPLES}
    _, distances_m = _distance_to_run(screen, robot, expression, **span)
    return distances_m[-1] if distances_m and distances_m[-1] is not None else "not known"


def close_approaches(screen: Context, robot: int) -> dict[str, Any]:
    """Return the close approaches in the known part of the run; those of a robot first."""
    if not 0 <= robot < len(screen.run.world.robots):
        return {"approaches": [], "robots": 0}
    return closest(screen.run.world, screen.feed, robot)


def value(
    environment: Environment, debugger: Debugger | None, robot: int, expression: str
) -> tuple[Value, str | None]:
    """Return the value of an expression, or why it has none.

    The text is that of a value of the program; None for all else.
    """
    found = _robot_quantity(environment, robot, expression)
    if found is not None:
        return found, None
    if debugger is None:
        return NOT_ASKED, None
    try:
        seen = debugger.view.evaluate_pure(expression, robot=robot)
    except DebugError as error:
        return str(error), None
    number, text = seen.number, seen.text[:_MAX_TEXT]
    if number is None:
        return f"'{expression}' is not a number", text
    return float(number) if math.isfinite(number) else "not finite", text


def _robot_quantity(environment: Environment, robot: int, expression: str) -> Value | None:
    """Return a quantity of the robot itself; None for an expression of its program."""
    if expression in QUANTITIES:
        return QUANTITIES[expression].of(environment, robot)
    reading = reading_of(expression)
    if reading is None:
        return None
    name, element = reading
    numbers = environment.reading(name, robot)
    if numbers is None or numbers.dtype.names or element >= numbers.size:
        return f"the robot has no {expression}"
    number = float(numbers.ravel()[element])
    return number if math.isfinite(number) else NO_ECHO


def readings(environment: Environment, robot: int) -> dict[str, Any]:
    """Return the last readings of a robot's devices, with their units."""
    found: dict[str, Any] = {}
    for device in devices():
        numbers = environment.reading(device.name, robot)
        if numbers is None or numbers.dtype.names or not 0 < numbers.size <= MAX_ELEMENTS:
            continue
        degradable = degradables().get(device.name)
        flat = numbers.ravel().astype(float).tolist()
        names: Sequence[str] = [str(each) for each in range(len(flat))]
        if degradable is not None:
            names = degradable.elements(environment.world.robots[robot].model) or names
        found[device.name] = {
            "unit": reading_unit(environment, robot, device.name),
            "elements": [
                [element, name, round(number, 5) if math.isfinite(number) else None]
                for element, (name, number) in enumerate(zip(names, flat, strict=False))
                if name
            ],
        }
    return found


def _debugger(screen: Context, robot: int) -> Debugger:
    debugger = screen.run.shell().debugger
    if not 0 <= robot < len(debugger.names):
        raise DebugError(f"no robot {robot}")
    return debugger


def _listed(expressions: str) -> Sequence[str]:
    wanted = [each.strip() for each in expressions.splitlines() if each.strip()]
    if len(wanted) > MAX_EXPRESSIONS:
        raise DebugError(f"at most {MAX_EXPRESSIONS} expressions")
    return wanted
