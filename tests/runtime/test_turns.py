"""Before and after a turn, clocks and fuel are what numpy computes; requests about time go on."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.requests import CODES, FAILED, SYSTEM_CALL
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.layout import MEMORY_BYTES
from crs_cc.session.build import build_executable
from tests.runtime.test_fleet import wild_program

PROGRAM = """
#include <crs_request.h>
int main(int argc, char **argv)
{
    static double pauses[] = {1e-3, 0.0, -1.0, 1e-9, 0.0, 1.0 / 3, 1e300, 7e-3};
    struct __crs_message message = {0};
    volatile unsigned i;
    int number = 0;
    pauses[4] = pauses[1] / pauses[1];
    for (;;) {
        __crs_request(CRS_CLOCK, &message);
        number = message.f[0] * 1e5 + message.f[1] * 1e7;
        for (i = 0; i < number % 5000; i++)
            ;
        message.f[0] = pauses[number % 7];
        message.result = 9;
        __crs_request(CRS_SLEEP, &message);
    }
}
"""
END_S = 0.05
COUNT = 40


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Executable:
    source = tmp_path_factory.mktemp("turns") / "pauses.c"
    source.write_text(PROGRAM)
    return build_executable([source], Diagnostics(), checked=False)


def fleet_of(program: Executable, threads: int = 1) -> Fleet:
    """Return a fleet that has read its arguments, at many times and speeds."""
    fleet, random = Fleet([program] * COUNT, threads=threads), np.random.default_rng(3)
    timing = fleet.timing
    timing["speed_hz"], timing["due_s"], timing["alive"] = 1e9, np.inf, True
    assert fleet.begin_round(END_S)
    fleet.run_round()
    fleet.end_round()
    assert (fleet.slots["code"][fleet.take_requesting()] == CODES["ARGUMENT"]).sum() == COUNT
    fleet.slots["message"]["result"] = -1
    timing["clock_s"] = random.random(COUNT) * 0.08
    timing["speed_hz"] = random.random(COUNT) * 1e7
    timing["due_s"][::7], timing["alive"][::5] = END_S, False
    return fleet


def test_clocks_and_fuel_advance_as_numpy_computes(program: Executable) -> None:
    fleet = fleet_of(program)
    timing, message = fleet.timing, fleet.slots["message"]
    answered = set()
    while True:
        before = timing.copy()
        runs = before["alive"] & np.isinf(before["due_s"]) & (before["clock_s"] < END_S)
        assert fleet.begin_round(END_S) == runs.any()
        if not runs.any():
            break
        given = np.ceil((END_S - before["clock_s"]) * before["speed_hz"])
        given = np.where(runs, given, 0).astype(np.int64)
        assert (timing["pending"] == given).all()
        assert fleet.run_round() is None
        code, posted = np.where(runs, fleet.slots["code"], 0), message.copy()
        used = np.where(runs, given - fleet.slots["fuel"], 0)
        fuel, clock_s = before["fuel"] + used, before["clock_s"] + used / before["speed_hz"]
        asked = code != 0
        fuel[asked] += SYSTEM_CALL
        clock_s[asked] += SYSTEM_CALL / before["speed_hz"][asked]
        fleet.end_round()
        read, slept = code == CODES["CLOCK"], code == CODES["SLEEP"]
        answered |= set(code.tolist())
        pause_s = posted["f"][:, 0]
        assert (message["f"][read, 0] == clock_s[read]).all()
        assert (message["f"][read, 1] == (fuel / before["speed_hz"])[read]).all()
        assert not message["result"][slept].any()
        real = slept & (pause_s > 0.0) & np.isfinite(pause_s)
        clock_s[real] += pause_s[real]
        assert (timing["clock_s"] == clock_s).all()
        assert (timing["fuel"] == fuel).all()
        assert not timing["pending"].any()
    assert answered == {0, CODES["CLOCK"], CODES["SLEEP"]}


@pytest.mark.parametrize("threads", [1, 3])
def test_rounds_run_together_are_those_run_one_by_one(program: Executable, threads: int) -> None:
    together, single = fleet_of(program, threads), fleet_of(program)
    rounds = ran = 0
    while single.begin_round(END_S):
        single.run_round()
        single.end_round()
        rounds += 1
    while more := together.run_rounds(END_S):
        ran += more
    assert ran == rounds > 5
    assert together.slots.tobytes() == single.slots.tobytes()
    for field in single.timing.dtype.names or ():
        assert (together.timing[field] == single.timing[field]).all(), field


@pytest.mark.parametrize("threads", [1, 3])
def test_a_program_that_traps_ends_its_turn_and_no_other(
    threads: int,
) -> None:
    bad, good = (
        wild_program(MEMORY_BYTES, checked=False),
        wild_program(MEMORY_BYTES - 4, checked=False),
    )
    fleet = Fleet([bad, good, bad, good, good, bad], threads=threads)
    timing = fleet.timing
    timing["speed_hz"], timing["due_s"], timing["alive"] = 1e6, np.inf, True
    assert fleet.run_rounds(END_S) == 1
    assert fleet.take_requesting().tolist() == [0, 2, 5]
    assert (fleet.slots["status"][[0, 2, 5]] == FAILED).all()
    assert not timing["pending"].any()
    assert (timing["clock_s"] > 0.0).all()
    assert not fleet.take_requesting().size
