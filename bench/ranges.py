"""Measures what cameras and lasers cost: a picture or a scan of every robot, and its pages.

The robots, walls and boxes are those of `environment.py`. Each robot has a camera of 64 columns and
a laser of 180 points, of 6 m, and drives; in each timestep of 100 ms all are asked for one reading.
What is told is processor time for each robot: for the request, rays included, and for the pages in
which the client fetches the readings.

    python bench/ranges.py [ROBOTS]
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from environment import world_text

from crs_cc.core.arrays import Records
from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.registry import device

COLUMNS = 64
POINTS = 180
PAGE = 62  # numbers
STEPS = 20
GOAL_US = 10  # for a request
SPEEDS = 100, 60  # 0.1 in/s
DEFINITION = f"""<robot-definition version="1" name="ring">
  <body radius="20cm" mass="10kg"/>
  <drive wheel-base="34cm" speed-limit="0.3m/s" acceleration-limit="2m/s2" speed="0.3m/s"
         acceleration="2m/s2"/>
  <bumpers><ring switches="8"/></bumpers>
  <sonars order=""/>
  <laser points="{POINTS}" field-of-view="180deg" range="6m" mode="51"/>
  <camera columns="{COLUMNS}" range="6m"/>
</robot-definition>
"""
KINDS = {  # request and its argument; request for pages, sensor, number of readings, their width
    "camera, pixels": ("CAMERA", 0, "READINGS", "camera", COLUMNS, 2),
    "camera, blobs": ("CAMERA", 1, "", "", 0, 0),
    "laser, ranges": ("LASER", 0, "READINGS", "laser", POINTS, 1),
    "laser, points": ("GET_LS", 0, "LASER_PAGE", "", POINTS, 2),
}

_ANSWERED = {"CONNECT", "VM", "CAMERA", "LASER", "GET_LS"}  # a page may be empty


def environment_of(robots: int) -> Environment:
    """Return an environment whose robots drive."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "ring.xml").write_text(DEFINITION)
        (folder / "world.xml").write_text(world_text(robots, 'definition="ring.xml"'))
        environment = Environment(load_world(folder / "world.xml"), 1)
    ask(environment, "CONNECT", messages_of(robots))
    moves = messages_of(robots)
    moves["i"][:, :2] = SPEEDS
    ask(environment, "VM", moves)
    return environment


def messages_of(robots: int) -> Records:
    """Return requests without arguments."""
    return np.zeros(robots, MESSAGE)


def ask(environment: Environment, request: str, messages: Records) -> float:
    """Serve a request of all robots; return the processor time [s]."""
    at_s = np.full(len(messages), environment.time_s + 0.05)
    start = time.process_time()
    environment.serve(CODES[request], np.arange(len(messages)), messages, at_s)
    taken_s = time.process_time() - start
    if request in _ANSWERED and not messages["result"].all():
        sys.exit(f"{request} was refused")
    return taken_s


def measure(environment: Environment, robots: int, kind: str) -> tuple[float, float]:
    """Return the processor time of a request and of its pages, for one robot [s]."""
    request, argument, page, sensor, readings, width = KINDS[kind]
    asked_s = pages_s = 0.0
    for _ in range(STEPS):
        environment.step()
        messages = messages_of(robots)
        messages["i"][:, 0] = argument
        asked_s += ask(environment, request, messages)
        for first in range(0, readings if page else 0, PAGE // max(width, 1)):
            messages = messages_of(robots)
            arguments = (device(sensor).number, first) if sensor else (first,)
            messages["i"][:, : len(arguments)] = arguments
            pages_s += ask(environment, page, messages)
    return asked_s / STEPS / robots, pages_s / STEPS / robots


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("robots", nargs="?", type=int, default=1000)
    robots = parser.parse_args().robots
    environment = environment_of(robots)
    goal = f"(goal of a request: {GOAL_US} us)"
    print(f"{robots:,} robots, for each{'request':>16}{'pages':>13}   {goal}")
    for kind in KINDS:
        asked_s, pages_s = measure(environment, robots, kind)
        print(f"{kind:20}{asked_s * 1e6:12.1f} us{pages_s * 1e6:10.1f} us")


if __name__ == "__main__":
    main()
