"""The intermediate representation of a program: functions as graphs of basic blocks, and data.

The front end compiles each C file to a `Program`, `runtime.link` joins them, `runtime.codegen`
translates the whole to WebAssembly. `ir.verify` checks the rules, `ir.text` prints a program.

In short:

- A `Register` holds one value of one type and may be assigned many times. Variables whose address
  is not taken are registers; all other variables are `Slot`s in the function's frame in memory.
- A `Block` is a sequence of instructions and one terminator. A `Call` and a `Request` are
  terminators because a program can be suspended and resumed there.
- Operands are registers or `Constant`s. An address is a base (register, slot, or the name of a
  global object or function) and an offset in bytes.
- Every instruction has the `Location` of the C source it comes from.
- Calls follow the i386 convention: arguments are consecutive in memory, each rounded up to 4 bytes;
  the callee reads its parameters there, whatever prototype the caller used.

Names of operators are WebAssembly's (`i32.add`, `f64.convert_i32_s`), with C's meaning where the
two differ: divisions and conversions from floating-point to integer types do not trap silently,
codegen adds checks. `ir.instruction` describes each instruction.

>>> from crs_cc.core.source import Location
>>> from crs_cc.ir.instruction import Binary, Constant, Return
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
from typing import Any

from crs_cc.core.source import Location
from crs_cc.ir.instruction import (
    Block,
    Branch,
    Call,
    Jump,
    Register,
    Request,
    SetJump,
    Slot,
    Switch,
    Variable,
)
from crs_cc.ir.types import CType
from crs_cc.ir.value_type import MemoryType, ValueType


@dataclass(slots=True, eq=False)
class Parameter:
    """A parameter, at the next multiple of 4 in the argument area.

    Attributes:
        place: the register it is loaded into at entry, or the slot that overlays it in memory.
        memory: its type in memory; None for a struct.
        size: size in bytes, before rounding up to 4.
        variable: the C parameter as it is passed, if it is converted to another variable.
    """

    place: Register | Slot
    memory: MemoryType | None
    size: int
    variable: Variable | None = None


@dataclass(slots=True, eq=False)
class Function:
    """A function. The first block is its entry.

    Attributes:
        name: the linker's name; a static function is prefixed with its file (`wander.c:turn`).
        result: the type of the returned value; None for void and struct results.
        slots: frame slots apart from those of parameters.
        trusted: whether it may access memory that C code may not, as the allocator does.
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
        """Return the state with blocks by number, so that pickling does not recurse along jumps."""
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
    """An offset in an object's bytes where the address `symbol + addend` is stored."""

    offset: int
    symbol: str
    addend: int = 0


@dataclass(slots=True, eq=False)
class Data:
    """A global object.

    Attributes:
        name: the linker's name; a static object is prefixed with its file.
        content: the initial bytes, `size` of them; None if all are zero.
        tentative: whether it is declared without initialiser, so that other files may define it.
    """

    name: str
    size: int
    align: int
    location: Location
    content: bytes | None = None
    relocations: list[Relocation] = field(default_factory=list)
    tentative: bool = False
    variable: Variable | None = None

    @property
    def is_constant(self) -> bool:
        """Return whether it must not be written: a string, or a const object."""
        return ':"' in self.name if self.variable is None else self.variable.ctype.const


@dataclass(slots=True, eq=False)
class Program:
    """The definitions of a file, or of all files of a program.

    Attributes:
        functions: the functions by name.
        data: the global objects by name.
        undefined: the first use of each name that is used but not defined.
        declared: the type and location of the declarations of undefined names.
        weak: the names whose definition can be overridden.
        optional: the undefined names that need no definition: their address is 0 without one.
        aliases: for each further name of a function or object, its own name.
        starts: functions to be called before `main`, with their priority, the lowest first.
        ends: functions to be called after the program's end, the highest priority first.
        unused: of a linked program, what the user has defined but nothing uses; for debuggers.
    """

    functions: dict[str, Function] = field(default_factory=dict)
    data: dict[str, Data] = field(default_factory=dict)
    undefined: dict[str, Location] = field(default_factory=dict)
    declared: dict[str, tuple[CType, Location]] = field(default_factory=dict)
    weak: set[str] = field(default_factory=set)
    optional: set[str] = field(default_factory=set)
    aliases: dict[str, str] = field(default_factory=dict)
    starts: list[tuple[int, str]] = field(default_factory=list)
    ends: list[tuple[int, str]] = field(default_factory=list)
    unused: Program | None = None


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
