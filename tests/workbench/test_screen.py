"""Commands of pages, without a browser: permissions, and effects on the run."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from websockets.sync.client import ClientConnection, connect

from crs_cc.cli.debug_options import DebugOptions
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.start_view import screen_of
from crs_cc.cli.view_recording import recording_screen
from crs_cc.recording.recording import Recording
from crs_cc.workbench.commands import TABLE
from crs_cc.workbench.frame_blocks import unpacked
from crs_cc.workbench.screen import Screen
from tests.workbench.in_browser import played

PROGRAM = """\
#include <Nclient.h>
#include <stdio.h>

int main(void)
{
    int i = 0;

    connect_robot(1);
    vm(100, 100, 0);
    for (;;) {
        get_sn();
        printf("%d\\n", i++);
    }
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="9m" width="4m"/>
  <robot x="1m" y="1m"/>
</world>
"""


class Page:
    """A page without a browser: sends commands, and stores the received messages."""

    def __init__(self, line: ClientConnection) -> None:
        self.line, self.number = line, 0
        self.told: dict[str, Any] = {}
        self.blocks: dict[int, bytes] = {}
        self.take_until(lambda: "hello" in self.told and "state" in self.told)

    def take_until(self, is_there: Callable[[], bool]) -> None:
        while not is_there():
            data = self.line.recv(20)
            if isinstance(data, str):
                message = json.loads(data)
                self.told[message["type"]] = message
            elif data[:1] == b"B":
                self.blocks[int.from_bytes(data[1:5], "little")] = data[5:]

    def ask(self, name: str, **fields: Any) -> Any:
        self.number += 1
        self.line.send(json.dumps({"id": self.number, "command": name, **fields}))
        self.take_until(lambda: self.told.get("answer", {}).get("id") == self.number)
        return self.told["answer"]

    def error(self, name: str, **fields: Any) -> str:
        return str(self.ask(name, **fields)["error"])


@contextmanager
def page_of(screen: Screen, role: str = "control") -> Iterator[Page]:
    words = ["crs.1", f"token.{screen.server.tokens[role]}"]  # type: ignore[index]
    url = f"ws://127.0.0.1:{screen.server.port}/channel"
    with connect(url, subprotocols=words, proxy=None, max_size=None) as line:  # type: ignore[arg-type]
        yield Page(line)


@pytest.fixture(scope="module")
def live(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Screen]:
    folder = tmp_path_factory.mktemp("screen")
    (folder / "go.c").write_text(PROGRAM)
    (folder / "room.xml").write_text(WORLD)
    files = Inputs((folder / "go.c",), folder / "room.xml")
    with played(screen_of(DebugOptions(inputs=files, quiet=True), 0)) as screen:
        yield screen


def test_a_command_is_checked_before_it_reaches_the_run(live: Screen) -> None:
    with page_of(live) as page:
        assert page.error("plaiy").startswith("unknown command 'plaiy'")
        assert page.error("seek") == "'time_s' must be a float"
        assert page.error("seek", time_s="1") == "'time_s' must be a float"
        assert page.error("seek", time_s=True) == "'time_s' must be a float"
        assert page.error("select", robot=7).startswith("unknown robot '7'")
        assert page.error("speed", speed=1e9).startswith("the speed must be 0.01 to 1000")
        assert page.error("console", line="x" * 5000) == "'line' is longer than 4000 characters"
        assert page.error("frames", block=10**6).startswith("no block 1000000")
        assert page.error("break", file="go.c", line=10**6).startswith("go.c has no code")


def test_the_viewing_token_does_not_permit_control(live: Screen) -> None:
    with page_of(live, "view") as page:
        for name, row in TABLE.items():
            if row.controls:
                assert "view-only" in page.error(name), name
        assert page.told["hello"]["role"] == "view"


@pytest.mark.parametrize(
    "line", ["source x", "save breakpoints x", "save run x.mcap", "quit", "shell ls", "so x"]
)
def test_the_console_rejects_commands_that_access_files_or_end_the_run(
    live: Screen, line: str
) -> None:
    with page_of(live) as page:
        assert page.error("console", line=line).endswith("is not available in the browser")


@pytest.mark.parametrize("line", ["source x", "save breakpoints x.dbg", "save run x.mcap"])
def test_commands_for_each_robot_cannot_access_files(live: Screen, line: str) -> None:
    with page_of(live) as page:
        *_, (kind, text) = page.ask("console", line=f"robot apply all {line}")["value"]["lines"]
        assert kind == "error"
        assert text.endswith("is not available in the browser")


@pytest.mark.parametrize("line", ["source /", "so /", "save breakpoints /", "save run /"])
def test_completion_lists_no_files(live: Screen, line: str) -> None:
    with page_of(live) as page:
        assert page.ask("complete", line=line)["value"]["words"] == []
        assert "save" in page.ask("complete", line="sa")["value"]["words"]


def test_commands_at_a_breakpoint_cannot_access_files(live: Screen) -> None:
    point = {"line": 9, "condition": "", "log": "", "robot": -1, "ignore": 0, "enabled": True}
    with page_of(live) as page:
        page.take_until(lambda: "position" in page.told)
        point["file"] = page.told["position"]["file"]
        for line in ("source x", "info world\nsave breakpoints x", "shell ls"):
            said = page.error("breakpoint", commands=line, **point)
            assert said.endswith("is not available in the browser")
        page.take_until(lambda: page.told["position"]["breakpoints"] == [])
        page.ask("breakpoint", commands="silent\nprint i", **point)
        page.take_until(lambda: len(page.told["position"]["breakpoints"]) == 1)
        assert page.told["position"]["breakpoints"][0]["commands"] == "silent\nprint i"
        page.ask("break", file=point["file"], line=9)


def test_stepping_seeking_and_frames_agree(live: Screen) -> None:
    with page_of(live) as page:
        page.ask("step", timesteps=40)
        page.take_until(lambda: page.told["state"]["t"] == pytest.approx(2.0))
        page.ask("seek", time_s=0.5)
        page.take_until(lambda: page.told["state"]["t"] == pytest.approx(0.5))
        assert page.told["state"]["end"] == pytest.approx(2.0)
    with page_of(live) as late:
        blocks = late.told["hello"]["blocks"]
        for number, begin_s, end_s in blocks:
            late.ask("frames", block=number)
            times_s, _ = unpacked(late.blocks[number])
            assert (times_s[0], times_s[-1]) == pytest.approx((begin_s, end_s))
        assert blocks[-1][2] == pytest.approx(2.0)
        assert len(late.told["hello"]["output"]) > 5


def test_a_change_discards_the_future_of_pages_too(live: Screen) -> None:
    with page_of(live) as page:
        page.ask("step", timesteps=20)
        page.ask("seek", time_s=0.5)
        assert page.ask("console", line="move robot0 to 4 2")["value"]["lines"]
        page.take_until(lambda: "truncate" in page.told)
        assert page.told["truncate"]["time_s"] == pytest.approx(0.5)
        page.ask("step", timesteps=1)
        page.take_until(lambda: page.told["state"]["end"] == pytest.approx(0.55))
    with page_of(live) as late:
        number = late.told["hello"]["blocks"][-1][0]
        late.ask("frames", block=number)
        _, frames = unpacked(late.blocks[number])
        assert frames[-1, 0, 0] == pytest.approx(4.0, abs=0.1)


def test_pause_interrupts_an_endless_command(live: Screen) -> None:
    with page_of(live) as page:
        page.line.send(json.dumps({"id": 900, "command": "console", "line": "continue"}))
        page.take_until(lambda: page.told["state"]["busy"])
        page.line.send(json.dumps({"id": 901, "command": "pause"}))
        page.take_until(lambda: page.told.get("answer", {}).get("id") == 900)
        page.take_until(lambda: not page.told["state"]["busy"])
        stood = live.run.time_s
        assert page.ask("step", timesteps=1)["value"] is None  # nothing is left of the interrupt
        assert live.run.time_s == pytest.approx(stood + 0.05, abs=0.05)


def test_a_run_ends_at_the_given_time(tmp_path: Path) -> None:
    (tmp_path / "go.c").write_text(PROGRAM)
    (tmp_path / "room.xml").write_text(WORLD)
    files = Inputs((tmp_path / "go.c",), tmp_path / "room.xml")
    screen = screen_of(DebugOptions(inputs=files, quiet=True, max_time_s=0.52), 0)
    assert not screen.run.advance(100)
    assert screen.run.time_s == pytest.approx(0.55)  # ends at 0.52 s or later
    assert (screen.run.halt.reason, screen.run.halt.text) == ("end", "the run ends at 0.55 s")
    screen.run.seek(0.2)
    assert screen.run.shell().debugger.resume().reason == "end"
    screen.server.close()


@pytest.fixture
def replayed(recorded: Path) -> Iterator[Screen]:
    with ExitStack() as stack:
        recording = Recording(recorded)
        stack.callback(recording.close)
        with played(recording_screen(recording, 0, stack)) as screen:
            yield screen


def test_a_recording_is_played_by_the_same_channel(recorded: Path, replayed: Screen) -> None:
    recording = Recording(recorded)
    with page_of(replayed) as page:
        hello = page.told["hello"]
        assert [event[1] for event in hello["events"]] == ["collision", "exited"]
        assert hello["events"][0][3] == "robot0 touched crate"
        page.ask("seek", time_s=2.0)
        page.take_until(lambda: page.told["status"]["t"] == pytest.approx(2.0))
        row, sensors = page.told["status"]["robots"][0], page.told["status"]["sensors"]
        frames = list(recording.frames(1_800_000_000, 2_000_000_000))
        way_m = np.hypot(*(frames[-1].values[:2, 0] - frames[0].values[:2, 0]))
        assert row["speed"] == pytest.approx(way_m / 0.2, rel=0.35)
        assert len(sensors["echoes"][0]) == 16
        page.ask("speed", speed=0.0)
        page.ask("play")
        page.take_until(lambda: page.told["state"]["halt"]["reason"] == "end")
        assert page.told["state"]["t"] == pytest.approx(recording.end_ns / 1e9)
        assert "position" not in page.told  # programs run again only for who asks
    recording.close()


def test_programs_in_a_recording_can_be_inspected_stepped_and_changed(replayed: Screen) -> None:
    with page_of(replayed) as page:
        end_s = page.told["state"]["end"]
        page.ask("seek", time_s=2.0)
        page.ask("sync")
        page.take_until(lambda: page.told.get("position", {}).get("t") == pytest.approx(2.0))
        assert page.told["position"]["frames"][-1]["function"] == "main"
        rows = page.ask("values", unfolded="locals")["value"][1]["children"]
        values = {each["name"]: each["value"] for each in rows}
        page.ask("console", line="reverse-next 3")
        assert page.ask("console", line="print i")["value"]["lines"] == [
            ["text", f"$1 = {values['i']}"]
        ]
        assert page.told["state"]["end"] == end_s
        assert "truncate" not in page.told
        assert len(page.told["hello"]["events"]) == 2
        page.ask("seek", time_s=1.0)
        page.ask("console", line="turn robot0 to 90")
        page.take_until(lambda: "truncate" in page.told)
        assert page.told["truncate"]["time_s"] == pytest.approx(1.0)
        page.ask("speed", speed=0.0)
        page.ask("play")
        page.take_until(lambda: page.told["state"]["halt"]["reason"] == "end")
    with page_of(replayed) as late:
        events = late.told["hello"]["events"]
        assert [event[1] for event in events] == ["collision", "bumper-pressed", "exited"]
        assert "edge-north" in events[0][3]  # and no crate any more
        assert late.told["hello"]["output"][0][3] == "told go\n"
