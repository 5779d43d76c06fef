"""The elements of an XML file as plain data, and a reader that turns their attributes into numbers.

A `Reader` does not stop at the first mistake: it notes it with its place, and gives a stand-in, so
that a user hears of all mistakes at once.

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
from dataclasses import dataclass, field
from typing import Final

from crs_cc.core.quantity import LENGTH, RATIO, Kind
from crs_cc.core.source import Diagnostics, Location

__all__ = ["LENGTH", "Element", "Reader"]

MAX_MESSAGES: Final = 100
_WHOLE_DIGITS: Final = 9
_LONGEST: Final = 400  # values in messages may be of any length


@dataclass(slots=True)
class Element:
    """An element of an XML file.

    Attributes:
        tag: its name.
        line: its line in the file.
        attributes: its attributes, those included for which the schema has a default.
        text: its text, without space around it.
        children: the elements in it.
        broken: whether one of its values could not be read.
        file: the file, where it is not the reader's.
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
        """Where it stands, for messages."""
        return f"{self.file}:{self.line}" if self.file else f"line {self.line}"

    def all(self, tag: str) -> Iterator[Element]:
        """Gives the children with a name."""
        return (child for child in self.children if child.tag == tag)

    def sensors(self, kind: str) -> Iterator[Element]:
        """Gives the children `<sensor>` of a type."""
        return (child for child in self.all("sensor") if child.first("type").text == kind)

    def first(self, tag: str) -> Element:
        """Gives the first child with a name; an empty one when there is none."""
        return next(self.all(tag), Element(tag, self.line))

    def maybe(self, tag: str) -> Element | None:
        """Gives the first child with a name, if there is one."""
        return next(self.all(tag), None)


@dataclass(slots=True)
class Reader:
    """Reads the values of one file, and collects what is wrong with them."""

    file: str
    diagnostics: Diagnostics

    def error(self, element: Element, text: str, hint: str = "") -> None:
        """Notes that something is wrong with an element."""
        if len(text) > _LONGEST:
            text = f"{text[: _LONGEST // 2]} ... {text[-_LONGEST // 2 :]}"
        count = len(self.diagnostics.messages)
        if count < MAX_MESSAGES:
            place = Location(element.file or self.file, element.line)
            self.diagnostics.error(place, text, hint)
        elif count == MAX_MESSAGES:
            self.diagnostics.error(Location(self.file), "more mistakes than are shown here")

    def refuse(self, element: Element, text: str) -> None:
        """Notes that a value of an element cannot be used."""
        element.broken = True
        self.error(element, f"{element.tag}, {text}")

    def quantity(
        self, element: Element, name: str, kind: Kind, absent: float = 0.0, unit: str = ""
    ) -> float:
        """Gives the value [SI unit] of an attribute, or of a child element, with that name.

        Args:
            element: where to look.
            name: the attribute's or child's name.
            kind: what it must be.
            absent: the value when there is none.
            unit: the unit of a bare number, where it differs from the kind's own.
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
        """Gives a value [SI unit] that must be greater than 0."""
        value = self.quantity(element, name, kind, absent)
        if value > 0.0:
            return value
        self.refuse(element, f"{name}: {_find(element, name)!r} must be greater than 0")
        return absent

    def not_negative(self, element: Element, name: str, kind: Kind, absent: float = 0.0) -> float:
        """Gives a value [SI unit] that must be 0 or more."""
        value = self.quantity(element, name, kind, absent)
        if value >= 0.0:
            return value
        self.refuse(element, f"{name}: {_find(element, name)!r} must not be negative")
        return absent

    def share(self, element: Element, name: str, absent: float = 0.0) -> float:
        """Gives a value from 0 to 1."""
        value = self.quantity(element, name, RATIO, absent)
        if 0.0 <= value <= 1.0:
            return value
        shown = _find(element, name)
        self.refuse(element, f"{name}: {shown!r} must be 0 or more and 1 or less")
        return absent

    def whole(self, element: Element, name: str, least: int, most: int, absent: int = 0) -> int:
        """Gives a whole number within bounds."""
        text = _find(element, name)
        if text is None:
            return absent
        if text.isascii() and text.isdigit() and len(text) <= _WHOLE_DIGITS:
            value = int(text)
            if least <= value <= most:
                return value
        self.refuse(element, f"{name}: {text[:40]!r} is not a whole number, {least} to {most}")
        return absent


def _find(element: Element, name: str) -> str | None:
    """Gives the text of an attribute, or of a child element, with that name."""
    child = element.maybe(name)
    return element.attributes.get(name, None if child is None else child.text)
