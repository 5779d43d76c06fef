"""When a server or a browser is killed, the other one notices and continues."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from tests.workbench.in_browser import FLAGS, chromium, new_page, running, wait

PROGRAM = """#include "Nclient.h"
int main(void) { connect_robot(1); vm(20, 20, 0); for (;;) get_sn(); }
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="20m" width="4m"/>
  <robot id="ada" x="1m" y="1m"/>
</world>
"""


@contextmanager
def served(folder: Path, port: int = 0) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Show a run in a process of its own; return it and the address of its page."""
    (folder / "go.c").write_text(PROGRAM)
    (folder / "room.xml").write_text(WORLD)
    words = ["view", "go.c", "room.xml", "--no-open", "--play", "--port", str(port)]
    process = subprocess.Popen(
        [sys.executable, "-m", "crs_cc", *words],
        cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    try:
        assert process.stdout is not None
        yield process, process.stdout.readline().split("open ")[1].strip()
    finally:
        process.kill()
        process.communicate()


def until(condition: Callable[[], bool]) -> None:
    deadline_s = time.monotonic() + 20
    while not condition():
        assert time.monotonic() < deadline_s
        time.sleep(0.02)


def test_a_page_reports_a_killed_server_and_a_new_one_works(browser: Any, tmp_path: Path) -> None:
    with served(tmp_path) as (process, address):
        page = new_page(browser)
        page.goto(address + "&flat=1")
        wait(page, "crs.model.isConnected && crs.model.state.t > 0.5")
        process.kill()
        process.wait()
        wait(page, "document.querySelector('.chip.state').textContent === 'not connected'")
        wait(
            page, "document.querySelector('#note').textContent.startsWith('no response from a run')"
        )
    port = int(address.split(":")[2].split("/")[0])
    with served(tmp_path, port) as (_, anew):
        opened = new_page(browser)
        opened.goto(anew + "&flat=1")
        wait(opened, "crs.model.isConnected && crs.model.state.t > 0.5")
        # The token of the page before is that of the killed server: it cannot steer this one.
        assert not page.evaluate("crs.model.isConnected")
        assert "open the address that crs printed" in page.locator("#note").inner_text()
        opened.close()
        page.close()


def test_a_run_continues_when_its_browser_is_killed(tmp_path: Path) -> None:
    command = chromium()
    with running(tmp_path, PROGRAM, WORLD) as screen:
        shown = subprocess.Popen(
            [
                *(command, "--headless", *FLAGS, f"--user-data-dir={tmp_path / 'profile'}"),
                *("--remote-debugging-port=0", screen.server.address()),
            ],
            start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        try:
            until(lambda: screen.server.page_count == 1)
            screen.player.submit(screen.player.play)
            until(lambda: screen.run.time_s > 0.2)
        finally:
            os.killpg(shown.pid, signal.SIGKILL)
            shown.wait()
        until(lambda: screen.server.page_count == 0)
        killed_s = screen.run.time_s
        until(lambda: screen.run.time_s > killed_s + 0.5)
