"""The examples in `docs/communication.md` work and match the code."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.sim.comms.inbox import INBOX, MAX_INCOMING
from crs_cc.sim.comms.outbox import MAX_MESSAGES
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.communication import HEAD_BYTES, MAX_QUEUE, PREDEFINED

ROOT = Path(__file__).parents[3]
PAGE = (ROOT / "docs" / "communication.md").read_text()
PAIR = '<robot x="0" y="0"/><robot x="1m" y="0"/>'
AREA = '<area length="90m" width="90m" origin="centre"/>'


def block(language: str) -> str:
    found = re.search(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)
    assert found
    return found[1]


def test_predefined_channels_are_lossless() -> None:
    assert not any(channel.loss or channel.burst_begin for channel in PREDEFINED)


def test_numbers_on_the_page_match_the_code() -> None:
    assert f"An inbox holds {INBOX} messages" in PAGE
    assert f"At most {MAX_INCOMING} messages can be in transit" in PAGE
    assert f"at most {MAX_MESSAGES} messages waiting" in PAGE
    assert f"{HEAD_BYTES} is the size of the header" in PAGE
    assert MAX_MESSAGES == MAX_QUEUE


def test_program_on_the_page_prints_the_documented_output(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("call.c").write_text(block("c"))
    Path("pair.xml").write_text(f'<world version="1">{AREA}{PAIR}</world>')
    assert main(["run", "-q", "call.c", "pair.xml", "--trace", "messages"]) == 0
    shown = capfd.readouterr()
    assert f"\n```\n{shown.out.replace('[robot1] ', '')}```\n" in PAGE
    assert f"\n```\n{shown.err}```\n" in PAGE


def test_world_file_on_the_page_is_valid() -> None:
    elements = f'{PAIR}<robot x="2m" y="0"/>{block("xml")}'
    communication = parse_world(
        f'<world version="1">{AREA}{elements}</world>'.encode(), "page"
    ).communication
    assert [channel.name for channel in communication.channels][3:] == ["acoustic"]
    assert communication.channels[0].walls == PREDEFINED[0].walls
    assert [(shut.sender, shut.receiver) for shut in communication.shuts] == [(-1, -1), (2, 0)]


def test_python_on_the_page_runs(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)
    exec(block("python"), {})
    assert capsys.readouterr().out == "0 0\n"


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ('<channel name="x" loss="1.5"/>', "loss"),
        ('<channel name="x" range="0"/>', "range: '0' must be greater than 0"),
        ('<channel name="x" queue="65"/>', "queue: '65' is not an integer from 1 to 64"),
        ('<channel name="x" delay="61s"/>', "delay: must be 60s or less"),
        ('<channel name="x" bandwidth="0.1"/>', "bandwidth: must be 1B/s or more"),
        ('<channel name="x" bandwidth="9 baud"/>', "is not a data rate (expected a number and one"),
        ('<channel name="x"/><channel name="x"/>', "duplicate channel 'x'"),
        ("".join(f'<channel name="x{n}"/>' for n in range(14)), "more than 16 channels"),
        ('<shut channel="x"/>', "shut, channel: unknown channel 'x'"),
        ('<shut from="nobody"/>', "shut, from: unknown robot 'nobody'"),
        ('<shut at="2s" until="2s"/>', "shut, until: must be later than at"),
        ("<shut/>" * 1001, "more than 1000 outages"),
    ],
)
def test_invalid_communication_is_rejected(
    text: str, wrong: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "wrong.xml"
    path.write_text(f'<world version="1">{AREA}{PAIR}<communication>{text}</communication></world>')
    assert main(["check", str(path)]) == 122
    shown = capfd.readouterr()
    assert wrong in shown.out + shown.err
    assert "wrong.xml:1" in shown.out + shown.err
