"""A kind of change to the world, and the common parts of the tables of changes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.core.suggest import unknown
from crs_cc.sim.model.world import Pose, Robot

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


def pose_of(words: Words, heading_rad: float = 0.0) -> Pose:
    """Return the pose that `X Y [HEADING]` describes.

    Args:
        words: two or three quantities.
        heading_rad: the heading if there are two.

    Raises:
        ValueError: some are invalid; the text has a line for each.
    """
    found, wrong = [], []
    for kind, word in zip((LENGTH, LENGTH, ANGLE), words, strict=False):
        try:
            found.append(kind.parse(word))
        except ValueError as error:
            wrong.append(str(error))
    if wrong:
        raise ValueError("\n".join(wrong))
    return Pose(found[0], found[1], found[2] if len(found) > 2 else heading_rad)


def find_robot(environment: Environment, name: str) -> Robot:
    """Return a robot; raise ValueError if there is none with this name."""
    robots = environment.world.robots
    for robot in robots:
        if robot.id == name:
            return robot
    raise ValueError(unknown("robot", name, [robot.id for robot in robots]))
