"""Elements and attributes that a schema has no name for, with the name that was probably meant.

The validator (libxml2) stops at the first element that it does not know: it looks at nothing behind
it, and cannot always say what it had expected. Names can be compared without it.

>>> from lxml import etree
>>> schema = etree.XML('''<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">
... <xs:element name="room"><xs:complexType><xs:choice maxOccurs="unbounded">
...   <xs:element name="wall"><xs:complexType><xs:attribute name="length"/></xs:complexType>
... </xs:element></xs:choice></xs:complexType></xs:element></xs:schema>''')
>>> room = etree.XML('<room><wal/><wall lenght="1m"/></room>')
>>> for name in unknown_names(room, schema):
...     print(name.text, "-", name.hint)
<wal> is not expected here; expected <wall> - did you mean <wall>?
<wall> has no attribute 'lenght' - did you mean 'length'?
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator
from typing import Any, Final, NamedTuple, TypeAlias

Node: TypeAlias = Any
"""An element of lxml's."""

_XS: Final = "{http://www.w3.org/2001/XMLSchema}"


class UnknownName(NamedTuple):
    """A name that the schema does not know there.

    Attributes:
        line: where it stands.
        text: what is wrong.
        hint: what may have been meant, else what there is.
    """

    line: int
    text: str
    hint: str


def unknown_names(root: Node, schema: Node) -> Iterator[UnknownName]:
    """Gives the names in a document that its schema does not know, in the order of the document.

    What stands in an element that is not known itself is not looked at.
    """
    return _Schema(schema).unknown(root)


class _Schema:
    def __init__(self, schema: Node) -> None:
        self._types = {each.get("name"): each for each in schema.iterfind(f"{_XS}complexType")}
        self._groups = {each.get("name"): each for each in schema.iterfind(f"{_XS}attributeGroup")}
        self._elements = {each.get("name"): each for each in schema.iterfind(f"{_XS}element")}

    def unknown(self, root: Node) -> Iterator[UnknownName]:
        declared = self._elements.get(root.tag)
        work = [] if declared is None else [(root, declared)]
        while work:
            node, declaration = work.pop()
            yield from self._unknown_attributes(node, declaration)
            known = self._children(declaration)
            if known is None:
                continue
            inner = []
            for child in node:
                if child.tag in known:
                    inner.append((child, known[child.tag]))
                else:
                    yield _unexpected(child, node, known)
            work += reversed(inner)

    def _unknown_attributes(self, node: Node, declaration: Node) -> Iterator[UnknownName]:
        known = self._attributes(self._type(declaration))
        for name in map(str, node.attrib):
            if name not in known:
                line, text = node.sourceline or 0, f"<{node.tag}> has no attribute {name!r}"
                meant = _closest(name, known)
                listed = ", ".join(known) or "none"
                hint = f"did you mean {meant!r}?" if meant else f"its attributes are: {listed}"
                yield UnknownName(line, text, hint)

    def _type(self, declaration: Node) -> Node:
        """Gives the type of an element: its own one, or one that has a name; None for text."""
        name = declaration.get("type")
        return declaration.find(f"{_XS}complexType") if name is None else self._types.get(name)

    def _children(self, declaration: Node) -> dict[str, Node] | None:
        """Gives the declarations of what may stand in an element; None where anything may."""
        found: dict[str, Node] = {}
        work = [self._type(declaration)]
        for node in work:
            for each in () if node is None else node:
                if each.tag == f"{_XS}element":
                    found[str(each.get("name"))] = each
                elif each.tag == f"{_XS}any":
                    return None
                elif each.tag in {f"{_XS}{kind}" for kind in ("sequence", "choice", "all")}:
                    work.append(each)
        return found

    def _attributes(self, holder: Node) -> list[str]:
        names: list[str] = []
        for each in () if holder is None else holder:
            if each.tag == f"{_XS}attribute":
                names.append(str(each.get("name")))
            elif each.tag == f"{_XS}attributeGroup":
                names += self._attributes(self._groups.get(each.get("ref")))
        return names


def _unexpected(child: Node, parent: Node, known: dict[str, Node]) -> UnknownName:
    there = {each.tag for each in parent}
    names = [name for name, each in known.items() if name not in there or _repeats(each)]
    listed = " or ".join(f"<{name}>" for name in names) or "nothing more"
    meant = _closest(str(child.tag), known)
    hint = f"did you mean <{meant}>?" if meant else ""
    text = f"<{child.tag}> is not expected here; expected {listed}"
    return UnknownName(child.sourceline or 0, text, hint)


def _repeats(declaration: Node) -> bool:
    """Tells whether an element may stand there more than once."""
    node: Node = declaration
    while node is not None and node.tag != f"{_XS}complexType":
        if node.get("maxOccurs", "1") != "1":
            return True
        node = node.getparent()
    return False


def _closest(name: str, known: Iterable[str]) -> str:
    return next(iter(difflib.get_close_matches(name, list(known), n=1)), "")
