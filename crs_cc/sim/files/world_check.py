"""Checks worlds that were built in Python as if they had been read from a file.

>>> from dataclasses import replace
>>> from crs_cc.sim.files.world_xml import empty_world
>>> check_world(replace(empty_world(), timestep_s=-0.05))
Traceback (most recent call last):
crs_cc.core.errors.WorldError: empty:2: error: world, timestep: '-0.05s' must be greater than 0
    <world version="1" name="empty" timestep="-0.05s">
"""

from __future__ import annotations

from dataclasses import replace

from crs_cc.sim.files.world_writer import world_element
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.files.xml_document import document_of
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import Robot, WorldModel


def check_world(world: WorldModel) -> None:
    """Check the values of a world and their consistency.

    Raises:
        WorldError: the world is invalid; all errors are reported at once, with the lines of the
            file that it would be.
        TypeError: a value has the wrong type.
        ValueError: no file can have a value.
    """
    models = {f"{number}.xml": _model(each) for number, each in enumerate(world.robots)}
    try:
        robots = tuple(
            replace(robot, model=replace(model, definition=name, setup=""), program="")
            for robot, (name, model) in zip(world.robots, models.items(), strict=True)
        )
        text = document_of(world_element(replace(world, robots=robots)))
    except (AttributeError, TypeError) as error:
        raise TypeError(f"{world.name}: a value has the wrong type: {error}") from None
    read = parse_world(text, world.name, models=models)
    if read.area != world.area:
        raise ValueError(f"{world.name}: the area must begin at 0, 0, or be centred there")
    for own, other in zip(world.goals, read.goals, strict=True):
        if own != other:
            raise ValueError(
                f"{world.name}: goal '{own.id}' would be read with other values: {other}"
            )


def _model(robot: Robot) -> RobotModel:
    if not isinstance(robot.model, RobotModel):
        kind = type(robot.model).__name__
        raise TypeError(f"{robot.id}: model must be a RobotModel, as of load_robot, not {kind}")
    return robot.model
