"""`<include file="furniture.xml"/>`: materials and definitions of objects from other files.

An included file has the root element `<definitions>`, and may include others, by paths relative to
itself. It is read only once. All of them must be in the folder of the world file or below.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Final

from crs_cc.core.errors import WorldError
from crs_cc.core.source import Diagnostics
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.files.nearby import read_below
from crs_cc.sim.files.xml_document import MAX_BYTES, elements, lines_of

MAX_FILES: Final = 32
MAX_DEPTH: Final = 8
_SHOWN: Final = 20  # maximum number of messages about one file


@dataclass(slots=True)
class Included:
    """The files that a world file includes.

    Attributes:
        folder: the folder of the world file; None if it was not read from a file.
        reader: receives the errors.
        read: the files that were read.
        lines: the line of the world file that led to a file, by the file's name in messages.
    """

    folder: Path | None
    reader: Reader
    read: set[PurePosixPath] = field(default_factory=set)
    lines: dict[str, int] = field(default_factory=dict)

    def definitions(self, root: Element) -> list[Element]:
        """Return `<material>` and `<define>` elements in order, also of included files."""
        found: list[Element] = []
        for child in root.children:
            if child.tag == "include":
                found += self._included(child, (), child.line)
            elif child.tag in {"material", "define"}:
                found.append(child)
        return found

    def _included(
        self, element: Element, chain: tuple[PurePosixPath, ...], line: int
    ) -> Iterator[Element]:
        name = element.attributes["file"]
        path = (chain[-1].parent if chain else PurePosixPath()) / name
        if path in chain:
            circle = [*chain[chain.index(path) :], path]
            text = f"{name!r} includes itself: {' in '.join(map(str, reversed(circle)))}"
            self.reader.error(element, text)
        elif path in self.read:
            return
        elif len(chain) >= MAX_DEPTH:
            self.reader.error(element, f"includes are nested more than {MAX_DEPTH} deep")
        elif len(self.read) >= MAX_FILES:
            self.reader.error(element, f"more than {MAX_FILES} included files")
        else:
            self.read.add(path)
            for child in self._children(element, path, line):
                if child.tag == "include":
                    yield from self._included(child, (*chain, path), line)
                else:
                    yield child

    def _children(self, element: Element, path: PurePosixPath, line: int) -> list[Element]:
        """Return the elements in a file; empty after an error."""
        diagnostics = self.reader.diagnostics
        if self.folder is None:
            self.reader.error(element, "include: only allowed in a world that is read from a file")
            return []
        file = str(self.folder / path)
        self.lines[file] = line
        try:
            text = read_below(self.folder, str(path), ".xml", MAX_BYTES)
        except ValueError as wrong:
            self.reader.error(element, f"include {element.attributes['file'][:80]!r}: {wrong}")
            return []
        diagnostics.lines[file] = lines_of(text)
        own = Diagnostics(lines=diagnostics.lines)
        try:
            root = elements(text, "world.xsd", file, own, outermost="definitions")
        except WorldError as wrong:
            self.reader.error(element, f"{element.attributes['file']!r} cannot be included")
            diagnostics.messages.extend(wrong.diagnostics[:_SHOWN])
            return []
        _name_file(root, file)
        return root.children


def _name_file(root: Element, file: str) -> None:
    """Set the file of all elements below a root."""
    work = [root]
    for element in work:
        element.file = file
        work += element.children
