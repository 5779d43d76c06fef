"""Objects made of parts: group elements into a definition, and dissolve an object into its parts.

>>> from crs_cc.builder.document import Document
>>> room = Document(b'''<world>
...   <box id="top" x="2m" y="1m" length="1m" width="60cm"/>
...   <cylinder id="leg" x="2.4m" y="1m" radius="2cm"/>
... </world>''', "room.xml")
>>> room.change("group", group(room, room.root.children, "table", "", {}).splices)
>>> print(room.text.decode())
<world>
  <define name="table">
    <box id="top" x="-0.2m" y="0m" length="1m" width="60cm"/>
    <cylinder id="leg" x="0.2m" y="0m" radius="2cm"/>
  </define>
  <object id="table" ref="table" x="2.2m" y="1m"/>
</world>
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from crs_cc.builder import markup
from crs_cc.builder.addresses import address, ids, outermost, unused_name
from crs_cc.builder.arrangement import Extents, around, written
from crs_cc.builder.changes import Plan, pins
from crs_cc.builder.document import Document, Splice
from crs_cc.builder.motion import Motion, frame, measure, moved, quantity
from crs_cc.builder.spans import Node
from crs_cc.core.quantity import LENGTH, MASS
from crs_cc.core.suggest import unknown
from crs_cc.core.units import INCH_M

PARTS: Final = ("wall", "box", "cylinder", "polygon", "object")
"""The elements that an object can be made of."""

_GRID_M: Final = 0.01


def group(
    document: Document, nodes: Sequence[Node], name: str, own_id: str, known: Extents
) -> Plan:
    """Make elements one object: a definition, and where they were, an object of it.

    The origin of the definition is in their middle. Masses add up to that of the object.

    Args:
        document: the document.
        nodes: the elements.
        name: the name of the definition.
        own_id: the id of the object; by default the name.
        known: what elements cover.

    Raises:
        ValueError: the name is taken, or an element cannot be a part of an object.
    """
    root, whole = document.root, outermost(nodes)
    if not name or name in definitions(root):
        raise ValueError(
            f"the definition {name!r} already exists" if name else "a definition has a name"
        )
    for node in whole:
        if node.tag not in PARTS or node.parent is not root:
            raise ValueError(f"{address(node)} cannot be a part of an object")
    if not whole:
        raise ValueError("no element to group")
    grid_m = INCH_M if document.length_unit in ("in", "ft") else _GRID_M
    centre = around(document, whole, known).centre_m
    x_m, y_m = (round(value / grid_m) * grid_m for value in centre)
    gone = {address(node) for node in whole}
    used = set(ids(root)) - gone
    parts = [
        written(document, node, {
            **moved(document, node, Motion.shift(-x_m, -y_m)),
            "mass": None,
            **_own_id(node),
        })
        for node in whole
    ]  # fmt: skip
    place = {
        "x": measure(LENGTH, x_m, document.length_unit),
        "y": measure(LENGTH, y_m, document.length_unit),
    }
    own_id = own_id or unused_name(name, used)
    new = {"id": own_id, "ref": name, **place, **_mass(whole)}
    define = markup.element("define", {"name": name}, "", *parts)
    return Plan(
        _replaced(document, whole, [define, markup.element("object", new)])
        + pins(document, {*(node.tag for node in whole), "object"}, whole),
        [own_id],
    )


def _own_id(node: Node) -> dict[str, str | None]:
    """Return the id that a part keeps, so that it does not depend on preceding elements."""
    return {"id": address(node)}


def _mass(nodes: Sequence[Node]) -> dict[str, str]:
    masses = [quantity(node, "mass", MASS) for node in nodes if "mass" in node.attributes]
    return {"mass": MASS.show(sum(masses))} if masses else {}


def _replaced(document: Document, nodes: Sequence[Node], texts: Sequence[str]) -> list[Splice]:
    """Return the splices that put new elements where the first of others was."""
    first = nodes[0]
    indent = markup.indent_of(document, first)
    joint = f"\n{indent}" if indent else ""
    text = joint.join(markup.indented(each, indent) for each in texts)
    place = Splice(first.begin, first.end, markup.encoded(document, text))
    return [place, *markup.remove(document, nodes[1:])]


def definitions(root: Node) -> dict[str, Node]:
    """Return the definitions in a document by their names."""
    return {node.attributes.get("name", ""): node for node in root.children if node.tag == "define"}


def ungroup(document: Document, node: Node) -> Plan:
    """Put the parts of an object where it is; the definition stays.

    Raises:
        ValueError: it is not an object, or its definition is in another file.
    """
    if node.tag != "object" or node.parent is None:
        raise ValueError(f"{address(node)} is not an object")
    known = definitions(document.root)
    ref = node.attributes.get("ref", "")
    if ref not in known:
        raise ValueError(unknown("definition in this file", ref, tuple(known)))
    whole, used = address(node).rpartition("/")[2], set(ids(node.parent))
    plan, texts = Plan([]), []
    for name, part in ids(known[ref]).items():
        new = unused_name(f"{whole}-{name}", used)
        used.add(new)
        plan.names.append(new)
        texts.append(written(document, part, {**moved(document, part, frame(node)), "id": new}))
    plan.splices = _replaced(document, [node], texts)
    plan.splices += pins(document, {"object", *(part.tag for part in known[ref].children)}, [node])
    return plan
