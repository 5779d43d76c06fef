"""The instructions of the IR and what they work on.

`ir.program` says how they make up a program; each class here says what its instruction does.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Final, SupportsIndex, TypeAlias

from crs_cc.ir.value_type import MemoryType, ValueType

if TYPE_CHECKING:
    from crs_cc.core.source import Location
    from crs_cc.ir.types import CType


@dataclass(frozen=True, slots=True)
class Variable:
    """A C variable as its programmer knows it, for debuggers and messages.

    Attributes:
        block: the first and the last place of the block that it is declared in; None for one that
            the whole function, or file, knows.
        is_indirect: the name means what this variable, a pointer, points to; so it is with an array
            whose length is not constant.
    """

    name: str
    ctype: CType
    location: Location
    block: tuple[Location, Location] | None = None
    is_indirect: bool = False

    def reaches(self, place: Location) -> bool:
        """Return whether a place lies in the block of the variable, be it before its declaration.

        Nobody knows what a file that is included into a block has to do with it.
        """
        if self.block is None or place.file != self.block[0].file:
            return True
        return self.block[0] <= place <= self.block[1]

    def is_visible(self, place: Location) -> bool:
        """Return whether the name means this variable at a place, if no inner one has it."""
        is_declared = place.file != self.location.file or self.location <= place
        return is_declared and self.reaches(place)


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
        """Keep `VARARGS` the one object that it is when a program is pickled."""
        return "VARARGS" if self is VARARGS else object.__reduce_ex__(self, protocol)


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


class ByteState(IntEnum):
    """What C may do with a byte of memory, as checked builds note it in the shadow memory."""

    INACCESSIBLE = 0
    WITHOUT_VALUE = 1
    WITH_VALUE = 0xFF


@dataclass(slots=True, eq=False)
class Instruction:
    """What all instructions have: the place in the C source to blame."""

    location: Location


@dataclass(slots=True, eq=False)
class Statement(Instruction):
    """Mark the start of a C statement: no code when running, a stop for the debugger."""


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
    """`result = left op right`; comparisons give an i32, 0 or 1.

    A `checked` operation is one of C's that may have no result: a shift, whose count must be below
    the width of its type, or arithmetic of a signed type, which may overflow.
    """

    result: Register
    op: str
    left: Operand
    right: Operand
    checked: bool = False


@dataclass(slots=True, eq=False)
class Load(Instruction):
    """`result = *(base + offset)`, widened as `memory` says.

    With a slot or a name as base the access must lie inside that object; an access that is not
    known to do so goes through a register made by `Address`, and is checked while running.

    An `unjudged` load may find bytes that were never given a value: they are put back as they are.
    """

    result: Register
    base: Base
    offset: int
    memory: MemoryType
    unjudged: bool = False


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
    """Copy `size` bytes as `memmove` does; the operands are i32, both ranges are checked."""

    target: Operand
    source: Operand
    size: Operand


@dataclass(slots=True, eq=False)
class Fill(Instruction):
    """Set `size` bytes to the low byte of `value`, as `memset` does; checked like `Copy`."""

    target: Operand
    value: Operand
    size: Operand


@dataclass(slots=True, eq=False)
class Lifetime(Instruction):
    """The object in a slot begins to exist, without a value, or ends. Other slots always exist."""

    slot: Slot
    begins: bool


@dataclass(slots=True, eq=False)
class Mark(Instruction):
    """Says what C may do with `size` bytes at `target`: `state` is one of `ByteState`.

    It is for the allocator; nothing happens in unchecked builds.
    """

    target: Operand
    size: Operand
    state: int


@dataclass(slots=True, eq=False)
class Callers(Instruction):
    """Write the numbers of the innermost `count` call sites to `target`, an i32 each.

    It is for the allocator; the first is the call of this function, after the outermost come
    zeros. Nothing happens in unchecked builds.
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
    """Leave the function. Without a value the caller finds an unspecified one."""

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
    """Call a function by name, or through a function pointer in a register; goes on at `then`.

    `result`, if any, takes the returned value. A struct result is returned through a hidden first
    argument that points to the caller's memory.
    """

    callee: str | Register
    arguments: list[Argument]
    result: Register | None
    then: Block


@dataclass(slots=True, eq=False)
class Request(Instruction):
    """Post request `code` with the message at address `message`, stops, goes on at `then`.

    The message is `struct __crs_message` (see `crs_cc.requests`); the reply takes its place, and
    `result` takes the reply's i32 result.
    """

    code: Operand
    message: Operand
    result: Register
    then: Block


@dataclass(slots=True, eq=False)
class Stop(Instruction):
    """End the program with an error that the C source asked for or cannot get past.

    `kind` is one of `crs_cc.requests.ERROR_KINDS`, for example "unreachable"; `value` is the
    address to blame, if there is one.
    """

    kind: str
    value: Operand = Constant("i32", 0)


@dataclass(slots=True, eq=False)
class SetJump(Instruction):
    """C's `setjmp`: gives 0 and goes on at `then`, where a `LongJump` comes back with its value.

    Stores the number of the place to come back to at `buffer`. Whoever jumps there names this
    number and the `activation`, which is not 0 and differs from that of all other calls of
    functions; the register is assigned once, at the function's start.
    """

    buffer: Register
    activation: Register
    result: Register
    then: Block


@dataclass(slots=True, eq=False)
class LongJump(Instruction):
    """Leave all functions up to the one with this `activation`, which goes on at `place`.

    The operands are i32; `value` is what that `SetJump` gives now. When no active function has
    that activation, the program fails.
    """

    activation: Operand
    place: Operand
    value: Operand


Terminator: TypeAlias = Jump | Branch | Switch | Return | Call | Request | Stop | SetJump | LongJump


@dataclass(slots=True, eq=False)
class Block:
    """A basic block. `label` is unique in its function."""

    label: str
    instructions: list[Instruction] = field(default_factory=list)
    terminator: Terminator | None = None

    @property
    def fuel(self) -> int:
        """Return what running the block costs: one unit for each instruction that does something."""
        return 1 + sum(not isinstance(each, Statement | Lifetime) for each in self.instructions)

    def successors(self) -> list[Block]:
        """Return the blocks that may come next, in a fixed order, each once."""
        match self.terminator:
            case Jump(target=block) | Call(then=block) | Request(then=block) | SetJump(then=block):
                return [block]
            case Branch(then=then, otherwise=otherwise):
                return [then] if then is otherwise else [then, otherwise]
            case Switch(cases=cases, default=default):
                return list(dict.fromkeys([block for _, block in cases] + [default]))
        return []
