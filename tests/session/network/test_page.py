"""The examples of `docs/sockets.md` work."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.session.network.operations import TIMEOUT_S
from crs_cc.sim.files.world_xml import parse_world

PAGE = (Path(__file__).parents[3] / "docs" / "sockets.md").read_text()


def blocks(language: str) -> list[str]:
    found = re.findall(r"^```(\w*)\n(.*?)^```$", PAGE, re.DOTALL | re.MULTILINE)
    return [text for each, text in found if each == language]


def test_the_example_prints_what_the_page_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for name, text in zip(("greeter.c", "visitor.c"), blocks("c"), strict=True):
        Path(name).write_text(text)
    Path("pair.xml").write_text(blocks("xml")[0])
    assert main(blocks("sh")[0].split()[1:]) == 0
    printed, script = blocks("")
    assert capfd.readouterr().out == printed
    Path("script.txt").write_text(script)
    assert main(blocks("sh")[1].split()[1:]) == 0


def test_the_latency_on_the_page_is_read_and_the_default_is_as_it_says() -> None:
    world = '<world version="1"><area length="4m" width="4m"/><robot x="1m" y="1m"/>{}</world>'
    for element, latency_s in ((blocks("xml")[1], 0.02), ("", 0.002)):
        found = parse_world(world.format(element).encode(), "page")
        assert found.communication.network_latency_s == latency_s
    assert f"after {TIMEOUT_S:.0f} s" in PAGE
