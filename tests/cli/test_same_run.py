"""A run is a function of programs, world and seed, not of where and how it is started."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

import crs_cc
from crs_cc.cli.main import main

MAIN = """#include <assert.h>
#include <stdio.h>
#include "Nclient.h"
#include "sub/speed.h"
#include <shared.h>

static int asked(void) { return 1; }

int main(int argc, char **argv)
{
    int n;

    connect_robot(asked());
    for (n = 0; n < 5; n++) {
        vm(SPEED, SHARED + turn(), 0);
        gs();
    }
    printf("%s %d %s %s %s %s\\n", argv[0], argc, __FILE__, __BASE_FILE__, speed_file, shared_file);
    assert(argc > 0);
    return 0;
}
"""

TURN = """static int asked(void) { return 20; }
const char *turn_file = __FILE__;
int turn(void) { return asked(); }
"""

SPEED = """#include "unit.h"
static const char *speed_file = __FILE__;
int turn(void);
"""

UNIT = "#define SPEED (100 + 0 * sizeof __FILE__)\n"

SHARED = "#define SHARED 5\nstatic const char *shared_file = __FILE__;\n"

WORLD = """<world version="1" seed="7"><area length="5m" width="5m"/>
  <robot setup="noisy" x="2m" y="2m">
    <argument>fast</argument><argument>3</argument></robot></world>"""


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with a program of two files and three headers, and go there."""
    folder = tmp_path / "project"
    for name, text in {
        "drive.c": MAIN,
        "turn.c": TURN,
        "sub/speed.h": SPEED,
        "sub/unit.h": UNIT,
        "include/shared.h": SHARED,
        "room.xml": WORLD,
    }.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    monkeypatch.chdir(folder)
    return folder


def ran(
    capfd: pytest.CaptureFixture[str], place: str, *, include: str = ""
) -> tuple[str, dict[str, Any]]:
    """Run the program in a folder; return its output and all its results."""
    files = [f"{place}{name}" for name in ("drive.c", "turn.c", "room.xml")]
    status = main(["run", *files, "-I", include or f"{place}include", "--json"])
    out, err = capfd.readouterr()
    assert status == 0, err
    result = json.loads(out)
    del result["timing"], result["world"]
    for robot in result["robots"]:
        del robot["program"]  # named as the user named it, for messages
    return err, result


def test_a_program_by_another_path_is_the_same_run(
    project: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    first = ran(capfd, "")
    assert first[0].splitlines()[-1] == "drive 3 drive.c drive.c sub/speed.h shared.h"
    assert ran(capfd, "./") == first
    assert ran(capfd, "../project/") == first
    assert ran(capfd, f"{project}/", include="include") == first
    longer = project.parent / "another folder" / "of a longer name"
    shutil.copytree(project, longer)
    assert ran(capfd, f"{longer}/") == first
    monkeypatch.chdir(project.parent)
    assert ran(capfd, "project/") == first


def test_command_line_and_python_reach_the_same_state(
    project: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """Seed and arguments are the world's by default."""
    Path("one.c").write_text(MAIN.replace("#include <shared.h>", SHARED).replace("turn()", "20"))
    assert main(["run", "one.c", "room.xml", "--json"]) == 0
    told = json.loads(capfd.readouterr().out)
    program = crs_cc.compile_c(project / "one.c")
    session = crs_cc.Session(crs_cc.load_world(project / "room.xml"), [program])
    while session.step():
        pass
    assert told["seed"] == 7
    assert told["state_hash"] == session.state_hash()
    assert told["robots"][0]["fuel"] == int(session.inner.state.fuel[0])
