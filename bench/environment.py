"""Measures what a robot costs in the environment, its C program included.

N robots stand on a jittered 3 m grid (9 m2 for each) in a square arena with N/4 fixed boxes of
0.6 m. Each has sixteen infrared sensors on its shell: single rays, 6 m long, cast against walls,
boxes and the other robots; what they tell is in steps of 0.4 m. Each runs the C program below in
its own sandbox: it asks for its ring of readings every 100 ms, drives at 0.3 m/s, and turns on the
spot while one of the front five tells of something nearer than 0.6 m. Requests travel over the
serial line, wheels have accelerations, contacts go through the physics. Nothing is recorded.

The same is done by Scouts, whose sonars hear in a cone and fire in turn, one every 60 ms; and by
Scouts in the noisy setup, in which it matters what hides what.

The limit is the bare ray cast: the same rays against the same things, by the same function, once
for each timestep, and nothing else.

Many programs, and rings, are divided among threads, which take processor time at the same time. So
robot-steps are also counted by the clock on the wall, which says something on an idle machine only.

    python bench/environment.py [--seconds S] [--scouts N] [--threads K] [ROBOTS ...]
"""

from __future__ import annotations

import argparse
import math
import resource
import statistics
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crs_cc.core.source import Diagnostics
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.devices.ray_caster import RayCaster
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.physics.simulation import REBUILD
from crs_cc.sim.state.snapshot_codec import packed

PROGRAM = """
#include <Nclient.h>
#include <unistd.h>

#define SPEED 118 /* 0.1 in/s: 0.3 m/s */

static int blocked(void)
{
    int i;

    for (i = 0; i < 3; i++)
        if (State[FIRST + i] <= NEAR || State[FIRST + (16 - i) % 16] <= NEAR)
            return 1;
    return 0;
}

int main(void)
{
    int turning = -1, before;

    connect_robot(1);
    for (;;) {
        READ();
        before = turning;
        turning = blocked();
        if (turning != before)
            vm(turning ? -SPEED : SPEED, SPEED, 0);
        usleep(95000);
    }
}
"""
DEFINITION = """<robot-definition version="1" name="ring">
  <body radius="20cm" mass="10kg"/>
  <drive wheel-base="34cm" speed-limit="0.3m/s" acceleration-limit="2m/s2" speed="0.3m/s"
         acceleration="2m/s2"/>
  <bumpers><ring switches="8"/></bumpers>
  <sonars order=""/>
  <infrared step="0.4m"/>
  <link baud="115200">
    <command name="GET_IR" sends="6" receives="18"/>
    <command name="VM" sends="12" receives="48"/>
  </link>
</robot-definition>
"""
INFRARED = ("READ=get_ir", "FIRST=STATE_IR_0", "NEAR=1")  # 0.4 m each, to the nearest
SONAR = ("READ=get_sn", "FIRST=STATE_SONAR_0", "NEAR=23")  # an inch each
SETUPS = {
    "ring": ('definition="ring.xml"', INFRARED),
    "scout": ("", SONAR),
    "noisy scout": ('setup="noisy"', SONAR),
}
RAYS = 16
RANGE_M = 6.0
RADIUS_M = 0.2
SPACING_M = 3.0
MARGIN_M = 0.5
WARM_UP = 20
RAYS_REPEAT = 10
LITTLE_M = 1e-9


def world_text(robots: int, attributes: str) -> str:
    """Return the world file."""
    random = np.random.default_rng(robots)
    side = math.ceil(math.sqrt(robots))
    cells = np.stack(np.divmod(np.arange(robots), side), axis=1)
    places = MARGIN_M + (cells + 0.5) * SPACING_M + random.uniform(-0.5, 0.5, (robots, 2))
    corners = MARGIN_M + cells[::4] * SPACING_M
    rows = [
        f'<robot x="{x:.3f}m" y="{y:.3f}m" heading="{angle:.1f}deg" {attributes}/>'
        for (x, y), angle in zip(places, random.uniform(0, 360, robots), strict=True)
    ]
    rows += [
        f'<box x="{x}m" y="{y}m" length="0.6m" width="0.6m" heading="{angle:.1f}deg"/>'
        for (x, y), angle in zip(corners, random.uniform(0, 90, len(corners)), strict=True)
    ]
    size_m = side * SPACING_M + 2 * MARGIN_M
    area = f'<area length="{size_m}m" width="{size_m}m"/>'
    return f'<world version="1" timestep="100ms">{area}{"".join(rows)}</world>'


def resident_bytes() -> int:
    """Return the memory of this process in use now, or its peak where only that is known."""
    statm = Path("/proc/self/statm")
    if statm.exists():
        return int(statm.read_text().split()[1]) * resource.getpagesize()
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else most * 1024


@dataclass(frozen=True, slots=True)
class Figures:
    """What was measured with some robots; times but one are processor time.

    Attributes:
        robots: how many.
        step_s: a timestep.
        wall_s: a timestep by the clock on the wall.
        rays_s: all rays of all robots alone.
        readings: rings read by each robot in a timestep.
        speed_mps: how fast the robots went on average.
        load_s: reading the world file.
        make_s: making the session.
        memory_bytes: what world and session take.
    """

    robots: int
    step_s: float
    wall_s: float
    rays_s: float
    readings: float
    speed_mps: float
    load_s: float
    make_s: float
    memory_bytes: float

    def row(self) -> str:
        step_s, rays_s = self.step_s / self.robots, self.rays_s / self.robots
        return (
            f"{self.robots:8,}{self.robots / self.wall_s:15,.0f}{1 / step_s:15,.0f}"
            f"{step_s * 1e6:9.1f} us{rays_s * 1e6:9.1f} us"
            f"{step_s / rays_s:7.1f}{self.readings:10.2f}{self.speed_mps:8.2f} m/s"
            f"{self.load_s:9.2f} s{self.make_s:8.2f} s{self.memory_bytes / 2**20:8.0f} MiB"
        )


def measure(
    folder: Path, robots: int, seconds: float, threads: int | None, setup: str = "ring"
) -> Figures:
    """Run a world with some robots for a while, with some threads or the default."""
    attributes, defines = SETUPS[setup]
    world_file, program = folder / "world.xml", folder / "wander.c"
    world_file.write_text(world_text(robots, attributes))
    program.write_text(PROGRAM)
    (folder / "ring.xml").write_text(DEFINITION)
    executable = build_executable([program], Diagnostics(), defines=defines)
    before, start = resident_bytes(), time.process_time()
    world = load_world(world_file)
    load_s, start = time.process_time() - start, time.process_time()
    session = Session(world, [executable] * robots, threads=threads)
    make_s = time.process_time() - start
    for _ in range(WARM_UP):
        session.step()
    state, times, walls = session.environment.state, [], []
    readings, way_m = state.devices.infrared.count.sum(), state.distance_m.sum()
    while not times or sum(times) < seconds or len(times) % REBUILD:
        start, wall = time.process_time(), time.perf_counter()
        session.step()
        times.append(time.process_time() - start)
        walls.append(time.perf_counter() - wall)
    if session.state.running != robots:
        sys.exit("a program has ended")
    robot_steps = robots * len(times)
    return Figures(
        robots,
        step_s=statistics.fmean(times),
        wall_s=statistics.fmean(walls),
        rays_s=rays_s(session),
        readings=(state.devices.infrared.count.sum() - readings) / robot_steps,
        speed_mps=(state.distance_m.sum() - way_m) / (robot_steps * world.timestep_s),
        load_s=load_s,
        make_s=make_s,
        memory_bytes=resident_bytes() - before,
    )


def rays_s(session: Session) -> float:
    """Return the processor time for all rays of all robots alone [s]."""
    state = packed(session.environment.state).state()
    fan = Fan.of(
        (RADIUS_M * math.cos(angle), RADIUS_M * math.sin(angle), angle, 0.0, RANGE_M)
        for angle in np.arange(RAYS) * (2 * math.pi / RAYS)
    )
    rays = RayCaster(Scene(session.environment.world), [fan])
    poses = np.column_stack([state.x_m, state.y_m, state.heading_rad])
    own, times = np.arange(len(poses)), []
    for _ in range(RAYS_REPEAT):
        state.bodies.position_m += LITTLE_M  # what has not moved would not be sorted again
        state.cycle += 1
        start = time.process_time()
        rays.distances_m(state, fan, poses, own)
        times.append(time.process_time() - start)
    return statistics.median(times)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("robots", nargs="*", type=int, default=[1, 10, 100, 1000, 10_000])
    parser.add_argument("--seconds", type=float, default=3.0, help="of each run (default 3)")
    parser.add_argument(
        "--scouts", type=int, default=1000, help="how many there are (default 1000)"
    )
    parser.add_argument("--threads", type=int, help="how many there may be (default: processors)")
    options = parser.parse_args()
    print(f"{'robots':>8}{'by the clock':>15}{'robot-steps/s':>15}{'each':>12}"
          f"{'rays only':>12}{'ratio':>7}{'readings':>10}{'speed':>12}"
          f"{'world':>11}{'session':>10}{'memory':>12}")  # fmt: skip
    found = []
    for robots in options.robots:
        with tempfile.TemporaryDirectory() as folder:
            found.append(measure(Path(folder), robots, options.seconds, options.threads))
        print(found[-1].row(), flush=True)
    each_s = {figures.robots: figures.step_s / figures.robots for figures in found}
    if {100, 10_000} <= each_s.keys():
        growth = each_s[10_000] / each_s[100]
        print(f"A robot-step costs {growth:.2f} times as much among 10,000 robots as among 100.")
    for setup in ("scout", "noisy scout"):
        with tempfile.TemporaryDirectory() as folder:
            figures = measure(Path(folder), options.scouts, options.seconds, options.threads, setup)
        each = figures.step_s / options.scouts
        speed = f"{1 / each:,.0f} robot-steps/s, {each * 1e6:.1f} us each"
        speed += f", {options.scouts / figures.wall_s:,.0f} by the clock"
        print(f"{options.scouts:,} times a {setup}: {speed}")
    print("Robot-steps of processor time, all threads together, but for those by the clock.")


if __name__ == "__main__":
    main()
