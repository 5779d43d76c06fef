"""Any control flow graph runs correctly, reducible or not, wherever it is suspended.

Random programs walk a random graph: every block mixes its number into a hash that decides where
to go next. An interpreter of a few lines tells what the hash must be.
"""

from __future__ import annotations

import random

import pytest

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Location
from crs_cc.ir.instruction import (
    Address,
    Binary,
    Block,
    Branch,
    Call,
    Constant,
    Jump,
    Load,
    Move,
    Register,
    Request,
    Return,
    Slot,
    Statement,
    Store,
    Switch,
)
from crs_cc.ir.program import Function, Program
from crs_cc.ir.verify import verify
from crs_cc.requests import CODES, MESSAGE, SUSPENDED
from crs_cc.runtime.codegen.module import compile_program
from crs_cc.runtime.executable import make_executable
from crs_cc.runtime.fleet import Fleet

HERE = Location("walk.c", 1, 1)
STEPS = 300
MASK = 2**32 - 1


def const(value: int) -> Constant:
    return Constant("i32", value)


def walker(seed: int, size: int, *, tangled: bool = False) -> Program:
    """Return a program that walks a random graph and exits with the hash of its walk."""
    rng = random.Random(seed)
    hash_, left, test = Register(0, "i32"), Register(1, "i32"), Register(2, "i32")
    at, result = Register(3, "i32"), Register(4, "i32")
    message = Slot("message", MESSAGE.itemsize, 8)
    blocks = [Block(f"b{number}") for number in range(size)]
    end = Block("end", [Store(HERE, message, 0, hash_, "i32"), Address(HERE, at, message, 0)])
    after = Block("after", [])
    after.terminator = Return(HERE, const(0))
    end.terminator = Request(HERE, const(CODES["EXIT"]), at, result, after)
    entry = Block("entry", [Move(HERE, hash_, const(seed)), Move(HERE, left, const(STEPS))])
    entry.terminator = Jump(HERE, blocks[0])
    checks = []
    for number, block in enumerate(blocks):
        block.instructions = [
            Statement(HERE),
            Binary(HERE, hash_, "i32.mul", hash_, const(1103515245)),
            Binary(HERE, hash_, "i32.add", hash_, const(number + 12345)),
            Binary(HERE, left, "i32.sub", left, const(1)),
        ]
        check = Block(f"c{number}", [Binary(HERE, test, "i32.shr_u", hash_, const(16))])
        checks.append(check)
        block.terminator = Branch(HERE, left, check, end)
        targets = [rng.choice(blocks) for _ in range(rng.choice([1, 2, 2, 2, 5]))]
        if tangled:
            targets = [blocks[size - 1 - number], blocks[(number + 1) % size]]
        if rng.random() < 0.2 and not tangled:
            targets = [blocks[(number + 1) % size]]
        check.instructions.append(
            Binary(HERE, test, "i32.rem_u", test, const(max(1, len(targets))))
        )
        if len(targets) == 1:
            check.terminator = Jump(HERE, targets[0])
        elif len(targets) == 2:
            check.terminator = Branch(HERE, test, targets[0], targets[1])
        else:
            check.terminator = Switch(HERE, test, list(enumerate(targets[:-1])), targets[-1])
        if rng.random() < 0.3:  # a call in the middle makes a resume point
            direct = check.terminator
            check.terminator = Call(HERE, "twist", [], None, Block(f"d{number}"))
            check.terminator.then.terminator = direct
            checks.append(check.terminator.then)
    reachable = _reachable([entry, *blocks, *checks, end, after])
    registers = [hash_, left, test, at, result]
    start = Function("__crs_start", HERE, "i32", [], False, registers, [message], reachable)
    return Program({"__crs_start": start, "twist": _twist()})


def _twist() -> Function:
    loaded = Register(0, "i32")
    slot = Slot("s", 4, 4)
    block = Block(
        "entry", [Store(HERE, slot, 0, const(7), "i32"), Load(HERE, loaded, slot, 0, "i32")]
    )
    block.terminator = Return(HERE, loaded)
    return Function("twist", HERE, "i32", [], False, [loaded], [slot], [block])


def _reachable(blocks: list[Block]) -> list[Block]:
    seen = [blocks[0]]
    for block in seen:
        seen += [each for each in block.successors() if each not in seen]
    return [block for block in blocks if block in seen]


def expected(program: Program) -> int:  # noqa: C901 - an interpreter is one match
    """Interpret the walk."""
    values: dict[Register, int] = {}

    def value(operand: Register | Constant) -> int:
        return int(operand.value) if isinstance(operand, Constant) else values[operand]

    block = program.functions["__crs_start"].blocks[0]
    operators = {
        "i32.mul": lambda a, b: a * b,
        "i32.add": lambda a, b: a + b,
        "i32.sub": lambda a, b: a - b,
        "i32.shr_u": lambda a, b: a >> b,
        "i32.rem_u": lambda a, b: a % b,
    }
    while True:
        for each in block.instructions:
            if isinstance(each, Move):
                values[each.result] = value(each.source) & MASK
            elif isinstance(each, Binary):
                values[each.result] = operators[each.op](value(each.left), value(each.right)) & MASK
        match block.terminator:
            case Request():
                register = program.functions["__crs_start"].registers[0]
                return (values[register] + 2**31) % 2**32 - 2**31
            case Jump(target=block):
                pass
            case Call(then=block):
                pass
            case Branch(condition=condition, then=then, otherwise=otherwise):
                block = then if value(condition) else otherwise
            case Switch(value=switch, cases=cases, default=default):
                block = dict(cases).get(value(switch), default)


def walk(program: Program, fuel: int, *, debug: bool, move: bool = False) -> tuple[int, int]:
    """Return the exit status and the fuel burnt; `move` changes the robot at each stop."""
    executable = make_executable(program, "walk.c", debug=debug)
    fleet = Fleet([executable] * 2)
    burnt, robot = 0, 0
    while True:
        slot = fleet.slots[robot : robot + 1]
        slot["run"], slot["fuel"] = 1, fuel
        slot["stop_before_all"] = 1
        slot["stop_from"] = slot["statements"] + 1
        fleet.run_round()
        burnt += fuel - int(slot["fuel"][0])
        assert slot["status"] == SUSPENDED
        if slot["code"]:
            return int(slot["message"]["i"][0, 0]), burnt
        if move:
            fleet.restore(1 - robot, fleet.snapshot(robot))
            robot = 1 - robot


@pytest.mark.parametrize("seed", range(60))
def test_random_graphs_run_as_drawn_however_they_are_suspended(seed: int) -> None:
    program = walker(seed, 2 + seed % 12)
    verify(program)
    want = expected(program)
    plain = walk(program, 10**6, debug=False)
    assert plain[0] == want
    assert walk(program, 1, debug=False) == plain
    assert walk(program, 10**6, debug=True) == plain


def test_a_suspended_walk_resumes_in_another_robot() -> None:
    program = walker(7, 9)
    assert walk(program, 1, debug=False, move=True)[0] == expected(program)


def test_a_long_function_needs_no_recursion() -> None:
    program = walker(3, 3000)
    assert walk(program, 10**6, debug=False)[0] == expected(program)


def test_irreducible_control_flow_compiles_in_linear_size() -> None:
    size = 1000
    program = walker(5, size, tangled=True)
    compiled = compile_program(program)
    assert len(compiled.module.to_binary()) < 1000 * size
    assert walk(program, 10**6, debug=False)[0] == expected(program)


def test_a_frame_larger_than_the_stack_is_a_stack_overflow() -> None:
    slots = [Slot(f"s{number}", 2**31 - 1, 1) for number in range(3)]
    entry = Block("entry", [Store(HERE, slots[2], 0, const(1), "i8")])
    entry.terminator = Return(HERE, const(0))
    start = Function("__crs_start", HERE, "i32", slots=slots, blocks=[entry])
    fleet = Fleet([make_executable(Program({start.name: start}), "huge.c")])
    fleet.slots["run"], fleet.slots["fuel"] = 1, 1000
    fleet.run_round()
    assert fleet.failure(0).kind == "stack overflow"


def test_an_overaligned_local_is_rejected() -> None:
    entry = Block("entry")
    entry.terminator = Return(HERE, const(0))
    slots = [Slot("s", 8, 32)]
    start = Function("__crs_start", HERE, "i32", slots=slots, blocks=[entry])
    with pytest.raises(CompileError, match="aligned to 32 bytes"):
        compile_program(Program({start.name: start}))
