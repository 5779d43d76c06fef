"""`crs new`, and the contents that `crs check` lists for worlds, robots and included files."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from crs_cc.cli.main import main

ROVER = "radius 0.2 m, 15 kg, differential drive, 3 sonars, 8 bumper switches, gps, heat"
ROOT = Path(__file__).parents[2]


@pytest.fixture(autouse=True)
def in_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_templates_can_be_checked_and_run(capfd: pytest.CaptureFixture[str]) -> None:
    for kind, name in (("world", "room"), ("robot", "rover.xml"), ("program", "go")):
        assert main(["new", kind, name]) == 0
    assert capfd.readouterr().out.splitlines()[0] == (
        "wrote room.xml; list its contents with: crs check room.xml"
    )
    assert main(["check", "room.xml", "rover.xml", "go.c"]) == 0
    shown = capfd.readouterr()
    assert shown.err == "3 files checked: 0 errors, 0 warnings\n"
    assert main(["run", "go.c", "room.xml", "--max-time", "3", "-q"]) == 0
    assert main(["run", "go.c", "--robot", "rover.xml", "--max-time", "1", "-q"]) == 0
    Path("room.xml").write_text(
        Path("room.xml").read_text().replace('definition="scout"', 'definition="rover.xml"')
    )
    assert main(["run", "go.c", "room.xml", "--setup", "noisy", "-q"]) == 0
    assert re.match(r"at x = -?[0-9.]+, y = -?[0-9.]+ inches", capfd.readouterr().out)


def test_check_lists_the_contents(capfd: pytest.CaptureFixture[str]) -> None:
    main(["new", "world", "room"])
    main(["new", "robot", "rover"])
    Path("lib.xml").write_text(
        '<definitions version="1"><material name="wood"/>'
        '<define name="post"><cylinder x="0" y="0" radius="1"/></define></definitions>'
    )
    capfd.readouterr()
    assert main(["check", "room.xml", "rover.xml", "lib.xml"]) == 0
    assert capfd.readouterr().out.splitlines() == [
        "room.xml: world 'room': 6 m x 5 m, timestep 50 ms, duration 60 s, seed 1",
        "room.xml: 1 wall, 4 boxes, 1 cylinder (1 to be pushed, 1 hot)",
        "room.xml: robot 'robot0': scout at x = 1 m, y = 1 m, 30 degrees",
        f"rover.xml: robot 'rover': {ROVER}",
        "lib.xml: materials: wood",
        "lib.xml: objects: post",
    ]
    assert main(["check", "-q", "room.xml"]) == 0
    assert capfd.readouterr().out == ""


def test_check_reports_errors_in_robots_and_included_files(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("r.xml").write_text('<robot-definition version="1" name="r"/>')
    Path("d.xml").write_text(
        '<definitions version="1"><material name="m" sonar="2"/></definitions>'
    )
    Path("x.xml").write_text("<something/>")
    for name, expected in (
        ("r.xml", "r.xml:1: error: missing element in <robot-definition>; expected <body>"),
        ("d.xml", "d.xml:1: error: material, sonar: '2' must be from 0 to 1"),
        ("x.xml", "x.xml:1: error: the root element must be <world>, not <something>"),
    ):
        assert main(["check", name]) == 122
        assert capfd.readouterr().err.splitlines()[0] == expected


def test_check_lists_terrain_and_degradations(
    capfd: pytest.CaptureFixture[str],
) -> None:
    for name in ("plateau", "hills", "faulty"):
        assert main(["check", str(ROOT / "worlds" / f"{name}.xml")]) == 0
    shown = capfd.readouterr().out
    assert re.search(r"plateau.xml: \d+ ramps? (and|or) plateaus?\n", shown)
    assert "hills.xml: ground from a picture\n" in shown
    assert re.search(r"faulty.xml: \d+ degradations?\n", shown)


def test_the_predefined_robots_are_listed(capfd: pytest.CaptureFixture[str]) -> None:
    for path in sorted((ROOT / "crs_cc" / "sim" / "files" / "robots").glob("*.xml")):
        assert main(["check", str(path)]) == 0
    assert "synchro drive" in capfd.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["world", "room"], "'room.xml' already exists."),
        (["world", "1st"], "'1st' is not a valid name"),
        (["robot", ""], "'' is not a valid name"),
        (["program", "/"], "'' is not a valid name"),
        (["program", ".."], "is not a valid name"),
        (["world", "nowhere/room"], "cannot write 'nowhere/room.xml': No such file or directory."),
        (["planet", "room"], "'planet' is not one of 'world', 'robot', 'program'."),
    ],
)
def test_new_never_overwrites_a_file(
    arguments: list[str], expected: str, capfd: pytest.CaptureFixture[str]
) -> None:
    shutil.copy(ROOT / "worlds" / "room.xml", "room.xml")
    before = Path("room.xml").read_bytes()
    assert main(["new", *arguments]) == 2
    assert expected in capfd.readouterr().err
    assert Path("room.xml").read_bytes() == before


def test_the_commented_parts_of_the_robot_template_are_valid(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    main(["new", "robot", "rover"])
    text = Path("rover.xml").read_text()
    head, _, rest = text.partition("docs/actuators.md describe them.\n")
    more, _, tail = rest.partition("  -->\n")
    Path("rover.xml").write_text(f"{head} -->\n{more}{tail}")
    capfd.readouterr()
    assert main(["check", "rover.xml"]) == 0
    told = capfd.readouterr().out
    for device in ("camera", "gripper", "light sensors", "microphones", "lamp", "speaker"):
        assert device in told, told
