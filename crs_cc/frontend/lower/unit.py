"""Lower a checked file to a `Program`: functions, objects, strings and undefined names."""

from __future__ import annotations

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.constant import ConstantAddress
from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol
from crs_cc.frontend.lower.function import lower_function
from crs_cc.frontend.lower.initializer import Image
from crs_cc.frontend.lower.unit_state import UnitState
from crs_cc.ir.program import Data, Program, Relocation


def lower_unit(unit: Unit) -> Program:
    """Return the program of a file that was checked and has no errors."""
    state = UnitState(unit)
    for definition in unit.objects:
        _define(state, definition)
    for function in unit.functions:
        made = lower_function(state, function)
        made.trusted = unit.trusted
        state.program.functions[made.name] = made
        _note(state.program, function.symbol)
    program = state.program
    _enter_aliases(unit, program)
    own = f"{unit.name}:"
    for name, location in state.uses.items():
        if name.startswith(own) and name not in program.functions and name not in program.data:
            if name in program.aliases:
                continue
            text = f"static function '{name.removeprefix(own)}' is used, but defined nowhere"
            unit.error(location, text)
    program.undefined = {
        name: location
        for name, location in state.uses.items()
        if name not in program.functions and name not in program.data
    }
    for name in program.undefined:
        symbol = unit.externals.get(name)
        if symbol is not None:
            program.declared[name] = symbol.type, symbol.location
            if symbol.may_be_missing:
                program.optional.add(name)
    return program


def _enter_aliases(unit: Unit, program: Program) -> None:
    """Enter the other names of functions and objects; report one of which none is defined here."""
    for symbol in unit.scope.names.values():
        if isinstance(symbol, ObjectSymbol | FunctionSymbol) and symbol.alias and symbol.link_name:
            _enter_alias(unit, program, symbol.link_name, symbol.alias, symbol.location)
            if symbol.is_weak:
                program.weak.add(symbol.link_name)
    for name, weak in unit.weak.items():
        if weak.alias and name not in unit.scope.names:
            _enter_alias(unit, program, name, weak.alias, weak.location)
            program.weak.add(name)


def _enter_alias(unit: Unit, program: Program, name: str, alias: str, location: Location) -> None:
    target = getattr(unit.scope.names.get(alias), "link_name", None) or alias
    if target in program.functions or target in program.data:
        program.aliases[name] = target
    else:
        text = f"'{name}' is an alias of '{alias}', which is not defined here"
        unit.error(location, text)


def _note(program: Program, symbol: FunctionSymbol) -> None:
    """Record the linker's properties of a defined function."""
    if symbol.is_weak:
        program.weak.add(symbol.link_name)
    if symbol.starts is not None:
        program.starts.append((symbol.starts, symbol.link_name))
    if symbol.ends is not None:
        program.ends.append((symbol.ends, symbol.link_name))


def _define(state: UnitState, definition: tree.ObjectDefinition) -> None:
    """Define a global or static object."""
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
        _fill(state, data, definition.initialiser)
    state.program.data[data.name] = data
    if symbol.is_weak:
        state.program.weak.add(data.name)


def _fill(state: UnitState, data: Data, initialiser: tree.Initialiser) -> None:
    image = Image(data.size)
    for each in initialiser.values:
        image.put(each)
    for offset, address in sorted(image.addresses.items()):
        name = _base_name(state, address)
        state.use(name, data.location)
        data.relocations.append(Relocation(offset, name, address.offset))
    if data.relocations or any(image.content):
        data.content = bytes(image.content)


def _base_name(state: UnitState, address: ConstantAddress) -> str:
    base = address.base
    if isinstance(base, tree.StringLiteral):
        return state.string(base)
    assert base is not None
    assert base.link_name is not None
    return base.link_name
