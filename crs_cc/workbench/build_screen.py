"""The page of the world builder: a world that is edited, and the pages that edit it.

Pages send operations of the builder's table, by their names; the builder's document is the only
truth, and each change is told to all pages. So a page that is loaded again, or comes back from a
run, is where it was.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from crs_cc.builder.addresses import address, ids
from crs_cc.builder.changes import path_of, schema_of
from crs_cc.builder.document import Document
from crs_cc.builder.shapes import shapes
from crs_cc.builder.spans import Node
from crs_cc.builder.table import OPERATIONS
from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.core.errors import CrsError
from crs_cc.core.file_names import displayed
from crs_cc.core.source import Diagnostic
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.known_robots import known_robots
from crs_cc.sim.files.schema_properties import properties
from crs_cc.sim.model.world import WorldModel
from crs_cc.workbench.clients import Client
from crs_cc.workbench.messages import VERSION, answer, message, refusal
from crs_cc.workbench.server import Server

MAX_NAMES: Final = 10_000
_LONGEST: Final = 60_000


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
        target: Path | None = None,
    ) -> None:
        """Serve pages on a port, 0 for any that is free.

        Args:
            builder: the world.
            start_run: starts a run of the world as it is, and returns the address of its page.
            port: the port.
            target: where a world that has no file yet is saved; None to ask for a name.

        Raises:
            OSError: the port is in use.
        """
        self.builder = builder
        self._start_run = start_run
        self._target = target
        self._clip = ""
        self._shown: dict[str, Any] = {}
        self._over = threading.Event()
        self._do: dict[str, Callable[[dict[str, Any]], Any]] = {
            "apply": self._apply, "undo": self._undo, "redo": self._redo, "save": self._save,
            "copy": self._copy, "paste": self._paste, "properties": self._properties,
            "try": self._try, "read": self._read,
        }  # fmt: skip
        self.server = Server(self, port, "/build")

    def wait(self) -> None:
        """Wait until Ctrl-C, or until `end`."""
        while not self._over.wait(1.0):
            pass

    def end(self) -> None:
        """End waiting."""
        self._over.set()

    # -- what pages are told ---------------------------------------------------------------------

    def greet(self, client: Client) -> None:
        """Send a page that has connected all that it must know."""
        client.put(message("hello", version=VERSION, role=client.role, operations=_operations()))
        client.put(self._document())

    def _document(self) -> str:
        builder = self.builder
        world = builder.visible()
        if world is not None:
            self._shown = {"area": _area(world), "shapes": shapes(builder.document, world)}
        root = builder.document.root
        return message(
            "document",
            file=displayed(str(builder.path or self._target or "")),
            changed=builder.is_changed,
            steps=len(builder.document.undoable),
            undo=builder.document.undoable[-1:],
            redo=builder.document.redoable[-1:],
            unit=builder.document.length_unit,
            things=[_thing(node, name) for node, name in _named(root)],
            materials=_names(root, "material", builder.library()),
            definitions=_names(root, "define", builder.library()),
            robots=list(known_robots()),
            problems=_problems(builder),
            clip=bool(self._clip),
            **self._shown,
        )

    # -- what pages ask for ----------------------------------------------------------------------

    def receive(self, client: Client, command: dict[str, Any]) -> None:
        """Carry a command out, and tell all pages what has become of the world."""
        number, name = command["id"], command["do"]
        do = self._do.get(name)
        if do is None:
            client.put(refusal(number, unknown("command", name[:40], list(self._do))))
            return
        if client.role != "control" and name != "properties":
            client.put(refusal(number, "this page may look only"))
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
        if name != "properties":
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
        if self.builder.path is not None or self._target is not None or not name:
            return displayed(str(self.builder.save(self.builder.path or self._target)))
        path = Path(str(name))
        if path.name != str(name) or path.suffix != ".xml":
            raise ValueError("the name must be that of a file (.xml), without a folder")
        return displayed(str(self.builder.save(path)))

    def _read(self, _: dict[str, Any]) -> None:
        """Read the file again, which somebody else has changed."""
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
        """Return the attributes that an element has and may have."""
        node = self.builder.element(_text(given, "name"))
        rows = properties(schema_of(self.builder.document), path_of(node))
        known = {row.name for row in rows}
        listed = [
            {
                "name": row.name, "value": node.attributes.get(row.name), "default": row.default,
                "choices": row.choices, "required": row.required, "help": row.help,
                "type": row.type, "units": [unit for unit, _ in row.kind.units] if row.kind else [],
            }
            for row in rows
        ]  # fmt: skip
        listed += [
            {"name": name, "value": value, "choices": [], "help": "unknown", "units": []}
            for name, value in node.attributes.items()
            if name not in known
        ]
        children = [{"name": address(each), "tag": each.tag} for each in node.children]
        return {"tag": node.tag, "rows": listed, "children": children}

    def _try(self, _: dict[str, Any]) -> str:
        self.builder.world()  # or says what is wrong
        return self._start_run(self.builder)


def _operations() -> list[dict[str, Any]]:
    """Return the operations on what is selected, with the fields of their forms."""
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
        if row.things != "none" and not row.attributes and row.name != "text"
    ]  # fmt: skip


def _named(root: Node) -> list[tuple[Node, str]]:
    """Return the elements below the root, and those of the ground, with their names."""
    known = {id(node): name for name, node in ids(root).items()}
    grounds = [each for each in root.children if each.tag == "surface"]
    nodes = [*root.children, *(child for ground in grounds for child in ground.children)]
    return [(node, known.get(id(node)) or address(node)) for node in nodes]


def _thing(node: Node, name: str) -> dict[str, Any]:
    return {"name": name, "tag": node.tag, "attributes": node.attributes}


def _names(root: Node, tag: str, library: list[Document]) -> list[str]:
    nodes = [*root.children, *(child for each in library for child in each.root.children)]
    return [node.attributes.get("name", "") for node in nodes if node.tag == tag]


def _area(world: WorldModel) -> dict[str, float]:
    area = world.area
    return {
        "x": area.x_min_m, "y": area.y_min_m, "length": area.length_m, "width": area.width_m,
        "edge": area.edge_m,
    }  # fmt: skip


def _problems(builder: WorldBuilder) -> list[dict[str, Any]]:
    """Return what is wrong, with the elements that it is about, by the lines of these."""
    found = builder.problems()
    document, rows = builder.document, list[tuple[int, int, str]]()
    for node, name in _named(document.root) if found else ():
        rows.append((node.line, node.line + document.text.count(b"\n", node.begin, node.end), name))
    return [
        {
            "text": each.text, "hint": each.hint, "line": each.location.line,
            "name": _at(rows, each) if each.location.file == document.file else "",
        }
        for each in found
    ]  # fmt: skip


def _at(rows: list[tuple[int, int, str]], found: Diagnostic) -> str:
    """Return the name of the smallest element at the line of a message."""
    line = found.location.line
    around = [(last - first, name) for first, last, name in rows if first <= line <= last]
    return min(around)[1] if around else ""


def _text(given: dict[str, Any], name: str) -> str:
    value = given.get(name)
    if not isinstance(value, str) or len(value) > _LONGEST:
        raise ValueError(f"{name!r} must be a text")
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
