"""`crs world`: world files edited by commands."""

from __future__ import annotations

import io
import shutil
from pathlib import Path

import pytest

from crs_cc.builder.table import OPERATIONS
from crs_cc.cli.main import main
from crs_cc.cli.world import world

WORLDS = Path(__file__).parents[2] / "worlds"


@pytest.fixture(autouse=True)
def in_copy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(WORLDS, tmp_path / "worlds")
    monkeypatch.chdir(tmp_path / "worlds")


def lines(path: str) -> set[str]:
    return set(Path(path).read_text().splitlines())


def test_every_operation_is_a_command() -> None:
    assert set(world.commands) >= set(OPERATIONS)


def test_one_line_changes_and_names_of_copies_are_printed(
    capfd: pytest.CaptureFixture[str],
) -> None:
    before = lines("room.xml")
    assert main(["world", "move", "room.xml", "crate", "--x", "-10cm", "--diff"]) == 0
    shown = capfd.readouterr().out.splitlines()
    assert [row[:20] for row in shown if row[:2] in ("- ", "+ ")] == [
        '-  <box id="crate" x', '+  <box id="crate" x'
    ]  # fmt: skip
    assert lines("room.xml") == before
    assert main(["world", "move", "room.xml", "crate", "--x", "-10cm"]) == 0
    assert len(lines("room.xml") - before) == 1
    assert main(["world", "array", "room.xml", "pillar", "--columns", "2", "--x", "-50cm"]) == 0
    assert main(["world", "add", "room.xml", "light", "x=1m", "y=2m", "-o", "lit.xml"]) == 0
    assert capfd.readouterr().out.split() == ["pillar-2", "light0"]
    assert lines("lit.xml") - lines("room.xml") == {'  <light id="light0" x="1m" y="2m"/>'}
    assert main(["world", "set", "room.xml", "carton", "mass=", "heat=2"]) == 0
    assert main(["world", "list", "room.xml"]) == 0
    assert capfd.readouterr().out.splitlines()[-2:] == ["pillar-2  cylinder", "robot0    robot"]
    assert main(["check", "-q", "room.xml", "lit.xml"]) == 0


def test_elements_go_from_world_to_world(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert main(["world", "copy", "canteen.xml", "p1"]) == 0
    clip = capfd.readouterr().out
    Path("p1.clip").write_text(clip)
    assert main(["world", "paste", "office-plan.xml", "p1.clip", "--x", "3m", "--y=-3m"]) == 0
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(clip.encode())))
    assert main(["world", "paste", "studio.xml", "-", "--x", "-1m", "--y", "-4m"]) == 0
    assert main(["check", "-q", "office-plan.xml", "studio.xml"]) == 0


@pytest.mark.parametrize(
    ("arguments", "status", "said"),
    [
        ("move room.xml crat --x 1m", 2, "unknown element 'crat'"),
        ("move room.xml crate --x 1kg", 2, "x: '1kg' is not a length"),
        ("set room.xml crate", 2, "give NAME=VALUE"),
        ("set room.xml crate wide=3m", 122, "did you mean 'width'?"),
        ("move room.xml robot0 --x 10m", 122, "is not completely inside the world"),
        ("move no.xml robot0 --x 10m", 122, "no.xml"),
        ("add room.xml bx x=1", 2, "unknown element of <world> 'bx'"),
        ("paste room.xml no.clip", 2, "cannot read 'no.clip'"),
        ("list room.xml crat", 2, "unknown element"),
        ("copy room.xml crat", 2, "unknown element"),
        ("turn room.xml crate --angle 1deg -o wall.xml", 122, "exists already"),
    ],
)
def test_errors_are_reported_and_nothing_is_written(
    arguments: str, status: int, said: str, capfd: pytest.CaptureFixture[str]
) -> None:
    before = {path: path.read_bytes() for path in Path().glob("*.xml")}
    assert main(["world", *arguments.split()]) == status
    assert said in capfd.readouterr().err
    assert {path: path.read_bytes() for path in Path().glob("*.xml")} == before
