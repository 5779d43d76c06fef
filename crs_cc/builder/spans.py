"""The positions of elements and attributes in the bytes of an XML document.

No library writes XML back byte for byte: quotes, spaces between attributes and character references
are lost in a tree. Here the bytes are unchanged, and the tree has the location of each part of
them, so that a change replaces only the affected parts. Expat checks the syntax; the loader of
worlds checks everything else.

>>> room = parse(b"<world><wall id = 'w'  x1='1m'/></world>", "room.xml").root
>>> wall = room.children[0]
>>> wall.tag, wall.attributes, wall.value_at["x1"]
('wall', {'id': 'w', 'x1': '1m'}, Span(begin=27, end=29))
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final, NamedTuple
from xml.parsers import expat

from crs_cc.core.errors import WorldError
from crs_cc.core.source import Location
from crs_cc.sim.files.xml_document import MAX_BYTES

MAX_DEPTH: Final = 256
"""Maximum depth of elements, as that of libxml2."""

_CODECS: Final = {"": "utf-8", "utf-8": "utf-8", "us-ascii": "ascii", "iso-8859-1": "latin-1"}
_UTF_16: Final = (b"\xff\xfe", b"\xfe\xff", b"<\0", b"\0<")
_ATTRIBUTE: Final = re.compile(rb"""\s+([^\s=/>"'<]+)\s*=\s*(?:"([^"]*)"|'([^']*)')""")
_TAG_NAME: Final = re.compile(rb"<[^\s/>]+")
_TAG_END: Final = re.compile(rb"\s*(/?)>")


class Span(NamedTuple):
    """A range of bytes."""

    begin: int
    end: int


@dataclass(slots=True, eq=False)
class Node:
    """An element of a document; all its offsets are in bytes.

    Attributes:
        tag: its name.
        line: its line, counted from 1.
        parent: the element around it; None for the root.
        begin: where its start tag begins.
        open_end: the end of its start tag.
        close: where its end tag begins; `open_end` if it has none.
        end: where it ends.
        attributes: its attributes, in their order.
        attribute_at: the span of each attribute, with the white space before it.
        value_at: the span of each value, without its quotes.
        children: its child elements.
        text: its own text.
    """

    tag: str
    line: int
    parent: Node | None
    begin: int
    open_end: int
    close: int
    end: int
    attributes: dict[str, str]
    attribute_at: dict[str, Span] = field(default_factory=dict)
    value_at: dict[str, Span] = field(default_factory=dict)
    children: list[Node] = field(default_factory=list)
    text: str = ""

    @property
    def is_empty(self) -> bool:
        """Whether it is written as one tag, `<area/>`."""
        return self.close == self.end

    def all(self) -> Iterator[Node]:
        """Yield the element and all below it, in the order of the document."""
        work = [self]
        while work:
            node = work.pop()
            yield node
            work += reversed(node.children)


@dataclass(frozen=True, slots=True)
class Tree:
    """A parsed document.

    Attributes:
        root: its root element.
        codec: how its text is encoded, by Python's name.
    """

    root: Node
    codec: str


def parse(text: bytes, file: str) -> Tree:
    """Return the elements of a document.

    Args:
        text: the document.
        file: its name in messages.

    Raises:
        WorldError: it is not well-formed, or has what is not allowed in files of ours.
    """
    if len(text) > MAX_BYTES:
        raise WorldError.at(Location(file), f"larger than {MAX_BYTES} bytes")
    if text.startswith(_UTF_16):
        raise WorldError.at(Location(file), "UTF-16 cannot be edited", "save the file as UTF-8")
    reader = _Reader(text, file)
    try:
        reader.parser.Parse(text, True)
    except expat.ExpatError as error:
        place = Location(file, error.lineno, error.offset + 1)
        reason = expat.ErrorString(error.code).removeprefix("not well-formed").strip(" ()")
        raise WorldError.at(place, f"not well-formed XML: {reason}") from None
    assert reader.root is not None  # or else it was not well-formed
    return Tree(reader.root, reader.codec)


class _Reader:
    """Builds the tree from what expat finds."""

    def __init__(self, text: bytes, file: str) -> None:
        self.root: Node | None = None
        self.codec = "utf-8"
        self.parser = expat.ParserCreate()
        self.parser.buffer_text = True
        self.parser.XmlDeclHandler = self._declaration
        self.parser.StartDoctypeDeclHandler = self._document_type
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.CharacterDataHandler = self._characters
        self._text, self._file = text, file
        self._open: list[Node] = []

    def _declaration(self, _version: str, encoding: str | None, _standalone: int) -> None:
        codec = _CODECS.get((encoding or "").lower())
        if codec is None:
            place = Location(self._file, 1)
            wrong = f"the encoding {encoding!r} cannot be edited"
            raise WorldError.at(place, wrong, "save the file as UTF-8")
        self.codec = codec

    def _document_type(self, *_: object) -> None:
        place = Location(self._file, self.parser.CurrentLineNumber)
        raise WorldError.at(
            place, "a document type declaration is not allowed", "remove <!DOCTYPE ...>"
        )

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        begin, line = self.parser.CurrentByteIndex, self.parser.CurrentLineNumber
        if len(self._open) >= MAX_DEPTH:
            wrong = f"elements are nested more than {MAX_DEPTH} deep"
            raise WorldError.at(Location(self._file, line), wrong)
        parent = self._open[-1] if self._open else None
        node = Node(tag, line, parent, begin, begin, begin, begin, attributes)
        self._read_tag(node)
        if parent is None:
            self.root = node
        else:
            parent.children.append(node)
        self._open.append(node)

    def _read_tag(self, node: Node) -> None:
        """Find the attributes and the end of a start tag, which is known to be well-formed."""
        name = _TAG_NAME.match(self._text, node.begin)
        assert name
        place = name.end()
        while found := _ATTRIBUTE.match(self._text, place):
            key = found[1].decode(self.codec)
            node.attribute_at[key] = Span(*found.span())
            node.value_at[key] = Span(*found.span(3 if found[2] is None else 2))
            place = found.end()
        end = _TAG_END.match(self._text, place)
        assert end
        node.open_end = node.close = node.end = end.end()

    def _end(self, _tag: str) -> None:
        node = self._open.pop()
        if self._text[node.open_end - 2 : node.open_end] != b"/>":
            node.close = self.parser.CurrentByteIndex
            node.end = self._text.index(b">", node.close) + 1

    def _characters(self, text: str) -> None:
        if self._open:
            self._open[-1].text += text
