"""The sample of a device in a package of its own: installed beside crs, and run."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from crs_cc.cli.main import main

ROOT = Path(__file__).parents[2]
SAMPLE = ROOT / "samples" / "plugins" / "uwb"


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Install the sample's package into a folder of its own."""
    source = tmp_path_factory.mktemp("source") / "uwb"
    shutil.copytree(SAMPLE, source)
    target = tmp_path_factory.mktemp("installed")
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    offline = ["--no-index", "--no-deps", "--no-build-isolation", "--target", str(target)]
    subprocess.run([*pip, *offline, str(source)], check=True)
    return target


def crs(
    target: Path, *arguments: str, folder: Path | None = None
) -> subprocess.CompletedProcess[str]:
    paths = [str(target), str(ROOT), os.environ.get("PYTHONPATH", "")]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
    command = [sys.executable, "-m", "crs_cc", *arguments]
    return subprocess.run(
        command, capture_output=True, text=True, env=environment, cwd=folder, check=False
    )


def test_its_sensor_measures_for_a_program_that_includes_its_header(installed: Path) -> None:
    """The comer starts 2 m away, 78.7 inches; the program waits for less than 40."""
    done = crs(installed, "run", str(SAMPLE / "meeting.xml"), "--max-time", "8")
    assert "error" not in done.stderr
    (line,) = [line for line in done.stdout.splitlines() if "listener" in line]
    assert 36.0 < float(line.split(" is ")[1].split()[0]) < 40.0


def test_its_element_is_checked_as_those_of_crs_are(installed: Path, tmp_path: Path) -> None:
    text = (SAMPLE / "scout-uwb.xml").read_text()
    broken = tmp_path / "broken.xml"
    broken.write_text(text.replace('range="10m"', 'range="far"'))
    done = crs(installed, "check", str(broken))
    assert done.returncode == 122
    assert "broken.xml:6: error: uwb, range: 'far' is not a length" in done.stderr


def test_without_the_package_the_element_is_unknown() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "crs_cc", "check", str(SAMPLE / "scout-uwb.xml")],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 122
    assert "uwb" in done.stderr


def test_a_device_that_cannot_be_loaded_is_named(installed: Path, tmp_path: Path) -> None:
    """Whatever its code raises is one line, and no traceback."""
    bad = tmp_path / "bad.dist-info"
    bad.mkdir()
    (bad / "METADATA").write_text("Metadata-Version: 2.1\nName: bad\nVersion: 1\n")
    (bad / "entry_points.txt").write_text("[crs_cc.devices]\nbad = crs_missing:DEVICE\n")
    done = crs(tmp_path, "run", str(SAMPLE / "come.c"))
    assert done.returncode == 2
    assert done.stderr.startswith("crs_missing:DEVICE: error: device 'bad' cannot be loaded:")
    assert "Traceback" not in done.stderr


def test_a_device_whose_measurement_fails_is_named(installed: Path, tmp_path: Path) -> None:
    """An exception in the package's code during a run is no internal error of crs."""
    target = tmp_path / "installed"
    shutil.copytree(installed, target)
    code = target / "crs_uwb" / "__init__.py"
    code.write_text(code.read_text().replace("nearest_m <= ", "farthest_m <= "))
    done = crs(target, "run", str(SAMPLE / "meeting.xml"), "--max-time", "8")
    assert done.returncode == 2
    (message,) = done.stderr.splitlines()
    assert message.startswith(f"{code}:")
    assert "error: device 'uwb': measure raised NameError: name 'farthest_m' is not" in message


PAGE = (ROOT / "docs" / "extending.md").read_text()


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)


def test_the_page_shows_the_sample_as_it_is() -> None:
    files = {path: path.read_text() for path in sorted(SAMPLE.rglob("*")) if path.is_file()}
    for block in (*blocks("python"), *blocks("toml")):
        lines = [line for line in block.splitlines() if line]
        assert any(_in_order(lines, text) for text in files.values()), block


def _in_order(lines: list[str], text: str) -> bool:
    rest = iter(text.splitlines())
    return all(line in rest for line in lines)


def test_the_pages_commands_run(installed: Path, tmp_path: Path) -> None:
    shutil.copytree(ROOT / "samples", tmp_path / "samples")
    commands = [line for line in "".join(blocks("sh")).splitlines() if line.startswith("crs ")]
    assert len(commands) == 4
    for command in commands:
        done = crs(installed, *shlex.split(command)[1:], folder=tmp_path)
        assert done.returncode == 0, f"{command}: {done.stderr}"


def test_the_pages_world_is_one(tmp_path: Path) -> None:
    (world,) = blocks("xml")
    (tmp_path / "world.xml").write_text(world)
    assert main(["check", str(tmp_path / "world.xml")]) == 0
