"""Lowers a checked file to a `Program`: functions, objects, strings, and what is left to link."""

from __future__ import annotations

from dataclasses import dataclass, field

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.constant import ConstantAddress
from crs_cc.frontend.check.scope import FunctionSymbol
from crs_cc.frontend.lower.function import lower_function
from crs_cc.frontend.lower.initializer import Image
from crs_cc.ir.program import Data, Program, Relocation


@dataclass(slots=True, eq=False)
class UnitLowering:
    """What the functions and objects of a file share while they are lowered.

    Attributes:
        sizes: size of each global object that was named [bytes]; 0 when unknown.
        strings: names of string literals by content.
        uses: where each global name was used first.
    """

    unit: Unit
    program: Program = field(default_factory=Program)
    sizes: dict[str, int] = field(default_factory=dict)
    strings: dict[tuple[bytes, int], str] = field(default_factory=dict)
    uses: dict[str, Location] = field(default_factory=dict)

    def use(self, name: str, location: Location) -> None:
        """Notes where a global name is used."""
        self.uses.setdefault(name, location)

    def string(self, literal: tree.StringLiteral) -> str:
        """Gives the name of a string's object; equal strings share one."""
        key = literal.content, literal.type.align
        name = self.strings.get(key)
        if name is None:
            name = self.strings[key] = f'{self.unit.name}:"{len(self.strings)}'
            self._add(name, literal.content, literal.type.align, literal.location)
        return name

    def image(self, function: str, content: bytes, align: int, location: Location) -> str:
        """Gives the name of an object that a local variable is initialised from."""
        name = self.unit.static_name(f"{function.rpartition(':')[2]}.image")
        self._add(name, content, align, location)
        return name

    def _add(self, name: str, content: bytes, align: int, location: Location) -> None:
        kept = content if any(content) else None
        self.program.data[name] = Data(name, len(content), align, location, kept)
        self.sizes[name] = len(content)

    def define(self, definition: tree.ObjectDefinition) -> None:
        """Makes the data of a global or static object."""
        symbol = definition.symbol
        assert symbol.link_name is not None
        extent = 0 if definition.initialiser is None else definition.initialiser.extent
        data = Data(
            symbol.link_name,
            max(symbol.type.size, extent),
            max(symbol.align, symbol.type.align),
            symbol.location,
            tentative=symbol.is_tentative and symbol.is_external and not symbol.is_defined,
            variable=symbol.variable(),
        )
        if definition.initialiser is not None:
            self._fill(data, definition.initialiser)
        self.program.data[data.name] = data
        if symbol.is_weak:
            self.program.weak.add(data.name)

    def _fill(self, data: Data, initialiser: tree.Initialiser) -> None:
        image = Image(data.size)
        for each in initialiser.values:
            image.put(each)
        for offset, address in sorted(image.addresses.items()):
            name = self._base_name(address)
            self.use(name, data.location)
            data.relocations.append(Relocation(offset, name, address.offset))
        if data.relocations or any(image.content):
            data.content = bytes(image.content)

    def _base_name(self, address: ConstantAddress) -> str:
        base = address.base
        if isinstance(base, tree.StringLiteral):
            return self.string(base)
        assert base is not None
        assert base.link_name is not None
        return base.link_name


def lower_unit(unit: Unit) -> Program:
    """Makes the program of a file that was checked and has no errors."""
    lowering = UnitLowering(unit)
    for definition in unit.objects:
        lowering.define(definition)
    for function in unit.functions:
        made = lower_function(lowering, function)
        made.trusted = unit.trusted
        lowering.program.functions[made.name] = made
        _note(lowering.program, function.symbol)
    program = lowering.program
    own = f"{unit.name}:"
    for name, location in lowering.uses.items():
        if name.startswith(own) and name not in program.functions and name not in program.data:
            text = f"static function '{name.removeprefix(own)}' is used, but defined nowhere"
            unit.error(location, text)
    program.undefined = {
        name: location
        for name, location in lowering.uses.items()
        if name not in program.functions and name not in program.data
    }
    for name in program.undefined:
        symbol = unit.externals.get(name)
        if symbol is not None:
            program.declared[name] = symbol.type, symbol.location
    return program


def _note(program: Program, symbol: FunctionSymbol) -> None:
    """Notes what the linker must know of a function that is defined."""
    if symbol.is_weak:
        program.weak.add(symbol.link_name)
    if symbol.starts is not None:
        program.starts.append((symbol.starts, symbol.link_name))
    if symbol.ends is not None:
        program.ends.append((symbol.ends, symbol.link_name))
