"""The state shared by the functions and objects of a file: strings, sizes, references."""

from __future__ import annotations

from dataclasses import dataclass, field

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Unit
from crs_cc.ir.program import Data, Program


@dataclass(slots=True, eq=False)
class UnitState:
    """The state shared by the functions and objects of a file while they are lowered.

    Attributes:
        unit: the checked file.
        program: the result.
        sizes: the size of each global object that was referenced [bytes]; 0 if unknown.
        strings: the names of string literals by content and alignment.
        uses: the first use of each global name.
    """

    unit: Unit
    program: Program = field(default_factory=Program)
    sizes: dict[str, int] = field(default_factory=dict)
    strings: dict[tuple[bytes, int], str] = field(default_factory=dict)
    uses: dict[str, Location] = field(default_factory=dict)

    def use(self, name: str, location: Location) -> None:
        """Record the use of a global name."""
        self.uses.setdefault(name, location)

    def string(self, literal: tree.StringLiteral) -> str:
        """Return the name of a string's object; equal strings share one."""
        key = literal.content, literal.type.align
        name = self.strings.get(key)
        if name is None:
            name = self.strings[key] = f'{self.unit.name}:"{len(self.strings)}'
            self._add(name, literal.content, literal.type.align, literal.location)
        return name

    def image(self, function: str, content: bytes, align: int, location: Location) -> str:
        """Return the name of a new object that a local variable is initialised from."""
        name = self.unit.static_name(f"{function.rpartition(':')[2]}.image")
        self._add(name, content, align, location)
        return name

    def _add(self, name: str, content: bytes, align: int, location: Location) -> None:
        kept = content if any(content) else None
        self.program.data[name] = Data(name, len(content), align, location, kept)
        self.sizes[name] = len(content)
