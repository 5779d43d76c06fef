"""Runs that are shown, and pages in a real browser that look at them."""

from __future__ import annotations

import os
import shutil
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Final

import pytest

from crs_cc.cli.debug_options import DebugOptions
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.start_view import screen_of
from crs_cc.workbench.build_screen import BuildScreen
from crs_cc.workbench.screen import Screen

FLAGS = [
    *("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"),
    *("--no-proxy-server", "--disable-background-networking"),
    *("--disable-gpu-compositing", "--disable-accelerated-2d-canvas"),
    "--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup,SpareRendererForSitePerProcess",
]
"""Only WebGL is left to the software that stands for a graphics processor: to compose the page and
to draw its flat pictures by it takes three times as long. A window without the lists of suggestions
of its address bar, which are two pages of their own, opens in two thirds of the time."""

SLOW_SCREEN: Final = """{
    const atNextFrame = requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (draw) => setTimeout(() => atNextFrame(draw), 84);
}"""
"""Has a page draw ten pictures a second instead of sixty: these tests look at no more."""


def chromium() -> str:
    """Return the command that starts Chromium; skip the test without it, or in CI let it fail.

    That without windows, Debian's chromium-headless-shell, is preferred: it opens faster.
    """
    for name in ("chromium-headless-shell", "chromium", "chromium-browser"):
        found = shutil.which(name)
        if found is not None:
            return found
    if os.environ.get("CI"):
        pytest.fail("chromium not found: .ci/run installs it")
    pytest.skip("chromium not found: the page cannot be looked at")


@contextmanager
def running(folder: Path, program: str, world: str) -> Iterator[Screen]:
    """Show a run of a program in a world."""
    (folder / "go.c").write_text(program)
    (folder / "room.xml").write_text(world)
    files = Inputs((folder / "go.c",), folder / "room.xml")
    with played(screen_of(DebugOptions(inputs=files, quiet=True), 0)) as screen:
        yield screen


@contextmanager
def played(screen: Screen) -> Iterator[Screen]:
    """Let a screen play in a thread of its own, and end it."""
    thread = threading.Thread(target=screen.play, daemon=True)
    thread.start()
    try:
        yield screen
    finally:
        screen.player.end()
        screen.run.interrupt()
        thread.join(10)
        screen.server.close()


@contextmanager
def page_in(
    browser: Any,
    screen: Screen | BuildScreen,
    width: int = 900,
    height: int = 600,
    *,
    flat: bool = False,
) -> Iterator[Any]:
    """Open the page of a screen, see `page_at`: flat, without WebGL, where no view is looked at."""
    address = screen.server.address() + ("&flat=1" if flat else "")
    with page_at(browser, address, width, height) as made:
        yield made


@contextmanager
def page_at(
    browser: Any, address: str, width: int, height: int, color_scheme: str = "light"
) -> Iterator[Any]:
    """Open a page; at its end, nothing has gone wrong in it, and it has asked only this machine."""
    made = new_page(browser, width, height, color_scheme)
    wrong: list[str] = []
    made.on("pageerror", lambda error: wrong.append(str(error)))
    made.on("console", lambda line: wrong.extend([line.text] if is_fault(line) else []))
    made.on("request", lambda asked: wrong.extend([] if is_here(asked.url) else [asked.url]))
    made.set_default_timeout(20_000)
    made.goto(address)
    yield made
    made.close()
    assert not wrong, wrong


def new_page(
    browser: Any, width: int = 1280, height: int = 720, color_scheme: str = "light"
) -> Any:
    """Return an empty page of its own, which draws seldom."""
    size = {"width": width, "height": height}
    made = browser.new_page(viewport=size, color_scheme=color_scheme)
    made.add_init_script(SLOW_SCREEN)
    return made


def is_here(url: str) -> bool:
    """Return whether a request stays on this machine."""
    return "127.0.0.1" in url or url.startswith(("file:", "data:"))


def is_fault(line: Any) -> bool:
    """Return whether a line of the browser's console is a fault; a lost connection is none."""
    return line.type == "error" and "WebSocket" not in line.text


def wait(page: Any, condition: str) -> None:
    """Wait until an expression of the page is true."""
    page.wait_for_function(f"() => {condition}", polling=100)
