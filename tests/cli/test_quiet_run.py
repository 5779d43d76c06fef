"""`crs run` shows the same whether it skips quiet time or not."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from crs_cc.cli.main import main
from crs_cc.sim.engine.environment import Environment
from tests.session.test_quiet_time import PROGRAMS

WORLD = """<world version="1" seed="3"><area length="5m" width="4m"/>
<robot id="left" x="1m" y="2m" setup="noisy"><argument>1</argument></robot>
<robot id="right" x="4m" y="2m" heading="180deg"><argument>2</argument></robot></world>"""


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("pair.xml").write_text(WORLD)
    for name, text in PROGRAMS.items():
        Path(f"{name.replace(' ', '_')}.c").write_text(text)


def shown(
    arguments: list[str], capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> list[tuple[Any, ...]]:
    """Run with and without quiet time skipped; return exit status, output and result of both."""
    found = []
    for skips in (True, False):
        monkeypatch.setattr(Environment, "skips_quiet_time", skips)
        status = main(["run", *arguments, "pair.xml"])
        out, err = capfd.readouterr()
        data = json.loads(out) if "--json" in arguments else {}
        data.pop("timing", None)
        found.append((status, data or out, err))
    return found


@pytest.mark.parametrize("name", ["prints", "anything", "fails", "computes", "idle"])
@pytest.mark.parametrize("max_time", ["0.001", "0.3", "9.37"])
def test_results_output_and_exit_status_are_the_same(
    name: str,
    max_time: str,
    capfd: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    arguments = ["--json", "--max-time", max_time, f"{name}.c"]
    skipping, whole = shown(arguments, capfd, monkeypatch)
    assert skipping == whole
    assert skipping[1]["robots"]


@pytest.mark.parametrize("what", ["requests", "messages"])
def test_traces_are_the_same(
    what: str, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    arguments = ["--trace", what, "--max-time", "4", "waits_for_messages.c"]
    skipping, whole = shown(arguments, capfd, monkeypatch)
    assert skipping == whole
    assert len(skipping[2].splitlines()) >= {"requests": 160, "messages": 2}[what]


@pytest.mark.parametrize("name", ["prints", "anything"])
@pytest.mark.parametrize("every", ["50ms", "150ms"])
def test_a_run_at_some_speed_has_the_recording_of_one_as_fast_as_possible(
    name: str, every: str
) -> None:
    run = ["run", f"{name}.c", "pair.xml", "--max-time", "9.37", "--record-every", every]
    for speed in ("max", "100"):
        main([*run, "--speed", speed, "--record", f"{speed}.mcap"])
    assert Path("max.mcap").read_bytes() == Path("100.mcap").read_bytes()
