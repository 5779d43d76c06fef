"""Instruction selection: from IR instructions to WebAssembly instructions.

C's operators that can fail (division, access through a pointer) are preceded by a check. The cold
path of a check stores the number of its site and leaves the function with FAILED.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from crs_cc.ir.instruction import (
    Address,
    Binary,
    Bounds,
    Callers,
    Constant,
    Copy,
    Fill,
    Instruction,
    Lifetime,
    Load,
    Mark,
    MarkUnset,
    Move,
    Passed,
    SameObject,
    Seal,
    State,
    Store,
    Unary,
)
from crs_cc.runtime.codegen.checked_arithmetic import CheckedArithmetic
from crs_cc.runtime.codegen.plain_memory import PlainMemory
from crs_cc.runtime.codegen.scalar_replacement import ReadCheck, WriteCheck
from crs_cc.runtime.codegen.watchpoints import Watchpoints
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.sites import Site

_LOWEST: Final = {"i32": -(2**31), "i64": -(2**63)}
_POWER: Final = {"i32": 2.0**31, "i64": 2.0**63}


class Selector:
    """Selects the instructions of one function."""

    def __init__(
        self,
        writer: Writer,
        memory: PlainMemory,
        arithmetic: CheckedArithmetic | None,
        watching: Watchpoints | None,
    ) -> None:
        """Set the parts that generate code.

        Args:
            writer: the writer of the function.
            memory: generates accesses to memory, with checks or without.
            arithmetic: checks the operands of arithmetic; None in unchecked code.
            watching: reports accesses to watchpoints; None in builds without watchpoints.
        """
        self._writer = writer
        self._memory = memory
        self._arithmetic = arithmetic
        self._watching = watching

    def forget(self) -> None:
        """Discard known facts at a join of control flow."""
        self._memory.forget()
        if self._arithmetic is not None:
            self._arithmetic.forget()

    def before(self, instruction: Instruction) -> None:
        """Write the checks before an instruction, terminators included."""
        self._memory.before(instruction)
        if self._arithmetic is not None:
            self._arithmetic.before(instruction)
        if self._watching is not None:
            self._watching.before(instruction)

    def after(self, instruction: Instruction) -> None:
        """Write the code after an instruction that has a result, terminators included."""
        if self._watching is not None:
            self._watching.after(instruction)

    def select(self, instruction: Instruction) -> None:
        """Write the code of one instruction that is not a terminator."""
        access = _ACCESS.get(type(instruction))
        if access is not None:
            getattr(self._memory, access)(instruction)
        else:
            _SELECT[type(instruction)](self, instruction)
        self._memory.after(instruction)
        if self._arithmetic is not None:
            self._arithmetic.after(instruction)
        self.after(instruction)

    def move(self, it: Move) -> None:
        """Write `result = source`."""
        writer = self._writer
        writer.push(it.source)
        writer.pop(it.result)

    def address_of(self, it: Address) -> None:
        """Write `result = base + offset`."""
        writer = self._writer
        writer.address(it.base, it.offset)
        writer.pop(it.result)

    def binary(self, it: Binary) -> None:
        """Write `result = left op right`."""
        writer = self._writer
        kind, _, op = it.op.partition(".")
        if op in ("div_s", "rem_s", "div_u", "rem_u"):
            self._check_division(it, kind, signed=op.endswith("s"))
        writer.push(it.left)
        writer.push(it.right)
        writer.code.append((it.op,))
        writer.pop(it.result)

    def _check_division(self, it: Binary, kind: str, *, signed: bool) -> None:
        """Check for a zero divisor and for an overflowing quotient (C17 6.5.5)."""
        writer = self._writer
        divisor, low = it.right, _LOWEST[kind]
        if isinstance(divisor, Constant) and divisor.value not in (0, -1):
            return
        writer.push(divisor)
        if signed:  # 0 and -1 are the only divisors that can fail: one test for both
            writer.code += [(f"{kind}.const", 1), (f"{kind}.add",), (f"{kind}.const", 2)]
            writer.code += [(f"{kind}.lt_u",), ("if",)]
            writer.push(divisor)
        writer.code.append((f"{kind}.eqz",))
        writer.fail_if(Site("division by zero", it.location), [("i32.const", 0)])
        if signed:
            writer.push(it.left)
            writer.code += [(f"{kind}.const", low), (f"{kind}.eq",)]
            writer.fail_if(Site("division overflow", it.location), [("i32.const", 0)])
            writer.code.append(("end",))

    def unary(self, it: Unary) -> None:
        """Write `result = op source`."""
        writer = self._writer
        kind, _, op = it.op.partition(".")
        if op.startswith("trunc_f"):
            self._truncate(it, kind, op)
        else:
            writer.push(it.source)
            writer.code.append((it.op,))
        writer.pop(it.result)

    def _truncate(self, it: Unary, kind: str, op: str) -> None:
        """Convert to an integer as i386 with SSE2 does: values out of range give the minimum.

        Conversion to a 32-bit unsigned type is via 64 bits, as with gcc.
        """
        writer = self._writer
        source = "f32" if "f32" in op else "f64"
        power = (f"{source}.const", _POWER[kind])
        writer.push(it.source)
        if op.endswith("_s"):
            writer.code += [(f"{kind}.trunc_sat_{source}_s",), (f"{kind}.const", _LOWEST[kind])]
        elif kind == "i32":
            writer.code += [(f"i64.trunc_sat_{source}_s",), ("i32.wrap_i64",)]
            return
        else:  # below 2**63 as signed, which keeps small negative numbers wrapping
            writer.code.append((f"i64.trunc_sat_{source}_s",))
            writer.push(it.source)
            writer.code.append((f"i64.trunc_sat_{source}_u",))
        writer.push(it.source)
        writer.code += [power, (f"{source}.lt",), ("select",)]


_SELECT: Final[dict[type[Instruction], Callable[..., None]]] = {
    Move: Selector.move,
    Unary: Selector.unary,
    Binary: Selector.binary,
    Address: Selector.address_of,
}
_ACCESS: Final[dict[type[Instruction], str]] = {
    Bounds: "bounds",
    SameObject: "same_object",
    Passed: "passed",
    Load: "load",
    Store: "store",
    Copy: "copy",
    Fill: "fill",
    Mark: "mark",
    MarkUnset: "mark_unset",
    Callers: "callers",
    Lifetime: "lifetime",
    Seal: "seal",
    State: "state",
    WriteCheck: "writable",
    ReadCheck: "readable",
}
"""The method of `PlainMemory` for each memory instruction."""
