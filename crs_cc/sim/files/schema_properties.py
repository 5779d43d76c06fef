"""The possible attributes of an element: names, kinds, defaults and help, from the schema.

>>> box = properties("world.xsd", ("world", "box"))
>>> [row.name for row in box][:4], box[3].kind.name, box[3].default
(['id', 'x', 'y', 'heading'], 'an angle', '0')
>>> children("world.xsd", ("world", "surface"))
('heightmap', 'ramp', 'plateau')
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Final

from crs_cc.core.quantity import ANGLE, HEAT, LENGTH, MASS, TIME, Kind
from crs_cc.sim.files.schema_names import Declarations, Node
from crs_cc.sim.files.xml_document import schema_document

_XS: Final = "{http://www.w3.org/2001/XMLSchema}"
_KINDS: Final = {"length": LENGTH, "angle": ANGLE, "mass": MASS, "time": TIME, "heat": HEAT}


@dataclass(frozen=True, slots=True)
class Property:
    """An attribute that an element may have.

    Attributes:
        name: its name.
        type: its type in the schema, such as `length`; empty for one of its own.
        kind: the quantity, if the type determines it.
        required: whether it must be there.
        default: its default, if the schema has one.
        choices: the values that are allowed; empty for any of its type.
        help: what it means.
    """

    name: str
    type: str
    kind: Kind | None
    required: bool
    default: str | None
    choices: tuple[str, ...]
    help: str


def properties(schema: str, tags: Sequence[str]) -> tuple[Property, ...]:
    """Return the attributes of an element in their usual order; empty if it is unknown.

    Args:
        schema: the file of the schema, such as `world.xsd`.
        tags: the element's tag and those around it, outermost first.
    """
    return _properties(schema, tuple(tags))


@cache
def _properties(schema: str, tags: tuple[str, ...]) -> tuple[Property, ...]:
    declared = _declarations(schema)
    found = declared.at(tags)
    parts = [] if found is None else declared.parts(found)
    return tuple(_property(declared, each) for each in parts if each.tag == f"{_XS}attribute")


def children(schema: str, tags: Sequence[str]) -> tuple[str, ...]:
    """Return the tags of the elements that an element may contain."""
    declared = _declarations(schema)
    found = declared.at(tags)
    parts = [] if found is None else declared.parts(found)
    return tuple(str(each.get("name")) for each in parts if each.tag == f"{_XS}element")


@cache
def _declarations(schema: str) -> Declarations:
    return Declarations(schema_document(schema).getroot())


def _property(declared: Declarations, node: Node) -> Property:
    name = str(node.get("type") or "").removeprefix("xs:")
    own = declared.type_of(node)
    choices = tuple(each.get("value") for each in node.iter(f"{_XS}enumeration"))
    return Property(
        str(node.get("name")),
        name,
        _KINDS.get(name),
        node.get("use") == "required",
        node.get("default"),
        choices,
        _help(node) or ("" if own is None else _help(own)),
    )


def _help(node: Node) -> str:
    text = node.findtext(f"{_XS}annotation/{_XS}documentation") or ""
    return " ".join(text.split())
