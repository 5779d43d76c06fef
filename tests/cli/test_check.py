"""`crs check` of one file, of a program in several files, and its JSON output."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from crs_cc.cli.main import main

WORLDS = Path(__file__).parents[2] / "worlds"


@pytest.fixture(autouse=True)
def in_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_check_links_programs_as_run_does(capfd: pytest.CaptureFixture[str]) -> None:
    Path("main.c").write_text("int turn(int);\nint main(void)\n{\n    return turn(1);\n}\n")
    assert main(["check", "main.c"]) == 121
    assert "main.c:4:12: error: 'turn' is used, but not defined" in capfd.readouterr().err
    Path("turn.c").write_text("int turn(int n) { return n; }\n")
    assert main(["check", "main.c", "turn.c"]) == 0
    Path("again.c").write_text("\nint turn(int n) { return -n; }\n")
    assert main(["check", "main.c", "turn.c", "again.c"]) == 121
    shown = capfd.readouterr().err
    assert "again.c:2:5: error: multiple definition of 'turn'" in shown
    assert "also defined at turn.c:1:5" in shown


def test_a_part_of_a_program_is_checked_alone(capfd: pytest.CaptureFixture[str]) -> None:
    Path("turn.c").write_text("int other(int);\nint turn(int n) { return other(n); }\n")
    assert main(["check", "turn.c"]) == 0
    assert capfd.readouterr().err == "1 file checked: 0 errors, 0 warnings\n"


def test_a_misspelt_function_is_reported_once(capfd: pytest.CaptureFixture[str]) -> None:
    Path("main.c").write_text('int main(void)\n{\n    return prinft("x");\n}\n')
    assert main(["check", "main.c"]) == 121
    shown = capfd.readouterr().err
    assert shown.count("prinft'") == 1
    assert "did you mean 'printf'?" in shown


def test_messages_as_data_have_stage_location_and_hint(capfd: pytest.CaptureFixture[str]) -> None:
    Path("main.c").write_text("int speed;\nint main(void)\n{\n    return sped\n}\n")
    assert main(["check", "--json", "main.c"]) == 121
    first, second = json.loads(capfd.readouterr().out)
    assert first == {
        "severity": "error", "stage": "types", "file": "main.c", "line": 4, "column": 12,
        "text": "use of undeclared identifier 'sped'", "hint": "did you mean 'speed'?", "flag": "",
    }  # fmt: skip
    assert (second["stage"], second["line"], second["column"]) == ("parsing", 4, 16)


def test_a_missing_include_folder_is_ignored(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("main.c").write_text("int main(void) { return 0; }\n")
    assert main(["check", "main.c", "-I", "nowhere"]) == 0
    assert "warning: -I nowhere: no such folder" in capfd.readouterr().err


def test_errors_in_a_world_are_reported(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["check", str(WORLDS / "faulty.xml")]) == 0
    told = capfd.readouterr()
    assert "degradation 'weak' of 'robot0': drive right, gain 0.97, from 50 s on for 10 s" in (
        told.out + told.err
    )


def test_check_rejects_programs_that_do_not_fit_as_run_does(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("large.c").write_text("char a[2000000000];\nint main(void) { return a[0]; }\n")
    assert main(["run", "large.c"]) == 121
    refused = capfd.readouterr().err
    assert refused.startswith("large.c:1:6: error: 'a' does not fit: 2000000000 bytes of ")
    assert main(["check", "-q", "large.c"]) == 121
    assert capfd.readouterr().err == refused


@pytest.mark.parametrize(
    ("source", "message"),
    [
        ("char a[2000000000];\n", "part.c:1:6: error: 'a' does not fit: 2000000000 bytes of "),
        (
            "int f(void)\n{ static int b[4000000]; return b[0]; }\n",
            "part.c:2:14: error: 'b' does not fit: 16000000 bytes of ",
        ),
    ],
)
def test_check_rejects_a_part_of_a_program_with_an_object_that_fits_nowhere(
    source: str, message: str, capfd: pytest.CaptureFixture[str]
) -> None:
    Path("part.c").write_text(source)
    assert main(["check", "-q", "part.c"]) == 121
    assert capfd.readouterr().err.startswith(message)


def test_check_accepts_a_large_object_that_the_program_never_uses_as_run_does() -> None:
    Path("main.c").write_text("char a[2000000000];\nint main(void) { return 0; }\n")
    assert main(["run", "main.c"]) == 0
    assert main(["check", "-q", "main.c"]) == 0


def test_programs_that_a_world_names_are_compiled(capfd: pytest.CaptureFixture[str]) -> None:
    """They were not, so that a world passed the check and crs run refused it."""
    Path("good.c").write_text("int main(void) { return 0; }\n")
    Path("bad.c").write_text("int main(void)\n{\n    return turn(1);\n}\n")
    robots = "".join(
        f'<robot x="{2 * number + 1}m" y="2m" program="{name}.c"/>'
        for number, name in enumerate(("good", "bad", "bad"))
    )
    world = f'<world version="1"><area length="9m" width="9m"/>{robots}</world>'
    Path("world.xml").write_text(world)
    assert main(["check", "world.xml"]) == 121
    shown = capfd.readouterr().err
    assert shown.count("bad.c:3:12: error: 'turn' is used, but not defined") == 1
    assert "3 files checked: 1 error" in shown
    assert main(["check", "good.c", "bad.c", "world.xml"]) == 121
    assert "3 files checked: " in capfd.readouterr().err
    Path("bad.c").write_text("int main(void) { return 1; }\n")
    assert main(["check", "world.xml"]) == 0
    assert capfd.readouterr().err == "3 files checked: 0 errors, 0 warnings\n"


def test_goals_that_no_robot_can_reach_are_warned_of(capfd: pytest.CaptureFixture[str]) -> None:
    wall = '<wall x1="2m" y1="0" x2="2m" y2="3m"/>'
    goal = '<goal id="there">\n<reach x="3m" y="1m" radius="20cm"/></goal>'
    robot = '<robot x="1m" y="1m"/>'
    world = f'<world version="1"><area length="4m" width="3m"/>\n{wall}{robot}{goal}</world>'
    Path("world.xml").write_text(world)
    assert main(["check", "world.xml"]) == 0
    shown = capfd.readouterr().err
    assert "world.xml:2: warning: goal 'there': no robot can get there" in shown
    Path("world.xml").write_text(world.replace(wall, ""))
    assert main(["check", "world.xml"]) == 0
    assert "warning:" not in capfd.readouterr().err


def test_channels_that_a_world_changes_are_described(capfd: pytest.CaptureFixture[str]) -> None:
    channels = """<communication>
        <channel name="radio" range="20m" delay="0s" jitter="0s" loss="0.1"/>
        <channel name="wire" bandwidth="1kB/s" delay="5ms" jitter="5ms" corruption="0.01"/>
        <shut channel="radio" at="1s" until="2s"/></communication>"""
    world = f'<world version="1"><area length="9m" width="9m"/>{channels}<robot x="1m" y="1m"/>'
    Path("world.xml").write_text(f"{world}</world>")
    assert main(["check", "world.xml"]) == 0
    lines = [line.split(": ", 1)[1] for line in capfd.readouterr().out.splitlines()]
    assert lines[1:4] == [
        "channel 'radio': range 20 m times 0.5 for each object in between, 14400 B/s, loss 10%",
        "channel 'wire': unlimited range, 1000 B/s, delay 5 to 10 ms, corruption 1% of bytes",
        "1 outage",
    ]
