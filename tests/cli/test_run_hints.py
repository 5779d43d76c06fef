"""Hints at mistakes that show only in a run."""

import json
import weakref
from pathlib import Path

import pytest

from crs_cc.cli import run_hints, simulate
from crs_cc.cli.main import main
from crs_cc.runtime.fleet import Fleet

HASTY = """#include <Nclient.h>
int main(void)
{
    connect_robot(1, MODEL_SCOUT, "", 0);
    vm(900, 100, 0);
    vm(100, 900, 0);
    st();
    ws(1, 1, 0, 9);
    pr(100, 100, 0);
    pr(50, 50, 0);
    return 0;
}
"""

PATIENT = """#include <Nclient.h>
int main(void)
{
    int i;

    connect_robot(1, MODEL_SCOUT, "", 0);
    for (i = 0; i < 2; i++) {
        pr(20, 20, 0);
        ws(1, 1, 0, 9);
    }
    pr(20, 20, 0);
    while (State[STATE_MOTOR_STATUS])
        gs();
    pr(20, 20, 0);
    gs();
    pr(-20, -20, 0);
    ws(1, 1, 0, 9);
    vm(300, 300, 0);
    st();
    return 0;
}
"""


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("hasty.c").write_text(HASTY)
    Path("patient.c").write_text(PATIENT)


def test_each_doubtful_call_is_hinted_at_once(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "hasty.c", "--json"]) == 0
    shown = capfd.readouterr()
    found = json.loads(shown.out)["diagnostics"]
    assert [(each["line"], each["flag"]) for each in found] == [
        (5, "speed-limit"), (10, "unfinished-move"),
    ]  # fmt: skip
    assert "'vm' asks for a speed of 900, but this robot's limit is 394" in shown.err
    assert "'pr' replaces another 'pr' that would run for " in shown.err


def test_a_program_that_ends_before_its_move_is_hinted_at(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("hasty.c").write_text(HASTY.replace("pr(50, 50, 0);", ""))
    assert main(["run", "hasty.c", "-Wno-speed-limit"]) == 0
    shown = capfd.readouterr().err
    assert shown.count("warning:") == 1
    assert "s before its last 'pr' is done [-Wunfinished-move]" in shown


def test_hints_are_switched_off(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "hasty.c", "-q", "--json"]) == 0
    shown = capfd.readouterr()
    assert json.loads(shown.out)["diagnostics"] == []
    assert "warning" not in shown.err


def test_a_program_that_waits_gets_no_hint(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "patient.c"]) == 0
    assert "warning" not in capfd.readouterr().err


def test_a_run_and_its_repetitions_free_their_programs_when_they_end(
    fleets: list[weakref.ref[Fleet]],
) -> None:
    assert main(["run", "patient.c", "--record", "run.mcap", "-q"]) == 0
    assert main(["replay", "run.mcap", "--verify"]) == 0
    assert main(["debug", "run.mcap", "--batch", "-ex", "continue"]) == 0
    assert [each() for each in fleets] == [None] * 3


def test_a_silent_run_without_a_limit_reports_its_progress(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    Path("silent.c").write_text(
        "#include <Nclient.h>\nint main(void) {\n"
        '    int i;\n    connect_robot(1, MODEL_SCOUT, "", 0);\n'
        "    for (i = 0; i < 500; i++)\n        gs();\n    return 0;\n}\n"
    )
    monkeypatch.setattr(run_hints, "SILENT_S", 0.0)
    assert main(["run", "silent.c"]) == 0
    assert "warning" not in capfd.readouterr().err  # it is over soon
    monkeypatch.setattr(run_hints, "SILENT_SIMULATED_S", 4.0)
    assert main(["run", "silent.c"]) == 0
    shown = capfd.readouterr().err
    assert "silent.c:6:9: warning: no output for 4 simulated s and no end at " in shown
    monkeypatch.setattr(simulate, "is_terminal", lambda _stream: True)
    assert main(["run", "silent.c"]) == 0
    shown = capfd.readouterr().err
    assert "silent.c:6:9: warning: no output for 0 s and no end at " in shown
    assert shown.count("[-Wsilent-run]") == 1
    assert main(["run", "silent.c", "--max-time", "99"]) == 0
    assert "warning" not in capfd.readouterr().err


ORDER = """#include <stdio.h>
#include <stdlib.h>
static int pool[8], other[8];
static int is_of_pool(int *p) { return p >= pool && p < pool + 8; }
int main(void)
{
    int own[2];
    printf("%d", is_of_pool(pool + 8));
    printf("%d", is_of_pool(other + 2));
    printf("%d", is_of_pool(own));
    printf("%d\\n", is_of_pool(NULL));
    ENDING
}
"""
COMPARED = "order.c:4:40: warning: pointers to different objects are compared: one points to"


@pytest.mark.parametrize(("ending", "status"), [("return 0;", 0), ("abort();", 123)])
def test_the_first_comparison_of_unrelated_pointers_is_hinted_at(
    ending: str, status: int, capfd: pytest.CaptureFixture[str]
) -> None:
    Path("order.c").write_text(ORDER.replace("ENDING", ending))
    assert main(["run", "order.c"]) == status
    shown = capfd.readouterr()
    assert shown.out == "0000\n"
    assert shown.err.count("warning:") == 1
    assert f"{COMPARED} 'other', the other to 'pool' [-Wpointer-order]" in shown.err


def test_variables_of_functions_that_were_compared_are_not_named(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("order.c").write_text(ORDER.replace("other + 2", "pool").replace("ENDING", ""))
    assert main(["run", "order.c"]) == 0
    assert "pointers to different objects are compared [-Wpointer-order]" in capfd.readouterr().err
