"""A kernel program that takes turns with the programs of a fleet, without returning to Python.

It is resumed, with the slots and clocks of all programs copied into its memory, and tells what is
to happen by a `TURN` at an address there: if its verdict is `RUN`, the fleet's driver runs rounds
up to the end that it tells, until a program asks for anything or nobody has to run, and it is
resumed again; otherwise that is why it returns to Python. A module that imports both joins them:
calls from one to the other and copies of a few hundred bytes take some tens of nanoseconds.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

import numpy as np
import wasmtime

from crs_cc.requests import SUSPENDED
from crs_cc.runtime.driver import HEADER, SLOTS
from crs_cc.runtime.executable import engine
from crs_cc.runtime.kernel_instance import KernelInstance
from crs_cc.runtime.layout import MEMORY_BYTES, PAGE
from crs_cc.runtime.turns import RECORD

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable
    from crs_cc.runtime.shard import PreparedCall, Shard
    from crs_cc.runtime.wasm import Instr

TURN: Final = np.dtype([("verdict", "<i4"), ("ran", "<i4"), ("end_s", "<f8")])
"""What the partner tells, and is told: see above; rounds that were run since, -1 for none."""

RUN: Final = 0
"""The verdict by which programs are to run."""

_MAILBOX, _MEMORY = range(2)  # memories
_ROUND, _RESUME = range(2)  # functions
_TURN, _RECORDS, _SIZE, _ROBOTS = range(4)  # parameters: addresses, bytes of slots, programs
_UNLIMITED: Final = -1


class Partner:
    """A program in the store of the only shard of a fleet.

    Attributes:
        instance: the program.
    """

    def __init__(
        self, shard: Shard, executable: Executable, end_turn: Callable[[Exception], int]
    ) -> None:
        """Start the program.

        Args:
            shard: the shard.
            executable: the program.
            end_turn: is called when a program has trapped; returns the rounds since the partner was
                last told of any.
        """
        self._shard, self._end_turn = shard, end_turn
        self.instance = KernelInstance(executable, shard.store)
        memory, resume = self.instance.exports["memory"], self.instance.exports["resume"]
        imports: list[Any] = [shard.mailbox, memory, shard.round, resume]
        exports = wasmtime.Instance(shard.store, _joint(engine()), imports).exports(shard.store)
        function = exports["turns"]
        assert isinstance(function, wasmtime.Func)
        self._function = function

    def turns(self, turn: int, records: int, robots: int) -> Turns:
        """Return what runs rounds of a number of programs, which are all, in turn with this one.

        Args:
            turn: the address of a `TURN` in this program's memory.
            records: the address of the slots there.
            robots: how many programs there are.
        """
        arguments = turn, records, robots * RECORD.itemsize, robots
        return Turns(self._shard.prepared(self._function, *arguments), self._end_turn)


class Turns:
    """Runs rounds of all programs of a fleet in alternation with a partner."""

    def __init__(self, call: PreparedCall, end: Callable[[Exception], int]) -> None:
        """Store a call of the partner's function, and what is done when a program traps in it."""
        self._call, self._end = call, end

    def take(self) -> int:
        """Run rounds until the partner ends them; return how many it was not told of.

        There are such rounds only if a program has trapped.
        """
        trap = self._call.make()
        return 0 if trap is None else self._end(trap)


@functools.cache
def _joint(engine: wasmtime.Engine) -> wasmtime.Module:
    return wasmtime.Module(engine, joint())


def joint() -> bytes:
    """Return the module that joins a driver and a program, in the binary format."""
    from crs_cc.runtime.wasm import TYPE_I32_I32, Code, Module

    module = Module(
        memory_imports=[("crs", "mailbox")],
        own_imports=[("kernel", "memory", MEMORY_BYTES // PAGE)],
        function_imports=[("crs", "round", ((), ())), ("kernel", "resume", TYPE_I32_I32)],
        functions=[Code("turns", (("i32",) * 4, ()), [], _turns())],
        exports=[("turns", "func", 2)],
    )
    return module.to_binary()


def _turns() -> list[Instr]:
    slots: list[Instr] = [("i32.const", SLOTS)]
    here, there = _get(_RECORDS), _get(_SIZE)
    return [
        # Where the driver leaves it, if it is not the driver that fails.
        ("i32.const", 0), _get(_ROBOTS), ("i32.store", _MAILBOX, _of_header("current")),
        ("loop",),
        here, *slots, there, ("memory.copy", _MEMORY, _MAILBOX),
        ("i32.const", 0), ("call", _RESUME),
        ("i32.const", SUSPENDED), ("i32.ne",), ("if",), ("unreachable",), ("end",),
        *slots, here, there, ("memory.copy", _MAILBOX, _MEMORY),
        _get(_TURN), ("i32.load", _MEMORY, _of_turn("verdict")), ("if",), ("return",), ("end",),
        *_tell("first", 0), *_tell("current", 0), *_tell("stride", 1), *_tell("timed", 1),
        *_tell("most", _UNLIMITED), *_tell("rounds", 0), *_tell("ran", 0), *_tell("asked", 0),
        ("i32.const", 0), _get(_ROBOTS), ("i32.store", _MAILBOX, _of_header("end")),
        ("i32.const", 0), _get(_TURN), ("f64.load", _MEMORY, _of_turn("end_s")),
        ("f64.store", _MAILBOX, _of_header("end_s")),
        ("call", _ROUND),
        _get(_TURN), ("i32.const", 0), ("i32.load", _MAILBOX, _of_header("rounds")),
        ("i32.store", _MEMORY, _of_turn("ran")),
        ("br", 0), ("end",),
    ]  # fmt: skip


def _get(local: int) -> Instr:
    return ("local.get", local)


def _tell(name: str, value: int) -> list[Instr]:
    """Store a number in the header of the only shard."""
    return [("i32.const", 0), ("i32.const", value), ("i32.store", _MAILBOX, _of_header(name))]


def _of_header(name: str) -> int:
    return int(HEADER.fields[name][1])  # type: ignore[index]


def _of_turn(name: str) -> int:
    return int(TURN.fields[name][1])  # type: ignore[index]
