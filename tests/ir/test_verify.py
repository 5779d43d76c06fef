"""The verifier accepts a valid program, and rejects one that violates a rule, for each rule."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from crs_cc.core.errors import InternalError
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
    Unary,
)
from crs_cc.ir.program import Data, Function, Parameter, Program, Relocation
from crs_cc.ir.verify import verify
from tests.ir.sample_program import at, number, sample_program

STRANGER = Register(0, "i32")
Spoil = Callable[[Program], object]
HERE = at(99)


def main(program: Program) -> Function:
    return program.functions["main"]


def register(program: Program, index: int) -> Register:
    return main(program).registers[index]


def adds(make: Callable[[Program], Instruction]) -> Spoil:
    """Append an instruction to the entry block of main."""
    return lambda program: main(program).blocks[0].instructions.append(make(program))


def ends(make: Callable[[Program], Instruction]) -> Spoil:
    """Append a block with this terminator to main, reachable from the switch."""

    def spoil(program: Program) -> None:
        last = main(program).blocks[-1]
        last.terminator = make(program)  # type: ignore[assignment]

    return spoil


def real(value: float) -> Constant:
    return Constant("f64", value)


CASES: dict[str, tuple[Spoil, str]] = {
    # names and data
    "filed under another name": (
        lambda p: p.functions.update(other=p.functions.pop("log")),
        "'log': is stored under the name 'other'",
    ),
    "function and object": (
        lambda p: p.data.update(main=Data("main", 4, 4, HERE)),
        "'main': is both a function and an object",
    ),
    "defined and undefined": (
        lambda p: p.undefined.update(log=HERE),
        "'log': is defined and listed as undefined",
    ),
    "content length": (
        lambda p: setattr(p.data["table"], "content", b"123"),
        "object 'table': has 3 bytes of content, but size 8",
    ),
    "alignment": (
        lambda p: setattr(p.data["zeros"], "align", 3),
        "object 'zeros': has alignment 3, which is not a power of two",
    ),
    "negative size": (
        lambda p: setattr(p.data["zeros"], "size", -1),
        "object 'zeros': has negative size -1",
    ),
    "relocation outside": (
        lambda p: p.data["table"].relocations.append(Relocation(5, "log")),
        "object 'table': relocation at 5 is outside its 8 bytes",
    ),
    "relocation to nothing": (
        lambda p: p.data["table"].relocations.append(Relocation(0, "nobody")),
        "object 'table': relocation names 'nobody', which is undefined",
    ),
    # functions
    "no entry": (lambda p: main(p).blocks.clear(), "'main': has no entry block"),
    "label twice": (
        lambda p: setattr(main(p).blocks[1], "label", "entry"),
        "'main': has 2 blocks labelled 'entry'",
    ),
    "unreachable block": (
        lambda p: main(p).blocks.append(Block("lost", [], Return(HERE, None))),
        "'main': block 'lost' is unreachable",
    ),
    "register number twice": (
        lambda p: main(p).registers.append(Register(0, "f32")),
        "'main': has 2 registers of number 0",
    ),
    "slot alignment": (
        lambda p: main(p).slots.append(Slot("s", 4, 0)),
        "'main': slot 's' has alignment 0",
    ),
    "struct parameter in a register": (
        lambda p: main(p).parameters.append(Parameter(register(p, 0), None, 8)),
        "'main': parameter 1 is a struct, but is in a register",
    ),
    "parameter size": (
        lambda p: main(p).parameters.append(Parameter(register(p, 0), "i32", 8)),
        "'main': parameter 1 is stored as i32, but has size 8",
    ),
    "parameter register type": (
        lambda p: main(p).parameters.append(Parameter(register(p, 2), "i32", 4)),
        "'main': parameter 1 is stored as i32, but its register has type f64",
    ),
    "parameter register of another": (
        lambda p: main(p).parameters.append(Parameter(STRANGER, "i32", 4)),
        "'main': parameter 1 is in a register of another function",
    ),
    "parameter slot too big": (
        lambda p: main(p).parameters.append(Parameter(Slot("x", 8, 4), "i32", 4)),
        "'main': parameter 1 has size 4, but its slot 8",
    ),
    "parameter slot listed": (
        lambda p: main(p).slots.append(main(p).parameters[0].place),  # type: ignore[arg-type]
        "'main': parameter 0 is in slot 'point', which is also listed as a local",
    ),
    # blocks
    "no terminator": (
        lambda p: setattr(main(p).blocks[-1], "terminator", None),
        "'main', block 'bad': has no terminator",
    ),
    "no real terminator": (
        ends(lambda p: Statement(HERE)),
        "'main', block 'bad': ends with Statement, which is not a terminator",
    ),
    "terminator in the middle": (
        adds(lambda p: Return(HERE, number(0))),
        "'main', block 'entry': Return is in the middle of the block",
    ),
    "target of another function": (
        ends(lambda p: Jump(HERE, p.functions["log"].blocks[1])),
        "'main', block 'bad': target 'done' is not in this function",
    ),
    "no location": (
        adds(lambda p: Statement(None)),  # type: ignore[arg-type]
        "Statement has no location",
    ),
    "foreign class": (adds(lambda p: Instruction(HERE)), "Instruction is not an instruction"),
    # operands
    "unknown operator": (
        adds(lambda p: Unary(HERE, register(p, 0), "i32.neg", number(1))),
        "'i32.neg' is not an operator of 1 operand(s)",
    ),
    "binary operator with one operand": (
        adds(lambda p: Unary(HERE, register(p, 0), "i32.add", number(1))),
        "'i32.add' is not an operator of 1 operand(s)",
    ),
    "operand type": (
        adds(lambda p: Binary(HERE, register(p, 0), "i32.add", number(1), real(1.0))),
        "right operand of i32.add has type f64, not i32",
    ),
    "result type": (
        adds(lambda p: Binary(HERE, register(p, 1), "i64.lt_s", register(p, 1), register(p, 1))),
        "result of i64.lt_s has type i64, not i32",
    ),
    "register of another": (
        adds(lambda p: Move(HERE, register(p, 0), STRANGER)),
        "source is a register of another function (%0)",
    ),
    "move of another type": (
        adds(lambda p: Move(HERE, register(p, 1), number(1))),
        "source has type i32, not i64",
    ),
    "unsigned constant": (
        adds(lambda p: Move(HERE, register(p, 0), number(2**31))),
        "source is 2147483648, outside the signed range of i32",
    ),
    "fractional integer": (
        adds(lambda p: Move(HERE, register(p, 0), Constant("i32", 1.0))),
        "source is the i32 constant 1.0, not an integer",
    ),
    "integral float": (
        adds(lambda p: Move(HERE, register(p, 2), Constant("f64", 1))),
        "source is the f64 constant 1, not a float",
    ),
    "no operand at all": (
        adds(lambda p: Move(HERE, register(p, 0), 1)),  # type: ignore[arg-type]
        "source is neither a register nor a constant",
    ),
    # memory
    "load type": (
        adds(lambda p: Load(HERE, register(p, 0), register(p, 3), 0, "i64")),
        "result has type i32, not i64",
    ),
    "store type": (
        adds(lambda p: Store(HERE, register(p, 3), 0, number(1), "f32")),
        "source has type i32, not f32",
    ),
    "base type": (
        adds(lambda p: Load(HERE, register(p, 0), register(p, 2), 0, "i32")),
        "base has type f64, not i32",
    ),
    "beyond the slot": (
        adds(lambda p: Store(HERE, main(p).slots[0], 13, number(0), "i32")),
        "i32 at 13 is outside 'buffer', which has 16 bytes",
    ),
    "before the slot": (
        adds(lambda p: Store(HERE, main(p).slots[0], -1, number(0), "i8")),
        "i8 at -1 is outside 'buffer'",
    ),
    "beyond the object": (
        adds(lambda p: Load(HERE, register(p, 1), "table", 1, "i64")),
        "i64 at 1 is outside 'table', which has 8 bytes",
    ),
    "slot of another": (
        adds(lambda p: Address(HERE, register(p, 0), Slot("far", 4, 4), 0)),
        "base is slot 'far' of another function",
    ),
    "unknown name": (
        adds(lambda p: Address(HERE, register(p, 0), "nobody", 0)),
        "base 'nobody' is neither defined nor listed as undefined",
    ),
    "code as data": (
        adds(lambda p: Load(HERE, register(p, 0), "log", 0, "i32")),
        "accesses the code of function 'log'",
    ),
    "varargs of a fixed function": (
        adds(lambda p: Address(HERE, register(p, 0), VARARGS, 0)),
        "base is VARARGS, but the function is not variadic",
    ),
    "access to varargs": (
        lambda p: (
            p.functions["log"]
            .blocks[0]
            .instructions.append(Load(HERE, p.functions["log"].registers[0], VARARGS, 0, "i32"))
        ),
        "i32 at 0 is outside '...', which has 0 bytes",
    ),
    "address type": (
        adds(lambda p: Address(HERE, register(p, 1), "table", 0)),
        "result has type i64, not i32",
    ),
    "copy size": (
        adds(lambda p: Copy(HERE, number(1), number(2), real(3.0))),
        "size has type f64, not i32",
    ),
    "fill value": (
        adds(lambda p: Fill(HERE, number(1), real(0.0), number(3))),
        "value has type f64, not i32",
    ),
    # terminators
    "condition": (
        ends(lambda p: Branch(HERE, real(1.0), main(p).blocks[1], main(p).blocks[2])),
        "condition has type f64, not i32",
    ),
    "switch on a float": (
        ends(lambda p: Switch(HERE, register(p, 2), [], main(p).blocks[1])),
        "value has type f64, not i32 or i64",
    ),
    "case twice": (
        ends(lambda p: Switch(HERE, register(p, 0), [(3, (b := main(p).blocks[1])), (3, b)], b)),
        "case 3 occurs 2 times",
    ),
    "case out of range": (
        ends(lambda p: Switch(HERE, register(p, 0), [(2**31, main(p).blocks[1])], p_loop(p))),
        "case is 2147483648, outside the signed range of i32",
    ),
    "return type": (
        ends(lambda p: Return(HERE, real(1.0))),
        "returned value has type f64, not i32",
    ),
    "return from void": (
        lambda p: setattr(p.functions["log"].blocks[1], "terminator", Return(HERE, number(1))),
        "returns a value from a function without a result",
    ),
    "unknown callee": (
        ends(lambda p: Call(HERE, "nobody", [], None, p_loop(p))),
        "callee 'nobody' is neither defined nor listed as undefined",
    ),
    "object called": (
        ends(lambda p: Call(HERE, "table", [], None, p_loop(p))),
        "callee 'table' is an object, not a function",
    ),
    "callee type": (
        ends(lambda p: Call(HERE, register(p, 2), [], None, p_loop(p))),
        "callee has type f64, not i32",
    ),
    "argument type": (
        ends(lambda p: Call(HERE, "puts", [Argument(number(1), "f64", 8)], None, p_loop(p))),
        "argument 0 has type i32, not f64",
    ),
    "argument size": (
        ends(lambda p: Call(HERE, "puts", [Argument(number(1), "i8", 4)], None, p_loop(p))),
        "argument 0 is stored as i8, but has size 4",
    ),
    "struct argument": (
        ends(lambda p: Call(HERE, "puts", [Argument(real(0.0), None, 4)], None, p_loop(p))),
        "address of argument 0 has type f64, not i32",
    ),
    "call result of another": (
        ends(lambda p: Call(HERE, "puts", [], STRANGER, p_loop(p))),
        "result is a register of another function",
    ),
    "request code": (
        ends(lambda p: Request(HERE, real(1.0), number(0), register(p, 0), p_loop(p))),
        "code has type f64, not i32",
    ),
    "request result": (
        ends(lambda p: Request(HERE, number(1), number(0), register(p, 2), p_loop(p))),
        "result has type f64, not i32",
    ),
    "jump operands": (
        ends(lambda p: LongJump(HERE, number(1), real(0.0), number(2))),
        "place has type f64, not i32",
    ),
    "jump buffer": (
        ends(lambda p: SetJump(HERE, register(p, 2), *[register(p, 0)] * 2, p_loop(p))),
        "buffer has type f64, not i32",
    ),
    "stop kind": (ends(lambda p: Stop(HERE, "tired")), "'tired' is not a kind of error"),
}


def p_loop(program: Program) -> Block:
    return main(program).blocks[1]


def test_a_valid_program_with_every_kind_of_instruction_is_accepted() -> None:
    verify(sample_program())


def test_an_empty_program_is_accepted() -> None:
    verify(Program())


@pytest.mark.parametrize(("spoil", "message"), CASES.values(), ids=CASES.keys())
def test_violations_are_reported_with_their_location(spoil: Spoil, message: str) -> None:
    program = sample_program()
    spoil(program)
    with pytest.raises(InternalError) as refused:
        verify(program)
    text = str(refused.value)
    assert "sample.c:" in text
    assert f"malformed IR in {message}" in text or f": {message}" in text


def test_all_violations_are_reported() -> None:
    program = sample_program()
    program.data["table"].content = b""
    main(program).blocks[0].instructions.append(Move(HERE, register(program, 0), real(1.0)))
    main(program).blocks[-1].terminator = None
    with pytest.raises(InternalError) as refused:
        verify(program)
    assert len(refused.value.diagnostics) == 3


def test_a_declared_function_may_be_called_before_it_is_linked() -> None:
    program = sample_program()
    ends(lambda p: Call(HERE, "puts", [], register(p, 2), p_loop(p)))(program)
    verify(program)
