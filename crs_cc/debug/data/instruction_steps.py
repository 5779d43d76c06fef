"""Blocks of IR as Python functions, one for each instruction, for the interpreter.

An expression may be evaluated thousands of times, as the condition of a breakpoint. So its
instructions are taken apart once; to execute one is then to call a function of the call's frame.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Final, Protocol

from crs_cc.debug.data.expression_memory import EvaluationError
from crs_cc.debug.data.operators import compute, operation, unsigned
from crs_cc.ir import instruction as ir
from crs_cc.ir.value_type import MEMORY_SIZE, MemoryType

SCRATCH: Final = 0x8000_0000
"""The first address of the scratch memory: no program's own memory reaches so far."""
SCRATCH_BYTES: Final = 1 << 24
_MAX_CACHED: Final = 20_000
"""So many blocks are kept taken apart."""

_FORMAT: Final[dict[MemoryType, str]] = {
    "i8": "<b", "u8": "<B", "i16": "<h", "u16": "<H", "i32": "<i", "i64": "<q",
    "f32": "<f", "f64": "<d",
}  # fmt: skip
_PACKED: Final = {memory: struct.Struct(form) for memory, form in _FORMAT.items()}
_STORED: Final[dict[MemoryType, int]] = {"i8": 8, "u8": 8, "i16": 16, "u16": 16}
_NO_EFFECT: Final = (
    ir.Statement | ir.Lifetime | ir.Seal | ir.Callers | ir.Bounds | ir.SameObject | ir.Passed
)


@dataclass(slots=True)
class CallFrame:
    """An active call: the memory it works on, registers, slots, and variable arguments."""

    space: AddressSpace
    values: dict[ir.Register, Any] = field(default_factory=dict)
    slots: dict[ir.Slot, int] = field(default_factory=dict)
    more: int = 0


Step = Callable[[CallFrame], None]


class AddressSpace(Protocol):
    """All memory that an expression can reach, its own included."""

    def read(self, address: int, size: int, *, judged: bool = True) -> bytes:
        """Return bytes; they must be initialised if `judged`."""

    def write(self, address: int, content: bytes, states: bytes = b"") -> None:
        """Write bytes; they become initialised unless `states` says otherwise."""

    def states(self, address: int, size: int) -> bytes:
        """Return the `ByteState`s of bytes; none of the expression's own."""

    def state(self, address: int) -> int:
        """Return the `ByteState` of a byte."""

    def mark(self, address: int, size: int, state: int) -> None:
        """Set the `ByteState`s of bytes."""

    def symbol_address(self, name: str) -> int:
        """Return the address of an object or function."""


def operand_value(frame: CallFrame, operand: ir.Operand) -> Any:
    """Return the value of an operand in a call."""
    if isinstance(operand, ir.Constant):
        return operand.value
    return frame.values.get(operand, 0)


def loaded(space: AddressSpace, address: int, memory: MemoryType, *, judged: bool = True) -> Any:
    """Return the number at an address."""
    return _PACKED[memory].unpack(space.read(address, MEMORY_SIZE[memory], judged=judged))[0]


def store(space: AddressSpace, address: int, memory: MemoryType, value: Any) -> None:
    """Write a number to an address."""
    if memory in _STORED:
        bits = _STORED[memory]
        content = unsigned(int(value), bits).to_bytes(bits // 8, "little")
    else:
        content = _PACKED[memory].pack(value)
    space.write(address, content)


class InstructionSteps:
    """Takes blocks apart, and keeps the parts."""

    def __init__(self) -> None:
        self._known: dict[ir.Block, tuple[Step, ...]] = {}

    def of(self, block: ir.Block) -> tuple[Step, ...]:
        """Return the instructions of a block; those without effect are left out."""
        found = self._known.get(block)
        if found is None:
            if len(self._known) >= _MAX_CACHED:
                self._known.clear()
            steps = map(_step, block.instructions)
            found = self._known[block] = tuple(each for each in steps if each is not None)
        return found


def _step(it: ir.Instruction) -> Step | None:
    match it:
        case ir.Move():
            return _move(it)
        case ir.Unary():
            return _unary(it)
        case ir.Binary():
            return _binary(it)
        case ir.Address():
            return _address_of(it)
        case ir.Load():
            return _load(it)
        case ir.Store():
            return _store(it)
    return _rare_step(it)


def _rare_step(it: ir.Instruction) -> Step | None:
    match it:
        case ir.State():
            return lambda frame: _state(frame, it)
        case ir.Copy():
            return lambda frame: _copy(frame, it)
        case ir.Fill():
            return lambda frame: _fill(frame, it)
        case ir.Mark():
            return lambda frame: _mark(frame, it.target, it.size, it.state)
        case ir.MarkUnset():
            unset = ir.ByteState.WITHOUT_VALUE
            return lambda frame: _mark(frame, it.target, it.size, unset)
    assert isinstance(it, _NO_EFFECT), it
    return None


# -- addresses and accesses ------------------------------------------------------------------------


def _place(base: ir.Base, offset: int) -> Callable[[CallFrame], int]:
    """Return a function for an address."""
    match base:
        case ir.Register():
            return lambda frame: (frame.values.get(base, 0) + offset) & 0xFFFF_FFFF
        case ir.Slot():
            if base is ir.VARARGS:
                return lambda frame: (frame.more + offset) & 0xFFFF_FFFF
            return lambda frame: (frame.slots[base] + offset) & 0xFFFF_FFFF
    return lambda frame: (frame.space.symbol_address(base) + offset) & 0xFFFF_FFFF


def _address_of(it: ir.Address) -> Step:
    place, result = _place(it.base, it.offset), it.result

    def step(frame: CallFrame) -> None:
        frame.values[result] = compute("i32.add", place(frame), 0)

    return step


def _load(it: ir.Load) -> Step:
    place, result, judged = _place(it.base, it.offset), it.result, not it.unjudged
    unpack, size = _PACKED[it.memory].unpack, MEMORY_SIZE[it.memory]

    def step(frame: CallFrame) -> None:
        content = frame.space.read(place(frame), size, judged=judged)
        frame.values[result] = unpack(content)[0]

    return step


def _store(it: ir.Store) -> Step:
    place, source, memory = _place(it.base, it.offset), it.source, it.memory

    def step(frame: CallFrame) -> None:
        store(frame.space, place(frame), memory, operand_value(frame, source))

    return step


def _state(frame: CallFrame, it: ir.State) -> None:
    address = unsigned(operand_value(frame, it.address), 32)
    is_own = address >= SCRATCH
    state = ir.ByteState.WITH_VALUE if is_own else frame.space.state(address)
    frame.values[it.result] = int(state)


def _copy(frame: CallFrame, it: ir.Copy) -> None:
    """Copy bytes with their states."""
    size = unsigned(operand_value(frame, it.size), 32)
    if size:
        source = unsigned(operand_value(frame, it.source), 32)
        content = frame.space.read(source, size, judged=False)
        states = frame.space.states(source, size) if source < SCRATCH else b""
        frame.space.write(unsigned(operand_value(frame, it.target), 32), content, states)


def _fill(frame: CallFrame, it: ir.Fill) -> None:
    size = unsigned(operand_value(frame, it.size), 32)
    if size > SCRATCH_BYTES:
        raise EvaluationError("the expression needs too much memory")
    byte = unsigned(operand_value(frame, it.value), 8)
    frame.space.write(operand_value(frame, it.target), bytes([byte]) * size)


def _mark(frame: CallFrame, target: ir.Operand, size: ir.Operand, state: int) -> None:
    address, count = (unsigned(operand_value(frame, each), 32) for each in (target, size))
    frame.space.mark(address, count, state)


# -- computing -------------------------------------------------------------------------------------


def _move(it: ir.Move) -> Step:
    source, result = it.source, it.result

    def step(frame: CallFrame) -> None:
        frame.values[result] = operand_value(frame, source)

    return step


def _unary(it: ir.Unary) -> Step:
    work, source, result = _work(it.op), it.source, it.result

    def step(frame: CallFrame) -> None:
        frame.values[result] = work(operand_value(frame, source))

    return step


def _binary(it: ir.Binary) -> Step:
    work, left, right, result = _work(it.op), it.left, it.right, it.result
    if isinstance(left, ir.Register) and isinstance(right, ir.Constant):
        number = right.value

        def with_number(frame: CallFrame) -> None:
            frame.values[result] = work(frame.values.get(left, 0), number)

        return with_number

    def step(frame: CallFrame) -> None:
        frame.values[result] = work(operand_value(frame, left), operand_value(frame, right))

    return step


def _work(op: str) -> Callable[..., Any]:
    if ".trunc_f" in op:  # C's conversions saturate to the lowest value here, see `selection`
        return lambda value: _truncated(op, value)
    return operation(op)


def _truncated(op: str, value: float) -> int:
    """Convert to an integer as `runtime.codegen.selection` does: i386 with SSE2."""
    kind, _, name = op.partition(".")
    source, bits = name[6:9], 32 if kind == "i32" else 64
    if name.endswith("_s"):
        low = -(1 << bits - 1)
        return int(compute(f"{kind}.trunc_sat_{source}_s", value)) if value < -low else low
    if kind == "i32":
        wide = compute(f"i64.trunc_sat_{source}_s", value)
        return int(compute("i32.wrap_i64", wide))
    sign = "s" if value < 1 << 63 else "u"
    return int(compute(f"i64.trunc_sat_{source}_{sign}", value))
