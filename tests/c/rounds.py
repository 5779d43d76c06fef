"""Many rounds of a fleet of one program in one call from Python, which costs more than most rounds.

The rounds are those of the fleet's own driver; only what its owner does between them, as long as
the program posts no request, is done in WebAssembly.
"""

from __future__ import annotations

import functools
from typing import Any, Final

import numpy as np
import wasmtime

from crs_cc.requests import FAILED, slot_offset
from crs_cc.runtime.driver import HEADER, SLOTS
from crs_cc.runtime.executable import engine
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.shard import view

STATE: Final = np.dtype(
    [
        ("fuel", "<i8"),
        ("statements", "<i8"),
        ("most_fuel", "<i8"),
        ("most_rounds", "<i8"),
        ("used", "<i8"),
        ("rounds", "<i8"),
    ]
)
"""What is asked for and what was done.

fuel: for each round
statements: to run in each round, 0 for no limit (debug builds)
most_fuel, most_rounds: no further round begins when so much was used
used: fuel used in all rounds but the last
rounds: rounds begun
"""


CURRENT: Final = dict(HEADER.fields or {})["current"][1]
"""Offset of the number of the robot to begin with, in the header of the only shard."""


def _at(field: str) -> str:
    return f"offset={SLOTS + slot_offset(field)}"


def _state(field: str) -> str:
    assert STATE.fields is not None
    return f"$state offset={STATE.fields[field][1]}"


_LOOP: Final = f"""
(module
  (import "fleet" "mailbox" (memory $slot 1 65536 shared))
  (import "fleet" "round" (func $round))
  (memory $state (export "state") 1)
  (func (export "rounds") (local $used i64)
    (loop $again
      (i32.store $slot {_at("run")} (i32.const 0) (i32.const 1))
      (i64.store $slot {_at("fuel")} (i32.const 0) (i64.load {_state("fuel")} (i32.const 0)))
      (if (i64.ne (i64.load {_state("statements")} (i32.const 0)) (i64.const 0)) (then
        (i32.store $slot {_at("stop_before_all")} (i32.const 0) (i32.const 2))
        (i64.store $slot {_at("stop_from")} (i32.const 0) (i64.add
          (i64.load $slot {_at("statements")} (i32.const 0))
          (i64.load {_state("statements")} (i32.const 0))))))
      (i64.store {_state("rounds")} (i32.const 0)
        (i64.add (i64.load {_state("rounds")} (i32.const 0)) (i64.const 1)))
      (i32.store $slot offset={CURRENT} (i32.const 0) (i32.const 0))
      (call $round)
      (if (i32.load $slot {_at("code")} (i32.const 0)) (then (return)))
      (if (i32.eq (i32.load $slot {_at("status")} (i32.const 0)) (i32.const {FAILED}))
        (then (return)))
      (if (i64.ge_s (i64.load {_state("rounds")} (i32.const 0))
                    (i64.load {_state("most_rounds")} (i32.const 0))) (then (return)))
      (local.set $used (i64.add
        (i64.load {_state("used")} (i32.const 0))
        (i64.sub (i64.load {_state("fuel")} (i32.const 0))
                 (i64.load $slot {_at("fuel")} (i32.const 0)))))
      (if (i64.ge_s (local.get $used) (i64.load {_state("most_fuel")} (i32.const 0)))
        (then (return)))
      (i64.store {_state("used")} (i32.const 0) (local.get $used))
      (br $again))))
"""


class Rounds:
    """The rounds of a fleet of one program."""

    def __init__(self, fleet: Fleet) -> None:
        """Make each call of the fleet's `run_round` run rounds until there is something to do."""
        (shard,) = fleet._shards
        shard.raise_instance_limit()
        store = shard.store
        parts: list[Any] = [shard.mailbox, shard.round]
        instance = wasmtime.Instance(store, _loop(engine()), parts)
        exports = instance.exports(store)
        self._fleet = fleet
        self._state = view(store, exports["state"])[: STATE.itemsize].view(STATE)
        rounds = exports["rounds"]
        assert isinstance(rounds, wasmtime.Func)
        shard._round = shard.prepared(rounds)

    def run(self, fuel: int, statements: int, most_fuel: int, most_rounds: int) -> tuple[int, int]:
        """Run rounds until the program posts a request or fails, or has used up so much.

        Args:
            fuel: fuel for each round.
            statements: statements to run in each, 0 for no limit.
            most_fuel: fuel after which no further round begins.
            most_rounds: number of rounds after which none begins.

        Returns:
            The fuel used and the number of rounds.
        """
        self._state[0] = (fuel, statements, most_fuel, most_rounds, 0, 0)
        self._fleet.run_round()
        state = self._state[0]
        return int(state["used"]) + fuel - int(self._fleet.slots[0]["fuel"]), int(state["rounds"])


@functools.cache
def _loop(engine: wasmtime.Engine) -> wasmtime.Module:
    return wasmtime.Module(engine, _LOOP)
