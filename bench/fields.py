"""Measures what pheromone fields cost: robots that drive, lay trails, and smell in each timestep.

N robots drive straight ahead in an area of 300 m by 300 m with a field of 10 cm cells. The figures
are the times of what is done for the field in a timestep of all robots: the requests SMELL (each
measures with both antennae), less the time of a request without work (MESSAGE_COUNT); the trails,
with the end of the timestep and its new tiles; and the memory of the tiles.

    python bench/fields.py [--robots N] [--timesteps T]
"""

from __future__ import annotations

import argparse
import math
import statistics
import tempfile
import time
from pathlib import Path

import numpy as np

from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.devices.gland import GlandState
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import load_world

SIZE_M = 300.0
DEFINITION = """<robot-definition version="1" name="ant">
  <body radius="5cm" mass="1kg"/>
  <drive wheel-base="8cm" speed-limit="0.3m/s" acceleration-limit="2m/s2" speed="0.3m/s"
         acceleration="2m/s2"/>
  <gland/><antennae/>
</robot-definition>
"""
WARM_UP = 5


def world_text(robots: int) -> str:
    """Return the world file."""
    side = math.ceil(math.sqrt(robots))
    random = np.random.default_rng(1)
    spacing_m = SIZE_M / (side + 1)
    rows = [
        f'<robot definition="ant.xml" x="{(1 + column) * spacing_m:.3f}m"'
        f' y="{(1 + row) * spacing_m:.3f}m" heading="{heading:.1f}deg"/>'
        for (row, column), heading in zip(
            np.ndindex(side, side), random.uniform(0, 360, robots), strict=False
        )
    ]
    area = f'<area length="{SIZE_M}m" width="{SIZE_M}m"/>'
    field = '<field name="trail" cell="10cm" evaporation="60s"/>'
    return f'<world version="1">{area}{field}{"".join(rows[:robots])}</world>'


def driving(robots: int) -> Environment:
    """Return a world whose robots drive and lay trails."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "ant.xml").write_text(DEFINITION)
        path = Path(folder) / "world.xml"
        path.write_text(world_text(robots))
        environment = Environment(load_world(path), seed=1)
    post(environment, "CONNECT")
    post(environment, "VM", integers=(118, 118))  # 0.1 in/s
    post(environment, "LAY_TRAIL", number=100.0)
    return environment


def post(
    environment: Environment, name: str, integers: tuple[int, ...] = (), number: float = 0.0
) -> None:
    """Post a request of all robots."""
    count = len(environment.world.robots)
    messages = np.zeros(count, MESSAGE)
    messages["i"][:, : len(integers)] = integers
    messages["f"][:, 0] = number
    at_s = np.full(count, environment.time_s + 0.01)
    environment.serve(CODES[name], np.arange(count), messages, at_s)


def main() -> None:
    """Print the figures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robots", type=int, default=10_000)
    parser.add_argument("--timesteps", type=int, default=100)
    given = parser.parse_args()
    environment = driving(given.robots)
    board = environment._data.devices
    constants = environment._data.constants
    times = []
    for timestep in range(given.timesteps + WARM_UP):
        began = time.process_time()
        post(environment, "MESSAGE_COUNT")
        posted = time.process_time()
        post(environment, "SMELL", (0, 0))
        smelled = time.process_time()
        state = environment.state
        # The work at the end of the timestep, once more on its own: `step` does it, too.
        glands = state.device("gland", GlandState)
        kept = [array.copy() for array in (glands.from_m, glands.distance_m)]
        environment.step()
        glands.from_m[:], glands.distance_m[:] = kept
        laying = time.process_time()
        board._glands.end_cycle(state, constants, environment.time_s)
        board.fields.end_cycle(state)
        if timestep >= WARM_UP:
            times.append((posted - began, smelled - posted, time.process_time() - laying))
    post_ms, smell_ms, lay_ms = (
        1000 * statistics.median(column) for column in zip(*times, strict=True)
    )
    tiles = state.fields.used
    print(f"{given.robots} robots: a request {post_ms:.2f} ms a timestep")
    print(f"  smelling {smell_ms - post_ms:.2f} ms more, laying {lay_ms:.2f} ms")
    print(f"  {tiles} tiles, {tiles * 520 / 2**20:.1f} MiB")


if __name__ == "__main__":
    main()
