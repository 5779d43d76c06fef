"""A fleet runs, saves and restores programs, and isolates their failures."""

from __future__ import annotations

import mmap
import sys
import weakref

import numpy as np
import pytest

from crs_cc.core.source import Location
from crs_cc.ir.instruction import (
    Address,
    Block,
    ByteState,
    Constant,
    Jump,
    Load,
    Move,
    Register,
    Request,
    Slot,
    Store,
)
from crs_cc.ir.program import Function, Program
from crs_cc.requests import CODES, ERROR_KINDS, FAILED, MESSAGE, SLOT, SUSPENDED
from crs_cc.runtime.executable import Executable, make_executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.layout import MEMORY_BYTES
from crs_cc.runtime.testing import counting_program

HERE = Location("wild.c", 7, 3)
TLB_SETS = 64  # of a small one


def wild_program(address: int, *, checked: bool) -> Executable:
    """Return a program that reads from an address and then loops for ever."""
    pointer, value = Register(0, "i32"), Register(1, "i32")
    entry, loop = Block("entry"), Block("loop")
    entry.instructions = [
        Move(HERE, pointer, Constant("i32", address)),
        Load(HERE, value, pointer, 0, "i32"),
    ]
    entry.terminator = Jump(HERE, loop)
    loop.terminator = Jump(HERE, loop)
    start = Function("__crs_start", HERE, "i32", registers=[pointer, value], blocks=[entry, loop])
    return make_executable(Program({start.name: start}), "wild.c", checked=checked)


def posting_program(size: int) -> Executable:
    """Return a program that posts an object of a size as a message, and then loops for ever."""
    message = Slot("message", size, 8)
    at, result = Register(0, "i32"), Register(1, "i32")
    entry, loop = Block("entry"), Block("loop")
    entry.instructions = [
        Store(HERE, message, 0, Constant("i32", 77), "i32"),
        Address(HERE, at, message, 0),
    ]
    entry.terminator = Request(HERE, Constant("i32", CODES["VM"]), at, result, loop)
    loop.terminator = Jump(HERE, loop)
    start = Function(
        "__crs_start", HERE, "i32", registers=[at, result], slots=[message], blocks=[entry, loop]
    )
    return make_executable(Program({start.name: start}), "post.c")


def run(fleet: Fleet, fuel: int = 1000) -> None:
    fleet.slots["run"] = 1
    fleet.slots["fuel"] = fuel
    fleet.run_round()


def test_only_robots_marked_to_run_are_resumed() -> None:
    fleet = Fleet([counting_program()] * 5)
    fleet.slots["fuel"] = 1000
    fleet.slots["run"][[1, 4]] = 1
    assert fleet.run_round() is None
    assert fleet.slots["code"].tolist() == [0, CODES["EXIT"], 0, 0, CODES["EXIT"]]


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_any_choice_of_robots_is_resumed_once(threads: int) -> None:
    fleet = Fleet([wild_program(MEMORY_BYTES - 4, checked=False)] * 75, threads=threads)
    random = np.random.default_rng(1)
    for share in (0.0, 0.1, 0.5, 1.0):
        wanted = random.random(75) < share
        fleet.slots["run"] = wanted
        fleet.slots["fuel"] = 100
        fleet.run_round()
        assert ((fleet.slots["fuel"] < 0) == wanted).all()
        assert not fleet.slots["run"].any()


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_traps_stop_their_robots_alone_in_any_number_of_threads(threads: int) -> None:
    good, bad = counting_program(), wild_program(MEMORY_BYTES, checked=False)
    fleet = Fleet([bad, good, bad, bad, good, good, good, bad], threads=threads)
    run(fleet)
    failed = np.array([1, 0, 1, 1, 0, 0, 0, 1], bool)
    assert ((fleet.slots["status"] == FAILED) == failed).all()
    assert (fleet.slots["code"][~failed] == CODES["EXIT"]).all()


@pytest.mark.parametrize("missing", [1, 16, 100])
def test_a_message_must_be_accessible_to_its_last_byte(missing: int) -> None:
    program = posting_program(MESSAGE.itemsize - missing)
    fleet = Fleet([program])
    run(fleet)
    assert fleet.slots["status"][0] == FAILED
    assert fleet.failure(0).kind == "out of bounds"


def test_a_message_crosses_the_door_whole_and_back() -> None:
    fleet = Fleet([posting_program(MESSAGE.itemsize)])
    run(fleet)
    assert fleet.slots["message"]["i"][0, 0] == 77
    reply = np.arange(1, MESSAGE.itemsize + 1).astype(np.uint8)
    fleet.reply(np.array([0]), reply.view(MESSAGE))
    run(fleet)
    memory, shadow = fleet.memory(0).tobytes(), fleet.shadow(0)
    at = memory.index(reply.tobytes())
    assert (shadow[at : at + MESSAGE.itemsize] == ByteState.WITH_VALUE).all()


def test_an_endless_loop_is_suspended_when_out_of_fuel() -> None:
    fleet = Fleet([wild_program(MEMORY_BYTES - 4, checked=False)])
    run(fleet, 500)
    assert fleet.slots["status"][0] == SUSPENDED
    assert fleet.slots["code"][0] == 0
    assert -10 <= fleet.slots["fuel"][0] < 0


def test_a_wild_read_is_reported_and_stops_only_its_robot() -> None:
    good = counting_program()
    fleet = Fleet([good, wild_program(MEMORY_BYTES - 3, checked=True), good])
    run(fleet)
    assert fleet.slots["status"].tolist() == [SUSPENDED, FAILED, SUSPENDED]
    assert fleet.slots["code"][[0, 2]].tolist() == [CODES["EXIT"]] * 2
    failure = fleet.failure(1)
    assert (failure.kind, failure.location) == ("wild pointer", HERE)
    assert failure.value == MEMORY_BYTES - 3


def test_null_and_wild_pointers_are_distinguished() -> None:
    fleet = Fleet([wild_program(12, checked=True)])
    run(fleet)
    assert fleet.failure(0).kind == "null pointer"


def test_a_trap_stops_its_robot_alone_and_the_round_is_finished() -> None:
    good = counting_program()
    fleet = Fleet([good, wild_program(MEMORY_BYTES, checked=False), good, good])
    run(fleet)
    assert fleet.slots["status"].tolist() == [SUSPENDED, FAILED, SUSPENDED, SUSPENDED]
    assert fleet.slots["code"][[0, 2, 3]].tolist() == [CODES["EXIT"]] * 3
    assert ERROR_KINDS[fleet.slots["error_kind"][1]] == "pointer outside memory"


def test_a_wild_access_in_an_unchecked_build_is_an_error_of_the_program() -> None:
    fleet = Fleet([wild_program(MEMORY_BYTES, checked=False)])
    run(fleet)
    assert "without memory checks" in fleet.report(0).text


def test_a_snapshot_resumes_in_another_fleet() -> None:
    program = counting_program(rounds=1000)
    first, second = Fleet([program]), Fleet([program, program])
    run(first, 100)
    assert first.slots["code"][0] == 0
    second.restore(1, first.snapshot(0))
    for fleet in (first, second):
        run(fleet, 10_000)
    assert first.slots["message"]["i"][0, 0] == second.slots["message"]["i"][1, 0] == 1000
    assert first.slots["fuel"][0] == second.slots["fuel"][1]
    assert np.array_equal(first.memory(0), second.memory(1))


def test_restoring_clears_what_was_written_since() -> None:
    fleet = Fleet([counting_program()])
    before = fleet.snapshot(0)
    fleet.memory(0)[9 * 2**20] = 1
    fleet.restore(0, before)
    assert not fleet.memory(0).any()


def test_ten_thousand_robots_can_be_made() -> None:
    fleet = Fleet([counting_program()] * 10_000)
    run(fleet)
    assert (fleet.slots["code"] == CODES["EXIT"]).all()


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere memories may lie otherwise")
def test_memories_do_not_compete_for_the_same_places_of_the_page_table_cache() -> None:
    fleet = Fleet([counting_program()] * 16)
    memories = [each for robot in range(16) for each in (fleet.memory(robot), fleet.shadow(robot))]
    sets = {each.ctypes.data // mmap.PAGESIZE % TLB_SETS for each in memories}
    assert len(sets) >= len(memories) // 2  # by chance, two may be in the same


def test_slots_do_not_overlap() -> None:
    assert SLOT.itemsize == 384
    assert SLOT.fields["message"][1] + SLOT["message"].itemsize == SLOT.itemsize


def test_a_slot_in_the_frame_survives_suspension() -> None:
    slot, pointer, value = Slot("x", 4, 4), Register(0, "i32"), Register(1, "i32")
    entry, loop = Block("entry"), Block("loop")
    entry.instructions = [
        Store(HERE, slot, 0, Constant("i32", 77), "i32"),
        Address(HERE, pointer, slot, 0),
    ]
    entry.terminator = Jump(HERE, loop)
    loop.instructions = [Load(HERE, value, pointer, 0, "i32")]
    loop.terminator = Jump(HERE, loop)
    start = Function(
        "__crs_start", HERE, "i32", registers=[pointer, value], slots=[slot],
        blocks=[entry, loop],
    )  # fmt: skip
    executable = make_executable(Program({start.name: start}), "slot.c")
    fleet = Fleet([executable])
    run(fleet, 10)
    run(fleet, 10)
    info = executable.detail().compiled.functions[0]
    base = 4096 + 2 * 2**20 - 16 - info.frame.size
    at = base + info.frame.offsets[slot]
    assert fleet.memory(0)[at : at + 4].view("<i4")[0] == 77


def test_arrays_into_a_fleet_keep_its_memory() -> None:
    fleet = Fleet([counting_program()])
    memory, slots, known = fleet.memory(0), fleet.slots, weakref.ref(fleet)
    del fleet
    assert known() is None
    assert memory[5000] == 0
    assert slots["run"][0] == 0
