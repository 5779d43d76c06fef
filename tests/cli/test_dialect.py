"""`--dialect`, and the dialect of a robot in a world file."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.cli.main import main

BODY = 'heatSensorCheck();\nprintf("%ld\\n", State[STATE_HEAT]);\nreturn(4);\n'
RUNCODE = (
    'void runcode()\n{\n    sonarSensorCheck();\n    printf("%ld\\n", State[STATE_SONAR_0]);\n}\n'
)
VENDORS = '#include "Nclient.h"\nint main(void) { connect_robot(1); get_sn(); return State[17]; }\n'
WORLD = """<world version="1"><area length="60m" width="60m" origin="centre" edge="0"/>
<cylinder x="0" y="1m" radius="10cm" heat="5"/><robot x="0" y="0"{}/></world>"""


@pytest.fixture(autouse=True)
def in_a_folder_with_programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name, text in (("body", BODY), ("runcode", RUNCODE), ("vendors", VENDORS)):
        Path(f"{name}.c").write_text(text)
    Path("world.xml").write_text(WORLD.format(""))


def test_a_body_runs_with_the_requested_dialect(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "--dialect", "report", "body.c", "world.xml"]) == 4
    assert capfd.readouterr() == ("5\n", "")


def test_a_body_without_the_dialect_gets_a_hint(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "body.c"]) == 121
    assert "--dialect report" in capfd.readouterr().err
    assert main(["run", "--dialect", "nomad", "body.c"]) == 121
    Path("vendors.c").write_text(VENDORS.replace("return", "retrun"))
    capfd.readouterr()
    assert main(["run", "vendors.c"]) == 121
    assert "--dialect" not in capfd.readouterr().err


def test_runcode_determines_its_dialect(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "runcode.c"]) == 0
    assert capfd.readouterr() == ("-1\n", "")


def test_the_vendors_header_determines_it_too() -> None:
    assert main(["run", "-q", "vendors.c"]) == 255


def test_a_world_file_sets_the_dialect_of_each_robots_program(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("both.xml").write_text(
        WORLD.format(' program="body.c" dialect="report"').replace(
            "</world>", '<robot id="other" x="5m" y="0" program="vendors.c"/></world>'
        )
    )
    assert main(["run", "-q", "both.xml"]) == 1
    assert capfd.readouterr().out == "[robot0] 5\n"
    Path("odd.xml").write_text(WORLD.format(' dialect="java"'))
    assert main(["check", "odd.xml"]) == 122
    assert "dialect" in capfd.readouterr().err


def test_the_command_line_overrides_the_world(capfd: pytest.CaptureFixture[str]) -> None:
    Path("world.xml").write_text(WORLD.format(' dialect="nomad"'))
    assert main(["run", "body.c", "world.xml"]) == 121
    assert main(["run", "--dialect", "report", "body.c", "world.xml"]) == 4


def test_check_detects_the_dialect_of_files_and_of_parts_by_the_others(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("part.c").write_text("int look(void) { sonarSensorCheck(); return State[STATE_HEAT]; }\n")
    assert main(["check", "runcode.c", "part.c"]) == 0
    assert capfd.readouterr().err == "2 files checked: 0 errors, 0 warnings\n"
    assert main(["check", "runcode.c", "vendors.c"]) == 0
    assert main(["check", "part.c"]) == 121
    assert main(["check", "--dialect", "report", "part.c", "body.c"]) == 0


def test_compile_shows_the_body_as_runcode(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["compile", "--dialect", "report", "body.c"]) == 0
    assert "runcode" in capfd.readouterr().out
    assert main(["compile", "--emit", "wat", "runcode.c"]) == 0


def test_an_unknown_dialect_is_rejected(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "--dialect", "java", "body.c"]) == 2
    assert "java" in capfd.readouterr().err
