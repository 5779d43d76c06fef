"""The scripts in `samples/python/` run, and show what they say."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.commands import python

ROOT = Path(__file__).parents[2]
SCRIPTS = ROOT / "samples" / "python"
CRASHES = "int main(void) { int a[3], i = 7; return a[i]; }\n"


def printed(folder: Path, script: str, *arguments: str, is_real: bool = False) -> list[str]:
    words = [SCRIPTS / script, *arguments]
    done = subprocess.run(
        [sys.executable, *words] if is_real else python(*words),
        cwd=folder, capture_output=True, text=True, check=False, timeout=300,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return done.stdout.splitlines()


def test_the_parameter_study_compares_speeds(tmp_path: Path) -> None:
    _, *rows = printed(tmp_path, "parameter_study.py", "3")
    distances = [float(row.split()[1]) for row in rows]
    assert len(rows) == 3
    assert 0.2 < distances[0] < distances[1] < distances[2]


def test_the_policy_leads_a_robot_that_runs_c(tmp_path: Path) -> None:
    *points, end = printed(tmp_path, "policy_beside_c.py")
    assert end == "finished"
    assert len(points) == 4
    assert all(0.5 < float(line.split()[-3]) < 1.3 for line in points)


def test_the_autograder_gives_points_or_the_reason(tmp_path: Path) -> None:
    (tmp_path / "broken.c").write_text("int main(void) { return x; }\n")
    (tmp_path / "crashes.c").write_text(CRASHES)
    teaching = ROOT / "samples" / "teaching" / "course"
    files = [teaching / "course.xml", teaching / "solution.c", "broken.c", "crashes.c"]
    solution, broken, crashes = printed(tmp_path, "autograder.py", *map(str, files))
    assert solution == "solution.c             10 of 10"
    assert "0 of 10  broken.c:1:25: error: use of undeclared identifier 'x'" in broken
    assert "stopped at crashes.c:1:42:" in crashes


def test_the_own_sensor_is_read_by_c_and_by_python(tmp_path: Path) -> None:
    rows = printed(tmp_path, "own_sensor.py", is_real=True)  # devices are added before all imports
    offsets_m = [float(row.split()[2]) for row in rows]
    assert len(set(offsets_m)) > 2
    assert all(abs(offset) < 0.05 for offset in offsets_m[1:])


def test_scripts_say_what_is_missing(tmp_path: Path) -> None:
    done = subprocess.run(
        python(SCRIPTS / "autograder.py"), capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (1, "usage: python autograder.py WORLD PROGRAM...\n")


@pytest.mark.parametrize("early", ["crs_cc.Session()", "crs_cc.load_world()"])
def test_a_device_that_is_added_too_late_is_one_clear_error(early: str) -> None:
    text = (SCRIPTS / "own_sensor.py").read_text()
    text = text.replace("crs_cc.add_device", f"{early}\ncrs_cc.add_device")
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=False)
    expected = "ValueError: device 'line' cannot be added: add_device must be called before"
    assert done.stderr.splitlines()[-1].startswith(expected)
