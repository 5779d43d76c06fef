"""Measures what messages cost: every robot broadcasts once in a second, and takes what comes.

N robots stand on a jittered 3 m grid (9 m2 for each) with N/4 boxes of 0.6 m among them. A tenth of
them broadcasts 32 bytes in each timestep of 100 ms; everybody empties its inbox. The channels are
the predefined ones, and one of 10 m that nothing blocks. What is told is processor time for a
simulated second, less that of robots that are silent; and the same for each message that arrives.

    python bench/messages.py [ROBOTS]
"""

from __future__ import annotations

import argparse
import time

import numpy as np

from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.comms.message_log import Fate
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.world import WorldModel

CYCLES = 10
CHANNEL = '<communication><channel name="10 m" range="10m"/></communication>'


def world_of(robots: int) -> WorldModel:
    """Return the world."""
    rng = np.random.default_rng(0)
    side = int(np.ceil(np.sqrt(robots)))
    things = [
        f'<robot x="{3 * column + 1.5 + x:.2f}" y="{3 * row + 1.5 + y:.2f}"/>'
        for (row, column), (x, y) in zip(
            (divmod(number, side) for number in range(robots)),
            rng.uniform(-0.5, 0.5, (robots, 2)),
            strict=True,
        )
    ]
    things += [
        f'<box x="{3 * x}" y="{3 * y}" length="0.6" width="0.6"/>'
        for x, y in rng.integers(1, max(side, 2), (robots // 4, 2)).tolist()
    ]
    area = f'<area length="{3 * side}" width="{3 * side}"/>'
    text = f'<world version="1" timestep="100ms">{area}{CHANNEL}{"".join(things)}</world>'
    return parse_world(text.encode(), "bench")


def talk(environment: Environment, robots: int, channel: int, cycle: int) -> None:
    """Lets a tenth of the robots broadcast, and all receive."""
    speakers = np.arange(cycle % CYCLES, robots, CYCLES)
    messages = np.zeros(len(speakers), MESSAGE)
    messages["i"][:, :4], messages["size"] = (-1, -1, 0, channel), 32
    at_s = np.full(robots, environment.time_s + 0.05)
    environment.serve(CODES["SEND"], speakers, messages, at_s[speakers])
    hearers = np.arange(robots)
    while len(hearers):
        messages = np.zeros(len(hearers), MESSAGE)
        environment.serve(CODES["RECEIVE"], hearers, messages, at_s[hearers])
        hearers = hearers[messages["result"] == 1]


def measure(world: WorldModel, channel: int | None) -> tuple[float, float]:
    """Return the processor time of a second [s], and how many hear each message."""
    robots = len(world.robots)
    environment = Environment(world, 1)
    start, delivered = 0.0, 0
    for cycle in range(2 * CYCLES):
        if cycle == CYCLES:  # what was sent before has come by now
            start, delivered = time.process_time(), 0
        if channel is not None:
            talk(environment, robots, channel, cycle)
        delivered += int((environment.step().traffic["fate"] == Fate.DELIVERED).sum())
    return time.process_time() - start, delivered / robots


def main() -> None:
    """Measures all predefined channels."""
    parser = argparse.ArgumentParser(description="What messages between robots cost.")
    parser.add_argument("robots", nargs="?", type=int, default=1000)
    robots = parser.parse_args().robots
    world = world_of(robots)
    silent_s, _ = measure(world, None)
    print(f"{robots} robots, silent: {silent_s:.2f} s")
    for number, channel in enumerate(world.communication.channels):
        time_s, heard = measure(world, number)
        more_s = time_s - silent_s
        each = f"{more_s / max(heard * robots, 1) * 1e6:.1f} us for each arrival"
        print(f"{channel.name}: {heard:.0f} hear each message, {more_s:.2f} s more, {each}")


if __name__ == "__main__":
    main()
