"""Elements and attributes that a schema does not define, with suggestions.

The validator (libxml2) stops at the first unknown element: it does not check those after it, and
does not always know what it expected. Names are compared without it.

>>> from lxml import etree
>>> schema = etree.XML('''<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">
... <xs:element name="room"><xs:complexType><xs:choice maxOccurs="unbounded">
...   <xs:element name="wall"><xs:complexType><xs:attribute name="length"/></xs:complexType>
... </xs:element></xs:choice></xs:complexType></xs:element></xs:schema>''')
>>> room = etree.XML('<room><wal/><wall lenght="1m"/></room>')
>>> for name in unknown_names(room, schema):
...     print(name.text, "-", name.hint)
unexpected element <wal>; expected <wall> - did you mean <wall>?
unknown attribute 'lenght' in <wall> - did you mean 'length'?
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Final, NamedTuple, TypeAlias

Node: TypeAlias = Any
"""An element of lxml."""

_XS: Final = "{http://www.w3.org/2001/XMLSchema}"
_ELEMENT, _ATTRIBUTE, _ANY = _LEAVES = (f"{_XS}element", f"{_XS}attribute", f"{_XS}any")
_COMPLEX_TYPE: Final = f"{_XS}complexType"
_SIMPLE_TYPE: Final = f"{_XS}simpleType"


class UnknownName(NamedTuple):
    """A name that the schema does not allow at its location.

    Attributes:
        text: the error message.
        hint: the suggested name, or the known ones.
    """

    line: int
    text: str
    hint: str


def unknown_names(root: Node, schema: Node) -> Iterator[UnknownName]:
    """Yield the names in a document that its schema does not allow, in the order of the document.

    The contents of an unknown element are not checked.
    """
    return Declarations(schema).unknown(root)


class Declarations:
    """What a schema declares."""

    def __init__(self, schema: Node) -> None:
        self._named = {(each.tag, each.get("name")): each for each in schema}

    def unknown(self, root: Node) -> Iterator[UnknownName]:
        """Yield the names in a document that are not declared."""
        declared = self._named.get((_ELEMENT, root.tag))
        work = [] if declared is None else [(root, declared)]
        while work:
            node, declaration = work.pop()
            parts = self.parts(declaration)
            yield from _unknown_attributes(node, _names(parts, _ATTRIBUTE))
            if _names(parts, _ANY):
                continue
            known = _names(parts, _ELEMENT)
            there = {child.tag for child in node}
            free = [name for name, each in known.items() if name not in there or _repeats(each)]
            inner = []
            for child in node:
                if child.tag in known:
                    inner.append((child, known[child.tag]))
                else:
                    yield _unexpected(child, known, free)
            work += reversed(inner)

    def at(self, tags: Sequence[str]) -> Node | None:
        """Return the declaration of an element by its tag and those around it, outermost first."""
        found = self._named.get((_ELEMENT, tags[0]))
        for tag in tags[1:]:
            if found is None:
                return None
            found = _names(self.parts(found), _ELEMENT).get(tag)
        return found

    def type_of(self, declaration: Node) -> Node | None:
        """Return the type that a declaration names, if the schema has it."""
        for kind in (_COMPLEX_TYPE, _SIMPLE_TYPE):
            if (kind, declaration.get("type")) in self._named:
                return self._named[kind, declaration.get("type")]
        return None

    def parts(self, declaration: Node) -> list[Node]:
        """Return the declarations of an element's attributes and children, however nested."""
        found: list[Node] = []
        work = [*declaration, *self._referred(declaration)]
        for node in work:
            if node.tag in _LEAVES:
                found.append(node)
            elif node.tag != _SIMPLE_TYPE:
                work += [*node, *self._referred(node)]
        return found

    def _referred(self, node: Node) -> Iterator[Node]:
        """Yield the references of a declaration: a type, the type that it extends, a group."""
        for kind in ("type", "base"):
            if (_COMPLEX_TYPE, node.get(kind)) in self._named:
                yield self._named[_COMPLEX_TYPE, node.get(kind)]
        if (node.tag, node.get("ref")) in self._named:
            yield self._named[node.tag, node.get("ref")]


def _names(parts: Sequence[Node], tag: str) -> dict[str, Node]:
    """Return the declarations of one kind by their names."""
    return {str(each.get("name")): each for each in parts if each.tag == tag}


def _unknown_attributes(node: Node, known: Iterable[str]) -> Iterator[UnknownName]:
    for name in map(str, node.attrib):
        if name not in known:
            line, text = node.sourceline or 0, f"unknown attribute {name!r} in <{node.tag}>"
            meant = _closest(name, known)
            listed = ", ".join(known) or "none"
            hint = f"did you mean {meant!r}?" if meant else f"known attributes: {listed}"
            yield UnknownName(line, text, hint)


def _unexpected(child: Node, known: Iterable[str], free: Sequence[str]) -> UnknownName:
    """Return the message about an element, with the names that are allowed there."""
    listed = " or ".join(f"<{name}>" for name in free) or "nothing more"
    meant = _closest(str(child.tag), known)
    hint = f"did you mean <{meant}>?" if meant else ""
    text = f"unexpected element <{child.tag}>; expected {listed}"
    return UnknownName(child.sourceline or 0, text, hint)


def _repeats(declaration: Node) -> bool:
    """Return whether an element is allowed more than once."""
    node: Node = declaration
    while node is not None and node.tag != _COMPLEX_TYPE:
        if node.get("maxOccurs", "1") != "1":
            return True
        node = node.getparent()
    return False


def _closest(name: str, known: Iterable[str]) -> str:
    return next(iter(difflib.get_close_matches(name, list(known), n=1)), "")
