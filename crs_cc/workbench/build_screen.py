"""The page of the world builder: a world that is edited, and the pages that edit it.

Pages send operations of the builder's table, by their names; the builder's document is the only
truth, and each change is sent to all pages. So a page that is loaded again, or comes back from a
run, is where it was.
"""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from crs_cc.builder.addresses import address, named
from crs_cc.builder.composition import definitions
from crs_cc.builder.document import Document
from crs_cc.builder.library import LibraryObject, library, put_object
from crs_cc.builder.motion import quantity
from crs_cc.builder.robot_shapes import robot_area, robot_shapes
from crs_cc.builder.shapes import shapes
from crs_cc.builder.spans import Node
from crs_cc.builder.table import OPERATIONS
from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.core.errors import CrsError
from crs_cc.core.file_names import displayed
from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.known_robots import known_robots
from crs_cc.sim.model.colours import NAMED
from crs_cc.sim.model.world import WorldModel
from crs_cc.workbench.clients import Client
from crs_cc.workbench.element_forms import element_form, new_form
from crs_cc.workbench.messages import VERSION, answer, message, refusal
from crs_cc.workbench.problem_list import problems
from crs_cc.workbench.program_checks import ProgramChecks
from crs_cc.workbench.programs_beside import programs_beside
from crs_cc.workbench.server import Server
from crs_cc.workbench.world_data import world_data

MAX_NAMES: Final = 10_000
_LOOKS: Final = ("properties", "form", "library", "scene")
"""Commands that change nothing."""

_MAX_TEXT: Final = 60_000


class BuildScreen:
    """Shows a world that is edited to pages.

    Attributes:
        builder: the world.
        server: serves the pages.
    """

    def __init__(
        self,
        builder: WorldBuilder,
        start_run: Callable[[WorldBuilder], str],
        port: int = 0,
    ) -> None:
        """Serve pages on a port, 0 for any that is free.

        Args:
            builder: the world.
            start_run: starts a run of the world as it is, and returns the address of its page.
            port: the port.

        Raises:
            OSError: the port is in use.
        """
        self.builder = builder
        self._start_run = start_run
        self._clip = ""
        self._shown: dict[str, Any] = {}
        self._over = threading.Event()
        self._handlers: dict[str, Callable[[dict[str, Any]], Any]] = {
            "apply": self._apply, "undo": self._undo, "redo": self._redo, "save": self._save,
            "copy": self._copy, "paste": self._paste, "properties": self._properties,
            "run": self._run, "read": self._read, "form": self._form, "again": lambda _: None,
            "scene": self._scene, "library": self._library, "insert": self._insert_object,
        }  # fmt: skip
        self._shelf: list[LibraryObject] = []
        self._programs = ProgramChecks(lambda: self.server.call_soon(self._broadcast))
        self.server = Server(self, port, "/build")

    def wait(self) -> None:
        """Wait until Ctrl-C, or until `end`."""
        while not self._over.wait(1.0):
            pass

    def end(self) -> None:
        """End waiting."""
        self._over.set()

    def close(self) -> None:
        """Stop serving, and end background work."""
        self._programs.end()
        self.server.close()

    # -- messages to pages -------------------------------------------------------------------------

    def greet(self, client: Client) -> None:
        """Send a page that has connected its initial data."""
        known = {"operations": _operations(), "colours": list(NAMED)}
        client.put(message("hello", version=VERSION, role=client.role, **known))
        client.put(self._document())

    def _document(self) -> str:
        builder = self.builder
        world = builder.visible()
        if world is not None:
            self._shown = {"area": _area(world), "shapes": shapes(builder.document, world)}
        root = builder.document.root
        is_robot = root.tag == "robot-definition"
        if is_robot:
            self._shown = {
                "area": robot_area(builder.document), "shapes": robot_shapes(builder.document)
            }  # fmt: skip
        items = [_item(node, name) for node, name in named(root)]
        return message(
            "document",
            file=displayed(str(builder.path or "")),
            changed=builder.is_changed,
            steps=len(builder.document.undoable),
            undo=builder.document.undoable[-1:],
            redo=builder.document.redoable[-1:],
            unit=builder.document.length_unit,
            isRobot=is_robot,
            items=items,
            parts={
                name: [_item(part, address(part)) for part in node.children]
                for name, node in definitions(root).items()
            },
            materials=_names(root, "material", builder.library()),
            definitions=_names(root, "define", builder.library()),
            robots=list(known_robots()),
            programs=programs_beside(builder.path),
            channels=[] if world is None else [each.name for each in world.communication.channels],
            problems=problems(builder, {} if world is None else self._programs.messages(world)),
            clip=bool(self._clip),
            **self._shown,
        )

    # -- what pages ask for ----------------------------------------------------------------------

    def receive(self, client: Client, command: dict[str, Any]) -> None:
        """Execute a command, and send the changed world to all pages."""
        number, name = command["id"], command["command"]
        do = self._handlers.get(name)
        if do is None:
            client.put(refusal(number, unknown("command", name[:40], list(self._handlers))))
            return
        if client.role != "control" and name not in _LOOKS:
            client.put(refusal(number, "this page is view-only"))
            return
        try:
            client.put(answer(number, do(command)))
        except CrsError as error:
            client.put(refusal(number, error.diagnostics[0].text))
        except (ValueError, OSError) as error:
            client.put(refusal(number, str(error)))
        except Exception as error:  # ours; the work must not be lost by it
            wrong = " ".join(f"{type(error).__name__}: {error}".split())
            client.put(refusal(number, f"internal error: {wrong}; please report it"))
        if name not in _LOOKS:
            self._broadcast()

    def _broadcast(self) -> None:
        self.server.broadcast_latest("document", self._document())

    def _apply(self, given: dict[str, Any]) -> list[str]:
        """Do operations, which are one to undo; each has `operation`, `names` and values."""
        steps = given.get("steps")
        if not isinstance(steps, list) or not all(isinstance(step, dict) for step in steps):
            raise ValueError("'steps' must be a list of operations")
        found: list[str] = []
        title = str(steps[0].get("operation", "")) if steps else ""
        with self.builder.together(title[:40]):
            for step in steps:
                found += self.builder.apply(
                    _text(step, "operation"),
                    _texts(step.get("names", [])),
                    _values(step.get("values", {})),
                    _values(step.get("attributes", {})),
                )
        return found

    def _undo(self, _: dict[str, Any]) -> str:
        return self.builder.undo()

    def _redo(self, _: dict[str, Any]) -> str:
        return self.builder.redo()

    def _save(self, given: dict[str, Any]) -> str:
        """Save the world; one that has no file yet to a new one in the folder where crs runs."""
        name = given.get("file", "")
        if self.builder.path is not None or not name:
            return displayed(str(self.builder.save()))
        path = Path(str(name))
        if path.name != str(name) or path.suffix != ".xml":
            raise ValueError("the name must be a file name (.xml) without a folder")
        return displayed(str(self.builder.save(path)))

    def _read(self, _: dict[str, Any]) -> None:
        """Reload the file, which another program has changed."""
        if self.builder.path is not None:
            self.builder = WorldBuilder(self.builder.path)

    def _copy(self, given: dict[str, Any]) -> str:
        self._clip = self.builder.copy(_texts(given.get("names", [])))
        return self._clip

    def _paste(self, given: dict[str, Any]) -> list[str]:
        values = _values(given.get("values", {}))
        clip = given.get("clip") or self._clip
        return self.builder.apply("paste", (), {**values, "clip": str(clip)})

    def _properties(self, given: dict[str, Any]) -> dict[str, Any]:
        return element_form(self.builder.document, self.builder.element(_text(given, "name")))

    def _form(self, given: dict[str, Any]) -> dict[str, Any]:
        parent = self.builder.element(given.get("into") or "")
        return new_form(self.builder.document, parent, str(given.get("kind") or ""))

    def _library(self, _: dict[str, Any]) -> list[dict[str, Any]]:
        """Return the objects that can be put into the world; pages name them by their places."""
        self._shelf = library(self.builder.path and self.builder.path.parent)
        return [
            {"name": each.name, "file": each.file.name, "shapes": each.shapes}
            for each in self._shelf
        ]

    def _insert_object(self, given: dict[str, Any]) -> str:
        """Put an object of the library into the world."""
        index, place = given.get("index"), _values(given.get("values", {}))
        if not isinstance(index, int) or not 0 <= index < len(self._shelf):
            raise ValueError("unknown object of the library")
        x_m, y_m = (LENGTH.parse(str(place.get(name, 0))) for name in ("x", "y"))
        return put_object(self.builder, self._shelf[index], x_m, y_m)

    def _scene(self, _: dict[str, Any]) -> dict[str, Any] | None:
        """Return the world as the viewer draws it; None if its form is wrong."""
        world = self.builder.visible()
        return None if world is None else world_data(world, [each.id for each in world.robots])

    def _run(self, _: dict[str, Any]) -> str:
        self.builder.world()  # raises the error, if any
        return self._start_run(self.builder)


def _operations() -> list[dict[str, Any]]:
    """Return the operations for the selection, with the fields of their forms."""
    return [
        {
            "name": row.name, "summary": row.summary,
            "fields": [
                {
                    "name": field.name, "help": field.help, "default": field.default,
                    "choices": field.kind if isinstance(field.kind, tuple) else (),
                }
                for field in row.fields
            ],
        }
        for row in OPERATIONS.values()
        if row.elements != "none" and not row.attributes and row.name != "text"
    ]  # fmt: skip


def _item(node: Node, name: str) -> dict[str, Any]:
    found: dict[str, Any] = {"name": name, "tag": node.tag, "attributes": node.attributes}
    if node.tag == "object":
        with contextlib.suppress(ValueError):  # the loader reports the error
            x_m, y_m = quantity(node, "x", LENGTH), quantity(node, "y", LENGTH)
            found["pose"] = [x_m, y_m, quantity(node, "heading", ANGLE, 0.0)]
    return found


def _names(root: Node, tag: str, library: list[Document]) -> list[str]:
    nodes = [*root.children, *(child for each in library for child in each.root.children)]
    return [node.attributes.get("name", "") for node in nodes if node.tag == tag]


def _area(world: WorldModel) -> dict[str, float]:
    area = world.area
    return {
        "x": area.x_min_m, "y": area.y_min_m, "length": area.length_m, "width": area.width_m,
        "edge": area.edge_m,
    }  # fmt: skip


def _text(given: dict[str, Any], name: str) -> str:
    value = given.get(name)
    if not isinstance(value, str) or len(value) > _MAX_TEXT:
        raise ValueError(f"{name!r} must be a string")
    return value


def _texts(value: Any) -> list[str]:
    if not isinstance(value, list) or len(value) > MAX_NAMES:
        raise ValueError("'names' must be a list of names")
    if not all(isinstance(each, str) for each in value):
        raise ValueError("'names' must be a list of names")
    return value


def _values(value: Any) -> dict[str, str | float | None]:
    if not isinstance(value, dict) or not all(map(_is_value, value.values())):
        raise ValueError("values must be an object of numbers and texts")
    return value


def _is_value(each: Any) -> bool:
    return each is None or (isinstance(each, str | float | int) and not isinstance(each, bool))
