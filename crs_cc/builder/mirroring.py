"""Mirroring: objects whose definitions are not symmetric get mirrored definitions.

An object that is mirrored keeps its definition if that looks the same from both sides of its x
axis. Otherwise it gets one with mirrored parts, `desk-mirrored`, which is made once: a definition
that is there already is used, also the first one when an object is mirrored back.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Hashable, Sequence
from typing import Final, TypeAlias

from crs_cc.builder import changes, markup
from crs_cc.builder.addresses import address, outermost, unused_name
from crs_cc.builder.arrangement import written
from crs_cc.builder.changes import Plan
from crs_cc.builder.composition import definitions
from crs_cc.builder.document import Document
from crs_cc.builder.motion import Motion, corners, frame, moved, position, quantity
from crs_cc.builder.spans import Node
from crs_cc.core.quantity import ANGLE, LENGTH

ACROSS: Final = Motion.mirror(0.0, 0.0, 0.0)
"""The reflection that exchanges left and right of what points along x."""

_PLACES: Final = ("id", "x", "y", "heading", "x1", "y1", "x2", "y2", "points", "ref")
_AS_IT_IS: Final = Motion()
_DIGITS: Final = 5
_HALF_TURNS: Final = {"box": 2, "cylinder": 0}

Form: TypeAlias = Counter[Hashable]
"""The parts of a definition, however they are written."""


class _Mirror:
    """The definitions that a document knows, and those that mirrored objects need."""

    def __init__(self, document: Document, library: Sequence[Document]) -> None:
        self.document = document
        self.new: dict[str, str] = {}
        self._known = {name: (home, node) for home in reversed(library)
                       for name, node in definitions(home.root).items()}  # fmt: skip
        own = definitions(document.root).items()
        self._known.update({name: (document, node) for name, node in own})
        self._other: dict[str, str] = {}

    def ref(self, ref: str) -> str:
        """Return the definition that looks like the mirror image of another.

        Raises:
            ValueError: it would have to be made of one in another file.
        """
        if ref not in self._known or ref in self._other:
            return self._other.get(ref, ref)
        self._other[ref] = ref  # also ends the circle of a definition that contains itself
        home, node = self._known[ref]
        wanted = self._form(home, node, ACROSS)
        if wanted == self._form(home, node, _AS_IT_IS):
            return ref
        same = [name for name, (own, each) in self._known.items()
                if len(each.children) == len(node.children)
                and self._form(own, each, _AS_IT_IS) == wanted]  # fmt: skip
        self._other[ref] = same[0] if same else self._create(ref, home, node)
        return self._other[ref]

    def _create(self, ref: str, home: Document, node: Node) -> str:
        if home is not self.document:
            raise ValueError(f"the definition {ref!r} is not symmetric, and in {home.file}")
        name = unused_name(f"{ref}-mirrored", {*self._known, *self.new})
        parts = [
            written(home, part, {**moved(home, part, ACROSS), **self.turned(part)})
            for part in node.children
        ]
        self.new[name] = markup.element("define", {"name": name}, "", *parts)
        return name

    def turned(self, node: Node) -> dict[str, str | None]:
        """Return the definition that an object has when it is mirrored."""
        return {"ref": self.ref(node.attributes.get("ref", ""))} if node.tag == "object" else {}

    def _form(self, home: Document, node: Node, motion: Motion) -> Form:
        return Counter(self._part(home, part, motion) for part in node.children)

    def _part(self, home: Document, node: Node, motion: Motion) -> Hashable:
        """Return a part's kind, looks and place after a motion, equal for what looks the same."""
        looks = frozenset(item for item in node.attributes.items() if item[0] not in _PLACES)
        if node.tag == "wall":
            ends = [[quantity(node, name, LENGTH) for name in pair] for pair in _ENDS]
            return node.tag, looks, frozenset(_rounded(*motion.point(x, y)) for x, y in ends)
        if node.tag == "polygon":
            place = frame(node)
            points = (motion.point(*place.point(x, y)) for x, y in corners(node))
            return node.tag, looks, frozenset(_rounded(x, y) for x, y in points)
        ref = node.attributes.get("ref", "")
        if motion.mirrors and ref:
            ref = self.ref(ref)
        turn_rad = motion.heading(quantity(node, "heading", ANGLE, 0.0))
        turns = _HALF_TURNS.get(node.tag, 1)
        heading = _rounded(math.cos(turns * turn_rad), math.sin(turns * turn_rad))
        return node.tag, looks, ref, _rounded(*motion.point(*position(home, node))), heading


_ENDS: Final = (("x1", "y1"), ("x2", "y2"))


def _rounded(x: float, y: float) -> tuple[float, float]:
    return round(x, _DIGITS) + 0.0, round(y, _DIGITS) + 0.0


def mirror(
    document: Document, nodes: Sequence[Node], motion: Motion, library: Sequence[Document]
) -> Plan:
    """Mirror elements as one body.

    Args:
        document: the document.
        nodes: the elements.
        motion: the reflection.
        library: the files that the document includes.

    Raises:
        ValueError: one of them cannot be mirrored.
    """
    mirrors = _Mirror(document, library)
    plan = changes.move(document, nodes, motion)
    for node in outermost(nodes):
        try:
            values = mirrors.turned(node)
        except ValueError as wrong:
            raise ValueError(f"{address(node)} cannot be mirrored: {wrong}") from None
        plan.splices += markup.set_attributes(document, node, values)
    texts = list(mirrors.new.values())
    if texts:
        plan.splices += markup.insert(document, document.root, "define", texts)
    return plan
