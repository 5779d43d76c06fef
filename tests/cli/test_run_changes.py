"""`crs run --inputs`: changes at simulated times, the same as those made by hand."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from tests.debug.debuggers import debugger_of

PROGRAM = """\
#include <Nclient.h>
int main(void)
{
    int i;
    connect_robot(1);
    for (i = 0; i < 400; i++)
        get_sn();
    return 0;
}
"""
CHANGES = {
    0: "drive robot0 0.2",
    7: "degrade robot0 sonar noise 3cm",
    9: "join more like robot0 to 1 1 90",
    12: "sleep robot0 0.3s",
    14: "join own like robot0 to 1 3 running beside.c",
    15: "heat robot0 4",
    20: "move robot0 to 1 1.5",
}


@pytest.fixture
def script(tmp_path: Path) -> Path:
    (tmp_path / "a.c").write_text(PROGRAM)
    (tmp_path / "beside.c").write_text("int main(void) { return 0; }\n")
    lines = [f"{timestep * 0.05:.2f}s: {text}" for timestep, text in CHANGES.items()]
    path = tmp_path / "by-hand.txt"
    path.write_text("# what was done\n" + "\n".join(lines) + "\n")
    return path


def test_a_script_repeats_the_changes_to_the_bit(
    script: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    debugger = debugger_of(PROGRAM, world="wall.xml", seed=3)
    debugger.run.uploads.add("beside.c", (tmp_path / "beside.c").read_text())
    for timestep, text in CHANGES.items():
        debugger.goto_timestep(timestep)
        debugger.edit_world(text)
    debugger.goto_timestep(30)
    world = Path(__file__).parents[2] / "worlds" / "wall.xml"
    run = tmp_path / "run.mcap"
    asked = ["run", str(tmp_path / "a.c"), str(world), "--seed", "3", "--json"]
    asked += ["--inputs", str(script), "--record", str(run), "-q"]
    assert main([*asked, "--max-time", "1.5"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert [robot["id"] for robot in result["robots"]] == ["robot0", "more", "own"]
    x_m, y_m, _ = debugger.session.state.robot_result(0).pose
    assert result["robots"][0]["pose"]["x_m"] == x_m
    assert result["robots"][0]["pose"]["y_m"] == y_m
    assert main(["replay", str(run), "--verify"]) == 0
    assert "3 hashes agree, 1 of them of the complete state" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("move robot0", "expected a time and a change"),
        ("0.1s: fly away", "'fly' is not a change of the world"),
        ("2s: heal robot0\n1s: heal robot0", "the time is before that of the previous line"),
    ],
)
def test_a_wrong_line_is_named(
    script: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str, said: str
) -> None:
    script.write_text(text)
    program = str(tmp_path / "a.c")
    assert main(["run", program, "--inputs", str(script), "--max-time", "0.5", "-q"]) == 2
    shown = capsys.readouterr().err
    assert f"{script}:{text.count(chr(10)) + 1}: {said}" in shown
