"""A kind of change of the world, and what the tables of changes share."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from crs_cc.core.suggest import unknown
from crs_cc.sim.model.world import Robot

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment

Words = Sequence[str]


@dataclass(frozen=True, slots=True)
class Edit:
    """A kind of change.

    Attributes:
        syntax: its arguments, optional ones in brackets.
        summary: what it does, in a line.
        text: further help.
        do: makes it, given the arguments; returns a description.
    """

    syntax: str
    summary: str
    text: str
    do: Callable[[Environment, Words], str]


def find_robot(environment: Environment, name: str) -> Robot:
    """Return a robot; raise ValueError if there is none of this name."""
    robots = environment.world.robots
    for robot in robots:
        if robot.id == name:
            return robot
    raise ValueError(unknown("robot", name, [robot.id for robot in robots]))
