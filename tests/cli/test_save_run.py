"""A run that is saved in the debugger is opened with its changes and its notes."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.recording.recording import Recording
from crs_cc.workbench.recorded_content import events_in

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
