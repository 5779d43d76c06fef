"""A readable text form of programs; the output of `crs compile --emit ir`.

Registers are `%name.number`, frame slots `$name.number`, global names `@name`. A comment has the
location in the C source if it differs from that of the line before.

>>> from crs_cc.ir.instruction import Binary, Block, Constant, Register, Return
>>> from crs_cc.ir.program import Function, Parameter
>>> from crs_cc.core.source import Location
>>> here = Location("twice.c", 1, 1)
>>> n, double = Register(0, "i32"), Register(1, "i32")
>>> body = Block("entry", [Binary(here, double, "i32.mul", n, Constant("i32", 2))])
>>> body.terminator = Return(Location("twice.c", 2, 5), double)
>>> print(to_text(Program({"twice": Function(
...     "twice", here, "i32", [Parameter(n, "i32", 4)], registers=[n, double], blocks=[body])})))
function @twice(i32 %0) -> i32                    ; twice.c:1:1
  i32 %0 %1
entry:                                            ; fuel 2
  %1 = i32.mul %0, 2                              ; 1:1
  return %1                                       ; 2:5
<BLANKLINE>
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from textwrap import TextWrapper
from typing import Final

from crs_cc.core.source import Location
from crs_cc.ir import instruction as ir
from crs_cc.ir.program import Data, Function, Program
from crs_cc.ir.types import spell

_COMMENT_COLUMN: Final = 50
_BYTES_PER_LINE: Final = 16
_REGISTERS: Final = TextWrapper(92, break_long_words=False, break_on_hyphens=False)


def to_text(program: Program) -> str:
    """Return the text of the program's data, functions and undefined names, in order."""
    parts = [_data_text(data) for data in program.data.values()]
    parts += [FunctionText(function).render() for function in program.functions.values()]
    names = [_line(f"undefined @{name}", str(at)) for name, at in program.undefined.items()]
    if names:
        parts.append("".join(names))
    return "\n".join(parts)


def _line(text: str, comment: str = "") -> str:
    if not comment:
        return f"{text}\n"
    return f"{text.ljust(_COMMENT_COLUMN - 1)} ; {comment}\n"


def _data_text(data: Data) -> str:
    kind = " tentative" if data.tentative else ""
    head = f"data @{data.name} size {data.size} align {data.align}{kind}"
    lines = [_line(head, str(data.location))]
    content = data.content or b""
    for start in range(0, len(content), _BYTES_PER_LINE):
        row = content[start : start + _BYTES_PER_LINE]
        printable = "".join(chr(byte) if 32 <= byte < 127 else "." for byte in row)
        lines.append(_line(f"  {start:04x}: {row.hex(' ')}", printable))
    for relocation in data.relocations:
        at, symbol = relocation.offset, relocation.symbol
        lines.append(_line(f"  {at:04x}: address @{symbol}{_offset(relocation.addend)}"))
    return "".join(lines)


def _offset(offset: int) -> str:
    if offset == 0:
        return ""
    return f" + {offset}" if offset > 0 else f" - {-offset}"


class FunctionText:
    """The text of one function."""

    def __init__(self, function: Function) -> None:
        self.function = function
        places = [each.place for each in function.parameters]
        slots = [place for place in places if isinstance(place, ir.Slot)] + function.slots
        self._slot_names = {id(slot): f"${slot.name}.{i}" for i, slot in enumerate(slots)}
        self._slot_names[id(ir.VARARGS)] = "$..."
        self._place = function.location

    def render(self) -> str:
        """Return the head, the registers and slots, and the blocks, each line with its location."""
        lines = [_line(self._head(), str(self.function.location))]
        for type_ in ("i32", "i64", "f32", "f64"):
            names = [self._operand(each) for each in self.function.registers if each.type == type_]
            lines += [_line(f"  {type_} {row}") for row in _REGISTERS.wrap(" ".join(names))]
        for slot in self.function.slots:
            name = self._slot_names[id(slot)]
            lines.append(_line(f"  slot {name} size {slot.size} align {slot.align}"))
        for block in self.function.blocks:
            lines.extend(self._block(block))
        return "".join(lines)

    def _head(self) -> str:
        parameters = [
            f"{each.memory or f'bytes[{each.size}]'} {self._parameter(each.place)}"
            for each in self.function.parameters
        ]
        if self.function.variadic:
            parameters.append("...")
        result = f" -> {self.function.result}" if self.function.result else ""
        return f"function @{self.function.name}({', '.join(parameters)}){result}"

    def _parameter(self, place: ir.Register | ir.Slot) -> str:
        return self._slot(place) if isinstance(place, ir.Slot) else self._operand(place)

    def _block(self, block: ir.Block) -> Iterator[str]:
        yield _line(f"{block.label}:", f"fuel {block.fuel}")
        self._place = Location("")
        for instruction in block.instructions:
            yield self._instruction(instruction)
        if block.terminator is None:
            yield _line("  (no terminator)")
        else:
            yield self._instruction(block.terminator)

    def _instruction(self, instruction: ir.Instruction) -> str:
        render = _RENDER.get(type(instruction))
        text = render(self, instruction) if render else f"({type(instruction).__name__})"
        place, comment = instruction.location, ""
        if place != self._place:
            self._place = place
            comment = str(place).removeprefix(f"{self.function.location.file}:")
        first, *more = text.split("\n")
        return _line(f"  {first}", comment) + "".join(_line(f"    {each}") for each in more)

    # Operands

    def _operand(self, operand: ir.Operand) -> str:
        if not isinstance(operand, ir.Register):
            return repr(operand.value)
        name = f"{operand.variable.name}." if operand.variable else ""
        return f"%{name}{operand.index}"

    def _slot(self, slot: ir.Slot) -> str:
        return self._slot_names.get(id(slot), f"${slot.name}.?")

    def _address(self, base: ir.Base, offset: int) -> str:
        if isinstance(base, ir.Register):
            name = self._operand(base)
        else:
            name = self._slot(base) if isinstance(base, ir.Slot) else f"@{base}"
        return name + _offset(offset)

    def _argument(self, argument: ir.Argument) -> str:
        value = self._operand(argument.value)
        if argument.memory is None:
            return f"bytes[{argument.size}] at {value}"
        return f"{argument.memory} {value}"

    # Instructions

    def _statement(self, _statement: ir.Statement) -> str:
        return "statement"

    def _move(self, move: ir.Move) -> str:
        return f"{self._operand(move.result)} = {self._operand(move.source)}"

    def _unary(self, unary: ir.Unary) -> str:
        return f"{self._operand(unary.result)} = {unary.op} {self._operand(unary.source)}"

    def _binary(self, binary: ir.Binary) -> str:
        operands = f"{self._operand(binary.left)}, {self._operand(binary.right)}"
        return f"{self._operand(binary.result)} = {binary.op} {operands}"

    def _load(self, load: ir.Load) -> str:
        place = self._address(load.base, load.offset)
        note = " unjudged" if load.unjudged else ""
        return f"{self._operand(load.result)} = load {load.memory} [{place}]{note}"

    def _store(self, store: ir.Store) -> str:
        place = self._address(store.base, store.offset)
        return f"store {store.memory} [{place}], {self._operand(store.source)}"

    def _take_address(self, address: ir.Address) -> str:
        place = self._address(address.base, address.offset)
        return f"{self._operand(address.result)} = address {place}"

    def _bounds(self, bounds: ir.Bounds) -> str:
        place = self._address(bounds.base, bounds.offset)
        index = self._operand(bounds.index) + (f" + {bounds.shift}" if bounds.shift else "")
        return f"bounds {index} < {bounds.array.length} [{place}]"

    def _same_object(self, pair: ir.SameObject) -> str:
        what = "order" if pair.is_order else "same object"
        return f"{what} {self._operand(pair.left)}, {self._operand(pair.right)}"

    def _passed(self, passed: ir.Passed) -> str:
        return f"passed {spell(passed.ctype)} [{self._operand(passed.address)}]"

    def _copy(self, copy: ir.Copy) -> str:
        operands = (copy.target, copy.source, copy.size)
        return "copy [{}], [{}], size {}".format(*map(self._operand, operands))

    def _fill(self, fill: ir.Fill) -> str:
        operands = (fill.target, fill.value, fill.size)
        return "fill [{}], {}, size {}".format(*map(self._operand, operands))

    def _lifetime(self, lifetime: ir.Lifetime) -> str:
        return f"{'begin' if lifetime.begins else 'end'} {self._slot(lifetime.slot)}"

    def _seal(self, seal: ir.Seal) -> str:
        return f"seal {self._slot(seal.slot)}"

    def _mark(self, mark: ir.Mark) -> str:
        operands = (self._operand(mark.target), self._operand(mark.size))
        return "mark [{}], size {}, ".format(*operands) + ir.ByteState(mark.state).name.lower()

    def _mark_unset(self, mark: ir.MarkUnset) -> str:
        operands = map(self._operand, (mark.target, mark.size, mark.origin))
        return "mark [{}], size {}, origin {}".format(*operands)

    def _callers(self, callers: ir.Callers) -> str:
        return f"callers [{self._operand(callers.target)}], {callers.count}"

    def _state(self, state: ir.State) -> str:
        return f"{self._operand(state.result)} = state [{self._operand(state.address)}]"

    # Terminators

    def _jump(self, jump: ir.Jump) -> str:
        return f"jump {jump.target.label}"

    def _branch(self, branch: ir.Branch) -> str:
        condition = self._operand(branch.condition)
        return f"branch {condition} ? {branch.then.label} : {branch.otherwise.label}"

    def _switch(self, switch: ir.Switch) -> str:
        rows = [f"{value} -> {block.label}" for value, block in switch.cases]
        rows.append(f"else -> {switch.default.label}")
        return "\n".join([f"switch {self._operand(switch.value)}", *rows])

    def _return(self, leave: ir.Return) -> str:
        return "return" if leave.value is None else f"return {self._operand(leave.value)}"

    def _call(self, call: ir.Call) -> str:
        pointer = call.callee if isinstance(call.callee, ir.Register) else None
        callee = f"*{self._operand(pointer)}" if pointer else f"@{call.callee}"
        arguments = ", ".join(map(self._argument, call.arguments))
        result = f"{self._operand(call.result)} = " if call.result else ""
        kind = f"{call.result.type} " if call.result else ""
        return f"{result}call {kind}{callee}({arguments}) then {call.then.label}"

    def _request(self, request: ir.Request) -> str:
        code, message = self._operand(request.code), self._operand(request.message)
        result = self._operand(request.result)
        return f"{result} = request {code} [{message}] then {request.then.label}"

    def _stop(self, stop: ir.Stop) -> str:
        blamed = "" if isinstance(stop.value, ir.Constant) else f", {self._operand(stop.value)}"
        return f"stop '{stop.kind}'{blamed}"

    def _set_jump(self, jump: ir.SetJump) -> str:
        place, activation = self._operand(jump.buffer), self._operand(jump.activation)
        result = self._operand(jump.result)
        return f"{result} = setjmp [{place}], {activation} then {jump.then.label}"

    def _long_jump(self, jump: ir.LongJump) -> str:
        operands = (jump.activation, jump.place, jump.value)
        return "longjmp {}, {}, {}".format(*map(self._operand, operands))


_RENDER: Final[dict[type[ir.Instruction], Callable[..., str]]] = {
    ir.Statement: FunctionText._statement,
    ir.Move: FunctionText._move,
    ir.Unary: FunctionText._unary,
    ir.Binary: FunctionText._binary,
    ir.Load: FunctionText._load,
    ir.Store: FunctionText._store,
    ir.Address: FunctionText._take_address,
    ir.Bounds: FunctionText._bounds,
    ir.SameObject: FunctionText._same_object,
    ir.Passed: FunctionText._passed,
    ir.Copy: FunctionText._copy,
    ir.Fill: FunctionText._fill,
    ir.Lifetime: FunctionText._lifetime,
    ir.Seal: FunctionText._seal,
    ir.Mark: FunctionText._mark,
    ir.MarkUnset: FunctionText._mark_unset,
    ir.Callers: FunctionText._callers,
    ir.State: FunctionText._state,
    ir.Jump: FunctionText._jump,
    ir.Branch: FunctionText._branch,
    ir.Switch: FunctionText._switch,
    ir.Return: FunctionText._return,
    ir.Call: FunctionText._call,
    ir.Request: FunctionText._request,
    ir.Stop: FunctionText._stop,
    ir.SetJump: FunctionText._set_jump,
    ir.LongJump: FunctionText._long_jump,
}
