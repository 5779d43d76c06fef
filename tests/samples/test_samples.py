"""The sample programs do in their worlds what they are there to show, and print what they printed.

Each row of `RUNS` is a run: a sample, a world, and what must be true of it. What it prints is kept
in `<sample>.<world>.out`; `pytest --update-goldens` rewrites it.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.frontend.preprocess.options import Dialect
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.world import Pose, WorldModel
from tests.samples import properties
from tests.samples.driving import ROOT, SAMPLES, WORLDS, Drive

HERE = Path(__file__).parent


@dataclass(frozen=True, slots=True)
class Run:
    """A sample in a world.

    Attributes:
        sample: its name: its C file without `.c`, or a folder with its C files.
        world: the name of the world, in `worlds` or in the sample's folder.
        holds: tests what must be true of the run.
        arguments: what `main` finds behind its name.
        reads: the files that it reads, from the root of the repository.
        standard: the C that it is written in.
        dialect: whose functions it calls; None for what it looks like.
    """

    sample: str
    world: str
    holds: Callable[[Drive], None]
    arguments: tuple[str, ...] = ()
    reads: tuple[str, ...] = ()
    standard: str = "gnu17"
    dialect: Dialect | None = None

    @property
    def name(self) -> str:
        """Return what its file of output is called."""
        return f"{self.sample.replace('/', '.')}.{self.world}"

    def program(self) -> list[str]:
        """Return its C files, below `samples/scout_c`."""
        if (SAMPLES / self.sample).is_dir():
            files = sorted((SAMPLES / self.sample).glob("*.c"))
            return [str(file.relative_to(SAMPLES)) for file in files]
        return [f"{self.sample}.c"]

    def world_file(self) -> Path:
        """Return the file of its world."""
        own = SAMPLES / self.sample / f"{self.world}.xml"
        return own if own.exists() else WORLDS / f"{self.world}.xml"

    def command(self) -> str:
        """Return the line that a user types for it."""
        sample, world = SAMPLES / self.sample, self.world_file()
        c_files = [f"{sample}/*.c" if sample.is_dir() else f"{sample}.c"]
        if world.parent == sample:
            c_files = []
        options = [] if self.standard == "gnu17" else [f"-std={self.standard}"]
        options += ["--dialect", self.dialect] if self.dialect else []
        words = ["crs", "run", *options, *c_files, str(world)]
        words += [f"--file {name}" for name in self.reads]
        words += ["--", *self.arguments] if self.arguments else []
        return " ".join(words).replace(f"{ROOT}/", "")

    def drive(self, setup: str = "", longest_s: float = 300.0, *, calmly: bool = True) -> Drive:
        """Run it, with a setup of the robots, and stop it at a time; see `Drive`."""
        return Drive(
            self.program(),
            load_world(self.world_file(), setup),
            arguments=self.arguments,
            files={name: (ROOT / name).read_bytes() for name in self.reads},
            standard=self.standard,
            dialect=self.dialect,
            longest_s=longest_s,
            calmly=calmly,
        )


RUNS = [
    Run("square", "empty", properties.closes_its_square),
    Run("square", "room", properties.closes_its_square),
    Run("report_table2", "stove", properties.bumps_into_the_stove, dialect="report"),
    Run("tag_heat", "complex-3r", properties.tags_all_heat),
    Run("clear_aisle", "warehouse", properties.pushes_what_is_in_the_way),
    Run("wander", "room", properties.gets_about),
    Run("wander", "office", properties.gets_about),
    Run("follow_wall", "room", properties.gets_about),
    Run("follow_wall", "office", properties.gets_about),
    Run("count_doors", "corridor", properties.counts_the_doors),
    Run("potential", "cluttered", properties.arrives_untouched),
    Run("behaviours", "cluttered", properties.uses_its_behaviours),
    Run("bounce", "room", properties.bounces),
    Run("figure_eight", "empty", properties.drives_an_eight),
    Run("grid_map", "studio", properties.draws_the_studio),
    Run("localise", "studio", properties.finds_itself, reads=("worlds/studio.map",)),
    Run("plan_path", "office", properties.arrives_at_its_goal, reads=("worlds/office.grid",)),
    Run("patrol", "night", properties.finds_two_doors_open, standard="gnu89"),
    Run("log_drive", "room", properties.reads_what_it_wrote),
    Run("mission", "studio", properties.comes_home, reads=("samples/scout_c/mission.txt",)),
    Run("convoy", "convoy", properties.keeps_behind),
    Run("relay", "radio-shadow", properties.carries_every_reading),
    Run("platoon", "platoon", properties.keeps_together_by_radio),
    Run("turret", "pillar", properties.keeps_its_eye_on_the_pillar),
    Run("slide", "wavy", properties.slides_along_the_wall),
    Run("by_compass", "slippery", properties.drives_its_square_by_compass),
    Run("mixed", "mixed", properties.all_kinds_get_about),
    Run("dead_reckoning", "wall", properties.reckons_until_it_slips),
    Run("sonar_ages", "wall", properties.tells_ages_of_readings),
    Run("distrust", "faulty", properties.finds_out_which_sonar_lies),
    Run("climb", "slope", properties.climbs_the_ramp),
    Run("stage", "plateau", properties.stops_at_both_edges),
    Run("follow_red", "gallery", properties.stops_before_the_red_thing),
    Run("waypoints", "gallery", properties.passes_all_waypoints),
    Run("warmer", "gallery", properties.finds_the_stove),
    Run("two_modes", "gallery", properties.looks_far_and_near),
    Run("laser_door", "gallery", properties.drives_through_the_door),
    Run("drivers/carmen_like", "studio", properties.goes_as_commanded),
    Run("drivers/player_like", "room", properties.serves_at_10_hz, standard="gnu89"),
    Run("sort", "sort", properties.sorts_cans),
    Run("ants", "ants", properties.follows_trail),
    Run("crowd", "crowd", properties.spreads_out),
    Run("hand", "hand", properties.puts_cans_into_a_row),
    Run("vehicle", "vehicle", properties.comes_to_the_light),
    Run("call", "call", properties.finds_who_calls),
    Run("lantern", "lantern", properties.follows_the_lamp),
    Run("push", "push", properties.pushes_the_crate_together),
    Run("mow", "mowing", properties.meets_all_goals),
    Run("deliver", "delivery", properties.meets_all_goals),
]


@pytest.mark.parametrize("run", [pytest.param(run, id=run.name) for run in RUNS])
def test_a_sample_does_what_it_shows_and_prints_what_it_printed(
    run: Run, check_golden: Callable[[Path, bytes], None]
) -> None:
    drive = run.drive()
    for robot in drive.robots:
        ended = ("exited", 0) if robot.left_s is None else ("left", None)
        assert (robot.outcome, robot.exit_status) == ended, robot.error
    run.holds(drive)
    assert not drive.hints
    check_golden(HERE / f"{run.name}.out", drive.output)


@pytest.mark.parametrize("sample", ["count_doors", "potential", "localise", "patrol"])
def test_a_sample_does_it_with_noisy_sonars_too(sample: str) -> None:
    (run,) = [run for run in RUNS if run.sample == sample]
    run.holds(run.drive("noisy"))


MASK = """
#include "Nclient.h"
int main(void)
{
    int i;
    connect_robot(1);
    for (i = 0; i <= NUM_MASK; i++)
        Smask[i] = 1;
    return ct() == FALSE;
}
"""


def test_a_driver_that_writes_one_past_the_mask_is_stopped_there_unless_unchecked(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "driver.c").write_text(MASK)
    assert main(["run", str(tmp_path / "driver.c")]) == 123
    assert "'Smask' is int[44], 176 bytes" in capfd.readouterr().err
    assert main(["run", "--unchecked", str(tmp_path / "driver.c")]) == 0


def test_every_sample_is_run_and_every_output_belongs_to_a_run() -> None:
    samples = {path.relative_to(SAMPLES) for path in SAMPLES.rglob("*.c")}
    assert samples == {Path(name) for run in RUNS for name in run.program()}
    assert {path.name for path in HERE.glob("*.out")} == {f"{run.name}.out" for run in RUNS}


def test_the_readme_shows_the_commands_of_all_runs_and_no_others() -> None:
    readme = (SAMPLES.parent / "README.md").read_text()
    assert sorted(re.findall(r"^crs .*", readme, re.MULTILINE)) == sorted(
        run.command() for run in RUNS
    )
    for name in re.findall(r"\]\(([^)]+)\)", readme):
        assert (SAMPLES.parent / name).exists(), name


def starting_at(world: WorldModel, x_m: float, y_m: float, heading_rad: float) -> WorldModel:
    """Return the world with its robot somewhere else."""
    moved = replace(world.robots[0], start=Pose(x_m, y_m, heading_rad))
    return replace(world, robots=(moved,))


@pytest.mark.parametrize("start", [(0.5, 4.5, 2.4)])
@pytest.mark.parametrize("program", ["wander", "follow_wall"])
def test_a_wandering_robot_gets_about_and_touches_nothing(
    program: str, start: tuple[float, float, float]
) -> None:
    world = starting_at(load_world(WORLDS / "room.xml"), *start)
    drive = Drive([f"{program}.c"], world, longest_s=25.0)
    properties.touches_nothing(drive)
    assert drive.robot.distance_m > 2
    assert drive.squares(0.5) > 4


def state_of_a_run(tmp_path: Path, hash_seed: int) -> str:
    command = [sys.executable, "-m", "crs_cc", "run", "--json", "--max-time", "10"]
    files = [str(SAMPLES / "wander.c"), str(WORLDS / "room.xml")]
    environment = {**os.environ, "PYTHONHASHSEED": str(hash_seed)}
    done = subprocess.run(
        command + files, env=environment, capture_output=True, check=True, cwd=tmp_path, text=True
    )
    return str(json.loads(done.stdout)["state_hash"])


def test_two_processes_come_to_the_same_state(tmp_path: Path) -> None:
    assert state_of_a_run(tmp_path, 1) == state_of_a_run(tmp_path, 2)
