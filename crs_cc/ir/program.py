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
silently, codegen adds the checks.

>>> from crs_cc.source import Location
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

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final, Literal, TypeAlias

if TYPE_CHECKING:
    from crs_cc.ir.types import CType
    from crs_cc.source import Location

ValueType: TypeAlias = Literal["i32", "i64", "f32", "f64"]
MemoryType: TypeAlias = Literal["i8", "u8", "i16", "u16", "i32", "i64", "f32", "f64"]

MEMORY_SIZE: Final[dict[MemoryType, int]] = {
    "i8": 1, "u8": 1, "i16": 2, "u16": 2, "i32": 4, "i64": 8, "f32": 4, "f64": 8,
}  # fmt: skip
VALUE_TYPE: Final[dict[MemoryType, ValueType]] = {
    "i8": "i32", "u8": "i32", "i16": "i32", "u16": "i32",
    "i32": "i32", "i64": "i64", "f32": "f32", "f64": "f64",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Variable:
    """A C variable as its programmer knows it, for debuggers and messages."""

    name: str
    ctype: CType
    location: Location


@dataclass(slots=True, eq=False)
class Register:
    """A typed virtual register; `variable` is set when it holds a C variable."""

    index: int
    type: ValueType
    variable: Variable | None = None


@dataclass(slots=True, eq=False)
class Slot:
    """Bytes in the function's frame; `variable` is set when they hold a C variable."""

    name: str
    size: int
    align: int
    variable: Variable | None = None


@dataclass(frozen=True, slots=True)
class Constant:
    """A constant operand. Integers are kept in the signed range of their type."""

    type: ValueType
    value: int | float


Operand: TypeAlias = Register | Constant
VARARGS: Final = Slot("...", 0, 4)
"""As the base of an `Address`: the first byte behind the named parameters (for `va_start`)."""
Base: TypeAlias = Register | Slot | str
"""Where an address starts: a pointer value, a frame slot, or a global object or function."""


@dataclass(slots=True, eq=False)
class Instruction:
    """What all instructions have: the place in the C source to blame."""

    location: Location


@dataclass(slots=True, eq=False)
class Statement(Instruction):
    """Marks the start of a C statement: no code when running, a stop for the debugger."""


@dataclass(slots=True, eq=False)
class Move(Instruction):
    """`result = source`."""

    result: Register
    source: Operand


@dataclass(slots=True, eq=False)
class Unary(Instruction):
    """`result = op source`, for negation, rounding, counting bits and every conversion."""

    result: Register
    op: str
    source: Operand


@dataclass(slots=True, eq=False)
class Binary(Instruction):
    """`result = left op right`; comparisons give an i32, 0 or 1."""

    result: Register
    op: str
    left: Operand
    right: Operand


@dataclass(slots=True, eq=False)
class Load(Instruction):
    """`result = *(base + offset)`, widened as `memory` says.

    With a slot or a name as base the access must lie inside that object; an access that is not
    known to do so goes through a register made by `Address`, and is checked while running.
    """

    result: Register
    base: Base
    offset: int
    memory: MemoryType


@dataclass(slots=True, eq=False)
class Store(Instruction):
    """`*(base + offset) = source`, narrowed as `memory` says. Bases as for `Load`."""

    base: Base
    offset: int
    source: Operand
    memory: MemoryType


@dataclass(slots=True, eq=False)
class Address(Instruction):
    """`result = base + offset`; the name of a function gives its function pointer."""

    result: Register
    base: Base
    offset: int


@dataclass(slots=True, eq=False)
class Copy(Instruction):
    """Copies `size` bytes as `memmove` does; the operands are i32, both ranges are checked."""

    target: Operand
    source: Operand
    size: Operand


@dataclass(slots=True, eq=False)
class Fill(Instruction):
    """Sets `size` bytes to the low byte of `value`, as `memset` does; checked like `Copy`."""

    target: Operand
    value: Operand
    size: Operand


@dataclass(slots=True, eq=False)
class Jump(Instruction):
    """Goes to another block."""

    target: Block


@dataclass(slots=True, eq=False)
class Branch(Instruction):
    """Goes to `then` when the i32 `condition` is not zero, else to `otherwise`."""

    condition: Operand
    then: Block
    otherwise: Block


@dataclass(slots=True, eq=False)
class Switch(Instruction):
    """Goes to the block of the case equal to the i32 or i64 `value`, else to `default`."""

    value: Operand
    cases: list[tuple[int, Block]]
    default: Block


@dataclass(slots=True, eq=False)
class Return(Instruction):
    """Leaves the function. Without a value the caller finds an unspecified one."""

    value: Operand | None


@dataclass(frozen=True, slots=True)
class Argument:
    """One argument of a call: a value stored as `memory`, or `size` bytes at address `value`.

    Attributes:
        value: the value; for a struct its address (i32).
        memory: how the value is stored; None for a struct, which is copied.
        size: size in bytes, before rounding up to 4.
    """

    value: Operand
    memory: MemoryType | None
    size: int


@dataclass(slots=True, eq=False)
class Call(Instruction):
    """Calls a function by name, or through a function pointer in a register; goes on at `then`.

    `result`, if any, takes the returned value. A struct result is returned through a hidden first
    argument that points to the caller's memory.
    """

    callee: str | Register
    arguments: list[Argument]
    result: Register | None
    then: Block


@dataclass(slots=True, eq=False)
class Request(Instruction):
    """Posts request `code` with the message at address `message`, stops, goes on at `then`.

    The message is `struct __crs_message` (see `crs_cc.requests`); the reply takes its place, and
    `result` takes the reply's i32 result.
    """

    code: Operand
    message: Operand
    result: Register
    then: Block


@dataclass(slots=True, eq=False)
class Stop(Instruction):
    """Ends the program with an error that the C source asked for or cannot get past.

    `kind` is one of `crs_cc.requests.ERROR_KINDS`, for example "unreachable".
    """

    kind: str


Terminator: TypeAlias = Jump | Branch | Switch | Return | Call | Request | Stop


@dataclass(slots=True, eq=False)
class Block:
    """A basic block. `label` is unique in its function."""

    label: str
    instructions: list[Instruction] = field(default_factory=list)
    terminator: Terminator | None = None

    @property
    def fuel(self) -> int:
        """Gives what running the block costs: one unit for each instruction that does something."""
        return 1 + sum(not isinstance(each, Statement) for each in self.instructions)

    def successors(self) -> list[Block]:
        """Gives the blocks that may come next, in a fixed order, each once."""
        match self.terminator:
            case Jump(target=block) | Call(then=block) | Request(then=block):
                return [block]
            case Branch(then=then, otherwise=otherwise):
                return [then] if then is otherwise else [then, otherwise]
            case Switch(cases=cases, default=default):
                return list(dict.fromkeys([block for _, block in cases] + [default]))
        return []


@dataclass(slots=True, eq=False)
class Parameter:
    """A parameter, at the next multiple of 4 in the argument area.

    Attributes:
        place: the register it is loaded into at entry, or the slot that lies over it in memory.
        memory: how it lies in memory; None for a struct.
        size: size in bytes, before rounding up to 4.
    """

    place: Register | Slot
    memory: MemoryType | None
    size: int


@dataclass(slots=True, eq=False)
class Function:
    """A function. The first block is its entry.

    Attributes:
        name: the linker's name; a static function has its file in front (`wander.c:turn`).
        result: the type of the returned value; None for void and struct results.
        slots: frame slots apart from those of parameters.
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
    """Functions and data by name, and where names that are used but not defined were first used."""

    functions: dict[str, Function] = field(default_factory=dict)
    data: dict[str, Data] = field(default_factory=dict)
    undefined: dict[str, Location] = field(default_factory=dict)
