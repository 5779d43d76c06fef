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
)
from crs_cc.ir.liveness import Liveness
from crs_cc.ir.program import Function
from crs_cc.runtime.codegen.deferred_checks import DeferredChecks

HERE = Location("sums.c", 1, 1)


def sums(count: int) -> Function:
    """Return `count` times `p = x + z; q = y + z`, where two flags are joined for the sake of z."""
    slots = [Slot(name, 4, 4) for name in "xyzpq"]
    x, y, z, p, q = slots
    registers: list[Register] = []

    def register() -> Register:
        registers.append(Register(len(registers), "i32"))
        return registers[-1]

    code: list[Instruction] = []
    for _ in range(count):
        a, b, c, left, right = (register() for _ in range(5))
        code += [Load(HERE, to, at, 0, "i32") for to, at in ((a, x), (b, y), (c, z))]
        code += [Binary(HERE, left, "i32.add", a, c), Binary(HERE, right, "i32.add", b, c)]
        code += [Store(HERE, p, 0, left, "i32"), Store(HERE, q, 0, right, "i32")]
    block = Block("entry", code, Return(HERE, Constant("i32", 0)))
    return Function("sums", HERE, "i32", [], False, registers, slots, [block])


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


def test_loads_of_the_same_sum_share_one_flag() -> None:
    function = sums(2)
    deferred = DeferredChecks(function, Liveness(function), keep=False)
    code = function.blocks[0].instructions
    flags = [deferred.flag_of(it) for it in code if isinstance(it, Load)]
    assert flags[0] is not None
    assert [flags.index(flag) for flag in flags] == [0, 0, 0, 3, 3, 3]
    assert deferred.registers == [flags[0], flags[3]]
    stores = [it for it in code if isinstance(it, Store)]
    assert [deferred.computed_for(it) for it in stores] == [flags[0]] * 2 + [flags[3]] * 2
    assert flags[3] is not None
    assert [deferred.is_last(it, flags[3]) for it in stores] == [False, False, False, True]


def test_joining_flags_takes_no_longer_for_each_in_a_long_function() -> None:
    assert lines_run(sums(400)) < 2.2 * lines_run(sums(200))
