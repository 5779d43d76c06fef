"""`--live`: a map on a terminal, one message where there is none, and the same run."""

from __future__ import annotations

import io
import json
import os
import re
import shutil
import sys
from pathlib import Path

import pytest

from crs_cc.cli.main import main

PROGRAM = """
#include <Nclient.h>
#include <stdio.h>
#include <unistd.h>
int main(void) { connect_robot(1); vm(300, 300, 0); sleep(2); puts("there"); return 0; }
"""
WORLD = """<world version="1" timestep="100ms"><area length="2m" width="2m"/>
  <robot x="1m" y="1m"/></world>
"""


class Screen(io.StringIO):
    def isatty(self) -> bool:
        return True


def run(folder: Path, *options: str) -> None:
    (folder / "drive.c").write_text(PROGRAM)
    (folder / "room.xml").write_text(WORLD)
    files = [str(folder / name) for name in ("drive.c", "room.xml")]
    assert main(["run", *files, "--live", "--json", "--no-summary", *options]) == 0


def test_a_live_map_changes_nothing_and_needs_a_terminal(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    run(tmp_path)
    said = capfd.readouterr()
    assert said.err.count("crs: no live map: standard error is not a terminal") == 1
    state = json.loads(said.out)["state_hash"]
    screen, sizes = Screen(), iter([(80, 24)] * 4)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "stderr", screen)
        patch.setenv("TERM", "xterm-256color")
        size = lambda: os.terminal_size(next(sizes, (60, 30)))  # noqa: E731 - it has become smaller
        patch.setattr(shutil, "get_terminal_size", size)
        patch.setattr("crs_cc.cli.live_map.INTERVAL_S", 0.0)
        patch.setattr(screen, "buffer", sys.__stderr__.buffer, raising=False)  # type: ignore[union-attr]
        run(tmp_path, "--quiet")
    assert json.loads(capfd.readouterr().out)["state_hash"] == state
    drawn = screen.getvalue()
    assert "\x1b[17;24r\x1b[17;1H" in drawn
    assert "\x1b[21;30r\x1b[21;1H" in drawn
    assert drawn.endswith("\x1b7\x1b[r\x1b8")
    last = drawn[drawn.rindex("\x1b[1;1H") :]
    rows = [re.sub(r"\x1b\[[0-9;]*m", "", row) for row in re.split(r"\x1b\[\d+;1H", last)[1:]]
    assert len(rows) == 20
    assert all(len(row.partition("\x1b")[0]) <= 60 for row in rows)
    assert any("✗" in row for row in rows)  # it has reached the wall
    assert "0 of 1 running" in rows[-1]


def test_a_small_terminal_is_rejected(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    from crs_cc.cli.live_map import reason_against

    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(shutil, "get_terminal_size", lambda: os.terminal_size((80, 5)))
    assert reason_against(Screen()) == "it needs 30 columns and 12 lines, there are 80, 5"
    monkeypatch.setenv("TERM", "dumb")
    assert reason_against(Screen()) == "the terminal does not support it"
