"""Measures what timesteps cost in which nothing happens in the world.

- A Scout that is connected and waits, its sonars on, in `worlds/room.xml`: processor time of a
  timestep, run as `crs run` does, and one by one.
- Programs that only compute, of `kernels/`: the time of a session, as `crs run` runs it, over that
  of the program alone in its sandbox. Both take turns, and the least times are compared.

    python bench/quiet_time.py [--steps N] [--repeat N] [KERNEL ...]
"""

from __future__ import annotations

import argparse
import statistics
import sys
import tempfile
import time
from pathlib import Path

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.build import build_executable
from crs_cc.session.host import Host, HostRequest, discard, no_input
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.world import WorldModel

KERNELS = Path(__file__).parent / "kernels"
ROOM = Path(__file__).parents[1] / "worlds" / "room.xml"
IDLE = """
#include <Nclient.h>
#include <unistd.h>

int main(void)
{
    connect_robot(1);
    for (;;)
        sleep(1000);
}
"""
FUEL = 10**12
AT_ONCE = 100  # timesteps, as in `crs run` with a timestep of 50 ms
MICROSECONDS = 1e6
MAX_IDLE_US = 10.0
MAX_RATIO = 1.3


def idle(executable: Executable, world: WorldModel, steps: int) -> dict[str, float]:
    """Return the time of a timestep of an idle Scout, by the way of running [us]."""

    def timed(at_once: int, *, skips: bool = True) -> float:
        session = Session(world, [executable])
        session.environment.skips_quiet_time = skips
        session.advance(1)
        begin, start = session.timesteps, time.process_time()
        while session.timesteps < begin + steps:
            session.advance(min(at_once, begin + steps - session.timesteps))
        return (time.process_time() - start) / steps * MICROSECONDS

    return {
        "as crs run": timed(AT_ONCE),
        "one by one": timed(1),
        "nothing skipped": timed(1, skips=False),
    }


def alone_s(executable: Executable) -> float:
    """Return the processor time of a program in its sandbox [s]."""
    host = Host([["kernel"]], discard, no_input)
    fleet = Fleet([executable])
    slot, seconds = fleet.slots[0], 0.0
    while host.exit_status[0] is None:
        slot["run"], slot["fuel"] = 1, FUEL
        start = time.process_time()
        fleet.run_round()
        seconds += time.process_time() - start
        host.serve(int(slot["code"]), HostRequest(0, slot["message"]))
    return seconds


def session_s(executable: Executable, world: WorldModel, *, skips: bool = True) -> float:
    """Return the processor time of its session [s]."""
    session = Session(world, [executable])
    session.environment.skips_quiet_time = skips
    start = time.process_time()
    while session.advance(AT_ONCE):
        pass
    seconds = time.process_time() - start
    if session.result().robots[0].exit_status != 0:
        sys.exit(f"{executable.name} failed")
    return seconds


def ratios(source: Path, world: WorldModel, repeat: int) -> tuple[float, float]:
    """Return the time of a session over that of its program, and the same with no cycle skipped."""
    executable = build_executable([source], Diagnostics())
    runs = [
        (
            alone_s(executable),
            session_s(executable, world),
            session_s(executable, world, skips=False),
        )
        for _ in range(repeat)
    ]
    alone, skipping, whole = map(min, zip(*runs, strict=True))
    return skipping / alone, whole / alone


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("kernels", nargs="*", help="names of kernels; all by default")
    parser.add_argument("--steps", type=int, default=2000, help="idle timesteps (default 2000)")
    parser.add_argument("--repeat", type=int, default=3, help="runs of each kernel (default 3)")
    options = parser.parse_args()
    sources = sorted(KERNELS.glob("*.c"))
    if options.kernels:
        sources = [source for source in sources if source.stem in options.kernels]
    world = load_world(ROOM)
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "idle.c"
        program.write_text(IDLE)
        times_us = idle(build_executable([program], Diagnostics()), world, options.steps)
    print("A timestep of an idle Scout [us]:")
    for way, each_us in times_us.items():
        print(f"{way:32}{each_us:8.1f}")
    print(f"aim: {MAX_IDLE_US:.0f}\n")
    print(f"{'time of a session over wasm alone':34}{'skipping':>10}{'nothing skipped':>17}")
    found = []
    for source in sources:
        found.append(ratios(source, world, options.repeat))
        print(f"{source.stem:34}{found[-1][0]:10.2f}{found[-1][1]:17.2f}", flush=True)
    skipping, whole = (statistics.geometric_mean(column) for column in zip(*found, strict=True))
    print(f"{'mean':34}{skipping:10.2f}{whole:17.2f}")
    print(f"aim: each at most {MAX_RATIO}; the largest is {max(found)[0]:.2f}")


if __name__ == "__main__":
    main()
