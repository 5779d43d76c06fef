"""Measures steps per second of robots that are steered from Python, beside other environments.

A differential robot drives with random wheel speeds in a room with four obstacles. A step is one
timestep of 50 ms; after each, Python gets its sonars and its pose:

- a session's step, without Python steering or looking: the floor of all that follow;
- `Env`, `GymEnv`, and several robots in one world, where a step counts once for each robot;
- `vector_env` over seeds, in this process and in a process each;
- gymnasium's CartPole: what the interface costs, with a world of four numbers;
- if it is installed (`pip install ir-sim`): ir-sim, a 2-D simulator in Python, with the same room,
  and a lidar of sixteen single beams instead of sonars.

    python bench/python_env.py [--steps N] [ROBOTS ...]
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

import crs_cc

SOLIDS = [(1.5, 3.5, 0.6, 0.4), (4.0, 1.2, 0.5, 0.8), (4.5, 3.8, 0.4, 0.4), (2.8, 2.4, 0.3, 0.9)]
LIDAR = """world: {{height: 5, width: 6, step_time: 0.05, sample_time: 0.05, collision_mode: stop}}
robot:
  - kinematics: {{name: diff}}
    shape: {{name: circle, radius: 0.2}}
    state: [1, 1, 0]
    vel_min: [-1, -3]
    vel_max: [1, 3]
    sensors:
      - {{type: lidar2d, range_min: 0, range_max: 6.5, angle_range: 6.28, number: 16}}
obstacle:
{obstacles}"""


def room(robots: int) -> crs_cc.WorldModel:
    """Return the room; for several robots it is as many times as large, with its obstacles."""
    side = int(np.ceil(np.sqrt(robots)))
    scout = crs_cc.load_robot("scout")
    boxes, found = [], []
    for number in range(side * side):
        left, low = 6.0 * (number % side), 5.0 * (number // side)
        for place, (x, y, length, width) in enumerate(SOLIDS):
            pose = crs_cc.Pose(left + x, low + y)
            boxes.append(crs_cc.Box(f"box{number}_{place}", pose, length, width))
        if number < robots:
            found.append(crs_cc.Robot(f"robot{number}", scout, crs_cc.Pose(left + 1.0, low + 1.0)))
    return crs_cc.WorldModel(
        "room",
        crs_cc.Area(0.0, 0.0, 6.0 * side, 5.0 * side),
        boxes=tuple(boxes),
        robots=tuple(found),
    )


def measured(name: str, step: Callable[[], object], steps: int, robots: int = 1) -> None:
    """Print the steps of a robot per second."""
    step()
    begin = time.perf_counter()
    for _ in range(steps):
        step()
    took_s = time.perf_counter() - begin
    print(f"{name:34s} {steps * robots / took_s:10.0f} steps/s")


def session(steps: int) -> None:
    run = crs_cc.Session(room(1))
    run.robots["robot0"].drive(0.3, 0.1)  # in a circle, to touch nothing
    measured("session, unseen", run.step, steps)


def ours(robots: int, steps: int) -> None:
    env = crs_cc.Env(room(robots), observe=["sonar", "pose"])
    env.reset(1)
    random = np.random.default_rng(1)

    def step() -> None:
        speeds = random.uniform(-0.5, 0.5, (robots, 2))
        env.step(dict(zip(env.steered, speeds, strict=True)))

    measured(f"Env, {robots} robot{'s' * (robots > 1)}", step, max(1, steps // robots), robots)


def gym(steps: int) -> None:
    env = crs_cc.GymEnv(room(1), observe=["sonar", "pose"])
    env.reset(seed=1)
    env.action_space.seed(1)
    measured("GymEnv", lambda: env.step(env.action_space.sample()), steps)


def vectorised(steps: int, *, processes: bool) -> None:
    count = max(2, os.process_cpu_count() if hasattr(os, "process_cpu_count") else 2)
    env = crs_cc.vector_env(range(count), room(1), processes=processes, observe=["sonar", "pose"])
    env.reset()
    where = "processes" if processes else "one process"
    measured(
        f"vector_env, {count} seeds, {where}",
        lambda: env.step(env.action_space.sample()), max(1, steps // count), count,
    )  # fmt: skip
    env.close()


def cart_pole(steps: int) -> None:
    import gymnasium

    env = gymnasium.make("CartPole-v1")
    env.reset(seed=1)

    def step() -> None:
        _, _, done, late, _ = env.step(env.action_space.sample())
        if done or late:
            env.reset()

    measured("gymnasium CartPole", step, steps * 10)


def ir_sim(steps: int) -> None:
    if importlib.util.find_spec("irsim") is None:
        print("ir-sim                             not installed")
        return
    import irsim

    rows = [
        f"  - {{state: [{x}, {y}, 0],"
        f" shape: {{name: rectangle, length: {length}, width: {width}}}}}"
        for x, y, length, width in SOLIDS
    ]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "room.yaml")
        path.write_text(LIDAR.format(obstacles="\n".join(rows)))
        env = irsim.make(str(path), display=False)
    random = np.random.default_rng(1)

    def step() -> None:
        env.step(random.uniform(-0.5, 0.5, (2, 1)))
        env.get_lidar_scan()
        env.get_robot_state()

    measured("ir-sim, lidar of 16 beams", step, steps)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument("robots", nargs="*", type=int, default=[1, 10, 100])
    options = parser.parse_args()
    session(options.steps)
    for robots in options.robots or [1, 10, 100]:
        ours(robots, options.steps * max(1, robots // 4))
    if importlib.util.find_spec("gymnasium") is None:
        print("gymnasium is not installed (install it with: pip install 'crs_cc[rl]')")
    else:
        gym(options.steps)
        for processes in (False, True):
            vectorised(options.steps, processes=processes)
        cart_pole(options.steps)
    ir_sim(options.steps)


if __name__ == "__main__":
    main()
