"""What `docs/python.md` shows works, in order, and is complete."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.sim.model.registry import devices

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "python.md"


def test_the_examples_run_in_order(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (copying,) = re.findall(r"^crs (samples copy .*)$", PAGE.read_text(), re.MULTILINE)
    assert main(copying.split()) == 0
    capsys.readouterr()
    names: dict[str, object] = {"__name__": "page"}
    blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(), re.DOTALL)
    for block in blocks:
        exec(block, names)
    printed = capsys.readouterr().out
    assert printed.startswith("<Session of room: 1 robot, 10 s>\n")
    assert "goal 'The crate is at the dock' met" in printed
    assert printed.endswith('<area length="8m" width="9m" edge="0.1m"/>\n')


def test_every_sensor_is_on_the_page() -> None:
    rows = re.findall(r"^\| `(\w+)` \| [^|]*\|$", PAGE.read_text(), re.MULTILINE)
    readable = {row.name for row in devices() if row.reading is not None}
    assert readable <= set(rows)
