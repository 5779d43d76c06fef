"""The sample programs drive in the worlds as they did before, sensibly, and the same every time.

What a program prints is kept in `<program>.<world>.out`; `pytest --update-goldens` rewrites it.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from crs_cc.session.build import build_executable
from crs_cc.session.result import RobotResult
from crs_cc.session.session import Session
from crs_cc.sim.model import Pose, WorldModel
from crs_cc.sim.world_xml import load_world
from crs_cc.source import Diagnostics

HERE = Path(__file__).parent
ROOT = HERE.parent.parent
SAMPLES = ROOT / "samples" / "scout_c"
WORLDS = ROOT / "worlds"

LONGEST_S = 120
slow = pytest.mark.slow


class Drive:
    """A run of one sample to its end.

    Attributes:
        output: what the program printed.
        places: position of the robot after each timestep [m].
        robot: the result.
    """

    def __init__(self, program: str, world: WorldModel, seed: int = 0) -> None:
        self.output = b""
        self.places: list[tuple[float, float]] = []
        executable = build_executable([SAMPLES / f"{program}.c"], Diagnostics())
        session = Session(world, [executable], seed, output=self._write)
        running = True
        while running and session.time_s < LONGEST_S:
            running = session.step()
            state = session.environment.state
            self.places.append((float(state.x_m[0]), float(state.y_m[0])))
        self.robot: RobotResult = session.result().robots[0]

    def _write(self, _robot: int, stream: int, content: bytes) -> None:
        if stream == 1:
            self.output += content

    def squares(self, side_m: float) -> int:
        """Gives how many squares of the floor the robot has been in."""
        return len({(int(x // side_m), int(y // side_m)) for x, y in self.places})


@pytest.mark.parametrize(
    ("program", "world"),
    [
        ("square", "empty"),
        ("square", "room"),
        ("report_table2", "room"),
        ("wander", "room"),
        pytest.param("wander", "office", marks=slow),
        pytest.param("follow_wall", "room", marks=slow),
        pytest.param("follow_wall", "office", marks=slow),
    ],
)
def test_a_sample_prints_what_it_printed_before(
    program: str, world: str, check_golden: Callable[[Path, bytes], None]
) -> None:
    drive = Drive(program, load_world(WORLDS / f"{world}.xml"))
    assert drive.robot.outcome == "exited"
    assert drive.robot.exit_status == 0
    check_golden(HERE / f"{program}.{world}.out", drive.output)


def starting_at(world: WorldModel, x_m: float, y_m: float, heading_rad: float) -> WorldModel:
    """Gives the world with its robot somewhere else."""
    moved = replace(world.robots[0], start=Pose(x_m, y_m, heading_rad))
    return replace(world, robots=(moved,))


@slow
@pytest.mark.parametrize("start", [(5.4, 4.5, 1.6), (0.5, 4.5, 2.4), (3.0, 2.5, 0.0)])
@pytest.mark.parametrize("program", ["wander", "follow_wall"])
def test_a_wandering_robot_gets_about_and_touches_nothing(
    program: str, start: tuple[float, float, float]
) -> None:
    drive = Drive(program, starting_at(load_world(WORLDS / "room.xml"), *start))
    assert drive.robot.outcome == "exited"
    assert drive.robot.collisions == 0
    assert drive.robot.distance_m > 6
    assert drive.squares(0.5) > 10


def test_the_square_is_closed_and_its_sides_are_a_metre() -> None:
    drive = Drive("square", load_world(WORLDS / "empty.xml"))
    x_m, y_m, _heading = drive.robot.pose
    assert abs(x_m) < 0.05
    assert abs(y_m) < 0.05
    assert drive.robot.distance_m == pytest.approx(4 * 40 * 0.0254, rel=0.01)
    far_x_m, far_y_m = (max(column) for column in zip(*drive.places, strict=True))
    assert far_x_m == pytest.approx(1.02, abs=0.03)
    assert far_y_m == pytest.approx(1.04, abs=0.03)


def test_the_program_of_the_report_stops_at_the_wall() -> None:
    drive = Drive("report_table2", load_world(WORLDS / "room.xml"))
    assert drive.robot.collisions >= 1
    assert drive.places[-1] == pytest.approx(drive.places[-2], abs=0.01)


def state_of_a_run(tmp_path: Path, hash_seed: int) -> str:
    command = [sys.executable, "-m", "crs_cc", "run", "--json", "--max-time", "10"]
    files = [str(SAMPLES / "wander.c"), str(WORLDS / "room.xml")]
    environment = {**os.environ, "PYTHONHASHSEED": str(hash_seed)}
    done = subprocess.run(
        command + files, env=environment, capture_output=True, check=True, cwd=tmp_path, text=True
    )
    return str(json.loads(done.stdout)["state_hash"])


@slow
def test_two_processes_come_to_the_same_state(tmp_path: Path) -> None:
    assert state_of_a_run(tmp_path, 1) == state_of_a_run(tmp_path, 2)
