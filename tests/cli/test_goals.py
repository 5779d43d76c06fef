"""Goals are shown by the summary, JSON, recordings and the debugger, with their instants."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.debug.commands.shell import Shell
from crs_cc.recording import topics
from crs_cc.recording.recording import Recording
from tests.debug.debuggers import debugger_at

WORLD = """<world version="1" duration="3s"><area length="6m" width="5m"/>
<robot x="1m" y="1m"/>
<goal id="near" name="[b]A &lt;place&gt;[/b]" points="2.5">
  <reach x="2m" y="1m" radius="80cm"/></goal>
<goal within="1s"><reach x="5m" y="4m" radius="10cm"/></goal>
<goal points="3"><no-collision/></goal>
<goal><cover share="1" cell="40cm"/></goal></world>"""
PROGRAM = """#include "Nclient.h"
int main(void) { connect_robot(1); conf_tm(0); vm(100, 100, 0); for (;;) gs(); }
"""


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("goals.xml").write_text(WORLD)
    Path("drive.c").write_text(PROGRAM)


def test_a_run_shows_and_records_the_status_of_goals(
    capfd: pytest.CaptureFixture[str],
) -> None:
    arguments = ["drive.c", "goals.xml", "--json", "--summary", "--record", "run.mcap"]
    assert main(["run", *arguments]) == 0
    out, err = capfd.readouterr()
    data = json.loads(out)
    near, late, clean, cover = data["goals"]
    at_s = near.pop("at_s")
    assert 1.0 < at_s < 2.0
    title = "[b]A <place>[/b]"
    assert near == {"id": "near", "title": title, "points": 2.5, "status": "met", "progress": ""}
    assert (late["status"], late["at_s"]) == ("failed", 1.0)
    assert (clean["status"], clean["at_s"]) == ("holds", None)
    assert (cover["status"], cover["progress"]) == ("open", "1% covered")
    assert data["points"] == {"earned": 5.5, "of": 7.5}
    rows = [" ".join(line.split()) for line in err.splitlines()]
    assert f"{title} met {at_s:.2f} s 2.5 of 2.5" in rows
    assert "in all 5.5 of 7.5" in rows

    assert main(["replay", "run.mcap"]) == 0
    assert f"  goal      {title}: met at {at_s:.2f} s\n" in capfd.readouterr().out
    recording = Recording(Path("run.mcap"))
    events = [(ns, data) for ns, data in recording.data(topics.EVENT.topic)]
    assert [data["text"] for _, data in events if data["kind"] == "goal"] == [
        "goal 'goal1' failed", f"goal '{title}' met"
    ]  # fmt: skip


def test_the_debugger_shows_goals_as_they_are_at_the_instant() -> None:
    debugger = debugger_at([Path("drive.c")], str(Path("goals.xml").resolve()))
    debugger.start()
    shell = Shell(debugger)
    said = [
        [line.text for line in shell.execute(command)]
        for command in ("info goals", "catch goal", "continue", "info goals")
    ]
    assert said[0] == [
        "[b]A <place>[/b]  open (2.5 points)",
        "goal1             open (1 point)",
        "goal2             holds (3 points)",
        "goal3             open, 0% covered (1 point)",
        "points            3 of 7.5",
    ]
    assert "Catchpoint 1: goal 'goal1' failed" in said[2]
    assert said[3][1] == "goal1             failed at 1.000 s (1 point)"
    for command in ("reverse-continue", "info goals"):
        back = [line.text for line in shell.execute(command)]
    assert back == said[0]


def test_a_world_is_checked_with_its_goals(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "goals.xml"]) == 0
    assert (
        "goals.xml: goal '[b]A <place>[/b]': reach, 2.5 points\n"
        "goals.xml: goal 'goal1': reach, 1 point, within 1 s\n"
        "goals.xml: goal 'goal2': no-collision, 3 points\n"
    ) in "".join(capfd.readouterr())
