"""References to elements by name, which are updated when a name changes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Final

from crs_cc.builder import markup
from crs_cc.builder.addresses import id_of, references
from crs_cc.builder.document import Document, Splice
from crs_cc.builder.spans import Node

_BY_NAME: Final = {"define": "ref", "material": "material"}
"""The attribute that names an element of each kind by its own attribute `name`."""


def rename_references(
    document: Document, node: Node, values: Mapping[str, str | None]
) -> Iterator[Splice]:
    """Yield the splices that make references follow an element whose id or name changes."""
    before, after = id_of(node), values.get("id")
    if before and after and node.parent is document.root and before != after:
        for other, attribute, words in references(document.root):
            new = [_followed(word, before, after) for word in words]
            if new != words and other is not node:
                yield from markup.set_attributes(document, other, {attribute: " ".join(new)})
    key, name = _BY_NAME.get(node.tag, ""), values.get("name")
    if key and name:
        for other in document.root.all():
            if other.attributes.get(key) == node.attributes.get("name"):
                yield from markup.set_attributes(document, other, {key: name})


def _followed(word: str, before: str, after: str) -> str:
    """Return a reference after a change of an id; parts are named by their objects.

    >>> _followed("table.leg0", "table", "desk"), _followed("tables", "table", "desk")
    ('desk.leg0', 'tables')
    """
    whole, dot, part = word.partition(".")
    if word == before:
        return after
    return f"{after}{dot}{part}" if dot and whole == before else word
