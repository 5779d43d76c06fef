"""Writes the table of devices into `docs/degradation.md`, and tries what else the page shows.

`--update-goldens` rewrites the table.
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path
from unittest.mock import MagicMock

import pytest

from crs_cc.cli.main import main
from crs_cc.sim.degradation.model import DEVICES, Degradation, Device, shown
from crs_cc.sim.files.world_xml import empty_world, known_robots, load_world
from crs_cc.sim.robot_model import RobotModel

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "degradation.md"
BEGIN, END = "<!-- made by tests/sim/degradation/test_page.py -->\n", "\n<!-- end -->"
FIRST = ("scout", "nomad200")


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text(), re.DOTALL)


def test_the_page_has_every_device(check_golden: Callable[[Path, bytes], None]) -> None:
    before, rest = PAGE.read_text().split(BEGIN)
    _, after = rest.split(END)
    check_golden(PAGE, (before + BEGIN + table() + END + after).encode())


def table() -> str:
    titles = ("device", "values", "unit", "elements", "without a value")
    lines = [f"| {' | '.join(titles)} |", f"| {' | '.join('---' for _ in titles)} |"]
    for device in DEVICES.values():
        title = f"{device.title} (actuator)" if device.acts else device.title
        cells = (f"`{device.name}`", title, unit(device), elements(device), device.nothing)
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def unit(device: Device) -> str:
    kinds = dict.fromkeys(device.kind_of(name) for name in names_of(device) if name)
    return ", ".join(kind.default or "-" for kind in kinds) or device.kind.default or "-"


def names_of(device: Device) -> list[str]:
    return [name for robot in robots() for name in device.elements(robot)] or [""]


def robots() -> list[RobotModel]:
    names = [*FIRST, *(name for name in known_robots() if name not in FIRST)]
    return [empty_world(robot=name).robots[0].model for name in names]


def elements(device: Device) -> str:
    """Gives the elements of robots that have them, in the order of `robots`."""
    told: dict[str, str] = {}
    for robot in robots():
        names = device.elements(robot)
        if names:
            told.setdefault(shown(names), robot.name)
    if not told:  # of no robot that comes with crs
        names = device.elements(MagicMock())
        numbers = "0" if device.width == 1 else f"0 to {device.width - 1}"
        return shown(names) if len(names) == device.width > 1 else numbers
    if len(told) == 1:
        return next(iter(told))
    return "; ".join(f"{each} ({name})" for each, name in told.items())


def test_every_kind_of_fault_is_on_the_page() -> None:
    text = PAGE.read_text()
    for name in ("gain", "bias", "noise", "step", "stuck", "delay", "dropouts", "dead"):
        assert f"| `{name}` |" in text
    for name in Degradation.__dataclass_fields__:
        assert f"`{name.removesuffix('_s')}`" in text, name


def test_the_world_of_the_page_is_the_world_that_comes_with_crs() -> None:
    (shown_here,) = blocks("xml")
    whole = (ROOT / "worlds" / "faulty.xml").read_text()
    assert shown_here.strip() in whole
    assert len(load_world(ROOT / "worlds" / "faulty.xml").degradations) == 3


def test_the_commands_of_the_page_run(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.chdir(ROOT)
    for line in "".join(blocks("sh")).splitlines():
        command = shlex.split(line.replace("docs/images", str(tmp_path)))
        assert main([*command[1:], *([] if "--trace" in command else ["--max-time", "1"])]) == 0
    told = capfd.readouterr()
    for line in blocks("text")[0].splitlines():
        assert line in told.out + told.err


def test_the_picture_is_that_of_the_world() -> None:
    text = (ROOT / "docs" / "images" / "faulty.svg").read_text()
    assert "distrust.c in faulty.xml" in text


def test_the_lines_of_python_run(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)
    (program,) = blocks("python")
    exec(program, {})
    assert capsys.readouterr().out.splitlines() == re.findall(r"^# (.*)$", program, re.MULTILINE)
