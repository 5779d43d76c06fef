"""Names of elements in a document: their ids, or else their paths.

`crate` is the element with this id, given or by default (`wall0`); `area`, `surface/ramp[1]` and
`sensor[3]/position` are elements by their tags, counted from 0; `define[table]/leg0` is a part of a
definition. So page, shell and Python name the same elements, with and without an id.

>>> from crs_cc.builder.document import Document
>>> room = Document(b"<world><wall/><define name='t'><box id='top'/></define></world>", "room.xml")
>>> find(room.root, "wall0").tag, find(room.root, "define[t]/top").tag
('wall', 'box')
>>> address(find(room.root, "define[t]/top"))
'define[t]/top'
>>> find(room.root, "wal0")
Traceback (most recent call last):
ValueError: unknown element 'wal0' (known: wall0, define[t]); did you mean 'wall0'?
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Final

from crs_cc.builder.spans import Node
from crs_cc.core.suggest import closest, unknown
from crs_cc.sim.files.object_ids import TAGS_WITH_ID

_STEP: Final = re.compile(r"([A-Za-z-]+)(?:\[([^\]]*)\])?")
_ENDING: Final = re.compile(r"(.*?)([-_.]?)([0-9]+)")
_NAMED: Final = ("id", "name")

REFERENCES: Final[Mapping[str, tuple[str, ...]]] = {
    "degradation": ("robot",),
    "shut": ("from", "to"),
    "approach": ("object",),
    "no-collision": ("except", "until"),
    "cool": ("objects",),
    "bring": ("objects",),
    "follow": ("target", "until"),
    "goal": ("robots", "after"),
}
"""The attributes of each element that name other elements by their ids."""


def ids(parent: Node) -> dict[str, Node]:
    """Return the elements below a parent that have an id, given or by default, by these."""
    found: dict[str, Node] = {}
    counts: Counter[str] = Counter()
    for child in parent.children:
        if child.tag in TAGS_WITH_ID:
            default = f"{child.tag}{counts[child.tag]}"
            counts[child.tag] += 1
            found.setdefault(child.attributes.get("id", default), child)
    return found


def id_of(node: Node) -> str:
    """Return an element's id, given or by default; empty if it has none."""
    if node.tag not in TAGS_WITH_ID or node.parent is None:
        return ""
    before = (each for each in node.parent.children if each.tag == node.tag)
    return node.attributes.get("id") or f"{node.tag}{next(_index(before, node))}"


def find(root: Node, name: str) -> Node:
    """Return the element with a name.

    Raises:
        ValueError: there is none; the message lists the existing ones.
    """
    node = root
    if name in ("", root.tag):
        return root
    for step in name.split("/"):
        found = ids(node).get(step) or _by_tag(node, step)
        if found is None:
            known = [address(each).rpartition("/")[2] for each in node.children]
            meant = closest(step, known)
            wrong = unknown("element", step, known)
            raise ValueError(f"{wrong}; did you mean {meant!r}?" if meant else wrong)
        node = found
    return node


def find_all(root: Node, names: Sequence[str]) -> list[Node]:
    """Return the elements with names, each as `find` does, in one pass for those with ids.

    Raises:
        ValueError: there is none with one of the names.
    """
    known = ids(root) if len(names) > 1 else {}
    known.pop(root.tag, None)
    return [known.get(name) or find(root, name) for name in names]


def _by_tag(node: Node, step: str) -> Node | None:
    parts = _STEP.fullmatch(step)
    if parts is None:
        return None
    tag, key = parts[1], parts[2]
    among = [each for each in node.children if each.tag == tag]
    if key is None:
        return among[0] if len(among) == 1 else None
    if key.isdecimal() and len(key) < 10:
        return among[int(key)] if int(key) < len(among) else None
    return next((each for each in among if key in _keys(each)), None)


def _keys(node: Node) -> list[str]:
    return [node.attributes[name] for name in _NAMED if name in node.attributes]


def address(node: Node) -> str:
    """Return the name by which `find` finds an element."""
    steps: list[str] = []
    while node.parent is not None:
        steps.append(_step(node, node.parent))
        node = node.parent
    return "/".join(reversed(steps)) or node.tag


def _step(node: Node, parent: Node) -> str:
    own = id_of(node)
    if own and "/" not in own and ids(parent).get(own) is node:
        return own
    among = [each for each in parent.children if each.tag == node.tag]
    if len(among) == 1 and "name" not in node.attributes:
        return node.tag
    key = node.attributes.get("name", "")
    if key and _by_tag(parent, f"{node.tag}[{key}]") is node and "/" not in key:
        return f"{node.tag}[{key}]"
    return f"{node.tag}[{next(_index(iter(among), node))}]"


def _index(among: Iterator[Node], node: Node) -> Iterator[int]:
    return (number for number, each in enumerate(among) if each is node)


def named(root: Node) -> list[tuple[Node, str]]:
    """Return the elements below the root, those of ground and communication too, by their names."""
    known = {id(node): name for name, node in ids(root).items()}
    nodes = list[Node]()
    for each in root.children:
        nodes.append(each)
        if each.tag in ("surface", "communication"):
            nodes += each.children
    return [(node, known.get(id(node)) or address(node)) for node in nodes]


def unused_name(name: str, used: Collection[str]) -> str:
    """Return a name like another that is not used: the next number.

    >>> unused_name("crate", ["crate"]), unused_name("rack-a1", ["rack-a1", "rack-a2"])
    ('crate-2', 'rack-a3')
    >>> unused_name("x", [])
    'x'
    """
    if name not in used:
        return name
    parts = _ENDING.fullmatch(name)
    begin, number = (parts[1] + parts[2], int(parts[3]) + 1) if parts else (f"{name}-", 2)
    while f"{begin}{number}" in used:
        number += 1
    return f"{begin}{number}"


def references(root: Node) -> Iterator[tuple[Node, str, list[str]]]:
    """Yield element, attribute and ids wherever elements are named by their ids."""
    for node in root.all():
        for name in REFERENCES.get(node.tag, ()):
            if name in node.attributes:
                yield node, name, node.attributes[name].split()


def referenced_ids(root: Node) -> set[str]:
    """Return all ids by which elements are named anywhere, parts by those of their objects."""
    words = {word for _, _, found in references(root) for word in found}
    return words | {word.partition(".")[0] for word in words}


def outermost(nodes: Sequence[Node]) -> list[Node]:
    """Return elements once each in the order of the document, without those inside of others."""
    wanted = {id(node): node for node in nodes}
    found = []
    for node in sorted(wanted.values(), key=lambda each: each.begin):
        around = node.parent
        while around is not None and id(around) not in wanted:
            around = around.parent
        if around is None:
            found.append(node)
    return found
