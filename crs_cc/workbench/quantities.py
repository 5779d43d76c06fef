"""Quantities of a robot itself that pages plot by name, with their units."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.sim.model.degradation import degradables
from crs_cc.sim.model.registry import devices

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment

CLEARANCE: Final = "clearance"
"""The distance from a robot's outline to the nearest object, see `clearances`."""

APART: Final = "apart from "
"""Before the name of another run: how far the robot is from where it is in that run."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity of a robot.

    Attributes:
        unit: its unit.
        of: returns its value now, given the environment and the robot's number.
    """

    unit: str
    of: Callable[[Environment, int], float]


def speeds(environment: Environment, robot: int) -> tuple[float, float]:
    """Return the speed [m/s] and the turn rate [rad/s] at which a robot's motors drive it."""
    model = environment.world.robots[robot].model
    axes = environment.last_state.drive.axes.speed[robot]
    right, left = float(axes[0]), float(axes[1])
    if model.drive.steering is not None:
        return right, left
    return (right + left) / 2, (right - left) / (model.drive.wheel_base_m or 1.0)


QUANTITIES: Final = {
    "speed": Quantity("m/s", lambda environment, robot: speeds(environment, robot)[0]),
    "turn": Quantity(
        "°/s", lambda environment, robot: math.degrees(speeds(environment, robot)[1])
    ),
    "battery": Quantity("%", lambda environment, robot: 100.0 * min(environment.charges(robot))),
    "pose.x": Quantity("m", lambda environment, robot: float(environment.last_state.x_m[robot])),
    "pose.y": Quantity("m", lambda environment, robot: float(environment.last_state.y_m[robot])),
    "pose.heading": Quantity(
        "°",
        lambda environment, robot: math.degrees(environment.last_state.heading_rad[robot])
        % 360.0,
    ),
}  # fmt: skip
"""Quantities by name; besides them there are readings such as `sonar.3`, and `CLEARANCE`."""


def reading_of(expression: str) -> tuple[str, int] | None:
    """Return device and element of a reading; None for another expression.

    >>> reading_of("sonar.3"), reading_of("pose.x"), reading_of("array.length")
    (('sonar', 3), None, None)
    """
    name, _, element = expression.partition(".")
    is_one = element.isdecimal() and len(element) < 5 and name in {each.name for each in devices()}
    return (name, int(element)) if is_one else None


def unit_of(environment: Environment, robot: int, expression: str) -> str:
    """Return the unit of an expression; empty where it is not known, as for C variables."""
    if expression == CLEARANCE or expression.startswith(APART):
        return "m"
    if expression in QUANTITIES:
        return QUANTITIES[expression].unit
    reading = reading_of(expression)
    return "" if reading is None else reading_unit(environment, robot, *reading)


def reading_unit(environment: Environment, robot: int, device: str, element: int = 0) -> str:
    """Return the unit of an element of a robot's device; empty if it has none."""
    degradable = degradables().get(device)
    if degradable is None:
        return ""
    names = degradable.elements(environment.world.robots[robot].model)
    name = names[element] if element < len(names) else ""
    unit = degradable.kind_of(name).default
    return "" if unit == "-" else unit
