"""A small valid program with every kind of instruction, for the tests of this folder."""

from __future__ import annotations

from crs_cc.core.source import Location
from crs_cc.ir.instruction import (
    VARARGS,
    Address,
    Argument,
    Binary,
    Block,
    Branch,
    Call,
    Constant,
    Copy,
    Fill,
    Instruction,
    Jump,
    Load,
    LongJump,
    Move,
    Register,
    Request,
    Return,
    SetJump,
    Slot,
    Statement,
    Stop,
    Store,
    Switch,
    Terminator,
    Unary,
)
from crs_cc.ir.program import Data, Function, Parameter, Program, Relocation


def at(line: int, column: int = 5) -> Location:
    return Location("sample.c", line, column)


def number(value: int) -> Constant:
    return Constant("i32", value)


def block(label: str, instructions: list[Instruction], terminator: Terminator | None) -> Block:
    return Block(label, instructions, terminator)


def log_function() -> Function:
    """`void log(const char *format, ...)`, posting one request."""
    format_, rest, result = Register(0, "i32"), Register(1, "i32"), Register(2, "i32")
    done = block("done", [], Return(at(4), None))
    entry = block(
        "entry",
        [Statement(at(2)), Address(at(2), rest, VARARGS, 0)],
        Request(at(3), number(2), rest, result, done),
    )
    return Function(
        "log",
        at(1, 1),
        parameters=[Parameter(format_, "i32", 4)],
        variadic=True,
        registers=[format_, rest, result],
        blocks=[entry, done],
    )


def main_function() -> Function:
    """Return a function with most kinds of instructions."""
    n, wide, real, pointer, flag = (
        Register(i, kind) for i, kind in enumerate(("i32", "i64", "f64", "i32", "i32"))
    )
    point = Slot("point", 8, 4)
    buffer = Slot("buffer", 16, 1)
    loop, called, one, two, bad = (Block(name) for name in ("loop", "called", "one", "two", "bad"))
    entry = block(
        "entry",
        [
            Statement(at(10)),
            Move(at(10), n, number(0)),
            Unary(at(11), wide, "i64.extend_i32_s", n),
            Unary(at(12), real, "f64.convert_i64_s", wide),
            Store(at(12), buffer, 8, real, "f64"),
            Load(at(13), flag, point, 4, "u16"),
        ],
        Jump(at(13), loop),
    )
    loop.instructions = [
        Binary(at(14), flag, "f64.lt", real, Constant("f64", 0.5)),
        Address(at(15), pointer, "table", 4),
        Copy(at(15), pointer, n, number(4)),
        Fill(at(16), pointer, number(255), number(2)),
        Load(at(16), n, "table", 0, "i32"),
    ]
    arguments = [
        Argument(pointer, "i32", 4),
        Argument(Constant("f64", 1.5), "f64", 8),
        Argument(pointer, None, 6),
    ]
    loop.terminator = Call(at(17), "log", arguments, None, called)
    called.terminator = Switch(at(18), wide, [(1, one), (-7, two)], bad)
    one.terminator = Branch(at(19), flag, loop, two)
    two.terminator = Call(at(20), pointer, [], n, ending := Block("ending"))
    ending.terminator = Return(at(21), n)
    bad.terminator = Stop(at(22), "unreachable code reached")
    return Function(
        "main",
        at(9, 1),
        result="i32",
        parameters=[Parameter(point, None, 8)],
        registers=[n, wide, real, pointer, flag],
        slots=[buffer],
        blocks=[entry, loop, called, one, two, ending, bad],
    )


def jump_function() -> Function:
    """Return a function with `setjmp` and `longjmp`."""
    buffer, activation, result = (Register(i, "i32") for i in range(3))
    landed = Block("landed")
    jump = SetJump(at(25), buffer, activation, result, landed)
    entry = block("entry", [Load(at(24), activation, "table", 0, "i32")], jump)
    landed.terminator = LongJump(at(26), activation, number(1), result)
    parameters = [Parameter(buffer, "i32", 4)]
    return Function(
        "again",
        at(23, 1),
        parameters=parameters,
        registers=[buffer, activation, result],
        blocks=[entry, landed],
    )


def sample_program() -> Program:
    """Return a new copy, which a test may modify."""
    table = Data("table", 8, 4, at(8, 1), b"\x01\0\0\0Hi!\0", [Relocation(4, "log", 0)])
    zeros = Data("zeros", 400, 8, at(8, 20), tentative=True)
    return Program(
        {"log": log_function(), "main": main_function(), "again": jump_function()},
        {"table": table, "zeros": zeros},
        {"puts": at(30, 3)},
    )
