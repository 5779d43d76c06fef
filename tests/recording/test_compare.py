"""Two recorded runs are compared up to the first timestep in which they differ."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.cli.main import main

PROGRAM = """
#include <Nclient.h>

int turns, limit = LIMIT;

int main(void)
{
    connect_robot(1);
    while (State[STATE_CONF_X] < limit) {
        turns++;
        vm(100, 100, 0);
    }
    st();
    for (;;)
        gs();
}
"""
WORLD = (
    '<world version="1" timestep="{}"><area length="9m" width="9m"/><robot x="2m" y="3m"/></world>'
)


@pytest.fixture(scope="module")
def runs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("compared")
    (folder / "drive.c").write_text(PROGRAM)
    (folder / "world.xml").write_text(WORLD.format("50ms"))
    (folder / "slow.xml").write_text(WORLD.format("100ms"))
    for name, world, limit, seconds in (
        ("near", "world", 40, 4), ("far", "world", 80, 4), ("short", "world", 40, 2),
        ("slow", "slow", 40, 2),
    ):  # fmt: skip
        words = [f"{folder / 'drive.c'}", f"{folder / world}.xml", "-D", f"LIMIT={limit}"]
        target = str(folder / f"{name}.mcap")
        assert main(["run", "-q", *words, "--max-time", str(seconds), "--record", target]) == 0
    return folder


def compared(
    runs: Path, here: str, there: str, capfd: pytest.CaptureFixture[str]
) -> tuple[int, str]:
    capfd.readouterr()
    status = main(["replay", str(runs / f"{here}.mcap"), "--compare", str(runs / f"{there}.mcap")])
    shown = capfd.readouterr()
    return status, (shown.out + shown.err).replace(f"{runs}/", "")


def test_programs_that_start_differently_differ_from_the_start(
    runs: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    status, shown = compared(runs, "near", "far", capfd)
    assert status == 125
    assert shown.splitlines() == [
        "the first difference is at 0.000 s (timestep 0):",
        "  near.mcap | far.mcap",
        "  robot0 limit: 40 | 80",
        "to investigate, run: crs debug near.mcap --at 0s",
    ]


def test_the_first_timestep_and_the_variables_that_differ_are_shown(
    runs: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    changed = tmp_path / "changed.mcap"
    commands = ["goto 1.5s", "set var turns = 1000", "goto 2s", f"save run {changed}"]
    words = [word for command in commands for word in ("-ex", command)]
    assert main(["debug", str(runs / "near.mcap"), "--batch", *words]) == 0
    capfd.readouterr()
    assert main(["replay", str(runs / "near.mcap"), "--compare", str(changed)]) == 125
    head, _, *rows, _ = capfd.readouterr().out.splitlines()
    assert head == "the first difference is at 1.550 s (timestep 31):"
    (turns,) = [row for row in rows if row.startswith("  robot0 turns: ")]
    assert "| 100" in turns


def test_identical_runs_have_no_difference_in_their_common_part(
    runs: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    status, shown = compared(runs, "near", "short", capfd)
    assert status == 0
    assert shown.splitlines() == [
        "near.mcap, short.mcap: no difference up to 2.00 s",
        "  near.mcap continues to 4.00 s",
    ]


def test_runs_with_different_timesteps_are_rejected(
    runs: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    status, shown = compared(runs, "near", "slow", capfd)
    assert status == 120
    assert "slow.mcap: error: its timestep is 0.1 s, not 0.05 s" in shown
    status, shown = compared(runs, "near", "missing", capfd)
    assert "missing.mcap: error: cannot be read: No such file or directory" in shown
