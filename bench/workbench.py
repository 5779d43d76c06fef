"""Measure the workbench: the server with many pages, and a page in a browser.

The server sends 20 frames a second of robots that all move to pages that read as fast as they come.
A page is drawn by a browser without a graphics card: the time to its first picture; for a picture,
the processor time of the page's main thread in scripts besides the call that draws it (the median
and the most, see `page_trace.py`), and that of all processes of the browser; last, the median time
of a step in which the table of robots is scrolled, its layout included.

    python bench/workbench.py [--pages N] [--seconds S] [ROBOTS...]

`--no-browser` leaves the page out.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from page_trace import CATEGORIES, MARK_DRAWING, script_times_ms

from crs_cc.cli.start_view import describe
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.workbench.feed import Feed
from crs_cc.workbench.player import Player
from crs_cc.workbench.run import Halt
from crs_cc.workbench.screen import Screen

if TYPE_CHECKING:
    from collections.abc import Iterator

RATE_HZ = 20
SPACING_M = 1.0

READER = """
import socket, sys, threading
port, token, pages = int(sys.argv[1]), sys.argv[2], int(sys.argv[3])
def read():
    line = socket.create_connection(("127.0.0.1", port))
    line.sendall((f"GET /channel HTTP/1.1\\r\\nHost: 127.0.0.1:{port}\\r\\nUpgrade: websocket\\r\\n"
        "Connection: Upgrade\\r\\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\\r\\n"
        f"Sec-WebSocket-Version: 13\\r\\nSec-WebSocket-Protocol: crs.1, token.{token}\\r\\n\\r\\n"
    ).encode())
    room = bytearray(1 << 20)
    while line.recv_into(room):
        pass
threads = [threading.Thread(target=read, daemon=True) for _ in range(pages)]
for each in threads:
    each.start()
sys.stdin.read()
"""


class Circles:
    """A run in which robots drive in circles, computed at once."""

    can = frozenset({"play"})
    halt = Halt()
    timestep_s = 1 / RATE_HZ

    def __init__(self, robots: int) -> None:
        columns = int(np.ceil(np.sqrt(robots)))
        number = np.arange(robots)
        self.middle_m = np.array([number % columns, number // columns]) * SPACING_M + 1.0
        self.phase_rad = number * 0.7
        self.time_s = 0.0

    def values(self) -> Any:
        angle_rad = self.phase_rad + 0.8 * self.time_s
        ring = 0.3 * np.array([np.cos(angle_rad), np.sin(angle_rad)])
        return np.vstack([self.middle_m + ring, angle_rad + np.pi / 2])

    def interrupt(self) -> None: ...
    def forget_interrupt(self) -> None: ...
    def select(self, robot: int) -> None: ...
    def settle(self) -> None: ...
    def where(self) -> None: ...
    def panel(self) -> None: ...
    def new_world(self) -> None: ...
    def switch(self, name: str) -> None: ...

    def status(self, *, is_playing: bool) -> dict[str, Any]:  # noqa: ARG002
        return {"t": self.time_s, "first": 0, "robots": [], "sensors": {}, "devices": {}}


@contextmanager
def shown(robots: int) -> Iterator[tuple[Screen, Circles]]:
    """Serve a run of so many robots."""
    size_m = np.ceil(np.sqrt(robots)) * SPACING_M + 2.0
    rows = "".join(
        f'<robot id="r{n}" x="{1 + n % int(size_m - 2)}m" y="{1 + n // int(size_m - 2)}m"/>'
        for n in range(robots)
    )
    text = f'<world version="1"><area length="{size_m}m" width="{size_m}m"/>{rows}</world>'
    world = parse_world(text.encode(), "circles.xml")
    run = Circles(robots)
    feed = Feed(describe("live", world, ("circles.c", "circles.xml"), 0), 1 / RATE_HZ)
    screen = Screen(run, feed, Player(1 / RATE_HZ))  # type: ignore[arg-type]
    screen.player.play()
    feed.roster(0.0, [robot.id for robot in world.robots], [])
    try:
        yield screen, run
    finally:
        screen.server.close()


def play(screen: Screen, run: Circles, seconds: float) -> tuple[float, float]:
    """Send frames in real time; return the processor time of that, and of computing them [s]."""
    begin_s, computing_s = time.monotonic(), 0.0
    cpu_s = time.process_time()
    first_s = run.time_s
    while run.time_s - first_s < seconds:
        run.time_s += 1 / RATE_HZ
        before_s = time.thread_time()
        values = run.values()
        computing_s += time.thread_time() - before_s
        screen.feed.frame(run.time_s, values, is_last=True)
        screen.tick()
        time.sleep(max(0.0, begin_s + run.time_s - first_s - time.monotonic()))
    return time.process_time() - cpu_s, computing_s


def server(robots: int, pages: int, seconds: float) -> str:
    """Measure the server with many pages."""
    with shown(robots) as (screen, run):
        words = [str(screen.server.port), screen.server.tokens["view"], str(pages)]
        reader = subprocess.Popen([sys.executable, "-c", READER, *words], stdin=subprocess.PIPE)
        while screen.server.page_count < pages:
            time.sleep(0.05)
        play(screen, run, min(1.0, seconds))
        cpu_s, computing_s = play(screen, run, seconds)
        assert reader.stdin is not None
        reader.stdin.close()
        reader.wait(10)
        last = screen.server._last
        size = len(last.change or b"") if last else 0
    share = 100 * (cpu_s - computing_s) / seconds
    return f"{size:>12,} {share:>12.1f}"


def page(robots: int, seconds: float) -> str:
    """Measure a page: to its first picture, and for each picture."""
    from playwright.sync_api import sync_playwright

    chromium = shutil.which("chromium")
    flags = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    with shown(robots) as (screen, run), sync_playwright() as started:
        play(screen, run, 0.5)
        browser = started.chromium.launch(executable_path=chromium, args=flags)
        made = browser.new_page(viewport={"width": 1280, "height": 720})
        begin_s = time.monotonic()
        made.goto(screen.server.address())
        while not made.evaluate("document.body.dataset.time !== undefined"):
            screen.player._run_jobs(0.0)
            time.sleep(0.02)
        first_s = time.monotonic() - begin_s
        made.evaluate(MARK_DRAWING)
        play(screen, run, 1.0)
        browser.start_tracing(page=made, categories=CATEGORIES)
        before_s = browser_cpu_s()
        play(screen, run, seconds)
        cpu_s = browser_cpu_s() - before_s
        scripts_ms = script_times_ms(json.loads(browser.stop_tracing())["traceEvents"])
        scroll_ms = made.evaluate(SCROLL)
        browser.close()
    figures = f"{first_s:>10.1f} {statistics.median(scripts_ms):>10.1f} {max(scripts_ms):>10.1f}"
    pictures = len(scripts_ms)
    return f"{figures} {cpu_s / pictures:>10.2f} {pictures / seconds:>10.1f} {scroll_ms:>10.1f}"


def browser_cpu_s() -> float:
    """Return the processor time of all processes of the browser so far (Linux)."""
    parents, times_s, names = {}, {}, {}
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            name, _, rest = path.read_text().partition("(")[2].rpartition(")")
        except OSError:  # it has ended meanwhile
            continue
        words, number = rest.split(), int(path.parent.name)
        parents[number], names[number] = int(words[1]), name
        times_s[number] = (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")

    def is_ours(number: int) -> bool:
        while number in parents and number != os.getpid():
            number = parents[number]
        return number == os.getpid()

    return sum(times_s[each] for each in parents if "chrom" in names[each] and is_ours(each))


SCROLL = """async () => {
    crs.drawer.open("table");
    const scroll = document.querySelector(".robot-table .scroll");
    const took = [];
    for (let step = 0; step < 40; step++) {
        await new Promise(requestAnimationFrame);
        const begin = performance.now();
        scroll.scrollTop += 90;
        scroll.dispatchEvent(new Event("scroll"));
        void scroll.offsetHeight;
        void document.querySelector(".robot-table .row:last-child").getBoundingClientRect();
        took.push(performance.now() - begin);
    }
    return took.sort((a, b) => a - b)[20];
}"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("robots", type=int, nargs="*", default=[100, 1000, 10_000])
    parser.add_argument("--no-browser", action="store_true")
    parser.add_argument("--pages", type=int, default=50)
    parser.add_argument("--seconds", type=float, default=5.0)
    options = parser.parse_args()
    options.no_browser |= shutil.which("chromium") is None
    print(f"{'robots':>8} {'frame bytes':>12} {'server %':>12}", end="")
    print(
        ""
        if options.no_browser
        else f" {'first s':>10} {'scripts ms':>10} {'most ms':>10}"
        f" {'cpu s':>10} {'pictures/s':>10} {'scroll ms':>10}"
    )
    for robots in options.robots:
        row = f"{robots:>8,} {server(robots, options.pages, options.seconds)}"
        print(row if options.no_browser else f"{row} {page(robots, options.seconds)}", flush=True)


if __name__ == "__main__":
    main()
