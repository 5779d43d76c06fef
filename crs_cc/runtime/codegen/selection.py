"""Instruction selection: which WebAssembly instructions each IR instruction becomes.

C's operators that can fail (division, access through a pointer) are preceded by a test. The cold
side of a test notes the place in the code (its site) and leaves the function with FAILED.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from crs_cc.ir.program import (
    Address,
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
    State,
    Store,
    Unary,
)
from crs_cc.runtime.codegen.checked_arithmetic import CheckedArithmetic
from crs_cc.runtime.codegen.indices import MEMORY
from crs_cc.runtime.codegen.names import Names
from crs_cc.runtime.codegen.plain_memory import LOADS, STORES, PlainMemory
from crs_cc.runtime.codegen.watching import Watching
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.layout import Frame
from crs_cc.runtime.sites import Site

_LOWEST: Final = {"i32": -(2**31), "i64": -(2**63)}
_POWER: Final = {"i32": 2.0**31, "i64": 2.0**63}


class Selector(Writer):
    """Writes the instructions of one function.

    Attributes:
        memory: how it writes accesses to memory.
        arithmetic: what tests the operands of arithmetic; None where nothing does.
        watching: what tells of accesses; None where nobody is told.
    """

    def __init__(self, names: Names, frame: Frame) -> None:
        super().__init__(names, frame)
        self.memory: PlainMemory = PlainMemory(self, shadowed=False)
        self.arithmetic: CheckedArithmetic | None = None
        self.watching: Watching | None = None

    def forget(self) -> None:
        """Drops what is known, where code from elsewhere joins."""
        self.memory.forget()
        if self.arithmetic is not None:
            self.arithmetic.forget()

    def before(self, instruction: Instruction) -> None:
        """Writes the tests that come before an instruction, terminators too."""
        self.memory.before(instruction)
        if self.arithmetic is not None:
            self.arithmetic.before(instruction)
        if self.watching is not None:
            self.watching.before(instruction)

    def follow(self, instruction: Instruction) -> None:
        """Writes what comes behind an instruction that has a result, terminators too."""
        if self.watching is not None:
            self.watching.follow(instruction)

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
        self.follow(instruction)

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
