"""Changes that drive a robot by its own motors, or hold it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.quantity import SPEED, TURN_RATE
from crs_cc.debug.world.edit import Edit, Words, find_robot
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.model.degradation import Degradation

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment
    from crs_cc.sim.model.robot import RobotModel

_DRIVE: Final = "ROBOT SPEED [TURN]"


def _drive(environment: Environment, words: Words) -> str:
    if len(words) not in (2, 3):
        raise ValueError(f"expected: drive {_DRIVE}")
    robot = find_robot(environment, words[0])
    number = environment.world.robots.index(robot)
    speed_mps = SPEED.parse(words[1])
    turn_radps = TURN_RATE.parse(words[2]) if len(words) == 3 else 0.0
    if not environment.present[number]:
        raise ValueError(f"{robot.id} is not in the world")
    speed = np.zeros((1, AXES))
    speed[0, :2] = _axes(robot.model, speed_mps, turn_radps)
    environment.drive(np.array([number]), speed)
    turn = f", {TURN_RATE.show(turn_radps)}" if turn_radps else ""
    return f"{robot.id} now drives at {SPEED.show(speed_mps)}{turn}"


def _axes(model: RobotModel, speed_mps: float, turn_radps: float) -> tuple[float, float]:
    """Return the speeds of the first two axes: right and left, or translation and steering."""
    if model.drive.steering is not None:
        return speed_mps, turn_radps
    difference_mps = turn_radps * (model.drive.wheel_base_m or 0.0) / 2
    return speed_mps + difference_mps, speed_mps - difference_mps


def _hold(environment: Environment, words: Words) -> str:
    robot = _only_robot(environment, words, "hold")
    environment.degradations.add(Degradation(robot, "drive", dead=True, id=f"hold-{robot}"))
    return f"{robot} is held"


def _release(environment: Environment, words: Words) -> str:
    robot = _only_robot(environment, words, "release")
    if f"hold-{robot}" not in {each.id for each in environment.degradations.all()}:
        raise ValueError(f"{robot} is not held")
    environment.degradations.remove(f"hold-{robot}")
    return f"{robot} is released"


def _only_robot(environment: Environment, words: Words, name: str) -> str:
    if len(words) != 1:
        raise ValueError(f"expected: {name} ROBOT")
    return find_robot(environment, words[0]).id


STEERING: Final = {
    "drive": Edit(
        _DRIVE,
        "Set the speed of a robot's motors: drive robot0 0.3 45.",
        "Like vm in its program: SPEED is in m/s, TURN in degrees per second, counter-clockwise."
        " The next command of its program replaces it.",
        _drive,
    ),
    "hold": Edit(
        "ROBOT",
        "Keep a robot's motors from turning, whatever its program does.",
        "It is a degradation of its drive, named hold-ROBOT.",
        _hold,
    ),
    "release": Edit("ROBOT", "Release a robot that is held.", "", _release),
}
"""Changes by name."""
