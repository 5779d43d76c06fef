"""Recordings of other versions: a checked-in one is opened and verified, as is another Python's."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.recording.recording import Recording
from crs_cc.recording.topics import FORMAT_VERSION

ROOT = Path(__file__).parents[2]
GOLDEN = Path(__file__).parent / "golden" / "drive.mcap"
PROGRAM = """\
#include <Nclient.h>
#include <math.h>
#include <stdio.h>

int main(void)
{
    int i;
    connect_robot(1);
    conf_tm(0);
    for (i = 0; i < 8; i++) {
        get_sn();
        vm(100 + (int)(20 * sin(i)), 100 - 10 * i, 0);
        ws(1, 1, 1, 1);
        printf("%d %ld\\n", i, State[STATE_SONAR_0]);
    }
    return 0;
}
"""
WORLD = """<world version="1" timestep="100ms" seed="7">
  <area length="3m" width="2m"/>
  <box id="crate" x="1.5m" y="1m" length="0.3m" width="0.3m" mass="3kg"/>
  <robot x="0.8m" y="1m" setup="noisy"/>
</world>
"""
NEEDED = "import click, lxml, numpy, pycparser, pymunk, wasmtime, zstandard"


def record(folder: Path) -> Path:
    """Record a run that drives, pushes, measures with noise and prints."""
    (folder / "drive.c").write_text(PROGRAM)
    (folder / "room.xml").write_text(WORLD.replace("", ""))
    path = folder / "run.mcap"
    files = [str(folder / name) for name in ("drive.c", "room.xml")]
    main(["run", *files, "--record", str(path), "--max-time", "4", "--quiet"])
    return path


def test_a_checked_in_recording_has_the_current_format_and_is_the_same_run(
    tmp_path: Path, request: pytest.FixtureRequest, capfd: pytest.CaptureFixture[str]
) -> None:
    if request.config.getoption("--update-goldens"):
        before = GOLDEN.read_bytes() if GOLDEN.exists() else b""
        if not before or main(["replay", str(GOLDEN), "--verify"]):
            shutil.copy(record(tmp_path), GOLDEN)
            pytest.fail(f"{GOLDEN.name} was rewritten; say why runs are others, then run again")
    recording = Recording(GOLDEN)
    assert json.loads(recording.mcap.metadata["crs.run"]["format"]) == FORMAT_VERSION == 6
    assert recording.is_complete
    frames = [(each.time_s, each.values[:, 0].tolist()) for each in recording.frames()]
    recording.close()
    assert frames[0] == (0.0, [0.8, 1.0, 0.0])
    assert frames[-1][1][0] > 1.0
    assert main(["replay", str(GOLDEN), "--verify"]) == 0, (
        "the simulation runs this recording in another way than it was recorded: if that is meant,"
        " --update-goldens records it anew"
    )
    assert "the same run: 5 hashes agree, 1 of them of the complete state" in capfd.readouterr().out


def test_a_recording_of_an_older_format_names_the_version_that_reads_it(
    capfd: pytest.CaptureFixture[str],
) -> None:
    assert main(["replay", str(GOLDEN.with_name("drive_format_5.mcap"))]) == 120
    said = capfd.readouterr().err
    assert "its format is 5 (this version reads 6); it is read by the crs that recorded it" in said


def other_python() -> str:
    """Return another Python that has our packages; skip if there is none."""
    names = [os.environ.get("CRS_OTHER_PYTHON", ""), *(f"python3.{n}" for n in range(11, 20))]
    own = f"{sys.version_info.major}.{sys.version_info.minor}"
    for name in filter(None, names):
        path = shutil.which(name)
        if path is None or name == f"python{own}":  # likely the one that runs this
            continue
        done = subprocess.run([path, "-c", NEEDED], capture_output=True, check=False, timeout=60)
        if done.returncode == 0:
            return path
    pytest.skip(
        f"no Python other than {own} that has our packages (CRS_OTHER_PYTHON, or python3.N on PATH)"
    )


def test_recordings_are_verified_across_python_versions(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    python = other_python()
    mine = record(tmp_path)
    theirs = tmp_path / "theirs.mcap"
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    files = [str(tmp_path / name) for name in ("drive.c", "room.xml")]
    for arguments in (
        ["replay", str(mine), "--verify"],
        ["run", *files, "--record", str(theirs), "--max-time", "4", "--quiet"],
    ):
        command = [python, "-m", "crs_cc", *arguments]
        done = subprocess.run(
            command, capture_output=True, text=True, check=False, timeout=120, env=environment
        )
        assert done.returncode == 0, done.stderr
    assert main(["replay", str(theirs), "--verify"]) == 0
    assert "the same run" in capfd.readouterr().out
    versions = [Recording(path).versions["python"] for path in (mine, theirs)]
    assert versions[0] != versions[1]
