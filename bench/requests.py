"""Measures what a request of one robot costs, from the program to the reply and back.

A Scout in `worlds/room.xml` asks for the same thing again and again. What is told is processor time
for a request: that of the rounds of a timestep over its requests, without the timestep itself; the
median and the least of all timesteps. The world's timestep is long enough for several requests.
Requests for the time and sleeps are answered without leaving WebAssembly.

    python bench/requests.py [--steps N] [NAME ...]
"""

from __future__ import annotations

import argparse
import statistics
import tempfile
import time
from dataclasses import replace
from pathlib import Path

from crs_cc.core.source import Diagnostics
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import load_world

ROOM = Path(__file__).parents[1] / "worlds" / "room.xml"
TIMESTEP_S = 0.2
PROGRAM = """
#include <Nclient.h>
#include <stdio.h>
#include <sys/time.h>
#include <unistd.h>

int main(void)
{
    struct timeval now;

    connect_robot(1);
    setbuf(stdout, 0);
    for (;;)
        ASK;
}
"""
ASKED = {
    "gettimeofday": "gettimeofday(&now, 0)",
    "usleep": "usleep(1000)",
    "putchar": "putchar(46)",
    "gs": "gs()",
    "get_sn": "get_sn()",
    "get_rc": "get_rc()",
    "vm": "vm(100, 20, 0)",
    "st": "st()",
}
MICROSECONDS = 1e6
MAX_US = 40.0


def times_us(ask: str, steps: int, folder: Path) -> list[float]:
    """Return the processor time of a request in each timestep [us]."""
    source = folder / "ask.c"
    source.write_text(PROGRAM.replace("ASK", ask))
    world = replace(load_world(ROOM), timestep_s=TIMESTEP_S)
    session = Session(world, [build_executable([source], Diagnostics())])
    found: list[float] = []
    for _ in range(steps):
        requests, start = session.state.rounds, time.process_time()
        while session.run_round():
            pass
        seconds, requests = time.process_time() - start, session.state.rounds - requests
        session.end_cycle()
        found.append(seconds / requests * MICROSECONDS)
    return found[1:]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("names", nargs="*", help="requests; all by default")
    parser.add_argument("--steps", type=int, default=200, help="timesteps (default 200)")
    options = parser.parse_args()
    print(f"{'a request of one robot [us]':32}{'median':>8}{'least':>8}")
    with tempfile.TemporaryDirectory() as folder:
        for name in options.names or ASKED:
            found = times_us(ASKED[name], options.steps, Path(folder))
            print(f"{name:32}{statistics.median(found):8.2f}{min(found):8.2f}", flush=True)
    print(f"aim: at most {MAX_US:.0f}")


if __name__ == "__main__":
    main()
