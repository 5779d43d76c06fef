"""Instruction selection: which WebAssembly instructions each IR instruction becomes.

C's operators that can fail (division, access through a pointer) are preceded by a test. The cold
side of a test notes the place in the code (its site) and leaves the function with FAILED.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final

from crs_cc.ir.program import (
    VARARGS,
    Address,
    Base,
    Binary,
    Callers,
    Constant,
    Copy,
    Fill,
    Instruction,
    Lifetime,
    Load,
    Mark,
    MemoryType,
    Move,
    Operand,
    Register,
    Slot,
    State,
    Store,
    Unary,
    ValueType,
)
from crs_cc.runtime.checked_arithmetic import CheckedArithmetic
from crs_cc.runtime.flow import FAULTED
from crs_cc.runtime.indices import ADDRESS, FIXED_LOCALS, FUEL, MEMORY, SITE, SP
from crs_cc.runtime.layout import Frame
from crs_cc.runtime.plain_memory import LOADS, STORES, PlainMemory
from crs_cc.runtime.signatures import Shape
from crs_cc.runtime.sites import CallSite, Site
from crs_cc.runtime.wasm import UNLIKELY, Instr

FREE_BYTES: Final = 256  # a copy costs one more unit of fuel for each so many bytes; 2**n

_LOWEST: Final = {"i32": -(2**31), "i64": -(2**63)}
_POWER: Final = {"i32": 2.0**31, "i64": 2.0**63}


@dataclass(slots=True)
class Names:
    """What names stand for in the whole program.

    Attributes:
        addresses: address of each global object; function pointer of each function that needs one.
        functions: index in the module of each function.
        sizes: size of each global object.
        parameters: size of the parameters of each function, as `layout` places them.
        tables: addresses of the tables that `signatures` makes.
        without_value: functions that may end without a value which somebody uses.
        pointers: how many function pointers there are; they are numbered from 1.
        sites: every place that can fail.
        call_sites: every place that calls, by its number less 1.
    """

    addresses: dict[str, int]
    functions: dict[str, int]
    sizes: dict[str, int]
    parameters: dict[str, int]
    pointers: int
    tables: dict[Shape, int]
    without_value: set[str]
    sites: list[Site] = field(default_factory=list)
    call_sites: list[CallSite] = field(default_factory=list)

    def number(self, site: Site) -> int:
        """Enters a place that can fail; gives its number."""
        self.sites.append(site)
        return len(self.sites) - 1

    def call_number(self, site: CallSite) -> int:
        """Enters a place that calls; gives its number."""
        self.call_sites.append(site)
        return len(self.call_sites)


class Selector:
    """Writes the instructions of one function.

    Attributes:
        code: the list that it appends to.
        memory: how it writes accesses to memory.
        arithmetic: what tests the operands of arithmetic; None where nothing does.
    """

    def __init__(self, names: Names, frame: Frame) -> None:
        self.names = names
        self.frame = frame
        self.memory: PlainMemory = PlainMemory(self, shadowed=False)
        self.arithmetic: CheckedArithmetic | None = None
        self.code: list[Instr] = []
        self.local_types: list[ValueType] = list(FIXED_LOCALS)
        self.locals: dict[Register, int] = {}
        self._released: set[Register] = set()
        self._free: dict[ValueType, list[int]] = {"i32": [], "i64": [], "f32": [], "f64": []}

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
        """Makes the register's local free for another one; assigned again it takes a new one."""
        self._free[register.type].append(self.locals[register])
        self._released.add(register)

    def forget(self) -> None:
        """Drops what is known, where code from elsewhere joins."""
        self.memory.forget()
        if self.arithmetic is not None:
            self.arithmetic.forget()

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
        if register not in self.locals or register in self._released:
            self._released.discard(register)
            self.take_local(register)
        self.code.append(("local.set", self.locals[register]))

    # -- errors ------------------------------------------------------------------------------

    def fail(self, site: Site, value: list[Instr]) -> None:
        """Stops the program; `value` pushes the address or number to blame."""
        number = self.names.number(site)
        self.code += [*value, ("local.set", ADDRESS)]
        self.code += [("i32.const", number), ("local.set", SITE), (FAULTED,)]

    def fail_if(self, site: Site, value: list[Instr]) -> None:
        """Stops the program if the i32 on the stack is not zero."""
        self.code.append(UNLIKELY)
        self.fail(site, value)
        self.code.append(("end",))

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

    def charge(self, size: Operand) -> None:
        """Takes fuel for moving `size` bytes, so that large copies cost the time they take."""
        if isinstance(size, Constant) and size.value < FREE_BYTES:
            return
        self.code += [("local.get", FUEL), self.value(size)]
        self.code += [("i32.const", FREE_BYTES.bit_length() - 1), ("i32.shr_u",)]
        self.code += [("i64.extend_i32_u",), ("i64.sub",), ("local.set", FUEL)]

    # -- instructions ------------------------------------------------------------------------

    def before(self, instruction: Instruction) -> None:
        """Writes the tests that come before an instruction, terminators too."""
        self.memory.before(instruction)
        if self.arithmetic is not None:
            self.arithmetic.before(instruction)

    def select(self, instruction: Instruction) -> None:
        """Writes the code of one instruction that is not a terminator."""
        access = _ACCESS.get(type(instruction))
        if access is not None:
            getattr(self.memory, access)(instruction)
        else:
            _SELECT[type(instruction)](self, instruction)
        self.memory.follow(instruction)
        if self.arithmetic is not None:
            self.arithmetic.follow(instruction)

    def move(self, it: Move) -> None:
        """Writes `result = source`."""
        self.push(it.source)
        self.pop(it.result)

    def store_at(self, base: int, offset: int, value: Operand, memory: MemoryType) -> None:
        """Stores into the frame, relative to local `base`."""
        self.code.append(("local.get", base))
        self.push(value)
        self.code.append((STORES[memory], MEMORY, offset))

    def load_at(self, base: int, offset: int, memory: MemoryType) -> None:
        """Pushes a value of the frame, relative to local `base`."""
        self.code += [("local.get", base), (LOADS[memory], MEMORY, offset)]

    def address_of(self, it: Address) -> None:
        """Writes `result = base + offset`."""
        self.address(it.base, it.offset)
        self.pop(it.result)

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
        self.fail_if(Site("division by zero", it.location), [("i32.const", 0)])
        if signed:
            self.push(it.left)
            self.code += [(f"{kind}.const", low), (f"{kind}.eq",)]
            self.fail_if(Site("division overflow", it.location), [("i32.const", 0)])
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
    Address: Selector.address_of,
}
_ACCESS: Final[dict[type[Instruction], str]] = {
    Load: "load",
    Store: "store",
    Copy: "copy",
    Fill: "fill",
    Mark: "mark",
    Callers: "callers",
    Lifetime: "lifetime",
    State: "state",
}
"""What a `PlainMemory` writes."""
