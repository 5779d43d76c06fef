"""Edits of elements as splices: attributes, new elements, removed elements.

What is new is written as the rest of the file: its indentation, its line ends, its encoding. What
is removed takes its line with it if nothing else is on it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Final

from crs_cc.builder.document import Document, Splice, spliced
from crs_cc.builder.spans import Node

ORDER: Final = (
    *("area", "surface", "include", "material", "define", "map"),
    *("wall", "box", "cylinder", "polygon", "object", "light", "sound"),
    *("source", "nest", "robot", "scatter", "degradation", "communication", "goal"),
)
"""The order of new elements in a world; existing ones may be in a different order."""

FIRST: Final = ("area", "surface", "heightmap")
"""Elements that must come before all others."""

LAST: Final = ("link", "host", "sensor", "setup")
"""Elements of a robot definition that must come after all others, in this order."""

_NAME: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]*")
_NO_XML: Final = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_COMMENTS: Final = re.compile(rb"[ \t]*(?:<!--(?:(?!--)[^\n])*-->[ \t]*)*(?=\r?\n|\Z)")
_STEP: Final = "  "


def escaped(value: str, quote: str = '"') -> str:
    r"""Return a value as written between quotes.

    >>> escaped("a<b & \"c\"\n")
    'a&lt;b &amp; &quot;c&quot;&#10;'

    Raises:
        ValueError: it has a character that XML does not allow.
    """
    if wrong := _NO_XML.search(value):
        raise ValueError(f"the character {wrong[0]!r} is not allowed in XML")
    text = value.replace("&", "&amp;").replace("<", "&lt;")
    text = text.replace(quote, {'"': "&quot;", "'": "&apos;"}[quote])
    return "".join(f"&#{ord(each)};" if each in "\t\n\r" else each for each in text)


def element(tag: str, attributes: Mapping[str, str], text: str = "", *inner: str) -> str:
    """Return an element as text, whose children are given as text.

    >>> print(element("define", {"name": "t"}, "", element("box", {"id": "top"})))
    <define name="t">
      <box id="top"/>
    </define>

    Raises:
        ValueError: a name or a value is not allowed in XML.
    """
    for name in (tag, *attributes):
        if not _NAME.fullmatch(name):
            raise ValueError(f"{name[:64]!r} is not a name")
    head = " ".join([tag, *(f'{name}="{escaped(value)}"' for name, value in attributes.items())])
    if inner:
        lines = "".join(f"\n{_STEP}{indented(each, _STEP)}" for each in inner)
        return f"<{head}>{lines}\n</{tag}>"
    return f"<{head}>{escaped(text)}</{tag}>" if text else f"<{head}/>"


def indented(text: str, indent: str) -> str:
    """Return a text whose lines after the first are indented."""
    return text.replace("\n", "\n" + indent)


# -- attributes ------------------------------------------------------------------------------------


def set_attributes(
    document: Document, node: Node, values: Mapping[str, str | None], order: Sequence[str] = ()
) -> list[Splice]:
    """Return the splices that set attributes of an element; None removes one.

    Args:
        document: the document.
        node: the element.
        values: the new values by names.
        order: the names in their usual order, in which new ones are inserted.

    Raises:
        ValueError: a name or a value is not allowed in XML.
    """
    found = []
    for name, value in values.items():
        if not _NAME.fullmatch(name):
            raise ValueError(f"{name[:64]!r} is not a name")
        if value is None:
            if name in node.attribute_at:
                found.append(Splice(*node.attribute_at[name], b""))
        elif name in node.attributes:
            if value != node.attributes[name]:
                begin, end = node.value_at[name]
                quote = document.text[end : end + 1].decode()
                found.append(Splice(begin, end, encoded(document, escaped(value, quote))))
        else:
            place = _attribute_place(document, node, name, order)
            found.append(Splice(place, place, encoded(document, f' {name}="{escaped(value)}"')))
    return found


def _attribute_place(document: Document, node: Node, name: str, order: Sequence[str]) -> int:
    """Return the position of a new attribute: after the last one that precedes it."""
    before = order[: order.index(name)] if name in order else tuple(node.attribute_at)
    places = [node.attribute_at[each].end for each in before if each in node.attribute_at]
    begin = node.begin + len(b"<") + len(node.tag.encode(document.codec))
    return max(places, default=begin)


def set_text(document: Document, node: Node, text: str) -> list[Splice]:
    """Return the splices that set the text of an element without children."""
    if node.children:
        raise ValueError(f"<{node.tag}> has elements, and no text of its own")
    new = encoded(document, escaped(text))
    if node.is_empty:
        tag = node.tag.encode(document.codec)
        return [Splice(_slash(document, node), node.end, b">" + new + b"</" + tag + b">")]
    return [Splice(node.open_end, node.close, new)]


def encoded(document: Document, text: str) -> bytes:
    """Return a text in the encoding and with the line ends of a document."""
    return text.replace("\n", document.newline).encode(document.codec, "xmlcharrefreplace")


def _slash(document: Document, node: Node) -> int:
    """Return where the end of an empty element's tag begins, white space included."""
    place = node.open_end - len(b"/>")
    while document.text[place - 1 : place].isspace():
        place -= 1
    return place


# -- elements --------------------------------------------------------------------------------------


def fragment(
    document: Document,
    node: Node,
    values: Mapping[str, str | None] | None = None,
    order: Sequence[str] = (),
) -> str:
    """Return an element as text without its indentation, with other attributes."""
    return changed(document, node, set_attributes(document, node, values or {}, order))


def changed(document: Document, node: Node, splices: Sequence[Splice]) -> str:
    """Return an element as text without its indentation, after changes of it."""
    text = document.text[node.begin : node.end]
    changes = [
        Splice(each.begin - node.begin, each.end - node.begin, each.text) for each in splices
    ]
    lines = spliced(text, changes).decode(document.codec).replace("\r\n", "\n")
    return lines.replace("\n" + indent_of(document, node), "\n")


def indent_of(document: Document, node: Node) -> str:
    """Return the white space before an element on its line, empty if something else is there."""
    line = document.text.rfind(b"\n", 0, node.begin) + 1
    before = document.text[line : node.begin]
    return before.decode() if not before.strip() and line else ""


def remove(document: Document, nodes: Sequence[Node]) -> list[Splice]:
    """Return the splices that remove elements, none of which is inside of another."""
    return [_removal(document.text, node) for node in nodes]


def _removal(text: bytes, node: Node) -> Splice:
    line = text.rfind(b"\n", 0, node.begin) + 1
    end = text.find(b"\n", node.end)
    if line and end >= 0 and not (text[line : node.begin] + text[node.end : end]).strip():
        return Splice(line, end + 1, b"")
    return Splice(node.begin, node.end, b"")


def insert(
    document: Document, parent: Node, tag: str, texts: Sequence[str], after: Node | None = None
) -> list[Splice]:
    """Return the splices that insert elements.

    Args:
        document: the document.
        parent: the element around them.
        tag: their kind, which decides where they go.
        texts: the elements, as text without indentation.
        after: the element behind which they go; by default the last of their kind, or of those
            that usually come before.
    """
    after = after or _before(parent, tag)
    indent, is_lined = _layout(document, parent)
    begin = "\n" + indent if is_lined else ""
    new = "".join(begin + indented(text, indent) for text in texts)
    if parent.is_empty:
        end = f"\n{indent_of(document, parent)}" if is_lined else ""
        text = encoded(document, f">{new}{end}</{parent.tag}>")
        return [Splice(_slash(document, parent), parent.end, text)]
    place = parent.open_end if after is None else after.end
    rest = _COMMENTS.match(document.text, place)
    place = rest.end() if rest and is_lined else place
    if is_lined and b"\n" not in document.text[place : parent.close] and not parent.children:
        new += f"\n{indent_of(document, parent)}"
    return [Splice(place, place, encoded(document, new))]


def _before(parent: Node, tag: str) -> Node | None:
    """Return the element after which one of a kind is inserted; None for the front."""
    same = [each for each in parent.children if each.tag == tag]
    if same:
        return same[-1]
    if tag in FIRST:
        known = FIRST[: FIRST.index(tag)]
    elif parent.tag == "world" and tag in ORDER:
        known = ORDER[: ORDER.index(tag)]
    elif parent.tag == "robot-definition":
        behind = LAST[LAST.index(tag) :] if tag in LAST else LAST
        known = tuple(each.tag for each in parent.children if each.tag not in behind)
    else:
        known = tuple(each.tag for each in parent.children)
    earlier = [each for each in parent.children if each.tag in known]
    return earlier[-1] if earlier else None


def _layout(document: Document, parent: Node) -> tuple[str, bool]:
    """Return the indentation of an element's children, and whether each has its line."""
    for child in parent.children:
        line = document.text.rfind(b"\n", 0, child.begin) + 1
        if line > parent.begin and not document.text[line : child.begin].strip():
            return document.text[line : child.begin].decode(), True
    if parent.children:
        return "", False
    return indent_of(document, parent) + _STEP, b"\n" in document.text.strip()
