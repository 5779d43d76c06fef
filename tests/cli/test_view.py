"""`crs view`, and runs that show themselves by `crs run --view`."""

from __future__ import annotations

import io
import json
import os
import signal
import subprocess
import sys
import threading
from contextlib import ExitStack, closing, redirect_stderr
from pathlib import Path

import pytest
from websockets.sync.client import connect

from crs_cc.cli import start_view
from crs_cc.cli.changed_run import recorded_changes
from crs_cc.cli.main import main
from crs_cc.cli.view_address import address_of, announced
from crs_cc.recording.recording import Recording
from crs_cc.workbench.clients import Client
from crs_cc.workbench.screen import Screen
from crs_cc.workbench.server import Server
from tests.cli.machines import free_port
from tests.cli.shown_run import page_of
from tests.commands import crs

PROGRAM = """\
#include <Nclient.h>
#include <stdio.h>

int main(void)
{
    int i;

    connect_robot(1);
    vm(100, 60, 0);
    for (i = 0; i < 40; i++)
        get_sn();
    printf("done\\n");
    return 0;
}
"""


@pytest.fixture
def program(tmp_path: Path) -> str:
    path = tmp_path / "go.c"
    path.write_text(PROGRAM)
    return str(path)


class Silent:
    def greet(self, client: Client) -> None:
        pass

    def receive(self, client: Client, command: object) -> None:
        pass


def test_a_run_that_is_shown_is_the_same_run(
    program: str, capfd: pytest.CaptureFixture[str]
) -> None:
    runs = []
    for extra in ([], ["--view"]):
        assert main(["run", program, "--json", *extra]) == 0
        shown = capfd.readouterr()
        runs.append(json.loads(shown.out))
        assert ("crs: open http://127.0.0.1:" in shown.err) == bool(extra)
    assert runs[0]["state_hash"] == runs[1]["state_hash"]


def test_a_page_can_pause_a_run_that_runs_by_itself(program: str) -> None:
    thread = threading.Thread(target=main, args=(["run", program, "--speed", "0.01", "--view"],))
    said = io.BytesIO()
    with redirect_stderr(io.TextIOWrapper(said, write_through=True)):
        thread.start()
        port, token = page_of(thread, said)
    words = ["crs.1", f"token.{token}"]
    url = f"ws://127.0.0.1:{port}/channel"
    with connect(url, subprotocols=words, proxy=None) as page:  # type: ignore[arg-type]
        hello = json.loads(page.recv(20))
        assert hello["can"] == ["change", "play"]
        page.send(json.dumps({"id": 1, "command": "seek", "time_s": 0.0}))
        page.send(json.dumps({"id": 2, "command": "speed", "speed": 0.0}))
        told = [json.loads(each) for each in page if isinstance(each, str)]
    thread.join(20)
    answers = {each["id"]: each for each in told if each["type"] == "answer"}
    assert "it only goes forward" in answers[1]["error"]
    assert "error" not in answers[2]
    assert any(each["type"] == "output" and "done" in each["output"][3] for each in told)
    assert [each for each in told if each["type"] == "state"][-1]["playing"] is False


LOOKER = """
import json, sys
from urllib.parse import urlsplit
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

address = urlsplit(sys.argv[1])
offered = ["crs.1", address.fragment.replace("=", ".")]
end_s, frames = 0.0, 0
with connect(f"ws://{address.netloc}/channel", subprotocols=offered, proxy=None) as page:
    hello = json.loads(page.recv(20))
    try:
        for message in page:
            if isinstance(message, str):
                end_s = json.loads(message).get("t", end_s)
                continue
            frames += 1
            if frames == 3:
                print([each["id"] for each in hello["world"]["robots"]], flush=True)
    except ConnectionClosed:
        pass
print(json.dumps({"joined_s": hello["end_s"], "end_s": end_s}))
"""
"""A substitute for a browser, which views a run to its end."""


def test_viewers_attach_at_any_time_to_three_robots(tmp_path: Path) -> None:
    """The run and each viewer are processes of their own."""
    (tmp_path / "looker.py").write_text(LOOKER)
    (tmp_path / "go.c").write_text(PROGRAM.replace("40", "4000"))
    assert main(["samples", "copy", "complex-3r.xml", str(tmp_path)]) == 0
    own = {"BROWSER": f"{sys.executable} looker.py %s", "DISPLAY": ":0"}
    port = free_port()

    def started(*words: str) -> subprocess.Popen[str]:
        return subprocess.Popen(
            crs(*words),
            cwd=tmp_path,
            env=os.environ | own,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    with ExitStack() as stack:
        words = ["run", "go.c", "complex-3r.xml", "--view", str(port)]
        run = started(*words, "--speed", "1")
        stack.callback(run.communicate)
        stack.callback(run.kill)
        assert run.stderr is not None
        while "token" not in run.stderr.readline():
            assert run.poll() is None
        viewers = []
        for _ in range(2):
            viewers.append(viewer := started("view", f"127.0.0.1:{port}"))
            stack.callback(viewer.communicate)
            stack.callback(viewer.kill)
            assert viewer.stdout is not None
            assert viewer.stdout.readline() == "['robot0', 'robot1', 'robot2']\n"
        run.send_signal(signal.SIGINT)
        seen = [json.loads(each.communicate(timeout=60)[0]) for each in viewers]
    assert seen[0]["joined_s"] < seen[1]["joined_s"]
    assert all(each["end_s"] > each["joined_s"] for each in seen)


def test_other_commands_of_the_user_find_a_run_by_its_port(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CRS_CACHE", str(tmp_path))
    server = Server(Silent())
    place = f"127.0.0.1:{server.port}"
    with announced(server.port, server.address()):
        file = tmp_path / "shown" / str(server.port)
        assert file.stat().st_mode & 0o077 == 0
        assert address_of(place) == server.address()
        assert main(["view", place, "--no-open"]) == 0
    server.close()
    assert server.address() in capfd.readouterr().err
    assert not file.exists()
    assert main(["view", place, "--no-open"]) == 2
    assert f"no run of yours is shown on port {server.port}" in capfd.readouterr().err
    assert main(["view", place, "--no-open", "--token", "x" * 22]) == 0
    said = capfd.readouterr().err
    assert f"warning: no run is served at {place} now: Connection refused" in said


def test_a_recording_is_viewed_alone_and_something_must_be(
    program: str, capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(["view"]) == 2
    assert "no C file, recording or HOST:PORT of a run to view" in capfd.readouterr().err
    assert main(["view", program, "run.mcap"]) == 2


def test_a_run_that_was_viewed_is_recorded_with_its_changes(
    program: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    def changed(screen: Screen, *, opens: bool) -> int:
        debugger = screen.run.debugger()
        debugger.goto_timestep(3)
        debugger.edit_world("drive robot0 0.1")
        debugger.goto_timestep(20)
        screen.server.close()
        return 0

    monkeypatch.setattr(start_view, "serve", changed)
    run = tmp_path / "run.mcap"
    assert main(["view", program, "--no-open", "-q", "--record", str(run)]) == 0
    with closing(Recording(run)) as recording:
        assert [each.text for each in recorded_changes(recording)] == ["drive robot0 0.1"]
    assert main(["replay", str(run), "--verify"]) == 0
    capfd.readouterr()
