"""Robots that join and leave, in the output of `crs run`."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from crs_cc.cli.main import main

WORLD = """<world version="1"><area length="9m" width="9m"/>
<robot id="stays" x="1m" y="1m"/>
<robot id="comes" x="3m" y="1m" join="0.5s"/>
<robot id="goes" x="5m" y="1m" leave="1s"/>
<robot id="never" x="7m" y="1m" join="60s"/>
</world>"""
DRIVES = (
    '#include "Nclient.h"\nint main(void) { connect_robot(1); vm(99, 99, 0); for (;;) gs(); }\n'
)


@pytest.fixture
def files(tmp_path: Path) -> list[str]:
    (tmp_path / "drives.c").write_text(DRIVES)
    (tmp_path / "world.xml").write_text(WORLD)
    return [str(tmp_path / "drives.c"), str(tmp_path / "world.xml"), "--max-time", "2"]


def test_results_include_join_and_leave_times(files: list[str], capfd: pytest.CaptureFixture[str]):
    assert main(["run", *files, "--json"]) == 0
    robots = json.loads(capfd.readouterr().out)["robots"]
    assert [(robot["outcome"], robot["joined_s"], robot["left_s"]) for robot in robots] == [
        ("running", 0.0, None),
        ("running", 0.5, None),
        ("left", 0.0, 1.0),
        ("absent", None, None),
    ]


def test_the_summary_includes_joins_and_leaves(files: list[str], capfd: pytest.CaptureFixture[str]):
    assert main(["run", *files, "--summary"]) == 0
    shown = capfd.readouterr().err
    assert re.search(r"goes +left at 1.00 s", shown)
    assert re.search(r"never +never joined", shown)


def test_a_trace_shows_robots_while_they_are_present(
    files: list[str], capfd: pytest.CaptureFixture[str]
):
    assert main(["run", *files, "--trace", "requests"]) == 0
    lines = capfd.readouterr().err.splitlines()
    times = {
        name: [float(line.split()[0]) for line in lines if re.match(rf"[\d.]+ {name} +\S*VM", line)]
        for name in ("comes", "goes", "never")
    }
    assert min(times["comes"]) >= 0.5
    assert max(times["goes"]) < 1.0
    assert times["never"] == []
    assert any(re.match(r"0.500 comes +join: joined", line) for line in lines)
    assert any(re.match(r"1.000 goes +leave: left", line) for line in lines)


def test_the_picture_shows_where_they_were(files: list[str], tmp_path: Path):
    """A robot that never joined is not drawn; one that has left is hollow at its end."""
    picture = tmp_path / "picture.svg"
    assert main(["run", *files, "--plot", str(picture)]) == 0
    text = picture.read_text()
    assert text.count("<polyline") >= 3
    assert "nan" not in text
    hollow = re.findall(r'<circle[^>]*fill-opacity="0.6"', text)
    assert len(hollow) == 3 + 1 + 1  # starts, the end of the one that is gone, the legend


@pytest.mark.parametrize(
    ("stay", "message"),
    [
        ('join="2s" leave="1s"', "leave: must be later than join"),
        ('leave="0s"', "must be greater than 0"),
        ('join="-1s"', "must not be negative"),
        ('join="soon"', "is not a time"),
        ('join="1e300s"', "is too large"),
        ('join="nan"', "is not a time"),
    ],
)
def test_invalid_join_times_are_rejected(
    stay: str, message: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
):
    world = tmp_path / "world.xml"
    world.write_text(
        f'<world version="1"><area length="9m" width="9m"/><robot x="1m" y="1m" {stay}/></world>'
    )
    assert main(["check", str(world)]) == 122
    assert message in " ".join(capfd.readouterr())


def test_a_later_robot_may_overlap_moving_objects(tmp_path: Path):
    """Three robots join at the same place, where there is a box at first."""
    robots = "".join(f'<robot x="1m" y="1m" join="{n}s"/>' for n in range(1, 4))
    elements = '<robot x="1.3m" y="1m"/><box x="1m" y="1m" length="9cm" width="9cm" mass="1kg"/>'
    world = tmp_path / "world.xml"
    world.write_text(
        f'<world version="1"><area length="9m" width="9m"/>{robots}'
        f"{elements.replace('1.3m', '4m')}</world>"
    )
    assert main(["check", str(world)]) == 0
    world.write_text(world.read_text().replace('mass="1kg"', ""))
    assert main(["check", str(world)]) == 122
