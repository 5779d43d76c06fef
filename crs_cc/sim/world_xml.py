"""World and robot files, read by a parser that trusts nothing.

The text may come from anywhere: entities are not resolved, nothing is fetched, a document type
declaration is refused, depth and size are limited (by libxml2 and by `MAX_BYTES`). The schema
(`world.xsd`, `robot.xsd`) checks the form; what a schema cannot say is checked afterwards. This
file alone in `sim` knows lxml.

>>> world = parse_world(b'''<world version="1" timestep="50ms">
...   <area length="6m" width="5m"/>
...   <robot x="1m" y="1m" heading="90deg"/>
... </world>''', "room")
>>> world.robots[0].model.name, len(world.robots[0].model.sonars)
('scout', 16)
>>> parse_world(b"<world version='1'><area length='6m'/></world>", "room")
Traceback (most recent call last):
crs_cc.errors.WorldError: room:1: error: <area> lacks the attribute 'width'
    <world version='1'><area length='6m'/></world>
"""

from __future__ import annotations

import math
import stat
from dataclasses import dataclass, field
from functools import cache
from itertools import islice
from pathlib import Path, PurePosixPath
from typing import Final

from lxml import etree

from crs_cc.errors import WorldError
from crs_cc.sim.document import MAX_MESSAGES, Element, Reader
from crs_cc.sim.model import WorldModel
from crs_cc.sim.robot_elements import robot_model
from crs_cc.sim.robot_model import Drive, RobotModel
from crs_cc.sim.schema_messages import explain
from crs_cc.sim.schema_names import UnknownName, unknown_names
from crs_cc.sim.world_elements import world_model
from crs_cc.source import Diagnostic, Diagnostics, Location

MAX_BYTES: Final = 16 * 1024 * 1024

SCOUT: Final = "scout"
"""The kind of robot where nothing else is said."""

IDEAL: Final = "ideal"
"""The setup that every robot definition has: the definition as it stands."""

_HERE: Final = Path(__file__).parent
_ROBOTS: Final = _HERE / "robots"
_STAND_IN: Final = RobotModel("unknown", 0.001, Drive(1.0))
_SAID_BETTER: Final = {
    "SCHEMAV_CVC_PATTERN_VALID",  # numbers, later: with the units that are known
    "SCHEMAV_CVC_IDC",  # ids, later: with the place of the other one
}
_SAID_OF_UNKNOWN: Final = {"SCHEMAV_ELEMENT_CONTENT", "SCHEMAV_CVC_COMPLEX_TYPE_3_2_1"}
_EMPTY_WORLD: Final = b"""<world version="1" name="empty">
  <area length="1000m" width="1000m" origin="centre" edge="0"/>
  <robot x="0" y="0"/>
</world>"""


def load_world(path: Path, setup: str = "", robot: str = SCOUT) -> WorldModel:
    """Gives the world that a file describes.

    Args:
        path: the file.
        setup: the setup of all robots, such as `noisy`; by default what the file says.
        robot: the kind of the robots of which the file says none: a name that comes with crs, or
            the path of a definition file.

    Raises:
        WorldError: the file cannot be read, or is wrong; all mistakes are told at once.
    """
    return _World(path.stem, str(path), path.parent, setup, robot).parse(_read_file(path))


def parse_world(text: bytes, name: str, setup: str = "", robot: str = SCOUT) -> WorldModel:
    """Gives the world that a text describes; `name` stands for it in messages.

    Raises:
        WorldError: the text is wrong; all mistakes are told at once.
    """
    return _World(name, name, None, setup, robot).parse(text)


def empty_world(setup: str = "", robot: str = SCOUT) -> WorldModel:
    """Gives the built-in world: one robot at the origin, wide and empty."""
    return parse_world(_EMPTY_WORLD, "empty", setup, robot)


def load_robot(path: Path, setup: str = "") -> RobotModel:
    """Gives the kind of robot that a definition file describes.

    Args:
        path: the file.
        setup: one of its setups, such as `noisy`; by default, and as `ideal`, the definition as it
            stands.

    Raises:
        WorldError: the file cannot be read, or is wrong; all mistakes are told at once.
    """
    text, file = _read_file(path), str(path)
    diagnostics = Diagnostics(lines={file: _lines(text)})
    root = _elements(text, "robot.xsd", file, diagnostics, setup)
    model = robot_model(root, Reader(file, diagnostics))
    _raise_errors(diagnostics)
    return model


def known_robots() -> list[str]:
    """Gives the names of the robot definitions that come with crs."""
    return sorted(path.stem for path in _ROBOTS.glob("*.xml"))


@dataclass(slots=True)
class _World:
    """A world file that is being read, and the robot definitions that it uses, each read once.

    Attributes:
        name: the world's name, if the file gives none.
        file: what to call it in messages.
        folder: where definitions and programs are looked for; None when it came from no file.
        setup: the setup of all robots; empty for what the file says.
        robot: the kind of the robots of which the file says none, by name or path.
    """

    name: str
    file: str
    folder: Path | None
    setup: str
    robot: str
    reader: Reader = field(init=False)
    found: dict[tuple[str | Path, str], RobotModel | None] = field(default_factory=dict)

    def parse(self, text: bytes) -> WorldModel:
        diagnostics = Diagnostics(lines={self.file: _lines(text)})
        root = _elements(text, "world.xsd", self.file, diagnostics)
        self.reader = Reader(self.file, diagnostics)
        world = world_model(root, self.name, self.folder, self.reader, self._model)
        diagnostics.messages = _by_line(diagnostics.messages, self.file)
        _raise_errors(diagnostics)
        return world

    def _model(self, element: Element) -> RobotModel:
        """Gives the model of a robot; notes it as a mistake of the element when there is none."""
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
                f"unknown robot definition {name!r}",
                f"known are {', '.join(known_robots())}, and files (.xml) in the world's folder",
            )
            return None
        try:
            return load_robot(path, setup)
        except WorldError as wrong:
            self.reader.error(element, f"robot definition {str(name)!r} cannot be used")
            self.reader.diagnostics.messages.extend(wrong.diagnostics)
            return None

    def _path(self, name: str) -> Path | None:
        """Gives a definition's file: one of ours, or one in the world's folder or below."""
        if name in known_robots():
            return _ROBOTS / f"{name}.xml"
        path = PurePosixPath(name)
        outside = path.is_absolute() or ".." in path.parts or path.suffix != ".xml"
        return None if outside or self.folder is None else self.folder / path


def _read_file(path: Path) -> bytes:
    """Gives what is in a file, which must be a regular one and not too large."""
    place = Location(str(path))
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise WorldError.at(place, "not a regular file")
        if status.st_size > MAX_BYTES:
            raise WorldError.at(place, f"larger than {MAX_BYTES} bytes")
        with path.open("rb") as file:
            return file.read(MAX_BYTES)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise WorldError.at(place, f"cannot be read: {reason}") from None
    except ValueError:  # a null character in the name
        raise WorldError.at(place, "cannot be read: not a file name") from None


def _elements(
    text: bytes, schema: str, file: str, diagnostics: Diagnostics, setup: str = ""
) -> Element:
    """Gives the outermost element of a document that keeps to a schema, also with a setup."""
    if len(text) > MAX_BYTES:
        raise WorldError.at(Location(file), f"larger than {MAX_BYTES} bytes")
    parser = etree.XMLParser(
        resolve_entities=False,
        no_network=True,
        load_dtd=False,
        dtd_validation=False,
        huge_tree=False,
        remove_comments=True,
        remove_pis=True,
    )
    try:
        root = etree.fromstring(text, parser)
    except etree.XMLSyntaxError as error:
        if b"<!DOCTYPE" in text:
            _refuse_document_type(file)
        line, column = error.position
        place = Location(file, line or 0, max(column, 0))
        raise WorldError([_syntax_message(place, str(error.msg), diagnostics)]) from None
    if root.getroottree().docinfo.doctype:
        _refuse_document_type(file)
    _validate(root, schema, file, diagnostics)
    if setup:
        _apply(setup, root, Reader(file, diagnostics))
        _raise_errors(diagnostics)
        _validate(root, schema, file, diagnostics)
    return _plain(root)


def _apply(setup: str, root: etree._Element, reader: Reader) -> None:
    """Lets the attributes in a setup take the place of those in the definition."""
    setups = {str(node.get("name")): node for node in root.iterfind("setup")}
    if setup not in setups:
        if setup != IDEAL:
            known = ", ".join([IDEAL, *setups])
            place = Element(root.tag, root.sourceline or 0)
            reader.error(place, f"the definition has no setup {setup!r}", f"it has {known}")
        return
    for change in setups[setup]:
        device = root.find(change.tag)
        if device is None or change.tag == "setup":
            place = Element(change.tag, change.sourceline or 0)
            reader.error(place, f"setup {setup!r} changes <{change.tag}>, which is not there")
        else:
            device.attrib.update(change.attrib)


def _refuse_document_type(file: str) -> None:
    raise WorldError.at(
        Location(file), "a document type declaration is not allowed", "take <!DOCTYPE ...> out"
    )


def _validate(root: etree._Element, name: str, file: str, diagnostics: Diagnostics) -> None:
    """Checks a document against a schema, and completes it with the schema's defaults."""
    schema = _schema(name)
    if schema.validate(root):
        return
    found = list(islice(unknown_names(root, _schema_document(name).getroot()), MAX_MESSAGES))
    lines = {each.line for each in found}
    for entry in schema.error_log:
        said = _SAID_BETTER | (_SAID_OF_UNKNOWN if entry.line in lines else set())
        if entry.type_name not in said:
            found.append(UnknownName(entry.line, *explain(entry.message)))
    reader = Reader(file, diagnostics)
    for each in sorted(found, key=lambda each: each.line):
        reader.error(Element("", each.line), each.text, each.hint)
    _raise_errors(diagnostics)


@cache
def _schema_document(name: str) -> etree._ElementTree:
    return etree.parse(_HERE / name)


@cache
def _schema(name: str) -> etree.XMLSchema:
    return etree.XMLSchema(_schema_document(name), attribute_defaults=True)


def _plain(node: etree._Element) -> Element:
    """Copies an lxml element; the depth is limited by the schema."""
    return Element(
        node.tag,
        node.sourceline or 0,
        dict(node.attrib),
        (node.text or "").strip(),
        [_plain(child) for child in node],
    )


def _by_line(messages: list[Diagnostic], file: str) -> list[Diagnostic]:
    """Sorts messages; those about another file stay behind the message that led there."""
    keys, key = [], math.inf
    for message in messages:
        if message.location.file == file:
            key = message.location.line or math.inf
        keys.append(key)
    order = sorted(range(len(messages)), key=keys.__getitem__)
    return [messages[number] for number in order]


def _lines(text: bytes) -> list[str]:
    return text.decode("utf-8", errors="replace").splitlines()


def _syntax_message(place: Location, text: str, diagnostics: Diagnostics) -> Diagnostic:
    shown = Diagnostics(lines=diagnostics.lines)
    shown.error(place, f"not well-formed XML: {text}")
    return shown.messages[0]


def _raise_errors(diagnostics: Diagnostics) -> None:
    if diagnostics.errors:
        raise WorldError(diagnostics.errors)
