"""The text form of a program."""

from __future__ import annotations

from pathlib import Path

from crs_cc.ir.instruction import Block, Instruction, Move, Register, Slot, Variable
from crs_cc.ir.program import Function, Program
from crs_cc.ir.text import to_text
from tests.ir.sample_program import at, number, sample_program


def test_text_of_the_sample() -> None:
    assert to_text(sample_program()) == (Path(__file__).parent / "sample.ir").read_text()


def test_registers_and_slots_have_variable_names() -> None:
    speed = Register(3, "i32", Variable("speed", None, at(1)))  # type: ignore[arg-type]
    entry = Block("entry", [Move(at(2), speed, number(-100))])
    first, second = Slot("i", 4, 4), Slot("i", 4, 4)
    function = Function("f", at(1), registers=[speed], slots=[first, second], blocks=[entry])
    text = to_text(Program({"f": function}))
    assert "  %speed.3 = -100" in text
    assert "slot $i.0 size" in text
    assert "slot $i.1 size" in text


def test_an_unfinished_program_can_be_printed() -> None:
    entry = Block("entry", [Instruction(at(2))])
    text = to_text(Program({"f": Function("f", at(1), blocks=[entry])}))
    assert "(Instruction)" in text
    assert "(no terminator)" in text
