"""World and robot files.

The schemas `world.xsd` and `robot.xsd` define their form (`xml_document`); rules that a schema
cannot express are checked afterwards.

>>> world = parse_world(b'''<world version="1" timestep="50ms">
...   <area length="6m" width="5m"/>
...   <robot x="1m" y="1m" heading="90deg"/>
... </world>''', "room")
>>> world.robots[0].model.name, len(world.robots[0].model.device("sonar").sonars)
('scout', 16)
>>> parse_world(b"<world version='1'><area length='6m'/></world>", "room")
Traceback (most recent call last):
crs_cc.core.errors.WorldError: room:1: error: missing attribute 'width' in <area>
    <world version='1'><area length='6m'/></world>
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path, PurePosixPath
from typing import Final, TypeAlias

from crs_cc.core.errors import WorldError
from crs_cc.core.source import Diagnostic, Diagnostics, Location
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.composite_elements import CompositeElements
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.files.include import Included
from crs_cc.sim.files.known_robots import ROBOTS, SCOUT, known_robots
from crs_cc.sim.files.material_elements import Materials
from crs_cc.sim.files.nearby import read_below
from crs_cc.sim.files.robot_elements import robot_model
from crs_cc.sim.files.solid_elements import SolidElements
from crs_cc.sim.files.world_elements import world_model
from crs_cc.sim.files.xml_document import (
    MAX_BYTES,
    elements,
    lines_of,
    outermost,
    raise_errors,
    read_file,
)
from crs_cc.sim.model.robot import Drive, RobotModel
from crs_cc.sim.model.world import WorldModel

_STAND_IN: Final = RobotModel("unknown", 0.001, Drive(1.0))
_EMPTY_WORLD: Final = b"""<world version="1" name="empty">
  <area length="1000m" width="1000m" origin="centre" edge="0"/>
  <robot x="0" y="0"/>
</world>"""


def load_world(
    path: Path,
    setup: str = "",
    robot: str = SCOUT,
    text: bytes | None = None,
    seed: int | None = None,
) -> WorldModel:
    """Return the world that a file describes.

    Args:
        path: the file.
        setup: the setup of all robots, such as `noisy`; by default that of the file.
        robot: the default kind of robot: a built-in name, or the path of a definition file.
        text: the content instead of the file's own, such as after changes.
        seed: the random seed of what is scattered; by default that of the file.

    Raises:
        WorldError: the file cannot be read or is invalid; all errors are reported at once.
    """
    return _World(path.stem, str(path), path.parent, setup, robot, seed).parse(
        read_file(path) if text is None else text
    )


def parse_world(
    text: bytes,
    name: str,
    setup: str = "",
    robot: str = SCOUT,
    folder: Path | None = None,
    *,
    models: Mapping[str, RobotModel] | None = None,
    seed: int | None = None,
) -> WorldModel:
    """Return the world that a text describes.

    Args:
        text: the text.
        name: its file name in messages.
        setup: the setup of all robots, see `load_world`.
        robot: the default kind of robot.
        folder: the folder of definitions, images and programs; None if it may not use any.
        models: robot models by the names of their definitions, for which no file is read.
        seed: the random seed of what is scattered; by default that of the text.

    Raises:
        WorldError: the text is invalid; all errors are reported at once.
    """
    world = _World(name, name, folder, setup, robot, seed)
    world.found.update({(each, setup): model for each, model in (models or {}).items()})
    return world.parse(text)


def empty_world(setup: str = "", robot: str = SCOUT) -> WorldModel:
    """Return the built-in world: one robot at the origin of a large empty area."""
    return parse_world(_EMPTY_WORLD, "empty", setup, robot)


def load_robot(path: Path, setup: str = "") -> RobotModel:
    """Return the robot model that a definition file describes.

    Args:
        path: the file.
        setup: one of its setups, such as `noisy`; by default, and for `ideal`, none.

    Raises:
        WorldError: the file cannot be read or is invalid; all errors are reported at once.
    """
    return parse_robot(read_file(path), str(path), setup)


@lru_cache(maxsize=64)  # worlds share few definitions
def parse_robot(text: bytes, file: str, setup: str = "") -> RobotModel:
    """Return the robot model that a text describes, the same object for the same text.

    Args:
        text: the text of a robot definition.
        file: its file name in messages.
        setup: one of its setups.

    Raises:
        WorldError: the text is invalid; all errors are reported at once.
    """
    diagnostics = Diagnostics(lines={file: lines_of(text)})
    root = elements(text, "robot.xsd", file, diagnostics, outermost="robot-definition", setup=setup)
    model = robot_model(root, Reader(file, diagnostics))
    raise_errors(diagnostics)
    definition = Path(file).stem if Path(file).parent == ROBOTS else file
    return replace(model, definition=definition, setup=setup)


@dataclass(frozen=True, slots=True)
class Definitions:
    """The contents of an included file: names of materials and of objects."""

    materials: tuple[str, ...]
    objects: tuple[str, ...]


def _definitions(text: bytes, file: str, folder: Path | None) -> Definitions:
    """Return the names in a file for worlds to include, and in the files that it includes."""
    diagnostics = Diagnostics(lines={file: lines_of(text)})
    root = elements(text, "world.xsd", file, diagnostics, outermost="definitions")
    reader = Reader(file, diagnostics)
    found = Included(folder, reader).definitions(root)
    materials = [element for element in found if element.tag == "material"]
    objects = [element for element in found if element.tag == "define"]
    CompositeElements(objects, SolidElements(reader, Materials(materials, reader)))
    raise_errors(diagnostics)
    names = [tuple(each.attributes["name"] for each in some) for some in (materials, objects)]
    return Definitions(*names)


Model: TypeAlias = WorldModel | RobotModel | Definitions
"""What an XML file describes."""


def load_any(path: Path) -> Model:
    """Load a world, a robot definition, or a file with definitions.

    Raises:
        WorldError: the file cannot be read or is invalid; all errors are reported at once.
    """
    model, messages = examine(read_file(path), str(path), path.stem, path.parent)
    if model is None or messages:
        raise WorldError(messages)
    return model


def examine(
    text: bytes, file: str, name: str, folder: Path | None
) -> tuple[Model | None, Sequence[Diagnostic]]:
    """Return the model of a text, as far as it is valid, and its errors.

    Of a world whose errors are in values only, it is the world without what is wrong in it.

    Args:
        text: a world, a robot definition, or definitions for worlds to include.
        file: its file name in messages.
        name: the default name of a world.
        folder: the folder of the files that it may use; None if it may not use any.
    """
    try:
        match outermost(text):
            case "robot-definition":
                return parse_robot(text, file), ()
            case "definitions":
                return _definitions(text, file, folder), ()
        world, diagnostics = _World(name, file, folder, "", SCOUT).read(text)
    except WorldError as wrong:
        return None, wrong.diagnostics
    return world, diagnostics.errors


@dataclass(slots=True)
class _World:
    """Reader of a world file and the robot definitions that it uses, each read once.

    Attributes:
        name: the default name of the world.
        file: the file's name in messages.
        folder: the folder of definitions and programs; None if the world was not read from a file.
        setup: the setup of all robots; empty for that of the file.
        robot: the default kind of robot, by name or path.
        seed: the random seed of what is scattered; None for that of the file.
    """

    name: str
    file: str
    folder: Path | None
    setup: str
    robot: str
    seed: int | None = None
    reader: Reader = field(init=False)
    found: dict[tuple[str | Path, str], RobotModel | None] = field(default_factory=dict)

    def parse(self, text: bytes) -> WorldModel:
        world, diagnostics = self.read(text)
        raise_errors(diagnostics)
        return world

    def read(self, text: bytes) -> tuple[WorldModel, Diagnostics]:
        """Return a world, in which wrong values are replaced or left out, and all messages.

        Raises:
            WorldError: its form is wrong.
        """
        diagnostics = Diagnostics(lines={self.file: lines_of(text)})
        root = elements(text, "world.xsd", self.file, diagnostics, outermost="world")
        self.reader = Reader(self.file, diagnostics)
        included = Included(self.folder, self.reader)
        world = world_model(root, self.name, included, self.reader, self._model, seed=self.seed)
        diagnostics.messages = _by_line(diagnostics.messages, self.file, included.lines)
        return world, diagnostics

    def _model(self, element: Element) -> RobotModel:
        """Return the model of a robot; report an error at its element if there is none."""
        setup = self.setup or element.attributes.get("setup", "")
        name: str | Path = element.attributes.get("definition", "")
        if not name:
            name = self.robot if self.robot in known_robots() else Path(self.robot)
        if (name, setup) not in self.found:
            self.found[name, setup] = self._load(element, name, setup)
        model = self.found[name, setup]
        if model is None:
            element.broken = True
            return _STAND_IN
        return model

    def _load(self, element: Element, name: str | Path, setup: str) -> RobotModel | None:
        path = name if isinstance(name, Path) else self._path(name)
        if path is None:
            self.reader.error(
                element,
                unknown("robot definition", str(name), known_robots()),
                "use one of these, or a file (.xml) in the world's folder",
            )
            return None
        try:
            return parse_robot(self._definition(element, path), str(path), setup)
        except WorldError as wrong:
            self.reader.error(element, f"robot definition {str(name)!r} cannot be used")
            self.reader.diagnostics.messages.extend(wrong.diagnostics)
            return None

    def _definition(self, element: Element, path: Path) -> bytes:
        """Return a definition's text; no link can lead out of the world's folder."""
        name = element.attributes.get("definition", "")
        if not name or name in known_robots() or self.folder is None:
            return read_file(path)
        try:
            return read_below(self.folder, name, ".xml", MAX_BYTES)
        except ValueError as wrong:
            raise WorldError.at(Location(str(path)), str(wrong)) from None

    def _path(self, name: str) -> Path | None:
        """Return a definition's file: a built-in one, or one in the world's folder or below."""
        if name in known_robots():
            return ROBOTS / f"{name}.xml"
        path = PurePosixPath(name)
        outside = path.is_absolute() or ".." in path.parts or path.suffix != ".xml"
        return None if outside or self.folder is None else self.folder / path


def _by_line(
    messages: list[Diagnostic], file: str, included: Mapping[str, int]
) -> list[Diagnostic]:
    """Sort messages; those about another file follow the message that led to it.

    Args:
        messages: the messages.
        file: the world file.
        included: the lines that include other files.
    """
    keys, key = [], math.inf
    for message in messages:
        if message.location.file == file:
            key = message.location.line or math.inf
        keys.append(included.get(message.location.file, key))
    order = sorted(range(len(messages)), key=keys.__getitem__)
    return [messages[number] for number in order]
