"""Measures what one robot costs in a round of a fleet, in time and memory, and what threads bring.

Every robot's program posts one request in each round. One call of `Fleet.run_round` resumes all, in
one thread. Then a hundred programs compute all the time, in one thread and in several, in turn.

    python bench/fleet.py [--rounds N] [ROBOTS ...]
"""

from __future__ import annotations

import argparse
import resource
import statistics
import sys
import tempfile
import time
from pathlib import Path

from crs_cc.core.host_system import available_cores
from crs_cc.core.source import Diagnostics
from crs_cc.requests import CODES, SUSPENDED
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.build import build_executable

PROGRAM = """
#include <crs_request.h>

static int readings[16];

/* What a control loop does between two commands, small: look at a ring, choose, ask again. */
int main(void)
{
    struct __crs_message message;
    int i, best;

    for (;;) {
        best = 0;
        for (i = 0; i < 16; i++)
            if (readings[i] > readings[best])
                best = i;
        message.i[0] = best;
        readings[best] = -__crs_request(CRS_GET_SN, &message);
    }
}
"""
BARE = """
#include <crs_request.h>

int main(void)
{
    static struct __crs_message message;

    for (;;)
        __crs_request(CRS_GET_SN, &message);
}
"""
COMPUTING = """
int main(void)
{
    unsigned sum = 0;

    for (;;)
        sum = sum * 1664525 + 1013904223;
}
"""
FUEL = 2_500_000
"""Fuel of a timestep of 50 ms on a host of 50 MHz."""


def resident_bytes() -> int:
    """Return the memory of this process in use now, or its peak where only that is known."""
    statm = Path("/proc/self/statm")
    if statm.exists():
        return int(statm.read_text().split()[1]) * resource.getpagesize()
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else most * 1024


def make(source: str, folder: Path) -> Executable:
    path = folder / "robot.c"
    path.write_text(source)
    return build_executable([path], Diagnostics())


def start(fleet: Fleet) -> None:
    """Run the programs, which ask for their arguments first, until main has begun."""
    for _ in range(3):
        fleet.slots["run"] = 1
        fleet.slots["fuel"] = 1_000_000
        fleet.slots["message"]["result"] = -1  # there are no more arguments
        fleet.run_round()
    if (fleet.slots["code"] == CODES["ARGUMENT"]).any():
        sys.exit("a robot still asks for its arguments")


def round_s(fleet: Fleet, rounds: int) -> float:
    """Return the median processor time of a round [s]."""
    times = []
    start(fleet)
    for _ in range(rounds):
        fleet.slots["run"] = 1
        fleet.slots["fuel"] = 1_000_000
        before_s = time.process_time()
        fleet.run_round()
        times.append(time.process_time() - before_s)
        if fleet.slots["run"].any() or (fleet.slots["status"] != SUSPENDED).any():
            sys.exit("a robot did not come back with a request")
    return statistics.median(times)


def parallel_s(fleets: list[Fleet], rounds: int) -> list[float]:
    """Return the median elapsed time of a round of each fleet [s], measured in turn."""
    times: list[list[float]] = [[] for _ in fleets]
    for fleet in fleets:
        start(fleet)
    for _ in range(rounds):
        for fleet, own in zip(fleets, times, strict=True):
            fleet.slots["run"] = 1
            fleet.slots["fuel"] = FUEL
            before_s = time.perf_counter()
            fleet.run_round()
            own.append(time.perf_counter() - before_s)
    return [statistics.median(own) for own in times]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("robots", nargs="*", type=int, default=[1, 100, 1000, 10_000])
    parser.add_argument("--rounds", type=int, default=51, help="rounds to take the median of")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        programs = {name: make(text, Path(folder)) for name, text in
                    (("bare request", BARE), ("small loop", PROGRAM))}  # fmt: skip
        computing = make(COMPUTING, Path(folder))
    print(f"{'robots':>8}{'program':>16}{'round':>12}{'per robot':>12}"
          f"{'making one':>13}{'memory of one':>16}")  # fmt: skip
    for count in options.robots:
        for name, executable in programs.items():
            before, begin_s = resident_bytes(), time.process_time()
            fleet = Fleet([executable] * count, threads=1)
            made_s = time.process_time() - begin_s
            seconds = round_s(fleet, options.rounds)
            each = (resident_bytes() - before) / count
            print(f"{count:8}{name:>16}{seconds * 1e6:9.0f} us{seconds / count * 1e9:9.0f} ns"
                  f"{made_s / count * 1e6:10.0f} us{each / 1024:12.0f} KiB")  # fmt: skip
            del fleet
    threads = range(1, available_cores() + 1)
    fleets = [Fleet([computing] * 100, threads=each) for each in threads]
    for each, seconds in zip(threads, parallel_s(fleets, options.rounds), strict=True):
        print(f"100 robots that compute, {each} threads: {seconds * 1e3:.1f} ms elapsed per round")
    print("Limits: 400 ns per robot in a round of 10,000, and 58 KiB.")
    print("One call from Python for each round. Times are of this machine; how they grow is not.")


if __name__ == "__main__":
    main()
