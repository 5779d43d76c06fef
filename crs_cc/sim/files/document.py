"""XML elements as plain data, and a reader that converts their attributes to numbers.

A `Reader` does not stop at the first error: it records it with its location and returns a
placeholder, so that all errors of a file are reported at once.

>>> from crs_cc.core.source import Diagnostics
>>> reader = Reader("room.xml", Diagnostics())
>>> wall = Element("wall", 7, {"x1": "150cm", "x2": "wide", "thickness": "-1"})
>>> reader.quantity(wall, "x1", LENGTH), reader.quantity(wall, "x2", LENGTH)
(1.5, 0.0)
>>> reader.positive(wall, "thickness", LENGTH)
1.0
>>> for message in reader.diagnostics.messages:
...     print(message.render())
room.xml:7: error: wall, x2: 'wide' is not a length (expected a number and one of m, cm, mm, in, \
ft, such as 1.5m)
room.xml:7: error: wall, thickness: '-1' must be greater than 0
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Final

from crs_cc.core.quantity import LENGTH, RATIO, Kind
from crs_cc.core.source import Diagnostics, Location

__all__ = ["LENGTH", "Element", "Reader"]

MAX_MESSAGES: Final = 100
_SHARE: Final = replace(RATIO, name="a share", example="0.5")
_WHOLE_DIGITS: Final = 9
_MAX_VALUE: Final = 400  # values in messages may be of any length


@dataclass(slots=True)
class Element:
    """An element of an XML file.

    Attributes:
        tag: its name.
        line: its line in the file.
        attributes: its attributes, including the defaults of the schema.
        text: its text, without surrounding white space.
        children: its child elements.
        broken: whether one of its values is invalid.
        file: the file, if it is not the reader's.
    """

    tag: str
    line: int
    attributes: dict[str, str] = field(default_factory=dict)
    text: str = ""
    children: list[Element] = field(default_factory=list)
    broken: bool = False
    file: str = ""

    @property
    def place(self) -> str:
        """Its location, for messages."""
        return f"{self.file}:{self.line}" if self.file else f"line {self.line}"

    def all(self, tag: str) -> Iterator[Element]:
        """Yield the children with a tag."""
        return (child for child in self.children if child.tag == tag)

    def sensors(self, kind: str) -> Iterator[Element]:
        """Yield the children `<sensor>` of a type."""
        return (child for child in self.all("sensor") if child.first("type").text == kind)

    def first(self, tag: str) -> Element:
        """Return the first child with a tag, or an empty element."""
        return next(self.all(tag), Element(tag, self.line))

    def find_child(self, tag: str) -> Element | None:
        """Return the first child with a tag, or None."""
        return next(self.all(tag), None)


@dataclass(slots=True)
class Reader:
    """Reads the values of one file, and collects errors."""

    file: str
    diagnostics: Diagnostics

    def error(self, element: Element, text: str, hint: str = "") -> None:
        """Report an error at an element."""
        if len(text) > _MAX_VALUE:
            text = f"{text[: _MAX_VALUE // 2]} ... {text[-_MAX_VALUE // 2 :]}"
        count = len(self.diagnostics.messages)
        if count < MAX_MESSAGES:
            place = Location(element.file or self.file, element.line)
            self.diagnostics.error(place, text, hint)
        elif count == MAX_MESSAGES:
            self.diagnostics.error(Location(self.file), "too many errors; the rest is not shown")

    def refuse(self, element: Element, text: str) -> None:
        """Report an invalid value of an element."""
        element.broken = True
        self.error(element, f"{element.tag}, {text}")

    def quantity(
        self, element: Element, name: str, kind: Kind, absent: float = 0.0, unit: str = ""
    ) -> float:
        """Return the value [SI unit] of an attribute or child element.

        Args:
            element: the element.
            name: the name of the attribute or child.
            kind: the expected quantity.
            absent: the default.
            unit: the unit of a bare number, if it is not the kind's own.
        """
        text = _find(element, name)
        if text is None:
            return absent
        try:
            return kind.parse(text, unit)
        except ValueError as wrong:
            self.refuse(element, f"{name}: {wrong}")
            return absent

    def positive(self, element: Element, name: str, kind: Kind, absent: float = 1.0) -> float:
        """Return a value [SI unit] greater than 0."""
        value = self.quantity(element, name, kind, absent)
        if value > 0.0:
            return value
        self.refuse(element, f"{name}: {_find(element, name)!r} must be greater than 0")
        return absent

    def not_negative(self, element: Element, name: str, kind: Kind, absent: float = 0.0) -> float:
        """Return a value [SI unit] of 0 or more."""
        value = self.quantity(element, name, kind, absent)
        if value >= 0.0:
            return value
        self.refuse(element, f"{name}: {_find(element, name)!r} must not be negative")
        return absent

    def fraction(self, element: Element, name: str, absent: float = 0.0) -> float:
        """Return a value from 0 to 1."""
        value = self.quantity(element, name, _SHARE, absent)
        if 0.0 <= value <= 1.0:
            return value
        shown = _find(element, name)
        self.refuse(element, f"{name}: {shown!r} must be from 0 to 1")
        return absent

    def whole(self, element: Element, name: str, least: int, most: int, absent: int = 0) -> int:
        """Return an integer from `least` to `most`."""
        text = _find(element, name)
        if text is None:
            return absent
        if text.isascii() and text.isdigit() and len(text) <= _WHOLE_DIGITS:
            value = int(text)
            if least <= value <= most:
                return value
        self.refuse(element, f"{name}: {text[:40]!r} is not an integer from {least} to {most}")
        return absent


def _find(element: Element, name: str) -> str | None:
    """Return the text of the attribute or child element with a name."""
    child = element.find_child(name)
    return element.attributes.get(name, None if child is None else child.text)
