"""Whole screens of real runs, character by character, in the sizes that people have.

`pytest --update-goldens` rewrites them, and the picture in the README.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from html import unescape
from pathlib import Path

import pytest
from textual.pilot import Pilot

from crs_cc.debug.engine import Debugger
from crs_cc.debug.tui.app import DebugApp
from crs_cc.debug.tui.controller import Controller
from crs_cc.debug.tui.program_streams import ProgramStreams
from crs_cc.sim.files.world_xml import load_world
from tests.debug.debuggers import ROOT, debug_program
from tests.debug.tui.screen import LARGE, NO_BARS, SMALL, TINY, drive, enter, settle, text_of

SCREENS = Path(__file__).parent / "screens"
PICTURE = ROOT / "docs" / "images" / "debugger.svg"

Size = tuple[int, int]
CheckGolden = Callable[[Path, bytes], None]


@pytest.fixture(autouse=True)
def in_the_project(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)  # so that files are shown by the same names everywhere


def controller(program: str, world: str) -> Controller:
    model, reads = load_world(Path(world)), ProgramStreams()
    programs = [debug_program(Path(program))] * len(model.robots)
    return Controller(Debugger(model, programs, read=reads.read), reads)


def show(backend: Controller, sizes: Sequence[Size], *inputs: str) -> tuple[list[str], str]:
    """Return the screen as text in each size, and as a picture, after commands and keys: `<f5>`."""
    texts: list[str] = []
    pictures: list[str] = []

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        for each in inputs:
            if each.startswith("<"):
                await pilot.press(each[1:-1])
            else:
                await enter(pilot, each)
            await settle(pilot)
        for size in sizes:
            await pilot.resize_terminal(*size)
            await settle(pilot)
            texts.append(text_of(app))
        pictures.append(app.export_screenshot(simplify=True))

    drive(backend, session, sizes[0])
    return texts, pictures[0]


WANDER = ("samples/scout_c/wander.c", "worlds/room.xml")
BREAK = ("break cruise if step == 3", "continue", "<f11>", "<f7>")
CASES = {
    "start": (WANDER, ()),
    "breakpoint": (WANDER, (*BREAK, "<f2>")),
    "error": (("tests/debug/tui/one_sonar_too_many.c", "worlds/room.xml"), ("continue",)),
    "robots": (("samples/scout_c/square.c", "worlds/pair.xml"), ("tick 30", "robot 1")),
    "end": (("tests/debug/tui/hello.c", "worlds/empty.xml"), ("continue", "<f5>")),
}


@pytest.mark.parametrize("case", CASES)
def test_the_screen_shows(case: str, check_golden: CheckGolden) -> None:
    sources, inputs = CASES[case]
    texts, _ = show(controller(*sources), [LARGE, SMALL], *inputs)
    together = "\n".join(texts)
    check_golden(SCREENS / f"{case}.txt", together.encode())


def test_the_smallest_screens_show_the_current_line(check_golden: CheckGolden) -> None:
    texts, _ = show(controller(*WANDER), [TINY], *BREAK)
    check_golden(SCREENS / "tiny.txt", texts[0].encode())


def test_the_picture_in_the_readme_shows_a_session(check_golden: CheckGolden) -> None:
    inputs = ["display state", "break enter", *["continue"] * 4, *["reverse-continue"] * 2]
    texts, picture = show(controller(*WANDER), [(132, 42)], *inputs, "<f10>")
    assert "state • 0" in texts[0]
    picture = plain(picture)
    if not PICTURE.exists() or words(PICTURE.read_text()) != words(picture):
        check_golden(PICTURE, picture.encode())


def plain(picture: str) -> str:
    """Return a picture that takes nothing from outside, and is half as long."""
    picture = re.sub(r"@font-face \{.*?\}", "", picture, flags=re.DOTALL)
    picture = re.sub(r"terminal-\d+", "t", picture.replace("&#160;", "\N{NO-BREAK SPACE}"))
    picture = re.sub(r'<clipPath id="t-line-\d+">.*?</clipPath>', "", picture, flags=re.DOTALL)
    picture = re.sub(r' clip-path="url\(#t-line-\d+\)"', "", picture)
    return re.sub(r"\n\s*(?=\n)", "", picture)


def words(picture: str) -> list[str]:
    """Return what a picture says, whatever its colours."""
    texts = re.findall(r"<text [^>]*>(.*?)</text>", picture, re.DOTALL)
    return " ".join(unescape(each) for each in texts).translate(NO_BARS).split()
