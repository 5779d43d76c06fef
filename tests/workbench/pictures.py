"""Take the pictures of the documentation: `python -m tests.workbench.pictures [NAME...]`.

`PICTURES` is the table of them: what is opened, what is done in the page, and how large it is. Look
at each picture before it is committed. To look at the pages at other sizes, take them into another
folder: `--into /tmp/look --size 1024x768 --dark`.
"""

from __future__ import annotations

import argparse
import io
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, chdir, contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Final

from PIL import Image
from playwright.sync_api import sync_playwright

from crs_cc.cli.debug_options import DebugOptions
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.main import main as crs
from crs_cc.cli.start_build import building
from crs_cc.cli.start_view import screen_of
from tests.workbench import picture_steps as steps
from tests.workbench.in_browser import FLAGS, page_at, played

ROOT: Final = Path(__file__).parents[2]
IMAGES: Final = ROOT / "docs" / "images"
SAMPLES: Final = ROOT / "samples" / "scout_c"
WORLDS: Final = ROOT / "worlds"
PICTURED: Final = Path(__file__).with_name("pictured")
SCOUT: Final = ROOT / "crs_cc" / "sim" / "files" / "robots" / "scout.xml"
COLOURS: Final = 256
PATIENCE_MS: Final = 60_000
SETTLED_MS: Final = 3000
"""Until edges are smooth and no note is shown any more."""


@contextmanager
def run_of(program: Path, world: Path) -> Iterator[str]:
    """Show a run, in the folder of its program; yield its address."""
    options = DebugOptions(inputs=Inputs((Path(program.name),), world), quiet=True)
    with chdir(program.parent), played(screen_of(options, 0)) as screen:
        yield screen.server.address()


@contextmanager
def builder_of(file: Path, name: str) -> Iterator[str]:
    """Edit a copy of a world or a robot definition; yield the address."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(shutil.copyfile(file, Path(folder, name)))
        with building(copy, SAMPLES / "wander.c", 0) as screen:
            yield screen.server.address()


@contextmanager
def page_of_a_recording(program: Path, world: Path) -> Iterator[str]:
    """Record half a minute as a web page; yield its address."""
    with tempfile.TemporaryDirectory() as folder:
        run, page = Path(folder, "run.mcap"), Path(folder, "run.html")
        crs(["run", "-q", str(program), str(world), "--max-time", "30", "--record", str(run)])
        crs(["replay", str(run), "--html", str(page)])
        yield page.as_uri()


@dataclass(frozen=True)
class Picture:
    """A picture: what is opened, what is done in the page before it is taken, and its size."""

    opened: Callable[[], AbstractContextManager[str]]
    steps: Callable[[Any], None]
    height: int = 760
    width: int = 1280
    is_dark: bool = False


three_robots: Final = partial(run_of, SAMPLES / "wander.c", WORLDS / "complex-3r.xml")

PICTURES: Final = {
    "workbench": Picture(three_robots, steps.at_a_breakpoint),
    "workbench-runs": Picture(three_robots, steps.two_runs, 900),
    "workbench-views": Picture(three_robots, steps.four_views, is_dark=True),
    "workbench-heat": Picture(
        partial(run_of, SAMPLES / "wander.c", WORLDS / "gallery.xml"), steps.infrared
    ),
    "workbench-field": Picture(
        partial(run_of, SAMPLES / "ants" / "ants.c", SAMPLES / "ants" / "ants.xml"), steps.trails
    ),
    "workbench-debugger": Picture(
        partial(run_of, PICTURED / "fault.c", WORLDS / "room.xml"), steps.at_an_error, 860
    ),
    "workbench-why": Picture(
        partial(run_of, PICTURED / "follow.c", PICTURED / "follow.xml"),
        steps.why_and_histories, 860,
    ),
    "workbench-robots": Picture(three_robots, steps.table_of_robots),
    "workbench-faults": Picture(three_robots, steps.faults_and_plot),
    "workbench-messages": Picture(
        partial(run_of, SAMPLES / "platoon.c", WORLDS / "platoon.xml"), steps.messages,
        is_dark=True,
    ),
    "world-builder": Picture(
        partial(builder_of, PICTURED / "hall.xml", "hall.xml"), steps.builder_with("stove")
    ),
    "robot-builder": Picture(
        partial(builder_of, SCOUT, "rover.xml"), steps.builder_with("sensor[1]")
    ),
    "replay": Picture(
        partial(page_of_a_recording, SAMPLES / "wander.c", WORLDS / "cluttered.xml"),
        steps.recorded_page, 720,
    ),
}  # fmt: skip


def take(browser: Any, picture: Picture, path: Path) -> None:
    """Take a picture, with a palette, which halves its size and more."""
    scheme = "dark" if picture.is_dark else "light"
    with (
        picture.opened() as address,
        page_at(browser, address, picture.width, picture.height, color_scheme=scheme) as page,
    ):
        page.set_default_timeout(PATIENCE_MS)
        picture.steps(page)
        page.mouse.move(0, 0)
        page.wait_for_timeout(SETTLED_MS)
        taken = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    method = Image.Quantize.MAXCOVERAGE  # keeps the colours of small marks
    reduced = taken.quantize(COLOURS, method, kmeans=2, dither=Image.Dither.NONE)
    reduced.save(path, optimize=True)


def main() -> None:
    """Take the named pictures, or all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", default=list(PICTURES))
    parser.add_argument("--into", type=Path, default=IMAGES)
    parser.add_argument("--size", metavar="WIDTHxHEIGHT", help="of all; by default that of each")
    parser.add_argument("--dark", action="store_true", help="all in dark colours")
    options = parser.parse_args()
    with sync_playwright() as started:
        browser = started.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        for name in options.names:
            row = PICTURES[name]
            width, height = map(int, (options.size or f"{row.width}x{row.height}").split("x"))
            is_dark = row.is_dark or options.dark
            row = Picture(row.opened, row.steps, height, width, is_dark)
            take(browser, row, options.into / f"{name}.png")
            print(name)
        browser.close()


if __name__ == "__main__":
    main()
