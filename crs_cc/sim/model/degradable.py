"""Degradable values: those that a sensor reports, or that an actuator receives."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from crs_cc.core.quantity import SPEED, TURN_RATE, Kind

if TYPE_CHECKING:
    from crs_cc.sim.model.robot import RobotModel

TURNING: Final = frozenset({"steering", "turret"})
"""The axes that turn instead of driving."""


@dataclass(frozen=True, slots=True)
class Degradable:
    """A sensor or actuator that can be degraded.

    Attributes:
        name: its name in world files.
        title: short description.
        kind: the quantity of its values; in radians for an element that turns.
        elements: returns the names of a robot's elements by their numbers, with empty names for
            unused numbers; an empty tuple if the robot has no such device.
        width: maximum number of elements.
        nothing: what happens if a value is dropped, as a clause.
        unit: the unit in words, where the kind has none.
        acts: whether it is an actuator.
    """

    name: str
    title: str
    kind: Kind
    elements: Callable[[RobotModel], tuple[str, ...]]
    width: int
    nothing: str
    unit: str = ""
    acts: bool = False

    def kind_of(self, element: str) -> Kind:
        """Return the quantity of an element's values."""
        return TURN_RATE if self.kind is SPEED and element in TURNING else self.kind


def numbered(count: int) -> tuple[str, ...]:
    """Return the names of elements that have only numbers."""
    return tuple(map(str, range(count)))


def at_numbers(numbers: Sequence[int]) -> tuple[str, ...]:
    """Return the names of elements that have these numbers.

    >>> at_numbers([0, 2])
    ('0', '', '2')
    """
    return tuple(str(n) if n in numbers else "" for n in range(max(numbers, default=-1) + 1))


def elements_of(
    device: str, names: Callable[[Any], tuple[str, ...]]
) -> Callable[[RobotModel], tuple[str, ...]]:
    """Return the function that names a device's elements, none without the device."""

    def elements(robot: RobotModel) -> tuple[str, ...]:
        model = robot.device(device)
        return () if model is None else names(model)

    return elements
