"""A document that is edited in place: its bytes, its elements, and its edit history.

A change is a list of splices: these bytes become those. Its inverse is a list of splices too, so
undoing gives the very bytes back, without end, and costs what has changed.

>>> room = Document(b"<world>  <wall x1 = '1m'/></world>", "room.xml")
>>> place = room.root.children[0].value_at["x1"]
>>> room.change("longer", [Splice(place.begin, place.end, b"2m")])
>>> room.text
b"<world>  <wall x1 = '2m'/></world>"
>>> room.undo(), room.text
('longer', b"<world>  <wall x1 = '1m'/></world>")
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from typing import Final, NamedTuple

from crs_cc.builder.spans import Node, Tree, parse

_LENGTH: Final = re.compile(r"[-+0-9.eE]*[1-9][-+0-9.eE]*(m|cm|mm|in|ft)")


class Splice(NamedTuple):
    """A replacement of a range of bytes."""

    begin: int
    end: int
    text: bytes


@dataclass(slots=True)
class _Step:
    """The changes that one undo takes back, in order, each with its inverse."""

    title: str
    changes: list[tuple[list[Splice], list[Splice]]] = field(default_factory=list)


def spliced(text: bytes, splices: Sequence[Splice]) -> bytes:
    """Return a text with ranges replaced, which do not overlap.

    >>> spliced(b"abcd", [Splice(3, 4, b""), Splice(1, 1, b"X"), Splice(1, 1, b"Y")])
    b'aXYbc'
    """
    parts, place = [], 0
    for begin, end, new in sorted(splices, key=lambda each: (each.begin, each.end)):
        if begin < place:
            raise ValueError("two changes of the same place")
        parts += [text[place:begin], new]
        place = end
    return b"".join([*parts, text[place:]])


def inverse(text: bytes, splices: Sequence[Splice]) -> list[Splice]:
    """Return the splices that take those of a text back."""
    found, shift = [], 0
    for begin, end, new in sorted(splices, key=lambda each: (each.begin, each.end)):
        found.append(Splice(begin + shift, begin + shift + len(new), text[begin:end]))
        shift += len(new) - (end - begin)
    return found


class Document:
    """A document.

    Attributes:
        file: its name in messages.
        text: its bytes.
    """

    def __init__(self, text: bytes, file: str) -> None:
        """Parse a document.

        Raises:
            WorldError: it is not well-formed, or has what is not allowed in files of ours.
        """
        self.file = file
        self.text = text
        self._tree: Tree = parse(text, file)
        self._done: list[_Step] = []
        self._undone: list[_Step] = []
        self._together: _Step | None = None

    @property
    def root(self) -> Node:
        """Its root element; nodes are valid until the next change."""
        return self._tree.root

    @property
    def codec(self) -> str:
        """Its encoding, by Python's name."""
        return self._tree.codec

    @cached_property
    def newline(self) -> str:
        """The line ending of the file."""
        return "\r\n" if b"\r\n" in self.text else "\n"

    @cached_property
    def length_unit(self) -> str:
        """The unit of most lengths in it; metres if there are none."""
        counts = Counter(
            found[1]
            for node in self.root.all()
            for text in node.attributes.values()
            if (found := _LENGTH.fullmatch(text))
        )
        return counts.most_common(1)[0][0] if counts else "m"

    # -- changes ---------------------------------------------------------------------------------

    @property
    def undoable(self) -> list[str]:
        """The titles of the changes that can be undone, the latest last."""
        return [step.title for step in self._done]

    @property
    def redoable(self) -> list[str]:
        """The titles of the changes that can be done again, the next last."""
        return [step.title for step in self._undone]

    def change(self, title: str, splices: Sequence[Splice]) -> None:
        """Replace ranges of bytes; nothing changes if the result is not well-formed.

        Args:
            title: its description, for undoing it.
            splices: what is replaced.

        Raises:
            WorldError: the result is not well-formed.
        """
        wanted = [each for each in splices if self.text[each.begin : each.end] != each.text]
        if not wanted:
            return
        back = inverse(self.text, wanted)
        self._replace(wanted)
        self._undone.clear()
        step = self._together or _Step(title)
        step.changes.append((wanted, back))
        if step is not self._together:
            self._done.append(step)

    @contextmanager
    def transaction(self, title: str) -> Iterator[None]:
        """Make the changes in the block one transaction, rolled back if the block fails."""
        if self._together is not None:
            yield
            return
        step = self._together = _Step(title)
        try:
            yield
        except BaseException:
            for _, back in reversed(step.changes):
                self._replace(back)
            raise
        else:
            if step.changes:
                self._done.append(step)
        finally:
            self._together = None

    def undo(self) -> str:
        """Take the latest change back; return its title, empty if there is none."""
        if not self._done:
            return ""
        step = self._done.pop()
        for _, back in reversed(step.changes):
            self._replace(back)
        self._undone.append(step)
        return step.title

    def redo(self) -> str:
        """Make the change again that was undone last; return its title, empty if there is none."""
        if not self._undone:
            return ""
        step = self._undone.pop()
        for splices, _ in step.changes:
            self._replace(splices)
        self._done.append(step)
        return step.title

    def _replace(self, splices: Sequence[Splice]) -> None:
        text = spliced(self.text, splices)
        self._tree = parse(text, self.file)
        self.text = text
        for known in ("newline", "length_unit"):
            self.__dict__.pop(known, None)
