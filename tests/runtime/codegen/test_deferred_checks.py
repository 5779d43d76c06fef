"""Deferred checks are found in linear time."""

from __future__ import annotations

import sys
from types import FrameType

from crs_cc.core.source import Location
from crs_cc.ir.instruction import (
    Binary,
    Block,
    Constant,
    Instruction,
    Load,
    Register,
    Return,
    Slot,
    Store,
    Unary,
)
from crs_cc.ir.liveness import Liveness
from crs_cc.ir.program import Function
from crs_cc.runtime.codegen.deferred_checks import DeferredChecks

HERE = Location("statements.c", 1, 1)


def statements(count: int) -> Function:
    """Return `count` times `p = (char)x; q = y; r = z + 1`."""
    x, y, z, p, q, r = slots = [Slot(name, 4, 4) for name in "xyzpqr"]
    registers: list[Register] = []

    def register() -> Register:
        registers.append(Register(len(registers), "i32"))
        return registers[-1]

    code: list[Instruction] = []
    for _ in range(count):
        a, b, c, narrow, more = (register() for _ in range(5))
        code += [Load(HERE, to, at, 0, "i32") for to, at in ((a, x), (b, y), (c, z))]
        code += [Unary(HERE, narrow, "i32.extend8_s", a)]
        code += [Binary(HERE, more, "i32.add", c, Constant("i32", 1))]
        code += [Store(HERE, to, 0, of, "i32") for to, of in ((p, narrow), (q, b), (r, more))]
    block = Block("entry", code, Return(HERE, Constant("i32", 0)))
    return Function("statements", HERE, "i32", [], False, registers, slots, [block])


def lines_run(function: Function) -> int:
    """Count the lines executed to find deferred checks."""
    liveness, lines = Liveness(function), 0

    def trace(_frame: FrameType, event: str, _value: object) -> object:
        nonlocal lines
        lines += event == "line"
        return trace

    before = sys.gettrace()
    sys.settrace(trace)  # type: ignore[arg-type]
    try:
        DeferredChecks(function, liveness, keep=False)
    finally:
        sys.settrace(before)
    return lines


def test_the_check_of_what_is_copied_or_converted_is_deferred_and_arithmetic_is_a_use() -> None:
    function = statements(1)
    deferred = DeferredChecks(function, Liveness(function), keep=False)
    code = function.blocks[0].instructions
    converted, copied, used = (it for it in code if isinstance(it, Load))
    stores = [it for it in code if isinstance(it, Store)]
    flag, states = deferred.flag_of(converted), deferred.states_of(copied)
    assert flag is not None
    assert states is not None
    assert not deferred.is_deferred(used)
    assert [deferred.converted_for(it) for it in stores] == [flag, None, None]
    assert [deferred.copied_by(it) for it in stores] == [None, states, None]
    assert deferred.is_last(stores[0], flag)


def test_a_long_block_takes_no_longer_for_each_load() -> None:
    assert lines_run(statements(400)) < 2.2 * lines_run(statements(200))
