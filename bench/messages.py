"""Measures what messages cost: every robot broadcasts once in a second, and takes what comes.

N robots stand on a jittered 3 m grid (9 m2 for each) with N/4 boxes of 0.6 m among them. A tenth of
them broadcasts 32 bytes in each timestep of 100 ms; everybody empties its inbox. The channels are
the predefined ones, and one of 10 m that nothing blocks. Their sonars are off, as each request at a
new time makes sonars measure that are due, whatever is asked.

First the environment alone is measured, of which all requests of a kind are asked at once, as a
session asks them. What is told is processor time for a simulated second, less that of robots that
only look into their empty inboxes; and the same for each message that arrives. The least of three
runs counts.

Then the same is done by C programs, on the last channel: each call takes a robot 1 ms, so that a
program's requests are at times of their own. This is what a message costs a user, programs
included.

    python bench/messages.py [ROBOTS ...]
"""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np

from crs_cc.core.source import Diagnostics
from crs_cc.requests import CODES, MESSAGE
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.comms.message_log import Fate
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.world import WorldModel

GOAL_US = 1.0  # for each message that arrives
GOAL_S = 5.0  # for a second of 10,000 robots with programs
RUNS = 3
CYCLES = 10
CHANNEL = '<communication><channel name="10 m" range="10m"/></communication>'
DEFINITION = """<robot-definition version="1" name="quiet">
  <body radius="20cm" mass="10kg"/>
  <drive wheel-base="34cm" speed-limit="0.3m/s" acceleration-limit="2m/s2" speed="0.3m/s"
         acceleration="2m/s2"/>
  <sonars order=""/>
</robot-definition>
"""
PROGRAM = """
#include <crs.h>
#include <sys/time.h>
#include <unistd.h>

int main(void)
{
    struct crs_message message;
    char text[32] = "";
    int turn = crs_my_number() % 10, cycle;
    struct timeval now;

    crs_use_channel(crs_find_channel("10 m"));
    for (cycle = 0;; cycle++) {
        if (SPEAKS && cycle % 10 == turn)
            crs_broadcast(1, text, sizeof text);
        while (crs_receive(&message, 0))
            ;
        gettimeofday(&now, 0);
        usleep(100000 - now.tv_usec % 100000);
    }
}
"""


def world_of(robots: int) -> WorldModel:
    """Return the world."""
    rng = np.random.default_rng(0)
    side, attributes = int(np.ceil(np.sqrt(robots))), 'definition="quiet.xml"'
    elements = [
        f'<robot x="{3 * column + 1.5 + x:.2f}" y="{3 * row + 1.5 + y:.2f}" {attributes}/>'
        for (row, column), (x, y) in zip(
            (divmod(number, side) for number in range(robots)),
            rng.uniform(-0.5, 0.5, (robots, 2)),
            strict=True,
        )
    ]
    elements += [
        f'<box x="{3 * x}" y="{3 * y}" length="0.6" width="0.6"/>'
        for x, y in rng.integers(1, max(side, 2), (robots // 4, 2)).tolist()
    ]
    area = f'<area length="{3 * side}" width="{3 * side}"/>'
    text = f'<world version="1" timestep="100ms">{area}{CHANNEL}{"".join(elements)}</world>'
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "quiet.xml").write_text(DEFINITION)
        (folder / "world.xml").write_text(text)
        return load_world(folder / "world.xml")


def talk(environment: Environment, robots: int, channel: int | None, cycle: int) -> None:
    """Lets a tenth of the robots broadcast, if there is a channel, and all receive."""
    at_s = np.full(robots, environment.time_s + 0.05)
    if channel is not None:
        speakers = np.arange(cycle % CYCLES, robots, CYCLES)
        messages = np.zeros(len(speakers), MESSAGE)
        messages["i"][:, :4], messages["size"] = (-1, -1, 0, channel), 32
        environment.serve(CODES["SEND"], speakers, messages, at_s[speakers])
    hearers = np.arange(robots)
    while len(hearers):
        messages = np.zeros(len(hearers), MESSAGE)
        environment.serve(CODES["RECEIVE"], hearers, messages, at_s[hearers])
        hearers = hearers[messages["result"] == 1]


def measure(world: WorldModel, channel: int | None) -> tuple[float, float]:
    """Return the processor time of a second [s], and how many hear each message."""
    robots = len(world.robots)
    environment, start, before = Environment(world, 1), 0.0, 0
    for cycle in range(2 * CYCLES):
        if cycle == CYCLES:  # what was sent before has come by now
            start, before = time.process_time(), delivered(environment)
        talk(environment, robots, channel, cycle)
        environment.step()
    return time.process_time() - start, (delivered(environment) - before) / robots


def measure_programs(world: WorldModel, *, speaks: bool) -> tuple[float, float]:
    """Return the processor time of a second of C programs [s], and how many hear each message."""
    robots = len(world.robots)
    with tempfile.TemporaryDirectory() as name:
        program = Path(name) / "talk.c"
        program.write_text(PROGRAM)
        defines = [f"SPEAKS={int(speaks)}"]
        executable = build_executable([program], Diagnostics(), defines=defines)
    session, before, start = Session(world, [executable] * robots), 0, 0.0
    for cycle in range(2 * CYCLES):
        if cycle == CYCLES:
            start, before = time.process_time(), delivered(session.environment)
        session.step()
    time_s = time.process_time() - start
    return time_s, (delivered(session.environment) - before) / robots


def delivered(environment: Environment) -> int:
    """Return how many messages have been received."""
    return int(environment.state.messages.counts[:, Fate.DELIVERED].sum())


def show(name: str, robots: int, time_s: float, silent_s: float, heard: float) -> None:
    """Print what the messages of a second cost."""
    more_s = time_s - silent_s
    each = f"{more_s / max(heard * robots, 1) * 1e6:.2f} us for each arrival (goal {GOAL_US:g})"
    print(f"{name}: {heard:.0f} hear each message, {more_s:.2f} s more, {each}")


def main() -> None:
    """Measures all predefined channels, and C programs."""
    parser = argparse.ArgumentParser(description="What messages between robots cost.")
    parser.add_argument("robots", nargs="*", type=int, default=[1000])
    for robots in parser.parse_args().robots:
        world = world_of(robots)
        silent_s, _ = min(measure(world, None) for _ in range(RUNS))
        print(f"{robots} robots to whom nobody speaks: {silent_s:.2f} s")
        for number, channel in enumerate(world.communication.channels):
            time_s, heard = min(measure(world, number) for _ in range(RUNS))
            show(channel.name, robots, time_s, silent_s, heard)
        silent_s, _ = min(measure_programs(world, speaks=False) for _ in range(RUNS))
        time_s, heard = min(measure_programs(world, speaks=True) for _ in range(RUNS))
        show("C programs, 10 m", robots, time_s, silent_s, heard)
        goal = f" (goal {GOAL_S:g} for 10,000)"
        print(f"C programs: {time_s:.2f} s for a second{goal}, {silent_s:.2f} s if nobody speaks")


if __name__ == "__main__":
    main()
