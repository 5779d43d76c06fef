"""A hand-made program, for examples and tests that need no compiler."""

from __future__ import annotations

from crs_cc.core.source import Location
from crs_cc.ir.instruction import Address as AddressOf
from crs_cc.ir.instruction import (
    Binary,
    Block,
    Branch,
    Constant,
    Jump,
    Move,
    Register,
    Request,
    Slot,
    Store,
)
from crs_cc.ir.program import Function, Program
from crs_cc.requests import CODES, MESSAGE
from crs_cc.runtime.executable import Executable, make_executable


def counting_program(rounds: int = 10) -> Executable:
    """Return a program that counts to `rounds` and exits with that number, again and again."""
    here = Location("counting.c", 1, 1)
    count, test, at = Register(0, "i32"), Register(1, "i32"), Register(2, "i32")
    result = Register(3, "i32")
    message = Slot("message", MESSAGE.itemsize, 8)
    entry, loop, done = Block("entry"), Block("loop"), Block("done")
    entry.instructions = [Move(here, count, Constant("i32", 0))]
    entry.terminator = Jump(here, loop)
    loop.instructions = [
        Binary(here, count, "i32.add", count, Constant("i32", 1)),
        Binary(here, test, "i32.lt_s", count, Constant("i32", rounds)),
    ]
    loop.terminator = Branch(here, test, loop, done)
    done.instructions = [Store(here, message, 0, count, "i32"), AddressOf(here, at, message, 0)]
    done.terminator = Request(here, Constant("i32", CODES["EXIT"]), at, result, entry)
    start = Function(
        "__crs_start", here, "i32", [], False, [count, test, at, result], [message],
        [entry, loop, done],
    )  # fmt: skip
    return make_executable(Program({start.name: start}), "counting.c")
