"""What `docs/world-builder.md` shows works, in order."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from crs_cc.cli.main import main

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "world-builder.md"


def test_the_examples_run_in_order(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copy(ROOT / "worlds" / "room.xml", tmp_path)
    (tmp_path / "plan.svg").write_text(
        '<svg viewBox="0 0 400 300"><rect width="90" height="60"/></svg>'
    )
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": "page"}
    for kind, block in re.findall(r"```(python|sh)\n(.*?)```", PAGE.read_text(), re.DOTALL):
        if kind == "python":
            exec(block, names)
            continue
        for line in block.splitlines():
            words = line.partition("#")[0].split()
            assert words[0] == "crs"
            assert main(words[1:]) == 0, line
    printed = capsys.readouterr().out
    assert "0 set array\n" in printed
    assert main(["check", "-q", "room.xml", "hall.xml"]) == 0
