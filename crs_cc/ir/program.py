"""What a compiled program is: functions as graphs of basic blocks, and data.

A front end makes one `Program` of each C file, `runtime.link` joins them, `runtime.codegen` turns
the whole into WebAssembly. The rules of the form are checked by `ir.verify`; `ir.text` prints it.

The form in short:

- A `Register` holds one value of one type and may be assigned many times. Variables whose address
  is not taken are registers; all other variables are `Slot`s in the function's frame in memory.
- A `Block` is a run of instructions and one terminator. A `Call` and a `Request` are terminators,
  because a program can be suspended there and go on later: they are resume points.
- Operands are registers or `Constant`s. An address is a base (register, slot, or the name of a
  global object or function) and an offset in bytes.
- Every instruction carries the `Location` of the C source it came from.
- Calls follow the i386 convention: arguments lie one after the other in memory, each rounded up to
  4 bytes; the callee finds its parameters there, whatever prototype the caller believed in.

Names of operators are WebAssembly's (`i32.add`, `f64.convert_i32_s`), with C's meaning where the
two differ: the division operators and the conversions from floating to integer types never trap
silently, codegen adds the checks. `ir.instruction` holds the instructions one by one.

>>> from crs_cc.core.source import Location
>>> here = Location("twice.c", 1, 1)
>>> n = Register(0, "i32")
>>> double = Register(1, "i32")
>>> body = Block("entry", [Binary(here, double, "i32.mul", n, Constant("i32", 2))])
>>> body.terminator = Return(here, double)
>>> twice = Function("twice", here, result="i32", parameters=[Parameter(n, "i32", 4)],
...                  registers=[n, double], blocks=[body])
>>> [block.fuel for block in twice.blocks]
[2]
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from typing import TYPE_CHECKING, Any

from crs_cc.ir.instruction import (
    VARARGS,
    Address,
    Argument,
    Base,
    Binary,
    Block,
    Branch,
    ByteState,
    Call,
    Callers,
    Constant,
    Copy,
    Fill,
    Instruction,
    Jump,
    Lifetime,
    Load,
    LongJump,
    Mark,
    Move,
    Operand,
    Register,
    Request,
    Return,
    SetJump,
    Slot,
    State,
    Statement,
    Stop,
    Store,
    Switch,
    Terminator,
    Unary,
    Variable,
)
from crs_cc.ir.value_type import MEMORY_SIZE, VALUE_TYPE, MemoryType, ValueType

if TYPE_CHECKING:
    from crs_cc.core.source import Location
    from crs_cc.ir.types import CType

__all__ = [
    "MEMORY_SIZE",
    "VALUE_TYPE",
    "VARARGS",
    "Address",
    "Argument",
    "Base",
    "Binary",
    "Block",
    "Branch",
    "ByteState",
    "Call",
    "Callers",
    "Constant",
    "Copy",
    "Data",
    "Fill",
    "Function",
    "Instruction",
    "Jump",
    "Lifetime",
    "Load",
    "LongJump",
    "Mark",
    "MemoryType",
    "Move",
    "Operand",
    "Parameter",
    "Program",
    "Register",
    "Relocation",
    "Request",
    "Return",
    "SetJump",
    "Slot",
    "State",
    "Statement",
    "Stop",
    "Store",
    "Switch",
    "Terminator",
    "Unary",
    "ValueType",
    "Variable",
]


@dataclass(slots=True, eq=False)
class Parameter:
    """A parameter, at the next multiple of 4 in the argument area.

    Attributes:
        place: the register it is loaded into at entry, or the slot that lies over it in memory.
        memory: how it lies in memory; None for a struct.
        size: size in bytes, before rounding up to 4.
        variable: the C parameter as it is passed, where it becomes another variable.
    """

    place: Register | Slot
    memory: MemoryType | None
    size: int
    variable: Variable | None = None


@dataclass(slots=True, eq=False)
class Function:
    """A function. The first block is its entry.

    Attributes:
        name: the linker's name; a static function has its file in front (`wander.c:turn`).
        result: the type of the returned value; None for void and struct results.
        slots: frame slots apart from those of parameters.
        trusted: whether it works on memory that C may not touch, as the allocator does.
    """

    name: str
    location: Location
    result: ValueType | None = None
    parameters: list[Parameter] = field(default_factory=list)
    variadic: bool = False
    registers: list[Register] = field(default_factory=list)
    slots: list[Slot] = field(default_factory=list)
    blocks: list[Block] = field(default_factory=list)
    ctype: CType | None = None
    trusted: bool = False

    def __getstate__(self) -> dict[str, Any]:
        """Return the function with blocks by number, so that pickling does not follow jumps."""
        number = {block: position for position, block in enumerate(self.blocks)}
        state = {each.name: getattr(self, each.name) for each in fields(self)}
        state["blocks"] = [
            (block.label, block.instructions, renumber(block.terminator, number.__getitem__))
            for block in self.blocks
        ]
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        rows = state["blocks"]
        blocks = [Block(label, instructions) for label, instructions, _ in rows]
        for block, (_, _, terminator) in zip(blocks, rows, strict=True):
            block.terminator = renumber(terminator, blocks.__getitem__)
        for name, value in state.items():
            setattr(self, name, value)
        self.blocks = blocks


@dataclass(frozen=True, slots=True)
class Relocation:
    """A place in an object's bytes that takes the address `symbol + addend`."""

    offset: int
    symbol: str
    addend: int = 0


@dataclass(slots=True, eq=False)
class Data:
    """A global object.

    Attributes:
        name: the linker's name; a static object has its file in front.
        content: initial bytes, as long as `size`; None when all zero.
        tentative: declared without initialiser, so that other files may define it too.
    """

    name: str
    size: int
    align: int
    location: Location
    content: bytes | None = None
    relocations: list[Relocation] = field(default_factory=list)
    tentative: bool = False
    variable: Variable | None = None


@dataclass(slots=True, eq=False)
class Program:
    """What a file, or all files of a program together, define.

    Attributes:
        functions: by name.
        data: by name.
        undefined: where names that are used but not defined were first used.
        declared: of names that are used but not defined, as what and where they are declared.
        weak: names whose definition gives way to another one.
        starts: functions to be called before `main`, with their priority, the lowest first.
        ends: functions to be called after the program's end, the highest priority first.
    """

    functions: dict[str, Function] = field(default_factory=dict)
    data: dict[str, Data] = field(default_factory=dict)
    undefined: dict[str, Location] = field(default_factory=dict)
    declared: dict[str, tuple[CType, Location]] = field(default_factory=dict)
    weak: set[str] = field(default_factory=set)
    starts: list[tuple[int, str]] = field(default_factory=list)
    ends: list[tuple[int, str]] = field(default_factory=list)


def renumber(terminator: Any, change: Callable[[Any], Any]) -> Any:
    """Return a copy of a terminator with `change` applied to each of its targets."""
    match terminator:
        case Jump(target=target):
            return replace(terminator, target=change(target))
        case Call(then=then) | Request(then=then) | SetJump(then=then):
            return replace(terminator, then=change(then))
        case Branch(then=then, otherwise=otherwise):
            return replace(terminator, then=change(then), otherwise=change(otherwise))
        case Switch(cases=cases, default=default):
            moved = [(value, change(block)) for value, block in cases]
            return replace(terminator, cases=moved, default=change(default))
    return terminator
