"""The forms of the world builder's page, from the schema: attributes of elements, new elements."""

from __future__ import annotations

import re
from itertools import chain
from typing import Any, Final

from crs_cc.builder.addresses import address
from crs_cc.builder.changes import path_inside, path_of, schema_of
from crs_cc.builder.document import Document
from crs_cc.builder.spans import Node
from crs_cc.sim.files.schema_properties import Property, children, properties

MAX_SHOWN: Final = 100
"""Elements in another whose attributes are shown with it."""

_HOMES: Final = ("surface", "communication", "goal")
"""Elements of a world that come with what is in them."""

_DEFAULT: Final = re.compile(r"(?:Default:|If it is omitted,) ([^.,:;]+)")

_LISTED: Final = ("world", "robot-definition", "definitions", "surface", "communication")
"""Elements whose contents are elements of the list."""


def element_form(document: Document, node: Node) -> dict[str, Any]:
    """Return the present and possible attributes of an element and its children."""
    schema = schema_of(document)
    inner = [] if node.tag in _LISTED else [each for each in node.all() if each is not node]
    return {
        **_filled(schema, node),
        "children": [_filled(schema, each) for each in inner[:MAX_SHOWN]],
        "may": children(schema, path_of(node)),
    }


def new_form(document: Document, parent: Node, kind: str) -> dict[str, Any]:
    """Return the attributes that a new element may have, and the kinds that can be added.

    Args:
        document: the document.
        parent: the element around it.
        kind: its kind; by default the first that can be added.
    """
    schema = schema_of(document)
    kinds = children(schema, path_of(parent))
    if parent.tag == "world":
        inner = [children(schema, [parent.tag, each]) for each in _HOMES]
        kinds = (*(each for each in kinds if each not in (*_HOMES, "area")), *chain(*inner))
    kind = kind or next(iter(kinds), "")
    rows = properties(schema, path_inside(parent, kind))
    return {"kinds": kinds, "kind": kind, "rows": [_row(row, None) for row in rows]}


def _filled(schema: str, node: Node) -> dict[str, Any]:
    """Return an element with the attributes that it has and may have."""
    rows = properties(schema, path_of(node))
    known = {row.name for row in rows}
    listed = [_row(row, node.attributes.get(row.name)) for row in rows]
    listed += [
        {"name": name, "value": value, "choices": [], "help": "unknown", "units": []}
        for name, value in node.attributes.items()
        if name not in known
    ]
    text = None if rows or node.children else node.text.strip()
    return {"name": address(node), "tag": node.tag, "rows": listed, "text": text}


def _said_default(text: str) -> str | None:
    """Return the default that a help text states, if the schema has none.

    >>> _said_default("Colour seen by cameras. Default: grey.")
    'grey'
    >>> _said_default("Mass. If it is omitted, the object is fixed: nothing moves it.")
    'the object is fixed'
    """
    said = _DEFAULT.search(text)
    return said and said[1]


def _row(row: Property, value: str | None) -> dict[str, Any]:
    return {
        "name": row.name, "value": value, "default": row.default or _said_default(row.help),
        "choices": row.choices, "required": row.required, "help": row.help,
        "type": row.type, "units": [unit for unit, _ in row.kind.units] if row.kind else [],
    }  # fmt: skip
