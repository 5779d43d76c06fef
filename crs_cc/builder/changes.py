"""The simple changes: add, set, remove, move, turn, mirror.

Each function returns a `Plan` and changes nothing. Values are texts as in the file.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from crs_cc.builder import markup
from crs_cc.builder.addresses import address, ids, outermost, referenced_ids, unused_name
from crs_cc.builder.document import Document, Splice
from crs_cc.builder.motion import Motion, movable, moved
from crs_cc.builder.mounting import is_mounted, mounted
from crs_cc.builder.naming import rename_references
from crs_cc.builder.spans import Node
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.object_ids import TAGS_WITH_ID
from crs_cc.sim.files.schema_properties import children, properties

IN_SURFACE: Final = ("heightmap", "ramp", "plateau")
"""Elements of the ground."""

_SHARED: Final = {
    **dict.fromkeys(IN_SURFACE, "surface"),
    **dict.fromkeys(("channel", "shut"), "communication"),
}
"""The element of a world, of which there is one, that each of these goes into."""

_CONDITIONS: Final = (
    *("reach", "approach", "visit", "no-collision", "cool", "cover", "bring", "follow"),
)
"""Elements each of which has a goal of its own around it."""


@dataclass(slots=True)
class Plan:
    """A change that is worked out, and not made yet.

    Attributes:
        splices: what it replaces.
        names: the names that new or renamed elements will have.
    """

    splices: list[Splice]
    names: list[str] = field(default_factory=list)


def schema_of(document: Document) -> str:
    """Return the file of the schema of a document."""
    return "robot.xsd" if document.root.tag == "robot-definition" else "world.xsd"


def path_of(node: Node) -> list[str]:
    """Return the tag of an element after those around it, outermost first; a clip is a world."""
    tags = [node.tag]
    while node.parent is not None:
        node = node.parent
        tags.append(node.tag)
    if tags[-1] == "clip":
        tags[-1] = "world"
    return tags[::-1]


def path_inside(parent: Node, tag: str) -> list[str]:
    """Return the tag of a new element after those that will be around it."""
    home = home_of(parent, tag)
    return [*path_of(parent), *([home] if home else []), tag]


def home_of(parent: Node, tag: str) -> str:
    """Return the element between the world and a new element of a kind; empty if there is none."""
    if parent.tag != "world":
        return ""
    return _SHARED.get(tag) or ("goal" if tag in _CONDITIONS else "")


def pins(document: Document, tags: Collection[str], gone: Sequence[Node] = ()) -> list[Splice]:
    """Return the splices that give elements their default ids where those are referred to.

    A default id counts the elements of its kind: those that come or go before it would change it.

    Args:
        document: the document.
        tags: the kinds that come or go.
        gone: the elements that are removed or rewritten.
    """
    used, left = referenced_ids(document.root), set(map(id, gone))
    found: list[Splice] = []
    for name, node in ids(document.root).items():
        stays = node.tag in tags and id(node) not in left
        if stays and name in used and "id" not in node.attributes:
            found += markup.set_attributes(document, node, {"id": name}, ("id",))
    return found


def add(
    document: Document, parent: Node, tag: str, values: Mapping[str, str], text: str = ""
) -> Plan:
    """Add an element.

    Args:
        document: the document.
        parent: the element around it; ramps, plateaus and height maps of a world go into its
            surface, channels into its communication, conditions each into a new goal.
        tag: its kind.
        values: its attributes; an id is made up if it can have one.
        text: its own text.

    Raises:
        ValueError: there is no such element, or a value is not allowed in XML.
    """
    home = home_of(parent, tag)
    if home:
        inside = next((each for each in parent.children if each.tag == home), None)
        if inside is None or home == "goal":
            own = f"{tag}[{values['name']}]" if "name" in values else tag
            return _add_with_home(document, home, markup.element(tag, values, text), own)
        parent = inside
    known = children(schema_of(document), path_of(parent))
    if tag not in known:
        raise ValueError(unknown(f"element of <{parent.tag}>", tag, known))
    name, count = "", sum(each.tag == tag for each in parent.children)
    if tag in TAGS_WITH_ID:
        name = values.get("id") or unused_name(f"{tag}{count}", ids(parent))
        values = {"id": name, **values}
    elif "name" in values:
        name = f"{tag}[{values['name']}]"
    own = f"{tag}[{count}]" if count else tag
    new = markup.element(tag, values, text)
    where = "" if parent.parent is None else f"{address(parent)}/"
    return Plan(markup.insert(document, parent, tag, [new]), [where + (name or own)])


def _add_with_home(document: Document, home: str, inner: str, own: str) -> Plan:
    """Add an element, given as text and by its own name, in a new one that it goes into."""
    world = document.root
    if home not in TAGS_WITH_ID:
        new = markup.element(home, {}, "", inner)
        return Plan(markup.insert(document, world, home, [new]), [f"{home}/{own}"])
    count = sum(each.tag == home for each in world.children)
    name = unused_name(f"{home}{count}", ids(world))
    new = markup.element(home, {"id": name}, "", inner)
    return Plan(markup.insert(document, world, home, [new]), [name])


def set_values(document: Document, nodes: Sequence[Node], values: Mapping[str, str | None]) -> Plan:
    """Set attributes of elements; None removes one. What refers to a new id or name follows.

    Raises:
        ValueError: a value is not allowed in XML, or several elements would get one id.
    """
    nodes = list({id(node): node for node in nodes}.values())
    if len(nodes) > 1 and not {"id", "name"}.isdisjoint(values):
        raise ValueError("several elements cannot have the same id or name")
    splices: list[Splice] = []
    for node in nodes:
        order = [row.name for row in properties(schema_of(document), path_of(node))]
        splices += markup.set_attributes(document, node, values, order)
        splices += rename_references(document, node, values)
    return Plan(splices)


def set_text(document: Document, node: Node, text: str) -> Plan:
    """Set the text of an element that has no other elements in it."""
    return Plan(markup.set_text(document, node, text))


def remove(document: Document, nodes: Sequence[Node]) -> Plan:
    """Remove elements.

    Raises:
        ValueError: the root or the area is among them.
    """
    whole = outermost(nodes)
    for node in whole:
        if node.parent is None or (node.tag == "area" and node.parent.tag == "world"):
            raise ValueError(f"<{node.tag}> cannot be removed")
    splices = markup.remove(document, whole)
    return Plan(splices + pins(document, {node.tag for node in whole}, whole))


def move(document: Document, nodes: Sequence[Node], motion: Motion) -> Plan:
    """Move, turn or mirror elements as one body.

    Raises:
        ValueError: one of them has no position.
    """
    splices: list[Splice] = []
    for node in outermost(nodes):
        if is_mounted(node):
            splices += mounted(document, node, motion)
            continue
        parts = list(movable(node))
        for part in parts or [node]:
            order = [row.name for row in properties(schema_of(document), path_of(part))]
            values = moved(document, part, motion)
            splices += markup.set_attributes(document, part, values, order)
    return Plan(splices)
