"""The readers in docs/recordings.md read what is recorded, one in Python and one in Node."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from crs_cc.recording.recording import Recording
from tests.npm_packages import installed

PAGE = Path(__file__).parents[2] / "docs" / "recordings.md"
NODE = Path(__file__).parent / "node"


def reader(language: str) -> str:
    found = re.search(rf"```{language}\n(.*?)```", PAGE.read_text(), re.DOTALL)
    assert found is not None
    return found[1]


def last_pose(path: Path) -> list[float]:
    recording = Recording(path)
    frame = list(recording.frames())[-1]
    recording.close()
    return [float(value) for value in frame.values[:, 0]]


def check(command: list[str], path: Path, **others: str) -> None:
    environment = {**os.environ, **others}
    done = subprocess.run(
        [*command, str(path)], capture_output=True, text=True, timeout=60, env=environment,
        check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    name, *pose = done.stdout.split()
    assert name == "robot0"
    assert [float(each) for each in pose] == pytest.approx(last_pose(path), abs=1e-9)


def test_the_reader_in_python_reads_it(recorded: Path, tmp_path: Path) -> None:
    program = tmp_path / "reader.py"
    program.write_text(reader("python"))
    check([sys.executable, str(program)], recorded)


def test_the_reader_in_javascript_reads_it(recorded: Path, tmp_path: Path) -> None:
    modules = installed(NODE)
    program = tmp_path / "reader.cjs"
    program.write_text(reader("javascript"))
    check(["node", str(program)], recorded, NODE_PATH=str(modules))
