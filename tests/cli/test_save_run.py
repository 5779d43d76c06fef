"""A run that is saved in the debugger is opened with its changes and its notes."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, cast

import pytest

from crs_cc.cli.main import main
from crs_cc.debug.breakpoints import Breakpoint
from crs_cc.debug.saved_breakpoints import KIND, restore_breakpoints
from crs_cc.recording.recording import Recording
from crs_cc.workbench.recorded_content import events_in

if TYPE_CHECKING:
    from crs_cc.debug.stop_points import StopPoints

DRIVES = """\
#include <unistd.h>
#include "Nclient.h"
int speed = 50;
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (i = 0; i < 30; i++) {
        scout_vm(speed, 0);
        usleep(200000);
    }
    return speed;
}
"""


def shown(capfd: pytest.CaptureFixture[str], *commands: str, file: str) -> str:
    words = [word for each in commands for word in ("-ex", each)]
    main(["debug", "--batch", "-q", *words, file])
    return capfd.readouterr().out


def test_changes_and_notes_are_in_the_recording(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "drive.c").write_text(DRIVES)
    monkeypatch.chdir(tmp_path)
    said = shown(
        capfd, "goto 1", "set var speed = 120", "goto 2", 'note "here it is fast"', "goto 3",
        "print $world.robot0.x", "save run.mcap", file="drive.c",
    )  # fmt: skip
    assert "Saved to 'run.mcap': the run up to t = 3.000 s." in said
    value = next(line for line in said.splitlines() if line.startswith("$1 = "))
    again = shown(
        capfd, "info notes", "info edits", "goto @1", "print speed", "goto 3",
        "print $world.robot0.x", file="run.mcap",
    )  # fmt: skip
    assert "here it is fast" in again
    assert "speed = 120" in again
    assert "= 120" in again
    assert value.removeprefix("$1") in again
    with closing(Recording(tmp_path / "run.mcap")) as recording:
        (note,) = [each for each in events_in(recording)[0] if each[1] == "note"]
    assert note == [pytest.approx(2.17, abs=0.01), "note", 0, "here it is fast", None, None]


def test_breakpoints_are_in_the_recording_and_set_when_it_is_opened(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "drive.c").write_text(DRIVES)
    monkeypatch.chdir(tmp_path)
    line = 1 + [each.strip() for each in DRIVES.splitlines()].index("scout_vm(speed, 0);")
    shown(
        capfd, f"break {line} if speed == 120", "watch speed", "catch collision", "disable 3",
        "enable count 3 1",
        "goto 1", "set var speed = 120", "goto 2", "save run run.mcap", file="drive.c",
    )  # fmt: skip
    said = shown(capfd, "info breakpoints", "delete 2", "continue", "print speed", file="run.mcap")
    assert f"drive.c:{line}" in said
    assert "speed == 120" in said
    assert "will be disabled after 3 stops" in said
    assert "collision" in said
    assert "$1 = 120" in said


def test_commands_of_breakpoints_are_not_saved() -> None:
    """They would be executed by opening another user's run."""
    data = {"kind": KIND, "what": "breakpoint", "text": "main", "commands": "shell"}
    points = cast("StopPoints", FakePoints())
    restore_breakpoints(points, [data, data | {"what": "x"}, data | {"ignore": []}], 1)
    assert cast("FakePoints", points).made == [
        ("main", {"condition": "", "robot": None, "ignore": 0})
    ]


class FakePoints:
    """Notes what is set."""

    def __init__(self) -> None:
        self.made: list[tuple[str, dict[str, object]]] = []

    def add_breakpoint(self, place: str, **options: object) -> Breakpoint:
        self.made.append((place, options))
        return Breakpoint(1, "breakpoint", place)


def test_no_other_file_is_overwritten(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "drive.c").write_text(DRIVES)
    (tmp_path / "mine.mcap").write_text("mine")
    (tmp_path / "link.mcap").symlink_to("other.mcap")
    monkeypatch.chdir(tmp_path)
    said = shown(
        capfd, "goto 0.1", "save run drive.c", "save run mine.mcap", "save run link.mcap",
        "save run nowhere/a.mcap", file="drive.c",
    )  # fmt: skip
    assert "must end with .mcap" in said
    assert "'mine.mcap' is not a recording: not overwritten" in said
    assert "'link.mcap' is a symbolic link: not overwritten" in said
    assert "'nowhere/a.mcap' cannot be written" in said
    assert (tmp_path / "drive.c").read_text() == DRIVES
    assert (tmp_path / "mine.mcap").read_text() == "mine"
    assert not (tmp_path / "other.mcap").exists()
