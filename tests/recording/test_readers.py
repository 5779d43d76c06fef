"""The readers in docs/recordings.md read what is recorded, one in Python and one in Node."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from crs_cc.recording.recording import Recording

PAGE = Path(__file__).parents[2] / "docs" / "recordings.md"
NODE = Path(__file__).parent / "node"
CACHE = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "crs_cc_tests"


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
    missing = [name for name in ("node", "npm") if shutil.which(name) is None]
    if missing:
        pytest.skip(f"{' and '.join(missing)} not found: the reader cannot be run")
    lock = (NODE / "package-lock.json").read_bytes()
    folder = CACHE / f"mcap-{hashlib.sha256(lock).hexdigest()[:16]}"
    if not (folder / "installed").exists():
        folder.mkdir(parents=True, exist_ok=True)
        for name in ("package.json", "package-lock.json"):
            shutil.copy(NODE / name, folder)
        options = ["--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"]
        done = subprocess.run(["npm", "ci", *options], cwd=folder, timeout=120, check=False)
        if done.returncode:
            pytest.skip("npm cannot install @mcap/core")
        (folder / "installed").touch()
    program = tmp_path / "reader.cjs"
    program.write_text(reader("javascript"))
    check(["node", str(program)], recorded, NODE_PATH=str(folder / "node_modules"))
