"""Instruction selection: which WebAssembly instructions each IR instruction becomes.

C's operators that can fail (division, access through a pointer) are preceded by a test. The cold
side of a test notes the place in the code (its site) and leaves the function with FAILED.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final

from crs_cc.ir.program import (
    MEMORY_SIZE,
    VARARGS,
    Address,
    Base,
    Binary,
    Constant,
    Copy,
    Fill,
    Instruction,
    Load,
    MemoryType,
    Move,
    Operand,
    Register,
    Slot,
    Store,
    Unary,
    ValueType,
)
from crs_cc.runtime.flow import UNWIND
from crs_cc.runtime.layout import MEMORY_BYTES, NULL_SIZE, Frame
from crs_cc.runtime.sites import CallSite, Site
from crs_cc.runtime.wasm import Instr
from crs_cc.source import Location

MAILBOX, MEMORY = 0, 1  # indices of the memories in a robot's module
FAULT, OUTSIDE = 0, 1  # indices of the module's own helper functions
SLOT_GLOBAL = 0
CALL_TYPE = 1  # index of the type of C functions
FP, FUEL, SP, LABEL, STATUS, ADDRESS = range(6)  # parameters and locals of every function
FIXED_LOCALS: Final[tuple[ValueType, ...]] = ("i32", "i32", "i32", "i32")

FREE_BYTES: Final = 256  # a copy costs one more unit of fuel for each so many bytes; 2**n

_LOADS: Final[dict[MemoryType, str]] = {
    "i8": "i32.load8_s", "u8": "i32.load8_u", "i16": "i32.load16_s", "u16": "i32.load16_u",
    "i32": "i32.load", "i64": "i64.load", "f32": "f32.load", "f64": "f64.load",
}  # fmt: skip
_STORES: Final[dict[MemoryType, str]] = {
    "i8": "i32.store8", "u8": "i32.store8", "i16": "i32.store16", "u16": "i32.store16",
    "i32": "i32.store", "i64": "i64.store", "f32": "f32.store", "f64": "f64.store",
}  # fmt: skip
_LOWEST: Final = {"i32": -(2**31), "i64": -(2**63)}
_POWER: Final = {"i32": 2.0**31, "i64": 2.0**63}


@dataclass(slots=True)
class Names:
    """What names stand for in the whole program.

    Attributes:
        addresses: address of each global object; function pointer of each function that needs one.
        functions: index in the module of each function.
        sizes: size of each global object.
        pointers: how many function pointers there are; they are numbered from 1.
        sites: every place that can fail.
        call_sites: every place that calls, by its number less 1.
    """

    addresses: dict[str, int]
    functions: dict[str, int]
    sizes: dict[str, int]
    pointers: int
    sites: list[Site] = field(default_factory=list)
    call_sites: list[CallSite] = field(default_factory=list)


class Selector:
    """Writes the instructions of one function; `code` is the list that it appends to."""

    def __init__(self, names: Names, frame: Frame, *, checked: bool) -> None:
        self.names = names
        self.frame = frame
        self.checked = checked
        self.code: list[Instr] = []
        self.local_types: list[ValueType] = list(FIXED_LOCALS)
        self.locals: dict[Register, int] = {}
        self._free: dict[ValueType, list[int]] = {"i32": [], "i64": [], "f32": [], "f64": []}
        self._proved: dict[Register, tuple[int, int]] = {}

    # -- locals ------------------------------------------------------------------------------

    def take_local(self, register: Register) -> None:
        """Gives a register a local of its own until it is released."""
        free = self._free[register.type]
        if free:
            self.locals[register] = free.pop()
            return
        self.local_types.append(register.type)
        self.locals[register] = len(self.local_types) + 1

    def release(self, register: Register) -> None:
        """Makes the register's local free for another one."""
        self._free[register.type].append(self.locals[register])

    def forget(self) -> None:
        """Drops what is known of pointers, where code from elsewhere joins."""
        self._proved.clear()

    def value(self, operand: Operand) -> Instr:
        """Gives the instruction that pushes an operand's value."""
        if isinstance(operand, Constant):
            return (f"{operand.type}.const", operand.value)
        return ("local.get", self.locals[operand])

    def push(self, operand: Operand) -> None:
        """Pushes an operand's value."""
        self.code.append(self.value(operand))

    def pop(self, register: Register) -> None:
        """Pops a value into a register."""
        if register not in self.locals:
            self.take_local(register)
        self._proved.pop(register, None)
        self.code.append(("local.set", self.locals[register]))

    # -- errors ------------------------------------------------------------------------------

    def note(self, kind: str, location: Location, value: list[Instr]) -> list[Instr]:
        """Gives code that notes an error and leaves the status FAILED on the stack.

        `value` pushes the address or number to blame.
        """
        site = len(self.names.sites)
        self.names.sites.append(Site(kind, location))
        return [("i32.const", site), *value, ("call", FAULT)]

    def fail(self, kind: str, location: Location, value: list[Instr]) -> None:
        """Stops the program; `value` pushes the address or number to blame."""
        self.code += [*self.note(kind, location, value), ("local.set", STATUS), (UNWIND,)]

    def fail_if(self, kind: str, location: Location, value: list[Instr]) -> None:
        """Stops the program if the i32 on the stack is not zero."""
        self.code.append(("if",))
        self.fail(kind, location, value)
        self.code.append(("end",))

    def check_range(self, address: Operand, size: Operand, location: Location) -> None:
        """Stops the program unless `size` bytes at `address` lie in memory."""
        self.push(address)
        self.push(size)
        self.code.append(("call", OUTSIDE))
        self.fail_if("memory", location, [self.value(address)])

    # -- memory ------------------------------------------------------------------------------

    def address(self, base: Base, offset: int) -> None:
        """Pushes an address."""
        match base:
            case Register():
                self.push(base)
            case Slot():
                self.code.append(("local.get", SP))
                offset += self.frame.varargs if base is VARARGS else self.frame.offsets[base]
            case str():
                self.code.append(("i32.const", self.names.addresses[base] + offset))
                return
        if offset:
            self.code += [("i32.const", offset), ("i32.add",)]

    def access(self, base: Base, offset: int, size: int, location: Location) -> int:
        """Pushes an address that is safe to access; gives the offset for the instruction."""
        if isinstance(base, Register):
            return self._through_pointer(base, offset, size, location)
        if isinstance(base, Slot):
            self.code.append(("local.get", SP))
            return self.frame.offsets[base] + offset
        self.code.append(("i32.const", self.names.addresses[base] + offset))
        if self.checked and not 0 <= offset <= self.names.sizes.get(base, 0) - size:
            # declared larger in this file than the object is: checked as through a pointer
            self.code.append(("local.tee", ADDRESS))
            self._check_local(ADDRESS, size, location)
        return 0

    def _check_local(self, local: int, size: int, location: Location) -> None:
        """Stops the program unless the address on the stack, also in `local`, is accessible."""
        self.code += [("i32.const", NULL_SIZE), ("i32.sub",)]
        self.code += [("i32.const", MEMORY_BYTES - NULL_SIZE - size), ("i32.gt_u",)]
        self.fail_if("memory", location, [("local.get", local)])
        self.code.append(("local.get", local))

    def _through_pointer(self, base: Register, offset: int, size: int, location: Location) -> int:
        if 0 <= offset < NULL_SIZE and (not self.checked or self._known(base, offset, size)):
            self.push(base)
            return offset
        self.push(base)
        local = self.locals[base]
        if offset:
            local = ADDRESS
            self.code += [("i32.const", offset), ("i32.add",), ("local.tee", ADDRESS)]
        if self.checked:
            self._check_local(local, size, location)
            low, high = self._proved.get(base, (offset, offset))
            self._proved[base] = (min(low, offset), max(high, offset + size))
        return 0

    def _known(self, base: Register, offset: int, size: int) -> bool:
        low, high = self._proved.get(base, (0, 0))
        return low <= offset and offset + size <= high

    def charge(self, size: Operand) -> None:
        """Takes fuel for moving `size` bytes, so that large copies cost the time they take."""
        if isinstance(size, Constant) and size.value < FREE_BYTES:
            return
        self.code += [("local.get", FUEL), self.value(size)]
        self.code += [("i32.const", FREE_BYTES.bit_length() - 1), ("i32.shr_u",)]
        self.code += [("i64.extend_i32_u",), ("i64.sub",), ("local.set", FUEL)]

    # -- instructions ------------------------------------------------------------------------

    def select(self, instruction: Instruction) -> None:
        """Writes the code of one instruction that is not a terminator."""
        _SELECT[type(instruction)](self, instruction)

    def move(self, it: Move) -> None:
        """Writes `result = source`."""
        self.push(it.source)
        self.pop(it.result)

    def load(self, it: Load) -> None:
        """Writes `result = *(base + offset)`."""
        offset = self.access(it.base, it.offset, MEMORY_SIZE[it.memory], it.location)
        self.code.append((_LOADS[it.memory], MEMORY, offset))
        self.pop(it.result)

    def store(self, it: Store) -> None:
        """Writes `*(base + offset) = source`."""
        offset = self.access(it.base, it.offset, MEMORY_SIZE[it.memory], it.location)
        self.push(it.source)
        self.code.append((_STORES[it.memory], MEMORY, offset))

    def store_at(self, base: int, offset: int, value: Operand, memory: MemoryType) -> None:
        """Stores into the frame, relative to local `base`."""
        self.code.append(("local.get", base))
        self.push(value)
        self.code.append((_STORES[memory], MEMORY, offset))

    def load_at(self, base: int, offset: int, memory: MemoryType) -> None:
        """Pushes a value of the frame, relative to local `base`."""
        self.code += [("local.get", base), (_LOADS[memory], MEMORY, offset)]

    def address_of(self, it: Address) -> None:
        """Writes `result = base + offset`."""
        self.address(it.base, it.offset)
        self.pop(it.result)

    def copy(self, it: Copy) -> None:
        """Writes a `memmove`."""
        if self.checked:
            self.check_range(it.target, it.size, it.location)
            self.check_range(it.source, it.size, it.location)
        self.charge(it.size)
        for operand in (it.target, it.source, it.size):
            self.push(operand)
        self.code.append(("memory.copy", MEMORY, MEMORY))

    def fill(self, it: Fill) -> None:
        """Writes a `memset`."""
        if self.checked:
            self.check_range(it.target, it.size, it.location)
        self.charge(it.size)
        for operand in (it.target, it.value, it.size):
            self.push(operand)
        self.code.append(("memory.fill", MEMORY))

    def binary(self, it: Binary) -> None:
        """Writes `result = left op right`."""
        kind, _, op = it.op.partition(".")
        if op in ("div_s", "rem_s", "div_u", "rem_u"):
            self._check_division(it, kind, signed=op.endswith("s"))
        self.push(it.left)
        self.push(it.right)
        self.code.append((it.op,))
        self.pop(it.result)

    def _check_division(self, it: Binary, kind: str, *, signed: bool) -> None:
        """Stops at a zero divisor, and at the quotient that does not fit (C17 6.5.5)."""
        divisor, low = it.right, _LOWEST[kind]
        if isinstance(divisor, Constant) and divisor.value not in (0, -1):
            return
        self.push(divisor)
        if signed:  # 0 and -1 are the only divisors that can fail: one test for both
            self.code += [(f"{kind}.const", 1), (f"{kind}.add",), (f"{kind}.const", 2)]
            self.code += [(f"{kind}.lt_u",), ("if",)]
            self.push(divisor)
        self.code.append((f"{kind}.eqz",))
        self.fail_if("division by zero", it.location, [("i32.const", 0)])
        if signed:
            self.push(it.left)
            self.code += [(f"{kind}.const", low), (f"{kind}.eq",)]
            self.fail_if("division overflow", it.location, [("i32.const", 0)])
            self.code.append(("end",))

    def unary(self, it: Unary) -> None:
        """Writes `result = op source`."""
        kind, _, op = it.op.partition(".")
        if op.startswith("trunc_f"):
            self._truncate(it, kind, op)
        else:
            self.push(it.source)
            self.code.append((it.op,))
        self.pop(it.result)

    def _truncate(self, it: Unary, kind: str, op: str) -> None:
        """Converts to an integer as i386 with SSE2 does: what does not fit gives the lowest value.

        To a 32-bit unsigned type it goes by way of 64 bits, as gcc does.
        """
        source = "f32" if "f32" in op else "f64"
        power = (f"{source}.const", _POWER[kind])
        self.push(it.source)
        if op.endswith("_s"):
            self.code += [(f"{kind}.trunc_sat_{source}_s",), (f"{kind}.const", _LOWEST[kind])]
        elif kind == "i32":
            self.code += [(f"i64.trunc_sat_{source}_s",), ("i32.wrap_i64",)]
            return
        else:  # below 2**63 as signed, which keeps small negative numbers wrapping
            self.code.append((f"i64.trunc_sat_{source}_s",))
            self.push(it.source)
            self.code.append((f"i64.trunc_sat_{source}_u",))
        self.push(it.source)
        self.code += [power, (f"{source}.lt",), ("select",)]


_SELECT: Final[dict[type[Instruction], Callable[..., None]]] = {
    Move: Selector.move,
    Unary: Selector.unary,
    Binary: Selector.binary,
    Load: Selector.load,
    Store: Selector.store,
    Address: Selector.address_of,
    Copy: Selector.copy,
    Fill: Selector.fill,
}
