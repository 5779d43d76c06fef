"""A small function in which calls of small functions are replaced by their bodies.

So a struct that is passed between them is seen by scalar replacement as a whole.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any, Final

from crs_cc.core.source import Location
from crs_cc.ir.instruction import (
    Argument,
    Binary,
    Block,
    Bounds,
    Call,
    Constant,
    Instruction,
    Jump,
    Load,
    Move,
    Operand,
    Register,
    Return,
    Terminator,
    Unary,
)
from crs_cc.ir.program import Function, Parameter, renumber
from crs_cc.ir.value_type import MemoryType
from crs_cc.runtime.codegen.body import Body
from crs_cc.runtime.codegen.scalar_replacement import ReadCheck, WriteCheck

_EXTENSIONS: Final[dict[MemoryType, str]] = {"i8": "i32.extend8_s", "i16": "i32.extend16_s"}
_MASKS: Final[dict[MemoryType, int]] = {"u8": 255, "u16": 65535}


@dataclass(slots=True, eq=False)
class Expanded:
    """A function without calls.

    Attributes:
        function: the function.
        fuel: the fuel of each block, as with calls.
        deferred: for each load of an expanded call, whether its check is deferred in the callee.
        checks: the checks of structs that expanded calls take and return, with the calls.
    """

    function: Function
    fuel: dict[Block, int] = field(default_factory=dict)
    deferred: dict[Load, bool] = field(default_factory=dict)
    checks: dict[Instruction, Call] = field(default_factory=dict)


def expand(function: Function, calls: Mapping[Call, Body | None]) -> Expanded | None:
    """Return a small function without its calls; None if one cannot be expanded."""
    found = {call: body for call, body in calls.items() if body is not None}
    if not all(call in found and _is_expandable(call, found[call]) for call in calls):
        return None
    return _Expansion(function, found).run() if calls else _unchanged(function)


def expand_some(function: Function, calls: Mapping[Call, Body]) -> Expanded:
    """Return a function without those of these calls in which nothing but structs can fail."""
    chosen = {
        call: body
        for call, body in calls.items()
        if not body.can_fail_inside and _is_expandable(call, body)
    }
    return _Expansion(function, chosen).run() if chosen else _unchanged(function)


def _unchanged(function: Function) -> Expanded:
    return Expanded(function, {block: block.fuel for block in function.blocks})


def _is_expandable(call: Call, body: Body) -> bool:
    """Return whether all structs that are passed have members that are used."""
    pairs = zip(call.arguments, body.function.parameters, strict=False)
    return all(
        isinstance(argument.value, Register) and body.members[parameter]
        for argument, parameter in pairs
        if parameter.memory is None
    )


class _Expansion:
    """Expands the calls of one function."""

    def __init__(self, function: Function, calls: Mapping[Call, Body]) -> None:
        self.function = function
        self.calls = calls
        self.registers = list(function.registers)
        self.blocks: list[Block] = []
        self.made = Expanded(function)

    def run(self) -> Expanded:
        """Return the function without calls."""
        copied = {block: Block(block.label) for block in self.function.blocks}
        for block, copy in copied.items():
            self.blocks.append(copy)
            self.made.fuel[copy] = block.fuel
            copy.instructions = list(block.instructions)
            end = block.terminator
            if isinstance(end, Call) and end in self.calls:
                self._call(copy, end, copied[end.then])
            else:
                copy.terminator = renumber(end, copied.__getitem__)
        self.made.function = replace(self.function, registers=self.registers, blocks=self.blocks)
        return self.made

    def _call(self, block: Block, call: Call, then: Block) -> None:
        """Write the callee's blocks, and let `block` jump to them instead of calling."""
        body = self.calls[call]
        names: dict[Register, Register] = {}
        for register in body.function.registers:
            names[register] = Register(len(self.registers), register.type)
            self.registers.append(names[register])
        pairs = zip(call.arguments, body.function.parameters, strict=False)
        for argument, parameter in pairs:
            block.instructions += _passed(call.location, argument, parameter, body, names)
        copied = {each: Block(f"{block.label} {each.label}") for each in body.function.blocks}
        for each, copy in copied.items():
            self.blocks.append(copy)
            self.made.fuel[copy] = body.fuel[each]
            copy.instructions = [self._renamed(it, names, body) for it in each.instructions]
            copy.terminator = self._end(copy, each.terminator, names, call, then)
            if not isinstance(each.terminator, Return):
                copy.terminator = renumber(copy.terminator, copied.__getitem__)
        block.terminator = Jump(call.location, copied[body.function.blocks[0]])
        for it in (it for each in [block, *copied.values()] for it in each.instructions):
            if isinstance(it, ReadCheck | WriteCheck):
                self.made.checks.setdefault(it, call)

    def _renamed(self, it: Instruction, names: dict[Register, Register], body: Body) -> Instruction:
        renamed = _renamed(it, names)
        if isinstance(it, Load) and isinstance(renamed, Load):
            self.made.deferred[renamed] = body.deferred.is_deferred(it)
        return renamed

    @staticmethod
    def _end(
        block: Block,
        end: Terminator | None,
        names: dict[Register, Register],
        call: Call,
        then: Block,
    ) -> Terminator | None:
        """Return the end of a callee's block; a returned value is moved to the call's result."""
        if not isinstance(end, Return):
            return None if end is None else _renamed(end, names)  # type: ignore[return-value]
        if call.result is not None and end.value is not None:
            value = _operand(end.value, names)
            block.instructions.append(Move(end.location, call.result, value))
        return Jump(end.location, then)


def _operand(value: Operand, names: dict[Register, Register]) -> Operand:
    return names[value] if isinstance(value, Register) else value


def _renamed(it: Instruction, names: dict[Register, Register]) -> Instruction:
    values = ((each.name, getattr(it, each.name)) for each in fields(it))
    changed: dict[str, Any] = {
        name: names[value] for name, value in values if isinstance(value, Register)
    }
    if isinstance(it, Bounds) and it.element is not None:
        changed["element"] = names[it.element[0]], it.element[1]
    return replace(it, **changed)


def _passed(
    location: Location,
    argument: Argument,
    parameter: Parameter,
    body: Body,
    names: dict[Register, Register],
) -> list[Instruction]:
    """Return the instructions that pass an argument."""
    value, place = argument.value, parameter.place
    if parameter.memory is None:
        assert isinstance(value, Register)
        loads = [
            Load(location, names[each.register], value, each.offset, each.memory, True)
            for each in body.members[parameter]
        ]
        return [ReadCheck(location, value, argument.size), *loads]
    assert isinstance(place, Register)
    target = names[place]
    if argument.memory == parameter.memory:
        return [Move(location, target, value)]
    if parameter.memory in _EXTENSIONS:
        return [Unary(location, target, _EXTENSIONS[parameter.memory], value)]
    mask = Constant("i32", _MASKS[parameter.memory])
    return [Binary(location, target, "i32.and", value, mask)]
