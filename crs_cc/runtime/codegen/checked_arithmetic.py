"""Checks of arithmetic that may be undefined in C: shifts, and optionally signed overflow.

Shifts wrap in WebAssembly, as on i386, and signed numbers wrap around; old programs rely on
the latter, so that overflow only stops a program if that is requested.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.instruction import Binary, Constant, Instruction, Register, Unary
from crs_cc.ir.liveness import writes
from crs_cc.runtime.codegen.indices import PRODUCT_FITS
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.sites import Site
from crs_cc.runtime.wasm import UNLIKELY, Code, Instr

_BITS: Final = {"i32": 32, "i64": 64}
_SHIFTS: Final = frozenset({"shl", "shr_s", "shr_u"})


class CheckedArithmetic:
    """Writes the checks of one function.

    Attributes:
        traps_overflow: whether signed overflow stops the program.
    """

    def __init__(self, writer: Writer, *, traps_overflow: bool) -> None:
        self.writer = writer
        self.traps_overflow = traps_overflow
        self._most: dict[Register, int] = {}

    def forget(self) -> None:
        """Discard known facts at a join of control flow."""
        self._most.clear()

    def before(self, it: Instruction) -> None:
        """Check the operands of an operation."""
        if not isinstance(it, Binary) or not it.checked:
            return
        kind, _, op = it.op.partition(".")
        if op in _SHIFTS:
            self._shift(it, kind)
        elif self.traps_overflow and op in {"add", "sub"}:
            self._sum(it, kind, op)
        elif self.traps_overflow and op == "mul":
            self._product(it, kind)

    def after(self, it: Instruction) -> None:
        """Note results that are known to be small."""
        target = writes(it)
        if target is None:
            return
        self._most.pop(target, None)
        match it:
            case Binary(op="i32.and" | "i64.and", right=Constant(value=mask)) if mask >= 0:
                self._most[target] = int(mask)
            case Binary(op="i32.rem_u" | "i64.rem_u", right=Constant(value=divisor)) if divisor > 0:
                self._most[target] = int(divisor) - 1
            case Unary(op="i64.extend_i32_s" | "i64.extend_i32_u", source=Register() as source):
                if source in self._most:
                    self._most[target] = self._most[source]

    def _fail_if(self, kind: str, it: Binary, value: list[Instr]) -> None:
        self.writer.fail_if(Site(kind, it.location), value)

    def _shift(self, it: Binary, kind: str) -> None:
        count, bits = it.right, _BITS[kind]
        if isinstance(count, Constant):
            known = 0 <= count.value < bits
        else:
            known = self._most.get(count, bits) < bits
        if not known:
            push = self.writer.value(count)
            self.writer.code += [push, (f"{kind}.const", bits), (f"{kind}.ge_u",)]
            value = [push] if kind == "i32" else [push, ("i32.wrap_i64",)]
            self._fail_if("shift out of range", it, value)

    def _sum(self, it: Binary, kind: str, op: str) -> None:
        """Check whether a sum differs in sign from both operands (Warren, Hacker's Delight 2-13).

        For a difference the second operand is taken with the opposite sign.
        """
        left, right = self.writer.value(it.left), self.writer.value(it.right)
        result = [left, right, (f"{kind}.{op}",)]
        first = [left, *result, (f"{kind}.xor",)]
        second = [right, *result, (f"{kind}.xor",)]
        if op == "sub":
            second = [left, right, (f"{kind}.xor",)]
        self.writer.code += [*first, *second, (f"{kind}.and",), (f"{kind}.const", 0)]
        self.writer.code.append((f"{kind}.lt_s",))
        self._fail_if("signed overflow", it, [("i32.const", 0)])

    def _product(self, it: Binary, kind: str) -> None:
        left, right = self.writer.value(it.left), self.writer.value(it.right)
        if kind == "i32":
            wide: list[Instr] = [left, ("i64.extend_i32_s",), right, ("i64.extend_i32_s",)]
            wide.append(("i64.mul",))
            narrow = [*wide, ("i64.extend32_s",)]
            self.writer.code += [*wide, *narrow, ("i64.ne",)]
        else:
            self.writer.code += [left, right, ("call", PRODUCT_FITS), ("i32.eqz",)]
        self._fail_if("signed overflow", it, [("i32.const", 0)])


def product_fits() -> Code:
    """`product_fits(left, right)`: whether the product of two i64 fits, checked by division."""
    left, right = 0, 1
    body = [
        ("local.get", left), ("i64.eqz",), ("if",), ("i32.const", 1), ("return",), ("end",),
        ("local.get", left), ("i64.const", -1), ("i64.eq",), UNLIKELY,
        ("local.get", right), ("i64.const", -(2**63)), ("i64.ne",), ("return",), ("end",),
        ("local.get", left), ("local.get", right), ("i64.mul",), ("local.get", left),
        ("i64.div_s",), ("local.get", right), ("i64.eq",),
    ]  # fmt: skip
    return Code("product_fits", (("i64", "i64"), ("i32",)), [], body)
