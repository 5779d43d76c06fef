"""The control panel of a run that the vendor's clients drive: each of its actions."""

from __future__ import annotations

import re
import signal
import subprocess
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

import pytest
from websockets.sync.client import connect

from tests.cli.test_serve import TIMEOUT_S, Served
from tests.commands import crs
from tests.net.vendor.nclient import Nclient
from tests.net.vendor.ndirect import Ndirect, over_tcp, over_terminal
from tests.workbench.test_screen import Page

WORLD = """<world version="1"><area length="9m" width="4m"/>
<robot id="left" x="1m" y="2m"/><robot id="right" x="5m" y="2m"/><robot id="idle" x="8m" y="2m"/>
<box id="crate" x="3m" y="3.5m" length="0.3m" width="0.3m" mass="1kg"/></world>"""

CHANGES = (
    *("degrade left sonar.0 dead", "heal left", "move left to 2 1 90", "turn left to 45"),
    *("move crate to 7 1", "sleep left 0.2", "wake left", "charge left 50", "heat left 5"),
    *("shut from left", "message right to left: hello", "open from left"),
    *("drive right 0.1 20", "hold right", "release right", "remove idle"),
)
"""Each kind of change, but for those of fields and networks, which the world has not."""


@contextmanager
def served(folder: Path, line: Sequence[str], speed: str) -> Iterator[Served]:
    """Serve robot left to Nclient, robot right to Ndirect on a line, and the page."""
    folder.joinpath("world.xml").write_text(WORLD)
    log = folder / "serve.log"
    words = "--nserver", "0", *line, "--speed", speed, "--record", "run.mcap"
    with log.open("w") as errors:
        process = subprocess.Popen(
            crs("serve", "world.xml", *words), cwd=folder, stderr=errors, text=True
        )
    try:
        yield Served(process, log)
    finally:
        process.kill()
        process.communicate()


@contextmanager
def page_of(run: Served) -> Iterator[Page]:
    found = run.wait_for(r"open http://([\d.:]+)/#token=(\S+)")
    protocols = ["crs.1", f"token.{found[2]}"]
    with connect(f"ws://{found[1]}/channel", subprotocols=protocols, max_size=None) as line:  # type: ignore[arg-type]
        yield Page(line)


@pytest.mark.parametrize(
    ("line", "speed"), [(("--tcp-robot", "right=0"), "max"), (("--serial", "right"), "1")]
)
def test_each_change_of_a_page_is_part_of_a_run_that_clients_drive(
    tmp_path: Path, line: Sequence[str], speed: str
) -> None:
    """Even if simulated time waits for requests of clients."""
    threads = ThreadPoolExecutor(2)  # one waits for the other otherwise, for half a second
    with threads, served(tmp_path, line, speed) as run, page_of(run) as page:
        left, right = clients(run)
        for text in CHANGES:
            assert "value" in page.ask("edit", text=text), page.told["answer"]
            asked = [threads.submit(left.state_call, 15), threads.submit(right.state_call, 7)]
            assert all(each.result() for each in asked)
        assert "robots cannot be added" in page.error("edit", text="join new like left to 1 1")
        page.ask("pause")
        page.take_until(lambda: not page.told["state"]["playing"])
        paused_s = page.told["state"]["t"]
        assert "value" in page.ask("edit", text="move left to 3 1")
        assert page.told["state"]["t"] == paused_s
        page.ask("play")
        assert left.get_rpx()
        page.ask("speed", speed=0.0)  # from now on, time goes by requests
        page.ask("edit", text="heat left 6")
        time.sleep(0.5)
        page.ask("edit", text="heat left 7")
        shown = page.ask("export", form="inputs")["value"]["text"]
        made = re.findall(r"^([\d.]+)s: (\w+)", shown, re.MULTILINE)
        expected = *(text.split()[0] for text in CHANGES), "move", "heat", "heat"
        assert [name for _, name in made] == list(expected)
        assert float(made[-1][0]) - float(made[-2][0]) < 0.2
        page.ask("speed", speed=2.0)
        assert left.state_call(15)
        run.process.send_signal(signal.SIGINT)
        assert run.process.wait(TIMEOUT_S) == 130, run.text
    words = crs("replay", "run.mcap", "--verify")
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert "the same run" in done.stdout + done.stderr, done.stderr


def clients(run: Served) -> tuple[Nclient, Ndirect]:
    left = Nclient(int(run.wait_for(r"Nserver is on port (\d+)")[1]))
    assert left.connect_robot(1)
    place = run.wait_for(r"right is on (?:port )?(\S+)")[1]
    right = over_tcp(int(place), 2) if place.isdigit() else over_terminal(place, 2)
    return left, right
