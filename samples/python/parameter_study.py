"""Runs a program with several speeds and seeds, each run in a process of its own.

The robot wanders in a room with noisy sonars. The faster it is, the farther it gets, until it is
too fast for its sonars: then it hits something. The table shows the means over the seeds.

    python parameter_study.py [SECONDS]
"""

import sys
from concurrent.futures import ProcessPoolExecutor
from itertools import product
from statistics import mean

import crs_cc

SPEEDS = (60, 120, 240)  # 0.1 inch/s
SEEDS = (1, 2, 3)
WORLD = """<world version="1">
  <area length="6m" width="5m"/>
  <box x="3m" y="2.5m" length="1m" width="60cm" heading="20deg"/>
  <cylinder x="1.5m" y="4m" radius="30cm"/>
  <robot id="scout" x="1m" y="1m" heading="30deg" setup="noisy"/>
</world>"""
PROGRAM = """
#include <Nclient.h>

int main(void)
{
    connect_robot(1);
    ac(150, 150, 0);
    for (;;) {
        int i, ahead = 255;

        get_sn();
        for (i = 17; i < 33; i++)          /* sonars 0 to 2, and 14 to 15 */
            if ((i < 20 || i > 30) && State[i] < ahead)
                ahead = State[i];
        if (ahead < 12)
            vm(-60, 60, 0);
        else
            vm(SPEED, SPEED, 0);
    }
}
"""


def program(speed: int) -> crs_cc.Executable:
    """Return the program for a speed: the first time it is compiled, then it is in the cache."""
    return crs_cc.compile_c(PROGRAM, defines=[f"SPEED={speed}"])


def run(speed: int, seed: int, seconds: float) -> tuple[float, int]:
    """Return how far the robot got [m], and how often it hit something."""
    session = crs_cc.Session(WORLD, program(speed), seed=seed, duration_s=seconds)
    (robot,) = session.run().robots
    return robot.distance_m, robot.collisions


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 60.0
    for speed in SPEEDS:
        program(speed)
    cases = list(product(SPEEDS, SEEDS))
    with ProcessPoolExecutor() as pool:
        results = list(pool.map(run, *zip(*cases, strict=True), [seconds] * len(cases)))
    print("speed [0.1 in/s]  distance [m]  collisions")
    for speed in SPEEDS:
        rows = [found for (each, _), found in zip(cases, results, strict=True) if each == speed]
        distances, collisions = zip(*rows, strict=True)
        print(f"{speed:16d} {mean(distances):13.2f} {mean(collisions):11.1f}")


if __name__ == "__main__":
    main()
