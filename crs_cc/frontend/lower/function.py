"""Lower a function definition: parameters, body, and simplification of its graph."""

from __future__ import annotations

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.scope import ENTRIES, ObjectSymbol
from crs_cc.frontend.lower.convert import convert_operand
from crs_cc.frontend.lower.graph import simplify
from crs_cc.frontend.lower.lowerer import (
    Lowering,
    memory_type,
    no_value,
    statements,
    value_type,
)
from crs_cc.frontend.lower.memory import store
from crs_cc.frontend.lower.rules import RULES
from crs_cc.frontend.lower.unit_state import UnitState
from crs_cc.ir.instruction import Block, Register, Return, Slot, Variable
from crs_cc.ir.names import in_library
from crs_cc.ir.pointer_bases import find_bases
from crs_cc.ir.program import Function, Parameter
from crs_cc.ir.types import CType, RecordType, VoidType
from crs_cc.ir.value_type import MEMORY_SIZE


def lower_function(unit: UnitState, definition: tree.FunctionDefinition) -> Function:
    """Return the IR of a function."""
    symbol, location = definition.symbol, definition.location
    result = symbol.type.result
    function = Function(
        symbol.link_name, location, variadic=symbol.type.variadic, ctype=symbol.type
    )
    entry = Block("entry")
    low = Lowering(unit, function, RULES, entry)
    function.blocks.append(entry)
    if isinstance(result, RecordType):
        low.result_pointer = low.new_register("i32")
        function.parameters.append(Parameter(low.result_pointer, "i32", 4))
    elif not isinstance(result, VoidType) or symbol.name in ENTRIES:
        function.result = "i32" if isinstance(result, VoidType) else value_type(result)
    for parameter, passed in zip(definition.parameters, definition.passed, strict=True):
        _parameter(low, parameter, passed)
    statements(low, definition.body)
    fall_off = Return(location, no_value(function))
    low.end(fall_off)
    kept = simplify(function)
    if not in_library(location):
        find_bases(function, unit.sizes)
    for block, name, place in low.references:
        if block in kept:
            unit.use(name, place)
    return function


def _parameter(low: Lowering, symbol: ObjectSymbol, passed: CType) -> None:
    """Lower a parameter; convert an old-style one from the type that it is passed as."""
    variable = symbol.variable()
    ctype, location = symbol.type, symbol.location
    if isinstance(ctype, RecordType):
        place: Register | Slot = Slot(symbol.name, ctype.size, ctype.align, variable)
        low.function.parameters.append(Parameter(place, None, ctype.size))
        low.places[symbol] = place
        return
    memory = memory_type(passed)
    if passed == ctype:
        if symbol.in_memory:
            place = Slot(symbol.name, ctype.size, min(4, ctype.align), variable)
        else:
            place = low.new_register(value_type(ctype), variable)
        low.places[symbol] = place
        low.function.parameters.append(Parameter(place, memory, MEMORY_SIZE[memory]))
        return
    arrived = low.new_register(value_type(passed))
    variable = Variable(symbol.name, passed, location)
    low.function.parameters.append(Parameter(arrived, memory, MEMORY_SIZE[memory], variable))
    _convert_parameter(low, symbol, arrived, passed, location)


def _convert_parameter(
    low: Lowering, symbol: ObjectSymbol, arrived: Register, passed: CType, location: Location
) -> None:
    place = low.local(symbol)
    if isinstance(place, Register):
        made = convert_operand(low, arrived, passed, symbol.type, location, into=place)
        low.move(place, made, location)
    else:
        made = convert_operand(low, arrived, passed, symbol.type, location)
        store(low, (place, 0), symbol.type, made, location)
