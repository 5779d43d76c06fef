"""The world builder: a file that is edited by operations, checked and saved.

>>> builder = WorldBuilder.new(length=6.0, width=4.0)
>>> builder.add("wall", x1=2.0, y1=0.0, x2=2.0, y2="250cm")
'wall0'
>>> builder.add("robot", x=1.0, y=1.0)
'robot0'
>>> builder.move(["wall0"], x="50cm")
>>> print(builder.text)
<?xml version="1.0" encoding="UTF-8"?>
<world version="1">
  <area length="6m" width="4m"/>
  <wall id="wall0" x1="2.5m" y1="0m" x2="2.5m" y2="250cm"/>
  <robot id="robot0" x="1m" y="1m"/>
</world>
<BLANKLINE>
>>> builder.undo(), builder.undo(), [each.text for each in builder.problems()]
('move', 'add', ['no robot in the world'])
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Literal, Self, TypeAlias

from crs_cc.builder import clips
from crs_cc.builder.addresses import address, find, find_all
from crs_cc.builder.arrangement import Extents
from crs_cc.builder.changes import path_inside, path_of, schema_of
from crs_cc.builder.document import Document
from crs_cc.builder.exporting import export
from crs_cc.builder.extents import extents, free_place
from crs_cc.builder.importing.plan import THICKNESS_M, read_plan
from crs_cc.builder.motion import measure
from crs_cc.builder.operations import planned
from crs_cc.builder.reaching import unreachable
from crs_cc.builder.spans import Node
from crs_cc.builder.table import OPERATIONS, Operation, Value
from crs_cc.builder.world_file import replace_file
from crs_cc.core.errors import WorldError
from crs_cc.core.quantity import ANGLE, LENGTH, MASS, TIME
from crs_cc.core.source import Diagnostic
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.schema_properties import properties
from crs_cc.sim.files.solid_writer import solid_element
from crs_cc.sim.files.world_writer import beacon_element, robot_element
from crs_cc.sim.files.world_xml import Model, examine
from crs_cc.sim.files.xml_document import read_file
from crs_cc.sim.model.beacons import Light, Sound
from crs_cc.sim.model.world import Box, Cylinder, Polygon, Robot, Wall, WorldModel

Names: TypeAlias = str | Sequence[str]
"""One element or several."""

_BEHIND_UNIT = {LENGTH: "m", ANGLE: "deg"}
_EMPTY = '<?xml version="1.0" encoding="UTF-8"?>\n<world version="1">\n</world>\n'
_ROUNDING = 1e-9
_MARGIN_M, _ROOM_M = 1.0, 0.4
"""Around a plan that becomes a world, and around the centre of its robot."""


class WorldBuilder:
    """A world file, a robot definition, or a file of definitions that is being edited.

    Elements are named by their ids, or by their positions in the tree: `crate`, `surface/ramp[1]`,
    `define[table]/leg0`. Lengths and angles are numbers in metres and radians, or texts with units,
    which are written as they are. Only changed parts are rewritten.

    Attributes:
        document: the file as it is now.
        path: where it is saved, and around which it finds other files; None if that is not known.
    """

    def __init__(self, path: str | os.PathLike[str] | None = None, text: str | bytes = b"") -> None:
        """Open a file.

        Args:
            path: the file; None for a text.
            text: instead of a file, its text.

        Raises:
            WorldError: the file cannot be read, or is not well-formed XML.
        """
        self.path = None if path is None else Path(path)
        given = text.encode() if isinstance(text, str) else text
        self._saved = given if self.path is None else read_file(self.path)
        self._before: bytes | None = None if self.path is None else self._saved
        self.document = Document(self._saved, "world" if self.path is None else str(self.path))
        self._warned: tuple[bytes, Sequence[Diagnostic]] | None = None
        self._examined: tuple[bytes, Model | None, Sequence[Diagnostic]] | None = None

    @classmethod
    def new(
        cls, length: float | str, width: float | str, name: str = "",
        path: str | os.PathLike[str] | None = None,
    ) -> Self:  # fmt: skip
        """Return the builder of a new world without anything in it.

        Args:
            length: the size of its area in x.
            width: its size in y.
            name: the name of the world; by default that of its file.
            path: the new file in which it is saved.
        """
        builder = cls(text=_EMPTY)
        builder.set("world", name=name)
        builder.add("area", length=length, width=width)
        builder.path = None if path is None else Path(path)
        builder.document = Document(builder.document.text, str(builder.path or "world"))
        return builder

    # -- what there is ---------------------------------------------------------------------------

    @property
    def text(self) -> str:
        """The text of the file as it is now."""
        return self.document.text.decode(self.document.codec)

    @property
    def is_changed(self) -> bool:
        """Whether there is something to save."""
        return self._before is None or self.document.text != self._saved

    def element(self, name: str) -> Node:
        """Return an element; it is valid until the next change.

        Raises:
            ValueError: there is no element with this name.
        """
        return find(self.document.root, name)

    def names(self, kind: str = "") -> list[str]:
        """Return the names of all elements, or those of one kind, in the order of the file."""
        nodes = self.document.root.children
        return [address(node) for node in nodes if kind in ("", node.tag)]

    def get(self, name: str) -> dict[str, str]:
        """Return the attributes of an element as written in the file."""
        return dict(self.element(name).attributes)

    def problems(self) -> tuple[Diagnostic, ...]:
        """Return the messages of `crs check` for the file; empty if it is valid."""
        return tuple(self._examine()[1])

    def warnings(self) -> tuple[Diagnostic, ...]:
        """Return warnings, as `crs check` does: goals that robots cannot reach."""
        world = self.visible()
        if world is None:
            return ()
        if self._warned is None or self._warned[0] is not self.document.text:
            self._warned = (self.document.text, unreachable(self.document, world))
        return tuple(self._warned[1])

    def world(self) -> WorldModel:
        """Return the world that the file describes, as `load_world` would.

        Raises:
            WorldError: it is invalid, or no world; all errors are reported at once.
        """
        model, messages = self._examine()
        if messages or not isinstance(model, WorldModel):
            raise WorldError(messages)
        return model

    def visible(self) -> WorldModel | None:
        """Return the world without its invalid elements; None if the file cannot be parsed."""
        model, _ = self._examine()
        return model if isinstance(model, WorldModel) else None

    def extents(self) -> Extents:
        """Return the extents of valid elements, by their names."""
        world = self.visible()
        return {} if world is None else extents(self.document, world)

    def library(self) -> list[Document]:
        """Return the files that this one includes, as far as they can be read."""
        return list(clips.included_files(self.document, self._folder))

    @property
    def _folder(self) -> Path | None:
        return None if self.path is None else self.path.parent

    def _examine(self) -> tuple[Model | None, Sequence[Diagnostic]]:
        text = self.document.text
        if self._examined is None or self._examined[0] is not text:
            name = "world" if self.path is None else self.path.stem
            found = examine(text, self.document.file, name, self._folder)
            self._examined = (text, *found)
        return self._examined[1:]

    # -- operations ------------------------------------------------------------------------------

    def apply(
        self,
        operation: str,
        names: Sequence[str] = (),
        values: Mapping[str, Value] | None = None,
        attributes: Mapping[str, Value] | None = None,
    ) -> list[str]:
        """Do an operation of the table; nothing changes if it fails.

        Args:
            operation: its name.
            names: the elements on which it acts.
            values: the values of its fields.
            attributes: attributes of elements; None and empty ones are removed.

        Returns:
            the names of new elements.

        Raises:
            ValueError: it is unknown, or cannot be done.
            WorldError: the file would not be well-formed.
        """
        row = OPERATIONS.get(operation)
        if row is None:
            raise ValueError(unknown("operation", operation, tuple(OPERATIONS)))
        nodes = self._elements(row, names)
        wanted = row.values(values or {})
        if attributes and not row.attributes:
            raise ValueError(f"{row.name} takes no attributes")
        tags = [] if row.elements == "none" else path_of(nodes[0])
        if row.name == "add":
            tags = path_inside(self.element(wanted["into"]), wanted["kind"])
        given = {
            name: self._attribute(tags, name, value) for name, value in (attributes or {}).items()
        }
        plan = planned(self, row.name, nodes, wanted, given)
        self.document.change(row.name, plan.splices)
        return plan.names

    def _elements(self, row: Operation, names: Sequence[str]) -> list[Node]:
        if row.elements == "none" and names:
            raise ValueError(f"{row.name} acts on no elements")
        if row.elements == "one" and len(names) != 1:
            raise ValueError(f"{row.name} acts on one element, not {len(names)}")
        if row.elements == "some" and not names:
            raise ValueError(f"{row.name} acts on one element or more")
        return find_all(self.document.root, names)

    def _attribute(self, tags: Sequence[str], name: str, value: Value) -> str | None:
        """Return a value as text: a number in the unit of the file."""
        if value is None or value == "":
            return None
        if isinstance(value, str):
            return value
        kind = {row.name: row.kind for row in properties(schema_of(self.document), tags)}.get(name)
        if kind in (LENGTH, ANGLE):
            assert kind is not None
            unit = self.document.length_unit if kind is LENGTH else _BEHIND_UNIT[kind]
            text = measure(kind, value, unit)
            return text if abs(kind.parse(text) - value) <= _ROUNDING else kind.exact(value)
        if kind in (MASS, TIME):
            assert kind is not None
            return kind.exact(value)
        return str(value) if isinstance(value, int) else f"{float(value)!r}"

    def add(
        self,
        kind: str | Wall | Box | Cylinder | Polygon | Robot | Light | Sound,
        attributes: Mapping[str, Value] | None = None,
        *,
        into: str = "",
        text: str = "",
        **more: Value,
    ) -> str:
        """Add an element; return its name.

        Args:
            kind: its tag, such as `box`; or an object as it is in a `WorldModel`.
            attributes: its attributes.
            into: the element around it, such as `define[table]`; by default the world.
            text: its own text.
            more: more attributes.

        Raises:
            ValueError: there is no such element, or a value cannot be written.
        """
        given: dict[str, Value] = {}
        inner: list[str] = []
        if not isinstance(kind, str):
            if isinstance(kind, Robot):
                new = robot_element(kind, self._folder)
            elif isinstance(kind, Light | Sound):
                new = beacon_element(kind)
            else:
                new = solid_element(kind)
            inner = [child.text for child in new.children]
            kind, given = new.tag, dict(new.attributes)
        given |= {**(attributes or {}), **more}
        with self.together("add"):
            (name,) = self.apply("add", (), {"kind": kind, "into": into, "text": text}, given)
            for argument in inner:
                self.apply("add", (), {"kind": "argument", "into": name, "text": argument})
        return name

    def set(
        self, names: Names, attributes: Mapping[str, Value] | None = None,
        **more: Value,
    ) -> None:  # fmt: skip
        """Set attributes of elements; None removes one. What refers to a new id follows."""
        self.apply("set", _several(names), None, {**(attributes or {}), **more})

    def set_text(self, name: str, text: str) -> None:
        """Set the text of an element, such as the position of a sensor."""
        self.apply("text", [name], {"text": text})

    def remove(self, names: Names) -> None:
        """Remove elements."""
        self.apply("remove", _several(names))

    def move(self, names: Names, x: Value = 0.0, y: Value = 0.0) -> None:
        """Move elements by a distance."""
        self.apply("move", _several(names), {"x": x, "y": y})

    def place(self, name: str, x: Value = None, y: Value = None, heading: Value = None) -> None:
        """Put an element at a place."""
        self.apply("place", [name], {"x": x, "y": y, "heading": heading})

    def turn(self, names: Names, angle: Value, x: Value = None, y: Value = None) -> None:
        """Turn elements as one body, by default about their middle."""
        self.apply("turn", _several(names), {"angle": angle, "x": x, "y": y})

    def mirror(self, names: Names, axis: Literal["x", "y"] = "x", at: Value = None) -> None:
        """Mirror elements: `x` exchanges left and right, `y` up and down."""
        self.apply("mirror", _several(names), {"axis": axis, "at": at})

    def scale(self, names: Names, factor: float, x: Value = None, y: Value = None) -> None:
        """Scale elements from above, by default about their middle."""
        self.apply("scale", _several(names), {"factor": factor, "x": x, "y": y})

    def array(
        self, names: Names, columns: int = 1, rows: int = 1,
        x: Value = 0.0, y: Value = 0.0,
    ) -> list[str]:  # fmt: skip
        """Copy elements into columns and rows; return the names of the copies."""
        values: dict[str, Value] = {"columns": columns, "rows": rows, "x": x, "y": y}
        return self.apply("array", _several(names), values)

    def ring(self, names: Names, count: int, x: Value = None, y: Value = None) -> list[str]:
        """Copy elements around a point; return the names of the copies.

        Sonars of a robot definition by default go around its centre.
        """
        return self.apply("ring", _several(names), {"count": count, "x": x, "y": y})

    def align(self, names: Sequence[str], side: str) -> None:
        """Bring sides into line: left, right, bottom, top, centre-x or centre-y."""
        self.apply("align", names, {"side": side})

    def distribute(self, names: Sequence[str], axis: Literal["x", "y"]) -> None:
        """Space the centres of elements evenly; the outer two stay."""
        self.apply("distribute", names, {"axis": axis})

    def group(self, names: Names, name: str, own_id: str = "") -> str:
        """Make elements an object of a new definition; return the object's id."""
        return self.apply("group", _several(names), {"name": name, "id": own_id})[0]

    def ungroup(self, name: str) -> list[str]:
        """Put the parts of an object in its place; return their names."""
        return self.apply("ungroup", [name])

    def copy(self, names: Names) -> str:
        """Return elements as a text that `paste` puts into any world, with their definitions."""
        nodes = [self.element(name) for name in _several(names)]
        return clips.clip(self.document, nodes, self.library())

    def cut(self, names: Names) -> str:
        """Remove elements, and return them as `copy` does."""
        found = self.copy(names)
        self.remove(names)
        return found

    def raise_ground(
        self, path: Sequence[tuple[float, float]], radius: Value = 0.5, rise: Value = 0.05
    ) -> None:
        """Raise the ground by a stroke of a brush through points [m]; by less than 0, lower it."""
        points = " ".join(f"{x:.9g},{y:.9g}" for x, y in path)
        self.apply("raise", (), {"path": points, "radius": radius, "rise": rise})

    def paste(self, clip: str, x: Value = 0.0, y: Value = 0.0) -> list[str]:
        """Put in what `copy` or `cut` has returned, moved; return the names of the elements."""
        return self.apply("paste", (), {"clip": clip, "x": x, "y": y})

    def import_plan(
        self,
        path: str | os.PathLike[str],
        scale: float | None = None,
        thickness: float = THICKNESS_M,
        x: Value = 0.0,
        y: Value = 0.0,
    ) -> tuple[list[str], list[str]]:
        """Insert the elements of a plan: SVG, PNG, a world of Stage (`.world`), or SDF.

        Args:
            path: the file.
            scale: the size of a pixel, or of a unit of SVG [m]; by default the physical size of an
                SVG file.
            thickness: the thickness of walls that are lines [m].
            x: the x coordinate of the plan's origin.
            y: its y coordinate.

        Returns:
            the names of the elements, and what was left out.

        Raises:
            WorldError: the plan cannot be read.
        """
        drawn = read_plan(Path(path), scale, thickness)
        return self.paste(drawn.clip(), x, y), drawn.omissions()

    @classmethod
    def from_plan(
        cls,
        path: str | os.PathLike[str],
        scale: float | None = None,
        thickness: float = THICKNESS_M,
    ) -> tuple[Self, list[str]]:
        """Return the builder of a new world with the elements of a plan, and what was omitted.

        The area is as large as the plan with a margin. If the plan has no robot, one is added at
        a free place, if there is any.
        """
        drawn = read_plan(Path(path), scale, thickness)
        (left_m, bottom_m), (right_m, top_m) = drawn.extent
        margin_m = 2 * _MARGIN_M
        length_m = math.ceil((right_m - left_m + margin_m) * 10) / 10
        builder = cls.new(length_m, math.ceil((top_m - bottom_m + margin_m) * 10) / 10)
        builder.paste(drawn.clip(), _MARGIN_M - left_m, _MARGIN_M - bottom_m)
        world = builder.visible()
        place = None if world is None or world.robots else free_place(world, _ROOM_M)
        if place is not None:
            builder.add("robot", x=place[0], y=place[1])
        return builder, drawn.omissions()

    def export(self, path: str | os.PathLike[str]) -> list[str]:
        """Write the world as a picture (SVG, PNG) or as SDF; return what was omitted.

        Raises:
            WorldError: it is invalid.
            ValueError: there is no such format.
            OSError: the file cannot be written.
        """
        return export(self.world(), Path(path))

    # -- history and file ------------------------------------------------------------------------

    def together(self, title: str) -> AbstractContextManager[None]:
        """Return a context in which all changes are one to undo; none is made if it fails."""
        return self.document.transaction(title)

    def undo(self) -> str:
        """Undo the latest change; return its description, empty if there is none."""
        return self.document.undo()

    def redo(self) -> str:
        """Redo the change that was undone last; return its description, empty if there is none."""
        return self.document.redo()

    def save(self, path: str | os.PathLike[str] | None = None) -> Path:
        """Save the file if it is valid; return its path.

        The old file is replaced in one step by the new one. Under another name, it must not exist.

        Raises:
            WorldError: it is invalid, or the file has been changed externally.
            ValueError: it has no name yet.
            OSError: it cannot be written.
        """
        target = self.path if path is None else Path(path)
        if target is None:
            raise ValueError("the world has no file yet: give a path")
        before = self._before if target == self.path else None
        was = self.path, self.document.file
        self.path, self.document.file = target, str(target)
        try:
            self._require_valid()
            if before != self.document.text:
                replace_file(target, self.document.text, before)
        except BaseException:
            self.path, self.document.file = was
            raise
        self._saved = self._before = self.document.text
        return target

    def _require_valid(self) -> None:
        self._examined = None  # files that it includes may have changed
        if messages := self.problems():
            raise WorldError(messages)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.document.file}: {len(self.names())} elements>"


def _several(names: Names) -> Sequence[str]:
    return [names] if isinstance(names, str) else names
