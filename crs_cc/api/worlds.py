"""Worlds from files, from text, and built in Python.

>>> world = load_world("<world version='1'><area length='6m' width='5m'/>"
...                    "<robot x='1m' y='1m'/></world>")
>>> world.robots[0].id, world.area.length_m
('robot0', 6.0)
"""

from __future__ import annotations

import os
from collections import deque
from dataclasses import replace
from pathlib import Path
from typing import Final

from crs_cc.core.suggest import unknown
from crs_cc.sim.files import world_xml as files
from crs_cc.sim.files.known_robots import ROBOTS, SCOUT, known_robots
from crs_cc.sim.files.robot_writer import robot_text
from crs_cc.sim.files.world_check import check_world
from crs_cc.sim.files.world_writer import world_text
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import WorldModel

WorldSource = str | os.PathLike[str] | bytes


def load_world(
    source: WorldSource | None = None,
    *,
    setup: str = "",
    robot: str = SCOUT,
    folder: str | os.PathLike[str] | None = None,
    seed: int | None = None,
) -> WorldModel:
    """Return a world.

    Args:
        source: the path of a world file, or XML text, which contains `<`; None for the built-in
            world, one robot in a large empty area.
        setup: the setup of all robots, such as `noisy`; by default that of the file.
        robot: the default kind of robot: a built-in name, or the path of a definition file.
        folder: the folder of the files to which a text refers; by default it may not refer to any.
        seed: the random seed of what is scattered; by default that of the file.

    Raises:
        WorldError: the world cannot be read or is invalid; all errors are reported at once.
    """
    if source is None:
        return _checked(files.empty_world(setup, robot))
    if not isinstance(source, str | bytes | os.PathLike):
        kind = type(source).__name__
        raise TypeError(f"a world must be a path, XML text or a WorldModel, not {kind}")
    if isinstance(source, str) and "<" in source:
        source = source.encode()
    if isinstance(source, bytes):
        where = None if folder is None else Path(folder)
        return _checked(files.parse_world(source, "world", setup, robot, where, seed=seed))
    return _checked(files.load_world(Path(source), setup, robot, seed=seed))


def world_of(world: WorldModel | WorldSource | None) -> WorldModel:
    """Return a valid world: one that is given, or what `load_world` loads.

    Raises:
        WorldError: it is invalid; all errors are reported at once.
        TypeError: a value has the wrong type.
        ValueError: no file can have a value.
    """
    if not isinstance(world, WorldModel):
        return load_world(world)
    if not any(each is world for each in _CHECKED):
        check_world(world)
    return _checked(world)


_CHECKED: Final[deque[WorldModel]] = deque(maxlen=8)
"""The last worlds that were found to be valid: episodes of an environment all have the same one."""


def _checked(world: WorldModel) -> WorldModel:
    _CHECKED.append(world)
    return world


def load_robot(name: str | os.PathLike[str], *, setup: str = "") -> RobotModel:
    """Return a robot model.

    Args:
        name: the name of a built-in definition, such as `scout`, or the path of a file.
        setup: one of its setups, such as `noisy`; by default, and for `ideal`, none.

    Raises:
        ValueError: the name is neither.
        WorldError: the file cannot be read or is invalid; all errors are reported at once.
    """
    if name in known_robots():
        return files.load_robot(ROBOTS / f"{name}.xml", setup)
    if not Path(name).suffix:
        text = unknown("robot", str(name), known_robots())
        raise ValueError(f"{text}, and the name of a definition file ends with .xml")
    return files.load_robot(Path(name), setup)


def world_xml(world: WorldModel, folder: str | os.PathLike[str] | None = None) -> str:
    """Return a world as the text of a world file, which `load_world` reads with equal values.

    Args:
        world: the world.
        folder: the folder where the file will be: programs and robot definitions must be there
            or below. None for a text without files of its own.

    Raises:
        ValueError: something in the world cannot be written.
        WorldError: the world is invalid; all errors are reported at once.
    """
    check_world(world)
    return world_text(world, None if folder is None else Path(folder)).decode()


def write_world(world: WorldModel, path: str | os.PathLike[str]) -> None:
    """Write a world to a file, see `world_xml`.

    Raises:
        ValueError: something in the world cannot be written.
        WorldError: the world is invalid; all errors are reported at once.
        OSError: the file cannot be written.
    """
    text = world_xml(world, Path(path).parent)
    Path(path).write_text(text, encoding="utf-8")


def robot_xml(model: RobotModel) -> str:
    """Return a robot model as the text of a definition file, which is read with equal values.

    Raises:
        ValueError: something in the model cannot be written.
        WorldError: the model is invalid; all errors are reported at once.
    """
    return robot_text(model).decode()


def write_robot(model: RobotModel, path: str | os.PathLike[str]) -> RobotModel:
    """Write a robot model to a definition file, without setups.

    Returns:
        the model, with that file as its definition: worlds with such robots can be written.

    Raises:
        ValueError: something in the model cannot be written.
        WorldError: the model is invalid; all errors are reported at once.
        OSError: the file cannot be written.
    """
    Path(path).write_text(robot_xml(model), encoding="utf-8")
    return replace(model, definition=str(Path(path)), setup="")
