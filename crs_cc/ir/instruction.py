"""The instructions of the IR and their operands.

`ir.program` describes the structure of a program.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any, Final, SupportsIndex, TypeAlias

from crs_cc.core.source import Location
from crs_cc.ir.types import (
    ArrayType,
    CType,
    EnumType,
    FloatType,
    FunctionType,
    IntegerType,
    PointerType,
)
from crs_cc.ir.value_type import MemoryType, ValueType


@dataclass(frozen=True, slots=True)
class Variable:
    """A C variable, for debuggers and messages.

    Attributes:
        block: the start and end of the block that it is declared in; None if its scope is the whole
            function or file.
        is_indirect: whether the variable is a pointer to the named object; an array of variable
            length is one.
    """

    name: str
    ctype: CType
    location: Location
    block: tuple[Location, Location] | None = None
    is_indirect: bool = False

    def reaches(self, location: Location) -> bool:
        """Return whether a location is in the variable's block, even before its declaration.

        A location in another file, which may be included in the block, counts as inside.
        """
        if self.block is None or location.file != self.block[0].file:
            return True
        return self.block[0] <= location <= self.block[1]

    def is_visible(self, location: Location) -> bool:
        """Return whether the variable is visible at a location unless an inner one hides it."""
        is_declared = location.file != self.location.file or self.location <= location
        return is_declared and self.reaches(location)


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

    def __reduce_ex__(self, protocol: SupportsIndex) -> str | tuple[Any, ...]:
        """Keep the identity of `VARARGS` when a program is pickled."""
        return "VARARGS" if self is VARARGS else object.__reduce_ex__(self, protocol)


@dataclass(frozen=True, slots=True)
class Constant:
    """A constant operand. Integers are kept in the signed range of their type."""

    type: ValueType
    value: int | float


Operand: TypeAlias = Register | Constant
VARARGS: Final = Slot("...", 0, 4)
"""As the base of an `Address`: the first byte after the named parameters (for `va_start`)."""
Base: TypeAlias = Register | Slot | str
"""Where an address starts: a pointer value, a frame slot, or a global object or function."""


class ByteState(IntEnum):
    """The state of a byte of memory, which checked builds keep in shadow memory.

    Bit 0 is set if it is accessible, bit 1 if it may be written, and bit 7 if it has a value. One
    of the other bits is clear in variable arguments, which says as what they were passed. In bytes
    without value they are a part of the number of their origin, see `runtime.codegen.origins`.
    """

    INACCESSIBLE = 0
    WITHOUT_VALUE = 3
    PASSED_STRUCT = 0xBF
    PASSED_FLOATING = 0xDF
    PASSED_WIDE = 0xEF
    PASSED_POINTER = 0xF7
    PASSED_INTEGER = 0xFB
    CONSTANT = 0xFD
    WITH_VALUE = 0xFF


def plain_states(states: bytes) -> bytes:
    """Return the states of bytes without the bits for constants, arguments and origins."""
    return states.translate(_PLAIN)


_PLAIN: Final = bytes(
    ByteState.WITH_VALUE if state >> 7 else ByteState.WITHOUT_VALUE if state & 1 else 0
    for state in range(256)
)


def passed_state(ctype: CType) -> ByteState | None:
    """Return the state of a variable argument of a type; None if no argument has this type.

    An argument of type `float` is passed as `double` (C17 6.5.2.2p6).
    """
    match ctype:
        case IntegerType() | EnumType():
            return ByteState.PASSED_WIDE if ctype.size > 4 else ByteState.PASSED_INTEGER
        case FloatType():
            return ByteState.PASSED_FLOATING if ctype.size > 4 else None
        case PointerType():
            return ByteState.PASSED_POINTER
    return ByteState.PASSED_STRUCT


@dataclass(slots=True, eq=False)
class Instruction:
    """The base of all instructions: the location in the C source, for messages."""

    location: Location


@dataclass(slots=True, eq=False)
class Statement(Instruction):
    """The start of a C statement: no code, but a stop for the debugger."""


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
    """`result = left op right`; the result of a comparison is an i32, 0 or 1.

    A `checked` operation may have an undefined result in C: a shift, whose count must be less than
    the width of its type, or signed arithmetic, which may overflow.
    """

    result: Register
    op: str
    left: Operand
    right: Operand
    checked: bool = False


@dataclass(slots=True, eq=False)
class Load(Instruction):
    """`result = *(base + offset)`, widened from the type `memory`.

    With a slot or a name as base the access must be inside that object; an access that is not known
    to be uses a register from `Address`, and is checked at run time.

    An `unjudged` load may read uninitialised bytes, which are stored back unchanged. `is_const` is
    set for a const lvalue, whose bytes may be constant.

    `within` is the object that the address was computed from, or the start of a heap block: the
    access must be inside, which checked builds test. It costs no fuel.
    """

    result: Register
    base: Base
    offset: int
    memory: MemoryType
    unjudged: bool = False
    is_const: bool = False
    within: Base | None = None


@dataclass(slots=True, eq=False)
class Store(Instruction):
    """`*(base + offset) = source`, narrowed to the type `memory`. Bases as for `Load`."""

    base: Base
    offset: int
    source: Operand
    memory: MemoryType
    within: Base | None = None


@dataclass(slots=True, eq=False)
class Address(Instruction):
    """`result = base + offset`; the address of a function is its function pointer."""

    result: Register
    base: Base
    offset: int


@dataclass(slots=True, eq=False)
class Bounds(Instruction):
    """Stops the program if `index + shift` is not the index of an element of an array.

    It has no effect in unchecked builds, and costs no fuel.

    Attributes:
        index: an i32.
        base: where the array starts, together with `offset`.
        array: its type, of known length.
        shift: a constant that is added to the index.
        element: where the element is, as a register and an offset; None if `index` is a constant.
    """

    index: Operand
    base: Base
    offset: int
    array: ArrayType
    shift: int = 0
    element: tuple[Register, int] | None = None


@dataclass(slots=True, eq=False)
class SameObject(Instruction):
    """Checks that two pointers are to the same object (C17 6.5.6p9, 6.5.8p5).

    It has no effect in unchecked builds, and costs no fuel. `size` is that of what they point to. A
    difference of others stops the program, a comparison (`is_order`) is noted.
    """

    left: Operand
    right: Operand
    size: int
    is_order: bool


@dataclass(slots=True, eq=False)
class Passed(Instruction):
    """Stops the program if the variable argument at an address was passed as another type.

    It has no effect in unchecked builds, and costs no fuel.
    """

    address: Register
    ctype: CType


@dataclass(slots=True, eq=False)
class Copy(Instruction):
    """A copy of `size` bytes, as by `memmove`; the operands are i32, both ranges are checked."""

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
class Lifetime(Instruction):
    """The start, without a value, or end of the lifetime of a slot's object. Others always live."""

    slot: Slot
    begins: bool


@dataclass(slots=True, eq=False)
class Seal(Instruction):
    """Makes a slot's object constant, after its initialisation; it costs no fuel."""

    slot: Slot


@dataclass(slots=True, eq=False)
class Mark(Instruction):
    """Sets the state of `size` bytes at `target`; `state` is one of `ByteState`.

    It is for the allocator and has no effect in unchecked builds.
    """

    target: Operand
    size: Operand
    state: int


@dataclass(slots=True, eq=False)
class MarkUnset(Instruction):
    """Sets the state of `size` bytes at `target` to that without value.

    `origin` is the number of the call that allocated them. It is for the allocator and has no
    effect in unchecked builds.
    """

    target: Operand
    size: Operand
    origin: Operand


@dataclass(slots=True, eq=False)
class Callers(Instruction):
    """Writes the numbers of the innermost `count` call sites to `target`, an i32 each.

    It is for the allocator and has no effect in unchecked builds. The first is the call of this
    function; the outermost is followed by zeros.
    """

    target: Operand
    count: int


@dataclass(slots=True, eq=False)
class State(Instruction):
    """`result` is the state of the byte at `address`; in unchecked builds it is inaccessible."""

    result: Register
    address: Operand


@dataclass(slots=True, eq=False)
class Jump(Instruction):
    """A jump to another block."""

    target: Block


@dataclass(slots=True, eq=False)
class Branch(Instruction):
    """A jump to `then` if the i32 `condition` is not zero, else to `otherwise`."""

    condition: Operand
    then: Block
    otherwise: Block


@dataclass(slots=True, eq=False)
class Switch(Instruction):
    """A jump to the block of the case equal to the i32 or i64 `value`, else to `default`."""

    value: Operand
    cases: list[tuple[int, Block]]
    default: Block


@dataclass(slots=True, eq=False)
class Return(Instruction):
    """A return from the function. Without a value the caller gets an unspecified one."""

    value: Operand | None


@dataclass(frozen=True, slots=True)
class Argument:
    """An argument of a call: a value stored as `memory`, or `size` bytes at address `value`.

    Attributes:
        value: the value; for a struct its address (i32).
        memory: the type in which the value is stored; None for a struct, which is copied.
        size: size in bytes, before rounding up to 4.
        ctype: the C type of a variable argument.
    """

    value: Operand
    memory: MemoryType | None
    size: int
    ctype: CType | None = None


@dataclass(slots=True, eq=False)
class Call(Instruction):
    """A call of a function by name or through a function pointer; continues at `then`.

    `result`, if any, receives the returned value. A struct is returned through a hidden first
    argument that points to the caller's memory. `prototype` is the type
    by which a pointer is called, if the function must have it.
    """

    callee: str | Register
    arguments: list[Argument]
    result: Register | None
    then: Block
    prototype: FunctionType | None = None


@dataclass(slots=True, eq=False)
class Request(Instruction):
    """Posts request `code` with the message at address `message`, waits, continues at `then`.

    The message is `struct __crs_message` (see `crs_cc.requests`); the reply overwrites it, and
    `result` receives the reply's i32 result.
    """

    code: Operand
    message: Operand
    result: Register
    then: Block


@dataclass(slots=True, eq=False)
class Stop(Instruction):
    """Ends the program with a run-time error.

    `kind` is one of `crs_cc.requests.ERROR_KINDS`, for example "unreachable"; `value` is the
    address at fault, if there is one.
    """

    kind: str
    value: Operand = Constant("i32", 0)


@dataclass(slots=True, eq=False)
class SetJump(Instruction):
    """C's `setjmp`: continues at `then` with result 0, and later with that of a `LongJump`.

    Stores the number of its resume point at `buffer`. A jump needs this number and the
    `activation`, which is not 0 and identifies the call of the function; the register is assigned
    once, at the function's start.
    """

    buffer: Register
    activation: Register
    result: Register
    then: Block


@dataclass(slots=True, eq=False)
class LongJump(Instruction):
    """Leaves all functions up to the one with this `activation`, which continues at `place`.

    The operands are i32; `value` becomes the result of that `SetJump`. It is a run-time error if
    no active function has that activation.
    """

    activation: Operand
    place: Operand
    value: Operand


_FREE: Final = frozenset({Statement, Lifetime, Seal, Bounds, SameObject, Passed})
"""The instructions that generate no code; looking up the class is faster than `isinstance`."""

Terminator: TypeAlias = Jump | Branch | Switch | Return | Call | Request | Stop | SetJump | LongJump


@dataclass(slots=True, eq=False)
class Block:
    """A basic block. `label` is unique in its function."""

    label: str
    instructions: list[Instruction] = field(default_factory=list)
    terminator: Terminator | None = None

    @property
    def fuel(self) -> int:
        """The cost of the block: one unit, and one for each instruction that generates code."""
        return 1 + len([each for each in self.instructions if each.__class__ not in _FREE])

    def successors(self) -> list[Block]:
        """Return the blocks that may follow, in a fixed order, each once."""
        match self.terminator:
            case Jump(target=block) | Call(then=block) | Request(then=block) | SetJump(then=block):
                return [block]
            case Branch(then=then, otherwise=otherwise):
                return [then] if then is otherwise else [then, otherwise]
            case Switch(cases=cases, default=default):
                return list(dict.fromkeys([block for _, block in cases] + [default]))
        return []
