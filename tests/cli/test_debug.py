"""`crs debug` from the command line; its commands are tested in `tests/debug`."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.cli.main import main

COUNT = """#include <stdio.h>
int main(void)
{
    int i, sum = 0;
    for (i = 0; i < 3; i++)
        sum += i;
    printf("%d", sum);
    return sum;
}
"""


@pytest.fixture
def program(tmp_path: Path) -> str:
    path = tmp_path / "count.c"
    path.write_text(COUNT)
    return str(path)


def test_commands_on_the_command_line_are_executed_and_shown(
    program: str, capfd: pytest.CaptureFixture[str]
) -> None:
    words = ["debug", "--batch", "-ex", "break 6", "-ex", "continue", "-ex", "rs", program]
    assert main(words) == 0
    shown = capfd.readouterr().out.splitlines()
    assert shown[2] == "(crs) break 6"
    assert shown[4:6] == ["(crs) continue", f"Breakpoint 1, main () at {program}:6, t = 0.000 s"]
    assert shown[-1] == "=>    5      for (i = 0; i < 3; i++)"


def test_a_failed_command_is_one_line_and_sets_the_status(
    program: str, capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(["debug", "--batch", "-ex", "foo", "-ex", "next", program]) == 1
    shown = capfd.readouterr()
    assert 'Undefined command: "foo".  Try "help".' in shown.out.splitlines()
    assert "=>    5  " in shown.out
    assert not shown.err


def test_after_the_end_execution_can_be_reversed(
    program: str, capfd: pytest.CaptureFixture[str]
) -> None:
    main(["debug", "--batch", "-ex", "continue", "-ex", "reverse-step", program])
    shown = capfd.readouterr().out.splitlines()
    end = shown.index("All programs have ended: robot0 exited with 3. Step back, or quit.")
    assert shown[end - 1] == "3"
    assert shown[-1] == "=>    8      return sum;"


def test_an_invalid_command_line_is_rejected(
    program: str, capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(["debug"]) == 2
    assert main(["debug", "-x", "none.dbg", program]) == 2
    assert main(["debug", "none.c"]) == 121
    assert "Traceback" not in capfd.readouterr().err


@pytest.mark.parametrize(("words", "end_s"), [([], "0.5"), (["--max-time", "0.2"], "0.2")])
def test_a_run_ends_when_its_world_or_max_time_says(
    tmp_path: Path, words: list[str], end_s: str, capfd: pytest.CaptureFixture[str]
) -> None:
    path, world = tmp_path / "wait.c", tmp_path / "world.xml"
    path.write_text("int main(void) { for (;;) ; }\n")
    world.write_text(
        '<world version="1" duration="0.5s"><area length="4m" width="4m"/>'
        '<robot x="2m" y="2m"/></world>'
    )
    main(["debug", "--batch", "-ex", "continue", *words, str(path), str(world)])
    assert capfd.readouterr().out.endswith(f"the run ends at {end_s} s\n")
