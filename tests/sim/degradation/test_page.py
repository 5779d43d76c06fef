"""What `docs/degradation.md` shows is complete and works."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.degradation import Degradation

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "degradation.md"


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text(), re.DOTALL)


def test_every_kind_of_fault_is_on_the_page() -> None:
    text = PAGE.read_text()
    for name in ("gain", "bias", "noise", "step", "stuck", "delay", "dropouts", "dead"):
        assert f"| `{name}` |" in text
    for name in Degradation.__dataclass_fields__:
        assert f"`{name.removesuffix('_s')}`" in text, name


def test_the_world_of_the_page_is_the_world_that_comes_with_crs() -> None:
    (shown_here,) = blocks("xml")
    whole = (ROOT / "worlds" / "faulty.xml").read_text()
    assert shown_here.strip() in whole
    assert len(load_world(ROOT / "worlds" / "faulty.xml").degradations) == 3


def test_the_commands_of_the_page_run(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.chdir(ROOT)
    for line in "".join(blocks("sh")).splitlines():
        command = shlex.split(line.replace("docs/images", str(tmp_path)))
        assert main([*command[1:], *([] if "--trace" in command else ["--max-time", "1"])]) == 0
    told = capfd.readouterr()
    for line in blocks("text")[0].splitlines():
        assert line in told.out + told.err


def test_the_picture_is_that_of_the_world() -> None:
    text = (ROOT / "docs" / "images" / "faulty.svg").read_text()
    assert "distrust.c in faulty.xml" in text


def test_the_lines_of_python_run(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)
    (program,) = blocks("python")
    exec(program, {})
    assert capsys.readouterr().out.splitlines() == re.findall(r"^# (.*)$", program, re.MULTILINE)
