"""Measures what a timestep of one driving robot costs, all in.

`samples/scout_c/wander.c` drives a Scout through `worlds/room.xml`: four requests in a timestep of
50 ms, with its sonars on. Most timesteps are calm: programs and a kernel take turns without Python.
The same is measured with calm time switched off, in turn.

    python bench/wander.py [--repeats N]
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

from crs_cc.core.source import Diagnostics
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import load_world

ROOT = Path(__file__).parents[1]
WARM_UP = 40
AT_ONCE = 100
REPEATS = 8
MICROSECONDS = 1e6
MAX_US = 100.0


def start(*, calm: bool) -> Session:
    """Return a session that has warmed up."""
    files = [ROOT / "samples" / "scout_c" / "wander.c"]
    world = load_world(ROOT / "worlds" / "room.xml")
    session = Session(world, [build_executable(files, Diagnostics())])
    session.calm.is_allowed = calm
    run(session, WARM_UP)
    return session


def run(session: Session, timesteps: int) -> float:
    """Run some timesteps; return the processor time of each [us]."""
    begin, end = time.process_time(), session.timesteps + timesteps
    while session.timesteps < end:
        session.advance(end - session.timesteps, calmly=True)
    return (time.process_time() - begin) / timesteps * MICROSECONDS


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("--repeats", type=int, default=REPEATS, help=f"default {REPEATS}")
    options = parser.parse_args()
    found: dict[bool, list[float]] = {True: [], False: []}
    sessions = {calm: start(calm=calm) for calm in found}
    for _ in range(options.repeats):
        for calm, session in sessions.items():
            found[calm].append(run(session, AT_ONCE))
    print(f"{'wander.c in room.xml, a timestep [us]':40}{'median':>8}{'least':>8}")
    for calm, name in ((True, "calm time allowed"), (False, "without calm time")):
        times = sorted(found[calm])
        print(f"{name:40}{times[len(times) // 2]:8.1f}{times[0]:8.1f}")
    same = sessions[True].state_hash() == sessions[False].state_hash()
    print(f"aim: at most {MAX_US:.0f}; the states are {'the same' if same else 'DIFFERENT'}")


if __name__ == "__main__":
    main()
